// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/renderer.h"

#include "common/error.h"
#include "common/log.h"
#include "common/output.h"
#include "common/stopwatch.h"
#include "level/level.h"
#include "refresh/vkpt/export/export_source.h"
#include "refresh/vkpt/frame_params.h"
#include "refresh/vkpt/gpu/first_dispatch.h"
#include "refresh/vkpt/guiding/guiding_counts.h"
#include "refresh/vkpt/pathtrace/first_paths.h"
#include "shared/direction_map.h"
#include "shared/views.h"

#include <algorithm>
#include <cstring>

namespace vigil::vkpt {

namespace {

gpu::DeviceOptions device_options(const refresh::Settings& settings) {
    gpu::DeviceOptions options;
    options.name = settings.vk_device;
    options.validation = settings.vk_validation;
    options.debug_names = settings.vk_debug_names != 0;
    options.cache = settings.vk_cache != 0;
    return options;
}

/// As refresh.h promises.
constexpr size_t max_finished_times = 1024;
/// For the first octree: they take some 10 milliseconds.
constexpr uint32_t first_path_count = 1u << 14;

} // namespace

VkptRenderer::VkptRenderer(FileSystem& files, refresh::SurfaceProvider* surface,
                           const refresh::Settings& settings)
    : files_(files), surface_(surface), settings_(settings),
      device_(device_options(settings), surface),
      compiler_(device_, settings.vk_cache != 0 ? cache_dir() / "pipelines.bin" : ""),
      frames_{gpu::FrameCommands(device_), gpu::FrameCommands(device_)}, waiting_frame_(device_),
      left_(device_, compiler_, frames_in_flight), buffers_(device_, left_.guiding().look_up()),
      path_tracer_(compiler_, buffers_), direction_map_(compiler_, buffers_),
      filter_(device_, compiler_, buffers_), post_(device_, compiler_, buffers_),
      draws_(device_, compiler_) {
    log_info("Vulkan device: {}", device_.description());
    if (surface_) swapchain_.emplace(device_, *surface_, frames_in_flight);
}

VkptRenderer::~VkptRenderer() {
    vkDeviceWaitIdle(device_.handle());
}

void VkptRenderer::load_level(std::shared_ptr<const Level> level,
                              const refresh::Settings& settings) {
    // Everything is made before anything is replaced: a level that fails leaves the one before.
    auto lister = std::make_unique<LightLister>(level->bsp, level->pvs);
    auto scene = std::make_unique<Scene>(device_, files_, level, settings);
    device_.wait_idle();
    left_.clear();
    right_.reset();
    scene_ = std::move(scene);
    lister_ = std::move(lister);
    level_ = std::move(level);
    traced_ = shown_a_frame_ = false;
    accumulated_ = 0;
    first_frame_ = frame_number_;
    accumulation_key_.clear();
    ray_query_failed_ = false;
    if (std::exchange(frame_unfinished_, false)) { // all else is made anew
        buffers_.forget_copies();
        draws_.forget_copies();
    }
    shown_ = {};
    guiding_work_ = {};
    reset_guiding();
}

void VkptRenderer::reset_guiding() {
    if (!scene_) return;
    filter_.forget();
    reset_side(left_);
    if (right_) reset_side(*right_);
}

void VkptRenderer::reset_side(Side& side) {
    // A cube around the world, larger by odd fractions: few walls lie on the borders of its cells.
    const Bounds& bounds = scene_->world_bounds();
    const glm::vec3 extent = bounds.extent();
    const float size = 1.0137f * std::max({extent.x, extent.y, extent.z, 1.0f});
    side.forget(bounds.center() - size * glm::vec3(0.5013f, 0.4991f, 0.5029f), size);
}

refresh::ModelHandle VkptRenderer::register_model(std::string_view name) {
    if (!scene_) fail("{}: no level is loaded", name);
    return scene_->register_model(name);
}

refresh::SkinHandle VkptRenderer::register_skin(std::string_view name) {
    if (!scene_) fail("{}: no level is loaded", name);
    return scene_->register_skin(name);
}

void VkptRenderer::set_sky(std::string_view name, float degrees_per_second, glm::vec3 axis) {
    if (!scene_) fail("sky {}: no level is loaded", name);
    scene_->set_sky(name, degrees_per_second, axis);
}

glm::uvec2 VkptRenderer::screen_size() const {
    if (surface_) {
        const glm::ivec2 size = surface_->framebuffer_size();
        if (size.x > 0 && size.y > 0) return size;
        if (buffers_.picture_size().x > 0)
            return buffers_.picture_size(); // minimised: keep what we have
    }
    return {static_cast<uint32_t>(settings_.vid_width),
            static_cast<uint32_t>(settings_.vid_height)};
}

void VkptRenderer::resize(glm::uvec2 size) {
    // While frames are averaged their size stays.
    resolution_.follow(settings_.vid_scale,
                       settings_.pt_accumulate != 0 ? 0.0f : settings_.vid_fps_target);
    make_buffers(size);
    buffers_.trace(resolution_.traced(size));
}

void VkptRenderer::make_buffers(glm::uvec2 size) {
    const glm::uvec2 most = resolution_.most_traced(size);
    if (size == buffers_.picture_size() && most == buffers_.most_traced() &&
        resolution_.scales() == buffers_.scales())
        return;
    device_.wait_idle();
    // A size that does not fit leaves the old one working.
    gpu::Image picture(device_, size.x, size.y, VK_FORMAT_R8G8B8A8_UNORM,
                       VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                           VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                       "picture");
    buffers_.resize(size, most, resolution_.scales());
    post_.bind();
    draws_.forget_display();
    picture_ = std::move(picture);
    accumulation_key_.clear();
    traced_ = false;
    rebind_ = true;
}

bool VkptRenderer::compares_raw() const {
    return settings_.pt_compare == setting_choice("pt_compare", "raw");
}

uint32_t VkptRenderer::split_column() const {
    const uint32_t width = buffers_.size().x;
    if (!right_ && !compares_raw()) return width;
    return static_cast<uint32_t>(std::lround(settings_.pt_compare_at * static_cast<float>(width)));
}

void VkptRenderer::select_sides() {
    const TechniqueContext context{device_, compiler_, *lister_};
    rebind_ |= left_.select(static_cast<Technique>(settings_.pt_nee), context);
    left_.set_guide(guide());
    const std::optional<TechniqueRow> compared =
        find_technique_row(choice_name(compare_choices, settings_.pt_compare));
    if (right_.has_value() != compared.has_value()) {
        // A side that nobody looks at takes no memory, and begins anew when it comes back.
        device_.wait_idle();
        right_.reset();
        rebind_ = true;
        if (compared) {
            right_.emplace(device_, compiler_, frames_in_flight);
            reset_side(*right_);
        }
    }
    if (!compared) return;
    rebind_ |= right_->select(compared->technique, context);
    right_->set_guide(choose_guide(compared->guide, settings_));
}

void VkptRenderer::prepare_sides(const refresh::Frame& frame) {
    const LightFrame lights{scene_->lights(), frame.view.origin, settings_};
    rebind_ |= left_.technique()->prepare(lights);
    if (right_) rebind_ |= right_->technique()->prepare(lights);
    if (!rebind_) return;
    device_.wait_idle();
    buffers_.bind(*scene_, *left_.technique(), *(right_ ? *right_ : left_).technique());
    rebind_ = false;
}

void VkptRenderer::for_each_side(const std::function<void(Side&)>& what) {
    // A side without pixels rests: it learned nothing from the frame before, and is not looked at.
    const uint32_t split = split_column(), width = buffers_.size().x;
    if (split > 0 || !right_) what(left_);
    if (split < width && right_) what(*right_);
}

void VkptRenderer::prepare_pipelines() {
    for_each_side([&](Side& side) { side.prepare_guiding(buffers_.most_traced(), settings_); });
    const std::vector<PictureSide> sides = picture_sides();
    path_tracer_.prepare(sides);
    if (settings_.pt_view == shader::VIEW_CDQ) direction_map_.prepare(sides);
    filter_.prepare_pipelines();
    post_.prepare(sides, settings_.pt_view);
}

void VkptRenderer::update_sides(gpu::FrameCommands& commands, size_t slot,
                                const FrameDescription& camera) {
    std::vector<glm::vec3> places; // asked for where an octree starts
    for_each_side([&](Side& side) {
        if (side.expects_places() && places.empty())
            places = first_paths(level_->bsp, camera, first_path_count, settings_.pt_bounces);
        side.technique()->adapt(commands);
        side.update_guiding(commands, slot, change_, places);
    });
}

SceneFeatures VkptRenderer::compiled_features(const Side& side) const {
    SceneFeatures features = scene_->compiled_features(settings_);
    features.caches = side.technique()->uses_guiding();
    return features;
}

std::vector<PictureSide> VkptRenderer::picture_sides() const {
    const auto describe = [&](const Side& side, uint32_t first, uint32_t end, bool filtered) {
        const SceneFeatures features = compiled_features(side);
        return PictureSide{{side.id(), features, use_ray_query(settings_), side.guide()},
                           side.technique()->samples_lights() && features.lights,
                           filtered,
                           side.guided(),
                           side.guiding().set(),
                           first,
                           end,
                           filtered ? filter_.indirect_turn() : shader::INDIRECT_ALL};
    };
    const uint32_t split = split_column();
    const uint32_t width = buffers_.size().x;
    std::vector<PictureSide> sides{describe(left_, 0, split, true)};
    if (right_)
        sides.push_back(describe(*right_, split, width, true));
    else if (compares_raw())
        sides.push_back(describe(left_, split, width, false));
    return sides;
}

void VkptRenderer::record_texts(gpu::FrameCommands& commands, std::span<const PictureSide> sides) {
    const glm::uvec2 size = buffers_.picture_size();
    const auto shown = [&](uint32_t column) { // where a traced column is in the picture
        return static_cast<uint32_t>(uint64_t{column} * size.x / buffers_.size().x);
    };
    for (size_t i = 0; i < sides.size(); ++i) {
        const PictureSide& side = sides[i];
        legends_.at(i).record(
            commands, buffers_.display(),
            {settings_.pt_view, side.variant.technique, side.samples_lights, side.guided, size,
             (i == 1 && right_ ? *right_ : left_).technique()->uses_guiding(),
             side.variant.guide.guides(), shown(side.first_column), shown(side.end_column)});
    }
    if (sides.size() < 2) return;
    std::array<std::string, 2> names;
    for (size_t i = 0; i < names.size(); ++i)
        names.at(i) =
            technique_row_name({sides[i].variant.technique, sides[i].variant.guide.guide});
    if (compares_raw()) names = {filter_.on() ? "filtered" : "raw", "raw"};
    side_labels_.record(commands, buffers_.display(), size, shown(split_column()), names);
}

bool VkptRenderer::use_ray_query(const refresh::Settings& settings) const {
    // The compute hierarchy is the default on CPUs, where ray queries are slow, and wherever they
    // are missing.
    const bool offered = device_.features().ray_query && !ray_query_failed_;
    if (settings.pt_trace == setting_choice("pt_trace", "query")) return offered;
    return settings.pt_trace == setting_choice("pt_trace", "auto") && offered &&
           !device_.features().is_cpu;
}

void VkptRenderer::follow_trace_setting() {
    if (settings_.pt_trace == trace_setting_) return;
    trace_setting_ = settings_.pt_trace;
    ray_query_failed_ = false;
    if (trace_setting_ == setting_choice("pt_trace", "query") && !device_.features().ray_query)
        log_warning("pt_trace query: {} lacks VK_KHR_ray_query. Our BVH in compute is used.",
                    device_.properties().deviceName);
}

void VkptRenderer::follow_environment_setting() {
    if (!scene_->follow_environment(settings_)) return;
    // Techniques know lights by their ids, and so do caches.
    device_.wait_idle();
    left_.clear();
    if (right_) right_->clear();
    reset_guiding();
}

bool VkptRenderer::prepare_ray_query() {
    try {
        return scene_->prepare_ray_query(use_ray_query(settings_));
    } catch (const Error& error) {
        log_error("ray queries: {}. Our BVH in compute is used.", error.what());
        ray_query_failed_ = true;
        return scene_->prepare_ray_query(false);
    }
}

GuideChoice VkptRenderer::guide() const {
    return choose_guide(static_cast<Guide>(settings_.pt_guide), settings_);
}

FrameDescription VkptRenderer::frame_params(const refresh::Frame& frame) {
    FrameDescription params{};
    params.settings = gpu_settings(settings_);
    params.exposure_part = 1.0f;
    set_camera(params, frame.view, buffers_.size());
    set_scene(params, *scene_, settings_, frame.time_s);
    return params;
}

void VkptRenderer::update_accumulation(const FrameDescription& params) {
    // The running mean goes on while nothing that the picture depends on has changed, and so does
    // the view's. Tone mapping and views come after the mean. Time only moves textures, which
    // teaches guiding nothing.
    shader::FrameParams relevant = params;
    const float time = scene_->textures_move() ? params.time_s : 0.0f;
    relevant.settings = {}; // compared by what they affect
    const uint64_t more[] = {scene_->revision(), use_ray_query(settings_), split_column()};
    std::vector<std::byte> key(sizeof(relevant) + sizeof(more));
    std::memcpy(key.data(), &relevant, sizeof(relevant));
    std::memcpy(key.data() + sizeof(relevant), more, sizeof(more));
    const uint64_t lights_before = std::exchange(light_places_, scene_->lights().place_revision());
    const uint64_t new_before = std::exchange(new_lights_, scene_->lights().new_revision());
    const bool still = key == accumulation_key_ && same_radiance(settings_, accumulation_settings_);
    change_ = still ? Change::Nothing : Change::Something;
    if (lights_before != light_places_) change_ = Change::Lights;
    if (new_before != new_lights_) change_ = Change::NewLights;
    const bool changed = !still || time != accumulation_time_;
    if (changed || settings_.pt_accumulate == 0) accumulated_ = 0;
    if (changed) view_accumulated_ = 0;
    accumulation_key_ = std::move(key);
    accumulation_settings_ = settings_;
    accumulation_time_ = time;
}

uint64_t VkptRenderer::render(const refresh::Frame& frame) {
    const bool first = scene_ && frame.show_level && !shown_a_frame_;
    if (first && Filter::wanted(frame.settings) && !frame.uncapped) {
        // Nobody sees these: lights are learned, and the filter gets a past.
        for (int i = 0; i < frame.settings.flt_first; ++i)
            draw(frame, false);
    }
    return draw(frame, true);
}

uint64_t VkptRenderer::draw(const refresh::Frame& frame, bool shown) {
    settings_ = frame.settings;
    resize(screen_size());
    const size_t slot = frame_number_ % frames_in_flight;
    gpu::FrameCommands& commands = frames_[slot];
    ImDrawData* overlay = frame.overlay;
    finish_slot(slot);
    draws_.prepare(buffers_.display(), buffers_.picture_size(), frame.draws);
    // Whoever goes on after a frame that failed (a command) would miss what it was to copy.
    if (frame_unfinished_) fail("the frame before this one failed");
    frame_unfinished_ = true;
    const bool traces = scene_ && frame.show_level;
    if (traces) {
        // Bring scene and technique to this frame.
        follow_environment_setting();
        select_sides();
        follow_trace_setting();
        rebind_ |= scene_->prepare(frame);
        rebind_ |= prepare_ray_query();
        rebind_ |= filter_.prepare(settings_, scene_->lights());
        prepare_sides(frame);
        prepare_pipelines();
        overlay = await_pipelines(overlay);
    }
    commands.begin();
    if (traces) {
        FrameDescription params = frame_params(frame);
        update_accumulation(params);
        {
            const PassScope scope(commands, Pass::Upload);
            scene_->upload(commands);
            left_.technique()->upload(commands);
            if (right_) right_->technique()->upload(commands);
        }
        update_sides(commands, slot, params);

        // Trace and finish the picture.
        const bool accumulating = settings_.pt_accumulate != 0;
        params.frame = static_cast<uint32_t>(frame_number_ - first_frame_);
        params.accumulated = accumulated_;
        params.view_accumulated = view_accumulated_;
        params.jitter =
            settings_.pt_jitter == 2 || (settings_.pt_jitter == 1 && accumulating) ? 1u : 0u;
        params.split_column = split_column();
        filter_.describe(params);
        post_.describe(params, settings_.pt_exposure_speed);
        const std::vector<PictureSide> sides = picture_sides();
        record_picture(commands, sides, params, static_cast<uint32_t>(settings_.pt_spp));
        record_texts(commands, sides);
        traced_ = true;
        ++accumulated_;
        const bool maps_directions = params.settings.pt_view == shader::VIEW_CDQ;
        view_accumulated_ = maps_directions ? view_accumulated_ + 1 : 0;
        remember_shown(frame, sides);
        shown_a_frame_ |= shown;
    } else {
        traced_ = !frame.draws.empty();
        if (traced_) record_black(commands);
        shown_ = {};
    }
    draws_.record(commands);
    if (shown) {
        present(commands, overlay, settings_.vid_vsync != 0 && !frame.uncapped);
    } else {
        commands.submit(VK_NULL_HANDLE, gpu::Swapchain::wait_stage, VK_NULL_HANDLE);
    }
    frame_unfinished_ = false;
    slot_frames_[slot] = {frame_number_, shown_.guided, shown_.right, resolution_.scale(),
                          device_.usage().take_uploads()};
    return frame_number_++;
}

void VkptRenderer::record_picture(gpu::FrameCommands& commands, std::span<const PictureSide> sides,
                                  const FrameDescription& params, uint32_t paths) {
    const int view = params.settings.pt_view;
    buffers_.describe(commands, params);
    path_tracer_.record(commands, sides, paths);
    if (view == shader::VIEW_CDQ) direction_map_.record(commands, sides, paths);
    if (params.filter_flags != 0) filter_.record(commands, sides, paths);
    post_.record(commands, sides, view, paths);
}

void VkptRenderer::record_black(gpu::FrameCommands& commands) {
    const VkCommandBuffer buffer = commands.commands();
    constexpr uint32_t black = 0xff000000;
    vkCmdFillBuffer(buffer, buffers_.display().handle(), 0, VK_WHOLE_SIZE, black);
}

void VkptRenderer::remember_shown(const refresh::Frame& frame, std::span<const PictureSide> sides) {
    const size_t shown = crosshair_side(sides, buffers_.size());
    shown_.right = shown == 1;
    const PictureSide& side = sides[shown];
    shown_.guided = side.guided;
    shown_.bucket_size = static_cast<uint32_t>(settings_.pt_vlc_bucket);
    shown_.guide = side.variant.guide;
    const auto shines = [](const auto& light) { return light.radius > 0.0f; };
    shown_.dynamic_lights =
        static_cast<size_t>(std::ranges::count_if(frame.dynamic_lights, shines) +
                            std::ranges::count_if(frame.beams, is_visible) +
                            std::ranges::count_if(frame.spots, shines));
}

ImDrawData* VkptRenderer::await_pipelines(ImDrawData* overlay) {
    constexpr std::chrono::milliseconds interval(100);
    if (watcher_ == nullptr) return overlay; // binding them waits
    const Stopwatch watch;
    const auto report = [&] {
        refresh::Compilation state = compiler_.state();
        state.seconds = watch.seconds();
        return watcher_->compiling(state);
    };
    bool watched = false;
    while (!compiler_.wait_for(interval)) {
        if (!watched) device_.wait_idle(); // the overlay counts the frames in flight
        watched = true;
        show_wait(report());
    }
    // A driver that compiles at the first dispatch: one shader after the other, so that the window
    // is drawn between them and answers meanwhile.
    while (const auto job = compiler_.begin_first_dispatch()) {
        if (watched) show_wait(report());
        device_.wait_idle();
        {
            gpu::FirstDispatch dispatch(device_, waiting_frame_, *job);
            while (!dispatch.wait_for(interval)) {
                watched = true;
                report();
            }
        }
        compiler_.finish_first_dispatch(job);
    }
    if (!watched) return overlay;
    waiting_frame_.finish();
    return report();
}

void VkptRenderer::show_wait(ImDrawData* overlay) {
    if (!surface_) return;
    waiting_frame_.begin();
    present(waiting_frame_, overlay, false);
}

void VkptRenderer::present(gpu::FrameCommands& commands, ImDrawData* overlay, bool vsync) {
    const VkCommandBuffer buffer = commands.commands();
    // From the buffer of pixels to the image that the overlay is drawn on.
    gpu::barrier(buffer, gpu::access_of_shaders | gpu::access_of_copies, gpu::access_of_copies);
    gpu::transition(buffer, picture_.handle(), VK_IMAGE_LAYOUT_UNDEFINED,
                    VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    if (traced_) {
        VkBufferImageCopy region{};
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageExtent = {picture_.width(), picture_.height(), 1};
        vkCmdCopyBufferToImage(buffer, buffers_.display().handle(), picture_.handle(),
                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    } else {
        const VkClearColorValue black{};
        const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCmdClearColorImage(buffer, picture_.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                             &black, 1, &all);
    }
    gpu::transition(buffer, picture_.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                    VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    if (overlay) {
        if (!overlay_) overlay_.emplace(device_, picture_.format(), frames_in_flight);
        const PassScope scope(commands, Pass::Overlay);
        overlay_->draw(buffer, picture_, overlay);
    }
    std::optional<gpu::SwapchainTarget> target;
    if (swapchain_) target = swapchain_->acquire(vsync);
    if (target) {
        const PassScope scope(commands, Pass::Present);
        swapchain_->blit(buffer, *target, picture_);
    }
    commands.submit(target ? target->acquired : VK_NULL_HANDLE, gpu::Swapchain::wait_stage,
                    target ? target->finished : VK_NULL_HANDLE);
    if (target) swapchain_->present(*target);
}

void VkptRenderer::finish_slot(size_t slot) {
    if (!frames_[slot].finish()) return;
    refresh::FrameTimes times;
    times.frame = slot_frames_[slot].number;
    for (const auto& [name, bytes] : std::exchange(slot_frames_[slot].uploads, {}))
        times.uploads.push_back({name, bytes});
    double whole = 0.0;
    for (size_t pass = 0; pass < std::size(pass_names); ++pass) {
        const double milliseconds = frames_[slot].timer().milliseconds(static_cast<uint32_t>(pass));
        if (static_cast<Pass>(pass) != Pass::Present) whole += milliseconds;
        if (milliseconds > 0.0)
            times.passes.push_back(
                {std::string(pass_names[pass]), milliseconds, pass_groups[pass]});
    }
    resolution_.learn(whole, slot_frames_[slot].scale);
    if (slot_frames_[slot].guided) {
        guiding_work_ =
            (slot_frames_[slot].right && right_ ? *right_ : left_).guiding().statistics(slot);
        times.counts = guiding_counts(guiding_work_);
    }
    if (finished_times_.size() == max_finished_times) finished_times_.pop_front();
    finished_times_.push_back(std::move(times));
}

std::vector<refresh::FrameTimes> VkptRenderer::take_frame_times(bool wait) {
    // Slots take turns, so the one that the next frame will use holds the older frame.
    for (size_t i = 0; wait && i < frames_in_flight; ++i)
        finish_slot((frame_number_ + i) % frames_in_flight);
    std::vector<refresh::FrameTimes> times(finished_times_.begin(), finished_times_.end());
    finished_times_.clear();
    return times;
}

uint32_t VkptRenderer::nonfinite_count() const {
    device_.wait_idle();
    return gpu::download_now_as<shader::FrameCounters>(device_, buffers_.counters(), 0, 1)[0]
        .nonfinite;
}

refresh::Health VkptRenderer::health() const {
    return {nonfinite_count(), device_.validation_messages()};
}

void VkptRenderer::export_scene(const refresh::Frame& frame, const std::string& path) {
    if (!scene_) fail("no level is loaded");
    settings_ = frame.settings;
    resize(screen_size());
    follow_environment_setting();
    select_sides();
    rebind_ |= scene_->prepare(frame);
    const ExportSummary summary =
        write_gltf(export_scene_of(*scene_, frame_params(frame), settings_), path);
    log_info("wrote {}: {} triangles in {} files, {:.1f} MiB", path, summary.triangles,
             summary.files, static_cast<double>(summary.bytes) / 1048576.0);
}

} // namespace vigil::vkpt

namespace vigil::refresh {

std::unique_ptr<Renderer> make_vkpt_renderer(FileSystem& files, SurfaceProvider* surface,
                                             const Settings& settings) {
    return std::make_unique<vkpt::VkptRenderer>(files, surface, settings);
}

} // namespace vigil::refresh
