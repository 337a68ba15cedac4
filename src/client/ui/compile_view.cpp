// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/ui/compile_view.h"

#include "client/ui/pen.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace vigil::client {

std::string compilation_text(const refresh::Compilation& state) {
    return fmt::format("compiling {}: {} of {} shaders done, {:.0f} s",
                       fmt::join(state.passes, ", "), state.done, state.total, state.seconds);
}

void draw_compilation(const refresh::Compilation& state, ImFont& font) {
    constexpr std::string_view title = "Compiling shaders";
    constexpr std::string_view comfort = "The driver keeps them: the next start is quick.";
    constexpr float height_in_window = 0.7f;
    const Pen pen(font);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const std::string count =
        fmt::format("{} of {}, {:.0f} s", state.done, state.total, state.seconds);
    const std::string passes = fmt::format("{}", fmt::join(state.passes, ", "));

    const float pad = pen.size(), row = pen.line_height();
    const float width = std::min(pen.measure(comfort).x + 2.0f * pad, screen.x);
    const float height = 4.0f * row + 3.0f * pad;
    const ImVec2 low{std::floor((screen.x - width) / 2.0f),
                     std::floor(std::clamp(height_in_window * screen.y - height / 2.0f, 0.0f,
                                           std::max(screen.y - height, 0.0f)))};
    const ImVec2 high{low.x + width, low.y + height};
    ImDrawList& list = pen.list();
    list.AddRectFilledMultiColor(low, high, ink::sheet_top, ink::sheet_top, ink::sheet_bottom,
                                 ink::sheet_bottom);
    list.AddRect(low, high, ink::edge);
    list.PushClipRect(low, high, true);
    const float left = low.x + pad, right = high.x - pad;
    float y = low.y + pad;
    pen.text({left, y}, ink::edge, title);
    pen.text({right - pen.measure(count).x, y}, ink::info, count);
    y += row + 0.5f * pad;
    list.AddRect({left, y}, {right, y + row}, ink::edge);
    const float inner = right - left - 4.0f;
    list.AddRectFilled({left + 2.0f, y + 2.0f},
                       {left + 2.0f + inner * std::clamp(state.share, 0.0f, 1.0f), y + row - 2.0f},
                       ink::edge);
    y += row + 0.5f * pad;
    pen.text({left, y}, ink::info, passes);
    y += row;
    pen.text({left, y}, ink::dim, comfort);
    list.PopClipRect();
}

} // namespace vigil::client
