// SPDX-License-Identifier: GPL-2.0-or-later
// One editable line of UTF-8 text with a cursor. It is ours rather than Dear ImGui's because it
// must take every event in order even when one frame spans many of them, as on a machine without a
// GPU.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace vigil::client {

enum class EditUnit { Character, Word };

class LineEditor {
public:
    const std::string& text() const { return text_; }
    /// Byte offset of the cursor; always between characters.
    size_t cursor() const { return cursor_; }

    /// Replaces everything; the cursor goes to the end.
    void set(std::string_view text);
    /// Replaces bytes [begin, cursor) by `text`; the cursor goes behind it.
    void replace_before_cursor(size_t begin, std::string_view text);
    /// Inserts at the cursor. Line breaks and tabs become spaces, other control characters are
    /// dropped.
    void insert(std::string_view text);

    void move_left(EditUnit unit);
    void move_right(EditUnit unit);
    void move_home() { cursor_ = 0; }
    void move_end() { cursor_ = text_.size(); }

    void erase_back(EditUnit unit);
    void erase_forward(EditUnit unit);
    void erase_to_start();
    void erase_to_end();

private:
    size_t left_of(size_t position, EditUnit unit) const;
    size_t right_of(size_t position, EditUnit unit) const;

    std::string text_;
    size_t cursor_ = 0;
};

} // namespace vigil::client
