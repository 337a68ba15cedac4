// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/ui/compile_box.h"

#include "client/ui/theme.h"

#include <algorithm>
#include <cfloat>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace vigil::client {

void draw_compilation(const refresh::Compilation& state) {
    constexpr const char* comfort = "The driver keeps them: the next start is quick.";
    constexpr float height_in_window = 0.7f;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float width = ImGui::CalcTextSize(comfort).x + 2.0f * ImGui::GetStyle().WindowPadding.x;
    ImGui::SetNextWindowPos({screen.x / 2.0f, height_in_window * screen.y}, ImGuiCond_Always,
                            {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(width, screen.x), 0.0f});
    ImGui::BeginTooltip(); // over all else
    ImGui::TextColored(
        theme::edge, "Compiling shaders: %s",
        fmt::format("{} of {}, {:.0f} s", state.done, state.total, state.seconds).c_str());
    ImGui::ProgressBar(std::clamp(state.share, 0.0f, 1.0f), {-FLT_MIN, 0.0f}, "");
    ImGui::TextUnformatted(fmt::format("{}", fmt::join(state.passes, ", ")).c_str());
    ImGui::TextDisabled("%s", comfort);
    ImGui::EndTooltip();
}

std::string compilation_text(const refresh::Compilation& state) {
    return fmt::format("compiling {}: {} of {} shaders done, {:.0f} s",
                       fmt::join(state.passes, ", "), state.done, state.total, state.seconds);
}

} // namespace vigil::client
