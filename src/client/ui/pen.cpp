// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/ui/pen.h"

#include <algorithm>
#include <cmath>

namespace vigil::client {

Pen::Pen(ImFont& font)
    : font_(font), list_(*ImGui::GetForegroundDrawList()), size_(size_of(font)) {}

float Pen::line_height() const {
    return std::ceil(size_ * 1.15f);
}

ImVec2 Pen::measure(std::string_view text, float wrap_width) const {
    return font_.CalcTextSizeA(size_, 1e9f, wrap_width, text.data(), text.data() + text.size());
}

int Pen::rows(std::string_view text, float wrap_width) const {
    if (text.empty()) return 1;
    return std::max(1, static_cast<int>(std::lround(measure(text, wrap_width).y / size_)));
}

void Pen::text(ImVec2 at, ImU32 color, std::string_view text, float wrap_width) const {
    if (text.empty()) return;
    list_.AddText(&font_, size_, at, color, text.data(), text.data() + text.size(), wrap_width);
}

} // namespace vigil::client
