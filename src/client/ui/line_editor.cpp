// SPDX-License-Identifier: GPL-2.0-or-later
// Editing a line: a character is a UTF-8 sequence, a word is what spaces and quotes end.
#include "client/ui/line_editor.h"

namespace vigil::client {

namespace {

bool continues_character(char c) {
    return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u;
}

bool separates_words(char c) {
    return c == ' ' || c == ';' || c == '"';
}

} // namespace

void LineEditor::set(std::string_view text) {
    text_ = text;
    cursor_ = text_.size();
}

void LineEditor::replace_before_cursor(size_t begin, std::string_view text) {
    text_.replace(begin, cursor_ - begin, text);
    cursor_ = begin + text.size();
}

void LineEditor::insert(std::string_view text) {
    std::string clean;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\n' || c == '\t') clean += ' ';
        if (byte >= 0x20u && byte != 0x7fu) clean += c;
    }
    text_.insert(cursor_, clean);
    cursor_ += clean.size();
}

size_t LineEditor::left_of(size_t position, EditUnit unit) const {
    if (unit == EditUnit::Character) {
        while (position > 0 && continues_character(text_[--position])) {
        }
        return position;
    }
    while (position > 0 && separates_words(text_[position - 1]))
        --position;
    while (position > 0 && !separates_words(text_[position - 1]))
        --position;
    return position;
}

size_t LineEditor::right_of(size_t position, EditUnit unit) const {
    const size_t size = text_.size();
    if (unit == EditUnit::Character) {
        if (position < size) ++position;
        while (position < size && continues_character(text_[position]))
            ++position;
        return position;
    }
    while (position < size && !separates_words(text_[position]))
        ++position;
    while (position < size && separates_words(text_[position]))
        ++position;
    return position;
}

void LineEditor::move_left(EditUnit unit) {
    cursor_ = left_of(cursor_, unit);
}

void LineEditor::move_right(EditUnit unit) {
    cursor_ = right_of(cursor_, unit);
}

void LineEditor::erase_back(EditUnit unit) {
    replace_before_cursor(left_of(cursor_, unit), "");
}

void LineEditor::erase_forward(EditUnit unit) {
    text_.erase(cursor_, right_of(cursor_, unit) - cursor_);
}

void LineEditor::erase_to_start() {
    replace_before_cursor(0, "");
}

void LineEditor::erase_to_end() {
    text_.erase(cursor_);
}

} // namespace vigil::client
