// SPDX-License-Identifier: GPL-2.0-or-later
#include "render_test.h"

#include "common/scratch_folder.h"
#include "gpu/validated.h"
#include "refresh/vkpt/gpu/commands.h"
#include "shared/firewall.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <optional>

namespace vigil::test {

namespace {

struct Shared {
    ScratchFolder folder; // files that tests add
    FileSystem files;
    std::unique_ptr<vkpt::VkptRenderer> renderer;
};
std::optional<Shared> shared; // between SetUp and TearDown of the environment

bool has_validation_layer() {
    uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    for (const VkLayerProperties& layer : layers)
        if (std::strcmp(layer.layerName, "VK_LAYER_KHRONOS_validation") == 0) return true;
    return false;
}

/// Makes the renderer before the first test and destroys it after the last.
class DeviceEnvironment : public testing::Environment {
public:
    void SetUp() override {
        ASSERT_TRUE(has_validation_layer())
            << "without its layer nothing is validated: install vulkan-validationlayers";
        // The caches of the tests are not the user's. Mesa's does not tell widths of vectors apart.
        const char* width = std::getenv("LP_NATIVE_VECTOR_WIDTH");
        const std::string cache =
            (std::filesystem::current_path() / (std::string("test-cache") + (width ? width : "")))
                .string();
        setenv("XDG_CACHE_HOME", cache.c_str(), 1);
        shared.emplace();
        shared->files.mount_game(std::filesystem::path(VIGIL_SOURCE_DIR) / "tests" / "data",
                                 "baseq2");
        cvars().set("vk_validation", std::to_string(validation()));
        shared->renderer =
            std::make_unique<vkpt::VkptRenderer>(shared->files, nullptr, cvars().values());
    }
    void TearDown() override { shared.reset(); }
};

const auto* const environment = testing::AddGlobalTestEnvironment(new DeviceEnvironment);

} // namespace

refresh::Frame Shot::frame() const {
    refresh::Frame frame;
    frame.settings = cvars().values();
    frame.view = view;
    frame.entities = entities;
    frame.dynamic_lights = dynamic_lights;
    frame.spots = spots;
    frame.time_s = time_s;
    frame.light_styles.fill(1.0f);
    for (const int style : dark_styles)
        frame.light_styles[static_cast<size_t>(style)] = 0.0f;
    return frame;
}

void RenderTest::SetUp() {
    ASSERT_TRUE(shared && shared->renderer);
    for (const CvarInfo& info : cvar_infos)
        if (info.life != CvarLife::Start) cvars().reset(info.name);
    // What learns from frames is asked for by those tests that are about it.
    set("pt_nee", "sll");
    set("pt_guide", "brdf");
    set_size(48, 32);
    set("pt_jitter", "0");
    if (const char* features = std::getenv("VIGIL_TEST_FEATURES")) set("pt_features", features);
    // Levels of tests are small: lists would do, and frames few.
    set("pt_vlc_enough", "0");
    set("pt_learn_every", "1");
    set("flt_enable", "0");
    set("flt_first", "0");
}

void RenderTest::TearDown() {
    if (!shared || !shared->renderer) return;
    EXPECT_EQ(renderer().device().validation_messages(), 0);
    EXPECT_EQ(renderer().nonfinite_count(), 0u);
}

vkpt::VkptRenderer& RenderTest::renderer() {
    return *shared->renderer;
}

FileSystem& RenderTest::files() {
    return shared->files;
}

void RenderTest::set_size(int width, int height) {
    set("vid_width", std::to_string(width));
    set("vid_height", std::to_string(height));
}

void RenderTest::write_game_file(std::string_view name, std::span<const uint8_t> bytes) {
    shared->folder.write(name, bytes);
    shared->files.mount_folder(shared->folder.path()); // to see what is new
}

void RenderTest::load(std::string_view name, const Edit& edit) {
    auto changed = std::make_shared<Level>(*load_level(files(), name));
    if (edit) edit(*changed);
    level_ = changed;
    renderer().load_level(level_, cvars().values());
}

void RenderTest::load_with_materials(std::string_view name, std::string_view text) {
    const auto write = [](std::string_view materials) {
        write_game_file("materials.json",
                        {reinterpret_cast<const uint8_t*>(materials.data()), materials.size()});
    };
    write(text);
    load(name);
    write("{}");
}

refresh::RadiancePicture RenderTest::radiance(const Shot& shot) {
    renderer().render(shot.frame());
    return renderer().read_radiance();
}

PictureBatches RenderTest::batches(const Shot& shot, int batches, int paths, int seed, int block) {
    PictureBatches result(cvars()->vid_width, cvars()->vid_height, block);
    set("pt_spp", "1");
    learn(shot, frames_to_learn);
    vkpt::FrameDescription frame = params(shot);
    for (int batch = 0; batch < batches; ++batch) {
        frame.settings.pt_seed = seed + batch;
        result.add(trace(frame, static_cast<uint32_t>(paths)));
    }
    return result;
}

int RenderTest::subgroup_factor() {
    return renderer().device().features().subgroup_size > 8 ? 2 : 1;
}

void RenderTest::learn(const Shot& shot, int frames) {
    radiance(shot);
    if (!renderer().guided() && !renderer().technique()->learns()) return;
    vkpt::FrameDescription frame = params(shot);
    renderer().reset_guiding();
    gpu::FrameCommands commands(renderer().device());
    for (int i = 0; i <= frames; ++i) {
        adapt(commands);
        frame.frame = static_cast<uint32_t>(i);
        if (i < frames) trace(frame, 1);
    }
}

shader::GuidingWork RenderTest::adapt(gpu::FrameCommands& commands) {
    renderer().device().wait_idle();
    commands.begin();
    renderer().technique()->adapt(commands);
    if (renderer().guided()) renderer().guiding().record(commands, 0, vkpt::Change::Something);
    commands.submit(VK_NULL_HANDLE, 0, VK_NULL_HANDLE);
    commands.finish();
    return renderer().guiding().statistics(0);
}

vkpt::FrameDescription RenderTest::params(const Shot& shot) {
    vkpt::FrameDescription params{};
    params.settings = gpu_settings(cvars().values());
    vkpt::set_camera(params, shot.view, renderer().buffers().size());
    vkpt::set_scene(params, *renderer().scene(), cvars().values(), shot.time_s);
    return params;
}

std::vector<float> RenderTest::trace(const vkpt::FrameDescription& params, uint32_t paths,
                                     LightSamples light_samples) {
    const auto technique = static_cast<Technique>(cvars()->pt_nee);
    return trace(params, {technique, renderer().compiled_features(), false, renderer().guide()},
                 paths,
                 light_samples == LightSamples::All && renderer().technique()->samples_lights());
}

std::vector<float> RenderTest::trace(const vkpt::FrameDescription& params,
                                     const vkpt::PathTracerVariant& variant, uint32_t paths,
                                     bool samples_lights) {
    const gpu::Device& device = renderer().device();
    device.wait_idle();
    const vkpt::FrameBuffers& buffers = renderer().buffers();
    const vkpt::PictureSide whole{variant,
                                  samples_lights && variant.features.lights,
                                  false,
                                  false,
                                  renderer().guiding().set(),
                                  0,
                                  buffers.size().x};
    gpu::FrameCommands commands(device);
    commands.begin();
    renderer().record_picture(commands, std::span(&whole, 1), params, paths);
    commands.submit(VK_NULL_HANDLE, 0, VK_NULL_HANDLE);
    commands.finish();
    return gpu::download_now_as<float>(device, buffers.mean_radiance(), 0,
                                       uint64_t{3} * buffers.size().x * buffers.size().y);
}

std::vector<shader::PrimaryHit> RenderTest::primary_hits() {
    const vkpt::FrameBuffers& buffers = renderer().buffers();
    return gpu::download_now_as<shader::PrimaryHit>(renderer().device(), buffers.primary_hits(), 0,
                                                    uint64_t{buffers.size().x} * buffers.size().y);
}

std::vector<uint32_t> RenderTest::pixel_flags() {
    const vkpt::FrameBuffers& buffers = renderer().buffers();
    return gpu::download_now_as<uint32_t>(renderer().device(), buffers.pixel_flags(), 0,
                                          uint64_t{buffers.size().x} * buffers.size().y);
}

bool all_finite_nonnegative(std::span<const float> values) {
    return std::ranges::all_of(values,
                               [](float value) { return shader::is_finite_nonnegative(value); });
}

double sum_of(std::span<const float> values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

std::vector<BspTexInfo*> texinfos_of(Level& level, std::string_view texture) {
    std::vector<BspTexInfo*> found;
    for (BspTexInfo& info : level.bsp.texinfos)
        if (info.texture == texture) found.push_back(&info);
    return found;
}

} // namespace vigil::test
