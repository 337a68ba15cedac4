// SPDX-License-Identifier: GPL-2.0-or-later
// Fixture of the GPU tests: one headless renderer per test binary under core and synchronisation
// validation, with the game data of tests/data. Every test ends with no validation message and no
// value that was not finite.
#pragma once

#include "common/file_system.h"
#include "console/cvar.h"
#include "judge.h"
#include "level/level.h"
#include "refresh/vkpt/frame_params.h"
#include "refresh/vkpt/renderer.h"

#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace vigil::test {

/// What a frame shows; owns what refresh::Frame only points to.
struct Shot {
    refresh::View view;
    std::vector<refresh::Entity> entities;
    std::vector<refresh::DynamicLight> dynamic_lights;
    double time_s = 0.0;
    std::vector<int> dark_styles{}; // light styles that are off; all others shine
    std::vector<refresh::Spot> spots{};
    refresh::Frame frame() const;
};

class RenderTest : public testing::Test {
protected:
    using Edit = std::function<void(Level&)>;

    /// All variables at their defaults but for the picture's size (48 x 32), pixel centres for
    /// camera rays, and the filter, which is off.
    void SetUp() override;
    void TearDown() override;

    static vkpt::VkptRenderer& renderer();
    static FileSystem& files();
    static void set(std::string_view name, std::string_view value) { cvars().set(name, value); }
    static void set_size(int width, int height);

    /// Lays a file over the game data until the program ends.
    static void write_game_file(std::string_view name, std::span<const uint8_t> bytes);

    /// Loads maps/NAME of tests/data, changed by `edit` before the renderer sees it.
    void load(std::string_view name, const Edit& edit = {});
    /// The same where materials.json has this text.
    void load_with_materials(std::string_view name, std::string_view text);
    const Level& level() const { return *level_; }

    /// One frame's radiance.
    static refresh::RadiancePicture radiance(const Shot& shot);
    /// What the camera rays of the last frame hit, and what became of each pixel's paths (PIXEL_*).
    static std::vector<shader::PrimaryHit> primary_hits();
    static std::vector<uint32_t> pixel_flags();
    /// `batches` pictures of `paths` paths per pixel with seeds seed, seed + 1, ..., after
    /// learning; the same whatever was rendered before.
    static PictureBatches batches(const Shot& shot, int batches, int paths, int seed, int block);

    /// Brings the scene to this shot and, if the technique learns, its caches: from nothing, over
    /// `frames` frames of it. The same whatever was rendered before.
    static void learn(const Shot& shot, int frames);
    static constexpr int frames_to_learn = 10;
    /// How many times as many samples of `vlc` show a bias in a few blocks as surely as with
    /// lavapipe's subgroups of 8. The pixels of a subgroup explore together: the larger it is, the
    /// fewer errors of a block are independent.
    static int subgroup_factor();
    /// Runs the passes that learn from what was traced last, the technique's and the octree's;
    /// returns what the latter counted. `commands` are free before and after.
    static shader::GuidingWork adapt(gpu::FrameCommands& commands);

    /// Parameters of a frame as the renderer would make them, for `trace`.
    static vkpt::FrameDescription params(const Shot& shot);
    /// Runs the path tracer's passes by themselves, as those of the frame that was rendered last,
    /// on its scene and bindings; returns its radiance.
    enum class LightSamples { All, Indirect }; // Indirect: none at primary hits
    static std::vector<float> trace(const vkpt::FrameDescription& params, uint32_t paths,
                                    LightSamples light_samples = LightSamples::All);
    /// The same of any variant; `samples_lights` as the technique says.
    static std::vector<float> trace(const vkpt::FrameDescription& params,
                                    const vkpt::PathTracerVariant& variant, uint32_t paths,
                                    bool samples_lights);

private:
    std::shared_ptr<const Level> level_;
};

/// Whether every value is finite and none is negative.
bool all_finite_nonnegative(std::span<const float> values);
double sum_of(std::span<const float> values);

/// The texinfos whose texture is `texture`.
std::vector<BspTexInfo*> texinfos_of(Level& level, std::string_view texture);

} // namespace vigil::test
