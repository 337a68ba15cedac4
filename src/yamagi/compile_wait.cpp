// SPDX-License-Identifier: GPL-2.0-or-later
#include "yamagi/compile_wait.h"

#include "common/error.h"
#include "common/log.h"
#include "yamagi/sdl_window.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <fmt/ranges.h>

namespace vigil::yamagi {

namespace {

/// Drivers that have compiled it all before need less.
constexpr double told_after_s = 1.0;

constexpr float place_in_window = 0.7f; // of its height, from above
constexpr float font_pixels = 13.0f, pixels_per_scale = 720.0f, most_scale = 3.0f;
constexpr const char* comfort = "The driver keeps them: the next start is quick.";

} // namespace

CompileWait::CompileWait() {
    IMGUI_CHECKVERSION();
    context_ = ImGui::CreateContext();
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    ImFontConfig config;
    config.SizePixels = font_pixels;
    config.OversampleH = 1;
    config.PixelSnapH = true;
    io.Fonts->AddFontDefault(&config);
#if IMGUI_VERSION_NUM >= 19200
    io.BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
#else
    io.Fonts->Build();
#endif
}

CompileWait::~CompileWait() {
    ImGui::DestroyContext(context_);
}

ImDrawData* CompileWait::compiling(const refresh::Compilation& state) {
    const bool over = state.done == state.total;
    if (!told_ && !over && state.seconds >= told_after_s) {
        log_info("compiling shaders: {} passes; the driver keeps them, the next start is quick",
                 state.total);
        told_ = true;
    }
    if (over) {
        if (told_) log_info("compiled {} passes in {:.0f} s", state.total, state.seconds);
        told_ = false;
    } else if (answer_window_system()) {
        fail("the window was closed while shaders were compiled");
    }
    return over || size_.x <= 0 || size_.y <= 0 ? nullptr : draw(state);
}

ImDrawData* CompileWait::draw(const refresh::Compilation& state) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size_.x), static_cast<float>(size_.y)};
    io.DeltaTime = 0.1f;
    io.FontGlobalScale =
        std::clamp(std::floor(io.DisplaySize.y / pixels_per_scale + 0.5f), 1.0f, most_scale);
    ImGui::NewFrame();
    const float width = ImGui::CalcTextSize(comfort).x + 2.0f * ImGui::GetStyle().WindowPadding.x;
    ImGui::SetNextWindowPos({0.5f * io.DisplaySize.x, place_in_window * io.DisplaySize.y},
                            ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(width, io.DisplaySize.x), 0.0f});
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(
        fmt::format("Compiling shaders: {} of {}, {:.0f} s", state.done, state.total, state.seconds)
            .c_str());
    ImGui::ProgressBar(std::clamp(state.share, 0.0f, 1.0f), {-FLT_MIN, 0.0f}, "");
    ImGui::TextUnformatted(fmt::format("{}", fmt::join(state.passes, ", ")).c_str());
    ImGui::TextDisabled("%s", comfort);
    ImGui::EndTooltip();
    ImGui::Render();
    return ImGui::GetDrawData();
}

} // namespace vigil::yamagi
