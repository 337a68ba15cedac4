// SPDX-License-Identifier: GPL-2.0-or-later
// What the path tracer learns from one frame for the next (paper, sections 4 and 6): the octree
// over surface samples, the light samples stored in its leaves, and the Visibility Light Caches
// made from them. Owns the buffers and records the passes of shaders/guiding. It knows buffers,
// positions and light ids; nothing of levels or lights.
#pragma once

#include "refresh/vkpt/gpu/compute_pass.h"
#include "refresh/vkpt/guiding/guider.h"
#include "refresh/vkpt/guiding/octree_start.h"
#include "shared/guiding_types.h"

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace vigil::vkpt {

/// The most that is new in a frame, against the one before.
enum class Change {
    Nothing,
    Something, // camera, models, or how bright lights are
    Lights,    // they vanish or move
    NewLights  // they appear
};

class Guiding {
public:
    /// `slots` is the number of frames in flight.
    Guiding(const gpu::Device& device, gpu::PipelineCompiler& compiler, size_t slots);

    /// What sizes and thresholds depend on.
    struct Options {
        glm::uvec2 picture_size{0, 0};
        shader::GuidingSettings settings{};
        GuideChoice guide{};           // what learns directions
        bool lights = true;            // light samples are stored, and caches made of them
        uint32_t first_cache_part = 6; // room for one in so many of all caches at the start
        uint32_t rest_after = 0;       // frames without a change; 0: never
        uint32_t learn_every = 1;      // of up to so many frames one teaches, if that is enough
        bool half_merged = false;      // neighbours take turns to be merged
        bool start_fine = true;        // the first octree follows `places`, or has one node
        double least_gain = 0.0;       // of guiders: part of the spread of rays that they take away
        uint32_t bounces = 1;          // that paths may have; 1 also where they have none
    };
    /// Options from the settings, but for `lights`: that is for who traces the rays to say.
    /// pt_oct_split and pt_oct_collapse are thresholds at 1920 x 1080 pixels: they follow the
    /// number of pixels, and pt_oct_scale.
    static Options options(glm::uvec2 picture_size, Guide guide, const refresh::Settings& settings);
    /// Inner nodes that a tree has room for: they follow from the thresholds and the number of
    /// surface samples, one for each surface of a path.
    static uint32_t node_capacity(const Options& options);

    /// Makes room, and has pipelines made: buffers depend on the options, not on the number of
    /// lights. Returns true if they were made anew: the octree starts anew then, and the GPU is
    /// idle.
    bool prepare(const Options& options);
    /// Forgets everything: the next record() starts a tree, without samples. `corner` and `size`
    /// are the root's cube, in map units.
    void restart(const glm::vec3& corner, float size);
    /// Whether the next record() starts a tree that is to be as fine as places ask for.
    bool expects_places() const { return restart_ && options_.start_fine; }
    /// Records the passes that make this frame's octree and caches from the samples of the frame
    /// before, if that stored any. Afterwards set() is the new tree's. `slot` is that of the frame
    /// in flight; a tree that starts expects samples at `places` (start_octree). Frames store
    /// samples as often as there is something to learn from them: all while Change::Lights goes on,
    /// fewer where one has plenty (Options::learn_every), one of 31 after Options::rest_after
    /// frames in which nothing changes. Where guiders gain less than Options::least_gain, they draw
    /// rays in a few frames only.
    void record(gpu::FrameCommands& commands, size_t slot, Change change,
                std::span<const glm::vec3> places = {});
    /// What the frame counted that was recorded last in `slot`; after its fence.
    shader::GuidingWork statistics(size_t slot) const;

    /// How many of what buffers hold a frame asked for.
    struct Needs {
        uint32_t nodes = 0, samples = 0, rays = 0, cache_words = 0;
    };
    static Needs needs_of(const shader::GuidingWork& work);
    /// The most of each since the buffers were made.
    const Needs& worst() const { return worst_; }

    /// Set 2 of the path tracer: look-ups and storing samples (shaders/guiding/octree.glsl).
    const gpu::DescriptorSet& look_up() const { return trees_[0].lookup; }
    VkDescriptorSet set() const { return trees_[current_].lookup.handle(); }

    uint64_t memory_bytes() const;

    // What tests read and write: the tree that the next record() starts from (after it: the one it
    // made).
    struct Tree {
        gpu::Buffer nodes;  // number of inner nodes, then the nodes (octree_node)
        gpu::Buffer cells;  // their cubes (octree_pack_cell), 2 words each
        gpu::Buffer leaves; // LEAF_WORDS arrays of 8 * node_capacity leaves
        gpu::Buffer caches; // light ids of the leaves' caches, with their ages
        gpu::DescriptorSet lookup;
        gpu::DescriptorSet passes; // of a record() that starts from this tree
    };
    const Tree& tree() const { return trees_[current_]; }
    const gpu::Buffer& samples() const { return samples_; }
    const gpu::Buffer& rays() const { return rays_; } // null without a guider
    const gpu::Buffer& vlc_lights() const { return tree().caches; }
    const gpu::Buffer& work() const { return work_; }
    const shader::GuidingHeader& header() const { return header_; }
    /// Whether a guider draws rays, so that the tree's nodes have what it learned.
    bool guided() const { return options_.guide.guides(); }

private:
    void choose_pipelines();
    void make_buffers();
    struct Sets {
        gpu::DescriptorSet lookup, passes;
    };
    Sets make_sets() const;
    gpu::Buffer make_caches(const shader::GuidingHeader& header) const;
    void bind(Tree& from, const Tree& to);
    /// Both return whether there is more room now, so that the header is to be uploaded.
    bool make_room(gpu::FrameCommands& commands, const Needs& needs);
    bool follow_needs(gpu::FrameCommands& commands, size_t slot);
    void upload_start(gpu::FrameCommands& commands, std::span<const glm::vec3> places);
    bool rests() const;
    bool teaches() const;
    bool guides() const;
    void follow_gain(const shader::GuidingWork& work);
    /// Frames of which one is enough, by what a frame counted.
    uint32_t turn_for(const shader::GuidingWork& work) const;
    void learn(gpu::FrameCommands& commands, size_t slot, const shader::GuidingSettings& settings);

    const gpu::Device& device_;
    gpu::Buffer unused_;
    std::array<Tree, 2> trees_;
    size_t current_ = 0;
    gpu::Buffer header_buffer_, plan_, samples_, rays_, lists_, work_, first_work_;
    std::vector<gpu::Buffer> statistics_;
    std::vector<bool> counted_;  // statistics of a slot are of the buffers that there are
    gpu::PipelineLayout layout_; // of the passes
    ComputePass mark_, deduplicate_, merge_, guide_, adapt_, augment_;
    Options options_;
    shader::GuidingHeader header_{};
    Needs worst_;
    uint32_t nodes_before_ = 0; // of the frame before the last known
    bool restart_ = true;
    uint32_t still_frames_ = 0; // since something changed, or the octree began
    uint32_t frames_ = 0;       // since Change::Lights, or the octree began
    uint32_t age_ = 0;          // frames since the octree began
    uint64_t samples_ever_ = 0; // that surfaces stored, since frames_ was 0
    bool guiders_begin_ = true; // guiders learn from each frame that they draw rays of
    double gain_ = 1.0;         // of guiders, lately: 1 - the ratio of both spreads (GuidingWork)
    uint32_t turn_ = 1;         // of so many frames one teaches
    uint32_t learned_ = 0;      // frames learned from
};

} // namespace vigil::vkpt
