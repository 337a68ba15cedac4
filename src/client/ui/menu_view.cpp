// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/ui/menu_view.h"

#include "client/ui/pen.h"

#include <algorithm>
#include <cmath>

namespace vigil::client {

namespace {

constexpr int about_rows = 2; // room for the sentence below the rows

/// Measures of the box, in pixels.
struct Box {
    ImVec2 low, high;
    float pad, row_height, value_x;
    size_t first, count; // rows that are shown
};

Box lay_out(const Menu& menu, const std::vector<MenuRow>& rows, const Pen& pen) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    Box box{};
    box.pad = pen.size();
    float labels = pen.measure(menu.title()).x, values = 0.0f;
    for (const MenuRow& row : rows) {
        labels = std::max(labels, pen.measure(row.label).x);
        if (!row.value.empty()) values = std::max(values, pen.measure("< " + row.value + " >").x);
    }
    // Wide enough for any value, so that the box keeps its size while one steps through them.
    values = std::max(values, menu.title() == "Vigil" ? 16.0f * pen.size() * 0.55f : 0.0f);
    const float width =
        std::min(std::max(labels + values + 4.0f * box.pad, 24.0f * pen.size()), screen.x);
    const float frame = 3.0f * box.pad + 2.0f * pen.line_height() +
                        static_cast<float>(about_rows) * pen.line_height();
    // Small windows show as many rows as they can, closer together.
    const auto count = static_cast<float>(std::max<size_t>(rows.size(), 1));
    box.row_height = std::clamp(std::floor((screen.y - frame) / count), pen.line_height(),
                                std::ceil(pen.line_height() * 1.2f));
    const auto room = static_cast<size_t>(std::max(1.0f, (screen.y - frame) / box.row_height));
    box.count = std::min(rows.size(), room);
    // From where it was, no further than it takes to show the chosen row.
    box.first = std::min(menu.first_shown(), rows.size() - box.count);
    if (menu.chosen() >= box.first + box.count) box.first = menu.chosen() + 1 - box.count;
    if (!rows.empty()) box.first = std::min(box.first, menu.chosen());
    const float height =
        frame + static_cast<float>(std::max<size_t>(box.count, 1)) * box.row_height;
    box.low = {std::floor((screen.x - width) / 2.0f),
               std::floor(std::max(0.0f, (screen.y - height) / 2.0f))};
    box.high = {box.low.x + width, box.low.y + height};
    box.value_x = box.low.x + labels + 2.5f * box.pad;
    return box;
}

} // namespace

std::vector<MenuPlace> draw_menu(const Menu& menu, ImFont& font) {
    const Pen pen(font);
    const std::vector<MenuRow> rows = menu.rows();
    const Box box = lay_out(menu, rows, pen);
    ImDrawList& list = pen.list();
    list.AddRectFilledMultiColor(box.low, box.high, ink::sheet_top, ink::sheet_top,
                                 ink::sheet_bottom, ink::sheet_bottom);
    list.AddRect(box.low, box.high, ink::edge);
    list.PushClipRect(box.low, box.high, true);

    const float left = box.low.x + box.pad, right = box.high.x - box.pad;
    float y = box.low.y + box.pad;
    pen.text({left, y}, ink::edge, menu.title());
    y += 1.5f * pen.line_height();
    std::vector<MenuPlace> places;
    const float inset = (box.row_height - pen.size()) / 2.0f;
    for (size_t i = box.first; i < box.first + box.count; ++i) {
        const MenuRow& row = rows[i];
        const bool chosen = i == menu.chosen();
        const ImVec2 low{box.low.x + 1.0f, y}, high{box.high.x - 1.0f, y + box.row_height};
        if (chosen) list.AddRectFilled(low, high, ink::chosen);
        pen.text({left, y + inset}, ink::info, row.label);
        const bool arrows = chosen && row.steps;
        const ImU32 color = chosen && menu.wants_key() ? ink::warning : ink::typed;
        pen.text({box.value_x, y + inset}, color,
                 arrows      ? "< " + row.value + " >"
                 : row.steps ? "  " + row.value
                             : row.value);
        places.push_back({i, {low.x, low.y}, {high.x, high.y}});
        y += box.row_height;
    }
    if (rows.empty()) {
        pen.text({left, y + inset}, ink::dim, "there are none");
        y += box.row_height;
    }
    // More above and below.
    const float mark = right - pen.measure("v").x;
    if (box.first > 0) pen.text({mark, box.low.y + box.pad}, ink::dim, "^");
    if (box.first + box.count < rows.size())
        pen.text({mark, y - box.row_height + inset}, ink::dim, "v");
    if (menu.chosen() < rows.size())
        pen.text({left, y + 0.5f * box.pad}, ink::dim, rows[menu.chosen()].about, right - left);
    list.PopClipRect();
    return places;
}

void draw_stats(const std::vector<std::string>& lines, ImFont& font, float top) {
    const Pen pen(font);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float pad = std::floor(pen.size() * 0.5f);
    float width = 0.0f;
    for (const std::string& line : lines)
        width = std::max(width, pen.measure(line).x);
    const float height = static_cast<float>(lines.size()) * pen.line_height();
    const float left = screen.x - width - 2.0f * pad;
    pen.list().AddRectFilled({left, top}, {screen.x, top + height + pad}, ink::ground);
    float y = top + pad * 0.5f;
    for (const std::string& line : lines) {
        pen.text({left + pad, y}, ink::info, line);
        y += pen.line_height();
    }
}

} // namespace vigil::client
