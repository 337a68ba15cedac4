// SPDX-License-Identifier: GPL-2.0-or-later
// The host side of a light-sampling technique: it keeps the buffers of descriptor set 1 that its
// shader (shaders/light/NAME.glsl) reads. Adding one: a shader file, a file here, and a row in
// shaders/shared/techniques.h.
#pragma once

#include "refresh/settings.h"
#include "refresh/vkpt/gpu/commands.h"

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "shared/bindings.h"
#include "shared/techniques.h"

namespace vigil {
class LightLister;
}

namespace vigil::gpu {
class PipelineCompiler;
}

namespace vigil::vkpt {

class LightSet;

/// What a technique is told about a frame.
struct LightFrame {
    const LightSet& lights;
    glm::vec3 eye; // the camera's position
    const refresh::Settings& settings;
};

class LightTechnique {
public:
    virtual ~LightTechnique() = default;

    /// Brings the technique's data to this frame's lights, on the host. Returns true if a buffer
    /// was made anew (the GPU is idle then), so that bindings must be written again.
    virtual bool prepare(const LightFrame& frame) = 0;
    /// Records the copies of what changed; after prepare.
    virtual void upload(gpu::FrameCommands& commands) = 0;
    /// Records passes that turn what the frames before taught into what this frame reads; after
    /// upload.
    virtual void adapt(gpu::FrameCommands&) {}
    /// Forgets what frames taught: the next adapt() begins anew.
    virtual void forget() {}
    /// Whether it learns from frame to frame, by itself or by the octree.
    virtual bool learns() const { return uses_guiding(); }
    /// Buffers by binding of set 1 (shared/bindings.h); null where there is none.
    using Bindings = std::array<const gpu::Buffer*, TECHNIQUE_BINDING_COUNT>;
    virtual void bind(Bindings& bindings) const = 0;
    /// Whether next event estimation is of any use: false where rays find the lights.
    virtual bool samples_lights() const { return true; }
    /// Whether its shader looks into the octree, which the renderer then brings to every frame; as
    /// prepare() found.
    virtual bool uses_guiding() const { return false; }
    /// What that was decided by, for reports.
    virtual std::string guiding_reason() const { return "only pt_nee vlc has them"; }
};

/// What techniques are made from: valid as long as the level is.
struct TechniqueContext {
    const gpu::Device& device;
    gpu::PipelineCompiler& compiler;
    const LightLister& lister; // PVS clusters of the level
};

std::unique_ptr<LightTechnique> make_technique(Technique technique,
                                               const TechniqueContext& context);

// One maker per row of shaders/shared/techniques.h, each defined in light/NAME.cpp.
#define VIGIL_DECLARE_TECHNIQUE(name, help)                                                        \
    std::unique_ptr<LightTechnique> make_##name(const TechniqueContext& context);
VIGIL_TECHNIQUE_TABLE(VIGIL_DECLARE_TECHNIQUE)
#undef VIGIL_DECLARE_TECHNIQUE

} // namespace vigil::vkpt
