// SPDX-License-Identifier: GPL-2.0-or-later
// Text over the picture, with ImGui's draw lists: what console, menu and statistics are drawn with,
// and their colours.
#pragma once

#include <imgui.h>

#include <string_view>

namespace vigil::client {

namespace ink {
constexpr ImU32 sheet_top = IM_COL32(12, 14, 18, 235);
constexpr ImU32 sheet_bottom = IM_COL32(24, 28, 34, 235);
constexpr ImU32 edge = IM_COL32(230, 150, 50, 255);
constexpr ImU32 info = IM_COL32(214, 214, 206, 255);
constexpr ImU32 warning = IM_COL32(255, 205, 90, 255);
constexpr ImU32 error = IM_COL32(255, 110, 95, 255);
constexpr ImU32 typed = IM_COL32(140, 200, 255, 255);
constexpr ImU32 dim = IM_COL32(150, 150, 145, 255);
constexpr ImU32 chosen = IM_COL32(230, 150, 50, 90);
constexpr ImU32 ground = IM_COL32(12, 14, 18, 190); // behind single lines over the picture
} // namespace ink

/// The size in pixels for which a font was made.
inline float size_of(const ImFont& font) {
#if IMGUI_VERSION_NUM >= 19200
    return font.LegacySize;
#else
    return font.FontSize;
#endif
}

/// A pen that draws text of one size on the screen, in the current ImGui frame.
class Pen {
public:
    explicit Pen(ImFont& font);

    float size() const { return size_; }
    float line_height() const;
    /// Size in pixels; lines break at `wrap_width` if it is above 0.
    ImVec2 measure(std::string_view text, float wrap_width = 0.0f) const;
    /// Rows that the text takes when it breaks at `wrap_width`.
    int rows(std::string_view text, float wrap_width) const;
    void text(ImVec2 at, ImU32 color, std::string_view text, float wrap_width = 0.0f) const;
    ImDrawList& list() const { return list_; }

private:
    ImFont& font_;
    ImDrawList& list_;
    float size_;
};

} // namespace vigil::client
