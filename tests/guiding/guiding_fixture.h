// SPDX-License-Identifier: GPL-2.0-or-later
// Runs the guiding passes on a GPU under validation, one frame at a time, and demands after each
// frame that trees, caches and statistics are the oracle's. Takes the path tracer's place: tests
// put the samples into the leaves.
#pragma once

#include "refresh/vkpt/guiding/guiding.h"
#include "tree_words.h"

#include <gtest/gtest.h>

namespace vigil::test {

class GuidingTest : public testing::Test {
protected:
    static void SetUpTestSuite();
    static void TearDownTestSuite();
    void SetUp() override;
    void TearDown() override;

    static vkpt::Guiding& guiding();
    static const gpu::Device& device();

    /// Makes room for a picture this wide and high; starts with the root divided once and runs a
    /// frame on it.
    /// With `cdq_bits`, its nodes have quadtrees of so many bits.
    void start(const shader::GuidingSettings& settings, uint32_t picture_size = 256,
               uint32_t cdq_bits = 0);
    /// Takes other settings that make the octree start anew by themselves, and runs a frame.
    void start_anew(const shader::GuidingSettings& settings);

    /// The same, but with the tree for samples at these places. Runs the frame that gives
    /// its leaves room.
    void start_with(const shader::GuidingSettings& settings, std::span<const glm::vec3> places,
                    uint32_t picture_size);

    /// The smallest cell that holds a position.
    static glm::uvec3 cell_of(glm::vec3 position);
    /// Stores a sample as the path tracer does.
    void place(glm::vec3 position, uint32_t light_sample);
    /// Random samples in every leaf of a tree, then a frame.
    void random_frame(Dice& dice, const InnerNodes& inner, const RandomLights& lights);

    /// Writes state_ to the GPU's buffers.
    void upload();
    /// Runs the passes on what is there, whatever they make.
    void run_passes(std::span<const glm::vec3> places = {});
    /// Uploads, runs the passes, compares what they made with the oracle, and makes that the next
    /// frame's state_.
    void frame();
    /// The same, and before the GPU is done a second frame that gets no samples.
    void two_frames_in_flight();

    TreeState state_;                  // what the next frame starts from
    AdaptedOctree tree_;               // made in the last frame
    Caches caches_;                    // on the tree before
    AdaptedByNode quadtrees_;          // on the tree before, if nodes have quadtrees
    ByPath<ShareState> shares_;        // the same for shares that are learned
    shader::GuidingWork statistics_{}; // seen in the last frame
    shader::GuidingSettings settings_{};
    uint32_t first_cache_part_ = 1; // start() makes room for all caches
    bool appears_ = false;          // a light does in the next frame

private:
    static void restart();
    void prepare(const shader::GuidingSettings& settings);
    /// Takes the tree that the first frame made, which has no samples, as the next one's state_.
    void take_first_tree();
    /// Whether quadtrees keep sums from frame to frame.
    bool remember() const { return cdq_bits_ > 0 && settings_.memory_rays > 0; }
    /// What the oracle makes of state_: tree_ and caches_.
    void ask_oracle();
    void compare_with(const vkpt::Guiding::Tree& old_tree);

    Dice garbage_{99};
    uint32_t picture_size_ = 0;
    uint32_t cdq_bits_ = 0;
    bool appeared_ = false; // a light did in the frame whose samples the next one learns from
    int frame_ = 0;
};

/// Most lights in a bucket, the hysteresis' 75%, and thresholds that random samples come near to.
shader::GuidingSettings settings_with(uint32_t bucket, uint32_t persist = 0);

} // namespace vigil::test
