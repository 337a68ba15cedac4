// SPDX-License-Identifier: GPL-2.0-or-later
// A side of the picture: a technique, whether guided rays go with it, and what both have learned.
// Without `pt_compare` the picture has one side. With it there are two, and each learns from its
// own pixels alone, in an octree of its own: nothing that one finds helps the other, and thresholds
// stay those of the whole picture, so that a leaf that one side sees is as fine, and knows as much,
// as it would without the other.
#pragma once

#include "refresh/vkpt/guiding/guiding.h"
#include "refresh/vkpt/light/technique.h"

#include <memory>

namespace vigil::vkpt {

class Side {
public:
    /// `slots` is the number of frames in flight.
    Side(const gpu::Device& device, gpu::PipelineCompiler& compiler, size_t slots)
        : device_(device), guiding_(device, compiler, slots) {}

    /// Makes the technique if another one is asked for; the GPU is idle then. True if it did.
    bool select(Technique technique, const TechniqueContext& context);
    /// What guides its rays.
    void set_guide(const GuideChoice& guide) { guide_ = guide; }
    /// Forgets technique and level; the GPU must be idle.
    void clear() { technique_.reset(); }
    /// Forgets what frames taught: the octree is that of a cube (Guiding::restart).
    void forget(const glm::vec3& corner, float size);

    /// Makes what the octree needs for a frame of `picture_size`, the level's frame number `frame`,
    /// if it is of use.
    void prepare_guiding(glm::uvec2 picture_size, const refresh::Settings& settings);
    /// Whether update_guiding() asks for places.
    bool expects_places() const { return guided() && guiding_.expects_places(); }
    /// Records the passes that bring the octree to that frame; after the technique's own adapt().
    /// `places`: see Guiding::record.
    void update_guiding(gpu::FrameCommands& commands, size_t slot, Change change,
                        std::span<const glm::vec3> places);

    LightTechnique* technique() const { return technique_.get(); } ///< null before a level
    Technique id() const { return id_; }
    const GuideChoice& guide() const { return guide_; }
    /// Whether the octree is kept: for the technique, or for the guider.
    bool guided() const { return technique_->uses_guiding() || guide_.guides(); }
    Guiding& guiding() { return guiding_; }
    const Guiding& guiding() const { return guiding_; }

private:
    const gpu::Device& device_;
    Guiding guiding_;
    std::unique_ptr<LightTechnique> technique_;
    Technique id_ = Technique::sll;
    GuideChoice guide_;
};

} // namespace vigil::vkpt
