// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/filter/filter.h"

#include "common/error.h"
#include "common/log.h"

#include "shared/filter_types.h"

namespace vigil::vkpt {

namespace {

/// Part number `index` of the Halton sequence of this base, in (0, 1).
float halton(uint32_t index, uint32_t base) {
    float part = 1.0f, sum = 0.0f;
    for (++index; index > 0; index /= base) {
        part /= static_cast<float>(base);
        sum += part * static_cast<float>(index % base);
    }
    return sum;
}

/// Points in a pixel, one a frame, after which they repeat: as many as temporal anti-aliasing
/// remembers.
constexpr uint32_t pixel_points = 16;

glm::uvec2 filter_tiles(glm::uvec2 size) {
    constexpr auto edge = static_cast<uint32_t>(shader::FILTER_TILE);
    return (size + (edge - 1)) / edge;
}

static_assert(sizeof(shader::FilterSurface) == 16 && sizeof(shader::FilterHistory) == 16 &&
              sizeof(shader::FilterStatistics) == 16 && sizeof(shader::FilterTile) == 32);

std::vector<gpu::BindingKind> binding_kinds() {
    std::vector<gpu::BindingKind> kinds(FILTER_BINDING_COUNT, gpu::BindingKind::Storage);
    for (const uint32_t records : {BINDING_FILTER_SURFACE_RECORDS, BINDING_FILTER_HISTORY_RECORDS,
                                   BINDING_FILTER_STATISTICS_RECORDS, BINDING_FILTER_LIGHT_RECORDS,
                                   BINDING_FILTER_TILE_RECORDS, BINDING_FILTER_RESOLVED_RECORDS})
        kinds[records] = gpu::BindingKind::Records;
    return kinds;
}

} // namespace

Filter::Filter(const gpu::Device& device, gpu::PipelineCompiler& compiler, FrameBuffers& buffers)
    : device_(device), buffers_(buffers), unused_(device, 16, gpu::MemoryUse::Device, "unused"),
      set_(device, binding_kinds(), unused_, "filter set"),
      layout_(device, {&buffers.scene_set(), &set_}), light_changes_(device, "light changes"),
      tiles_(Pass::FilterTiles, compiler, layout_),
      temporal_(Pass::FilterTemporal, compiler, layout_),
      atrous_(Pass::FilterAtrous, compiler, layout_),
      compose_(Pass::FilterCompose, compiler, layout_),
      taa_pass_(Pass::FilterTaa, compiler, layout_) {}

void Filter::forget() {
    has_past_ = false;
    frame_ = 0; // the same points in pixels again
    changes_.forget();
}

bool Filter::wanted(const refresh::Settings& settings) {
    return settings.flt_enable != 0 && settings.pt_accumulate == 0;
}

Filter::Kept Filter::make_buffers() const {
    const uint64_t pixels = uint64_t{buffers_.most_traced().x} * buffers_.most_traced().y;
    const glm::uvec2 tiles = filter_tiles(buffers_.most_traced());
    const auto make = [&](uint64_t bytes, const char* name) {
        return gpu::Buffer(device_, bytes, gpu::MemoryUse::Device, name);
    };
    return {make(2 * pixels * sizeof(shader::FilterSurface), "filter surfaces"),
            make(2 * pixels * sizeof(shader::FilterHistory), "filter history"),
            make(2 * pixels * sizeof(shader::FilterStatistics), "filter statistics"),
            make(2 * pixels * sizeof(glm::uvec4), "filter light"),
            make(2 * pixels * sizeof(glm::uvec2), "filter resolved"),
            make(uint64_t{tiles.x} * tiles.y * sizeof(shader::FilterTile), "filter tiles")};
}

bool Filter::prepare(const refresh::Settings& settings, const LightSet& lights) {
    const bool rebind = follow(settings);
    changed_ =
        on_ && settings.flt_antilag != 0 && changes_.update(lights.lights(), lights.revision());
    if (changed_ && light_changes_.set(std::as_bytes(changes_.factors()))) {
        device_.wait_idle();
        set_.bind(BINDING_FILTER_LIGHT_CHANGES, light_changes_.buffer());
    }
    return rebind;
}

bool Filter::follow(const refresh::Settings& settings) {
    const bool wanted = Filter::wanted(settings);
    steps_ = settings.flt_atrous;
    taa_ = settings.flt_taa != 0;
    jitters_ = settings.pt_jitter != 0;
    halves_indirect_ = settings.pt_indirect_rate == setting_choice("pt_indirect_rate", "half");
    if (!wanted || failed_size_ != buffers_.most_traced()) failed_size_.reset();
    const bool on = wanted && !failed_size_;
    if (on == on_ && (!on || size_ == buffers_.most_traced())) return false;
    // Sizes and bindings change: the GPU must be idle.
    device_.wait_idle();
    on_ = false;
    forget();
    kept_ = {};
    buffers_.keep_filter_input(false);
    if (!on) return true;
    try {
        kept_ = make_buffers();
        buffers_.keep_filter_input(true);
        set_.bind(BINDING_FILTER_SURFACES, kept_.surfaces);
        set_.bind(BINDING_FILTER_HISTORY, kept_.history);
        set_.bind(BINDING_FILTER_LIGHT, kept_.light);
        set_.bind(BINDING_FILTER_RESOLVED, kept_.resolved);
        set_.bind(BINDING_FILTER_TILES, kept_.tiles);
        set_.bind(BINDING_FILTER_STATISTICS, kept_.statistics);
        set_.bind(BINDING_FILTER_SURFACE_RECORDS, kept_.surfaces);
        set_.bind(BINDING_FILTER_HISTORY_RECORDS, kept_.history);
        set_.bind(BINDING_FILTER_STATISTICS_RECORDS, kept_.statistics);
        set_.bind(BINDING_FILTER_LIGHT_RECORDS, kept_.light);
        set_.bind(BINDING_FILTER_TILE_RECORDS, kept_.tiles);
        set_.bind(BINDING_FILTER_RESOLVED_RECORDS, kept_.resolved);
        size_ = buffers_.most_traced();
        on_ = true;
    } catch (const Error& error) {
        log_warning("the picture is not filtered: {}", error.what());
        kept_ = {};
        failed_size_ = buffers_.most_traced();
    }
    return true;
}

void Filter::prepare_pipelines() {
    if (!on_) return;
    tiles_.choose();
    if (taa_) taa_pass_.choose();
    temporal_.choose();
    if (steps_ > 0) atrous_.choose();
    compose_.choose();
}

void Filter::describe(FrameDescription& params) {
    indirect_turn_ = on_ && halves_indirect_ ? shader::indirect_turn_of_frame(frame_, pixel_points)
                                             : shader::INDIRECT_ALL;
    if (!on_) {
        has_past_ = false;
        return;
    }
    params.filter_flags = shader::FILTER_ON;
    if (has_past_) params.filter_flags |= shader::FILTER_HISTORY;
    if (taa_) {
        params.filter_flags |= shader::FILTER_TAA;
        const uint32_t point = frame_ % pixel_points;
        if (jitters_) params.pixel_point = {halton(point, 2), halton(point, 3)};
    }
    if (changed_) params.filter_flags |= shader::FILTER_CHANGES;
    params.filter_half = frame_ & 1;
    params.filter_capacity = size_.x * size_.y;
    params.last_size = last_.size;
    params.last_pixel_point = last_.pixel_point;
    params.last_camera_origin = last_.camera_origin;
    params.last_camera_forward = last_.camera_forward;
    params.last_camera_right = last_.camera_right;
    params.last_camera_up = last_.camera_up;
    last_ = params;
    has_past_ = true;
    ++frame_;
}

void Filter::record(gpu::FrameCommands& commands, std::span<const PictureSide> sides,
                    uint32_t paths) {
    if (!on_) return;
    prepare_pipelines();
    const auto record_pass = [&](const ComputePass& pass, size_t side, int step,
                                 gpu::WorkGroups groups) {
        FrameBuffers::SideInputs inputs = buffers_.side(sides, side, paths, paths);
        inputs.push.filter_step = static_cast<uint32_t>(step);
        inputs.push.filter_stride = step + 1 < steps_ ? 1u << step : 1u;
        const std::array<VkDescriptorSet, 2> sets{inputs.sets[0], set_.handle()};
        pass.record(commands, {sets, gpu::bytes_of_value(inputs.push)}, groups);
    };
    if (changed_) light_changes_.upload(commands);
    record_pass(tiles_, 0, 0, {{(filter_tiles(buffers_.size()) + 7u) / 8u, 1}});
    record_pass(temporal_, 0, 0, buffers_.groups());
    for (int step = 0; step < steps_; ++step)
        record_pass(atrous_, 0, step, buffers_.groups());
    for (const ComputePass* pass : {&compose_, taa_ ? &taa_pass_ : nullptr})
        for (size_t side = 0; side < sides.size() && pass != nullptr; ++side)
            if (sides[side].filtered && sides[side].first_column < sides[side].end_column)
                record_pass(*pass, side, steps_, buffers_.groups(sides[side]));
}

uint64_t Filter::bytes() const {
    if (!on_) return 0;
    return buffers_.filter_input().bytes() + kept_.surfaces.bytes() + kept_.history.bytes() +
           kept_.statistics.bytes() + kept_.light.bytes() + kept_.resolved.bytes() +
           kept_.tiles.bytes();
}

} // namespace vigil::vkpt
