// SPDX-License-Identifier: GPL-2.0-or-later
// What the client does while the renderer waits for a compiler: in a window it shows how far that
// is and keeps answering the window system; without one it tells a terminal. No time passes in the
// level, and what is typed counts afterwards.
#include "client/client.h"
#include "client/ui/compile_box.h"
#include "common/error.h"

namespace vigil::client {

namespace {

/// Drivers that have compiled it all before need less.
constexpr double told_after_s = 1.0;

} // namespace

ImDrawData* Client::compiling(const refresh::Compilation& state) {
    const bool over = state.done == state.total;
    if (over) {
        compile_s_ += state.seconds;
        last_frame_s_ = clock_.seconds();
    }
    if (headless()) {
        tell_compilation(state, over);
        return nullptr;
    }
    for (platform::Event& event : window_->poll_events()) {
        if (std::holds_alternative<platform::CloseEvent>(event)) {
            quit();
            throw CompilationEnded();
        }
        waiting_events_.push_back(std::move(event));
    }
    return draw_overlay(over ? nullptr : &state, 0.0);
}

void Client::tell_compilation(const refresh::Compilation& state, bool over) {
    if (over) {
        compile_line_.reset();
        return;
    }
    if (!compile_line_) compile_line_ = std::make_unique<ProgressLine>(told_after_s, told_after_s);
    compile_line_->show(state.share, compilation_text(state));
}

} // namespace vigil::client
