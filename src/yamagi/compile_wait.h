// SPDX-License-Identifier: GPL-2.0-or-later
// What is seen while the renderer waits for a compiler: a box over the window that says how far it
// is, and two lines at the console. The window system is answered meanwhile; keys count afterwards.
#pragma once

#include "refresh/refresh.h"

#include <imgui.h>

namespace vigil::yamagi {

class CompileWait final : public refresh::CompilationWatcher {
public:
    /// Make it before the renderer and keep it longer: the renderer draws with its ImGui context.
    CompileWait();
    ~CompileWait() override;
    CompileWait(const CompileWait&) = delete;
    CompileWait& operator=(const CompileWait&) = delete;

    /// The window's size in pixels; (0, 0): there is none, nothing is drawn.
    void set_size(glm::ivec2 size) { size_ = size; }

    /// Throws Error when the window was closed.
    ImDrawData* compiling(const refresh::Compilation& state) override;

private:
    ImDrawData* draw(const refresh::Compilation& state);

    ImGuiContext* context_;
    glm::ivec2 size_{0};
    bool told_ = false; // of this wait
};

} // namespace vigil::yamagi
