// SPDX-License-Identifier: GPL-2.0-or-later
#include "yamagi/compile_wait.h"

#include "client/ui/compile_box.h"
#include "client/ui/theme.h"
#include "common/error.h"
#include "common/log.h"
#include "yamagi/sdl_window.h"

namespace vigil::yamagi {

namespace {

/// Drivers that have compiled it all before need less.
constexpr double told_after_s = 1.0;

} // namespace

CompileWait::CompileWait() : context_(client::theme::make_context()) {}

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
    const float scale = client::theme::scale_for(io.DisplaySize.y);
    ImGui::GetStyle() = client::theme::style(scale);
    ImGui::NewFrame();
    ImGui::PushFont(client::theme::letters(scale));
    client::draw_compilation(state);
    ImGui::PopFont();
    ImGui::Render();
    return ImGui::GetDrawData();
}

} // namespace vigil::yamagi
