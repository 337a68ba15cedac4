// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/quality_renderer.h"

#include "bench/quality_estimate.h"
#include "common/error.h"
#include "common/log.h"
#include "common/stopwatch.h"
#include "console/cvar.h"
#include "console/outdir.h"
#include "formats/bsp_query.h"
#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/gpu/passes.h"
#include "refresh/vkpt/gpu/shader_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

namespace vigil::bench {

namespace {

/// pt_seed of a reference's first batch; measured frames have smaller ones.
constexpr int first_reference_seed = 1 << 30;

/// Number of the pass, from its name in refresh/vkpt/gpu/passes.h.
std::size_t pass_index(std::string_view name) {
    const auto found = std::ranges::find(vkpt::pass_names, name);
    return static_cast<std::size_t>(found - std::begin(vkpt::pass_names));
}

/// So that every shader is compiled by itself before its frame, and its time is known.
class SilentWatcher : public refresh::CompilationWatcher {
public:
    ImDrawData* compiling(const refresh::Compilation&) override { return nullptr; }
};

std::uint64_t shader_hash(const std::string& technique, const std::string& guider) {
    std::uint64_t hash = hash_bytes({});
    for (const std::string& name :
         {std::string("primary"), "direct." + technique, "indirect." + technique + "." + guider})
        for (const char* backend : {"", ".query"})
            hash = hash_bytes(std::as_bytes(vkpt::shader_code(name + backend)), hash);
    return hash;
}

/// Times of frames of which one in pt_learn_every learns, each as the mean of so many.
std::vector<double> over_turns(std::span<const double> frames) {
    return running_means(frames, static_cast<std::size_t>(cvars()->pt_learn_every));
}

} // namespace

std::string SceneChange::text() const {
    std::string text;
    if (lamp)
        text += fmt::format(" lamp {} {} {} radius {} radiance {} {} {}", lamp->origin.x,
                            lamp->origin.y, lamp->origin.z, lamp->radius, lamp->radiance.x,
                            lamp->radiance.y, lamp->radiance.z);
    if (hidden >= 0) text += fmt::format(" without {}", hidden);
    if (brightness != 1.0f) text += fmt::format(" styles times {}", brightness);
    return text;
}

double group_ms(std::span<const double> pass_ms, refresh::PassGroup group) {
    double sum = 0.0;
    for (std::size_t pass = 0; pass < pass_ms.size(); ++pass)
        if (vkpt::pass_groups[pass] == group) sum += pass_ms[pass];
    return sum;
}

QualityRenderer::QualityRenderer(const QualityOptions& options, const std::string& level)
    : level_name_(level) {
    const std::filesystem::path basedir = folder_with(options.basedirs, level);
    if (basedir.empty())
        fail("maps/{}.bsp is in none of the folders (--basedir FOLDER names one)", level);
    cvars().set("vid_width", std::to_string(options.size.x));
    cvars().set("vid_height", std::to_string(options.size.y));
    if (cvars()->pt_jitter == 1)
        fail("pt_jitter 1 moves the pixels of references only; set 0 or 2");
    const auto add_base = [&](const QualityRow& row) {
        for (const Setting& setting : row.settings)
            base_.push_back({setting.name, cvars().get_text(setting.name)});
    };
    std::ranges::for_each(options.rows, add_base);
    add_base(options.reference);
    for (const char* name : {"pt_nee", "pt_spp"}) // references set them
        base_.push_back({name, cvars().get_text(name)});

    files_.mount_game(basedir, "baseq2");
    renderer_ = std::make_unique<vkpt::VkptRenderer>(files_, nullptr, cvars().values());
    if (options.measured == Measured::Economy) {
        watcher_ = std::make_unique<SilentWatcher>();
        renderer_->watch_compilation(watcher_.get());
    }
    session_ = std::make_unique<client::Session>(files_, *renderer_, cvars());
    session_->load_map(level);

    const std::string route = fmt::format("routes/{}.route", level);
    places_ = files_.exists(route)
                  ? route_places(client::Route::parse(route, files_.read_text(route)),
                                 options.views, options.warmup)
                  : start_places(session_->level()->bsp, options.views, options.warmup);

    content_hash_ = hash_bytes({});
    for (const std::string& file : {"maps/" + level + ".bsp", std::string("materials.json")}) {
        if (!files_.exists(file)) continue;
        const std::vector<std::uint8_t> content = files_.read(file);
        content_hash_ = hash_bytes(std::as_bytes(std::span(content)), content_hash_);
    }
}

QualityRenderer::~QualityRenderer() {
    for (const Setting& setting : base_)
        cvars().set(setting.name, setting.value);
}

void QualityRenderer::begin_run(const QualityRow& row, int seed) {
    for (const Setting& setting : base_)
        cvars().set(setting.name, setting.value);
    for (const Setting& setting : row.settings)
        cvars().set(setting.name, setting.value);
    cvars().set("pt_seed", std::to_string(seed));
    cvars().set("pt_accumulate", "0");
    renderer_->reset_guiding();
}

void QualityRenderer::prepare(const std::vector<QualityRow>& rows) {
    constexpr int frames = 2; // the second one reads what the first has learned
    for (const QualityRow& row : rows) {
        begin_run(row, 0);
        stand_still(places_.front().measured(), frames);
        preparations_.push_back({renderer_->compiled_features(), renderer_->take_compiled()});
    }
}

std::uint64_t QualityRenderer::render(const Pose& pose) {
    // The session's own clock only moves on; a run starts at any time.
    refresh::Frame frame = session_->frame_at(pose.time_s);
    frame.view.origin = pose.origin;
    frame.view.angles = pose.angles;
    if (change_.lamp) frame.dynamic_lights = std::span(&*change_.lamp, 1);
    if (change_.hidden >= 0) {
        entities_.assign(frame.entities.begin(), frame.entities.end());
        for (refresh::Entity& entity : entities_)
            if (entity.number == change_.hidden) entity.model = -1;
        frame.entities = entities_;
    }
    for (float& style : frame.light_styles)
        style *= change_.brightness;
    return renderer_->render(frame);
}

Measurement QualityRenderer::measure(const Place& place, const QualityRow& row, int seed,
                                     int frames) {
    begin_run(row, seed);
    renderer_->take_frame_times(true);
    const std::size_t warmup = place.frames.size() - 1;
    std::uint64_t first_timed = 0;
    std::vector<double> frame_ms;
    for (std::size_t frame = 0; frame < warmup; ++frame) {
        const Stopwatch watch;
        first_timed = render(place.frames[frame]) + 1;
        if (frame >= warmup - warmup / 2) frame_ms.push_back(1e3 * watch.seconds());
    }
    first_timed -= warmup / 2;
    Measurement result;
    result.frame_ms = median(over_turns(frame_ms));
    result.pictures = stand_still(place.measured(), frames);

    std::vector<std::vector<double>> times(std::size(vkpt::pass_names));
    for (const refresh::FrameTimes& frame : renderer_->take_frame_times(true)) {
        if (frame.frame < first_timed) continue;
        for (std::vector<double>& pass : times)
            pass.push_back(0.0);
        for (const refresh::PassTime& pass : frame.passes)
            times[pass_index(pass.name)].back() = pass.milliseconds;
    }
    for (const std::vector<double>& pass : times)
        result.pass_ms.push_back(pass.empty() ? 0.0 : median(over_turns(pass)));

    // What became of the light samples.
    const vkpt::FrameBuffers& buffers = renderer_->buffers();
    const std::uint64_t pixels = std::uint64_t{buffers.size().x} * buffers.size().y;
    std::size_t hits = 0, unlit = 0, explored = 0;
    const std::vector<shader::PrimaryHit> surfaces = this->surfaces();
    const auto flags =
        gpu::download_now_as<std::uint32_t>(renderer_->device(), buffers.pixel_flags(), 0, pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        if (surfaces[i].primitive == shader::NONE) continue;
        ++hits;
        unlit += (flags[i] & shader::PIXEL_UNLIT) != 0;
        explored += (flags[i] & shader::PIXEL_EXPLORED) != 0;
    }
    const bool samples = renderer_->technique()->samples_lights() && hits > 0;
    const double total =
        samples ? static_cast<double>(hits) : std::numeric_limits<double>::quiet_NaN();
    result.unlit = static_cast<double>(unlit) / total;
    result.explored = static_cast<double>(explored) / total;
    return result;
}

std::vector<FrameCost> QualityRenderer::fly(const Place& place, const QualityRow& row, int seed) {
    begin_run(row, seed);
    renderer_->take_frame_times(true);
    std::vector<FrameCost> costs;
    for (const Pose& pose : place.frames) {
        const Stopwatch watch;
        render(pose);
        FrameCost& cost = costs.emplace_back();
        cost.pass_ms.resize(std::size(vkpt::pass_names));
        for (const refresh::FrameTimes& frame : renderer_->take_frame_times(true)) {
            for (const refresh::PassTime& pass : frame.passes)
                cost.pass_ms[pass_index(pass.name)] = pass.milliseconds;
            for (const refresh::Upload& upload : frame.uploads)
                cost.upload_bytes += upload.bytes;
        }
        cost.frame_ms = 1e3 * watch.seconds();
    }
    const auto smooth = [&](auto time_of) {
        std::vector<double> times;
        for (FrameCost& cost : costs)
            times.push_back(time_of(cost));
        const std::vector<double> means = over_turns(times);
        for (std::size_t frame = 0; frame < costs.size(); ++frame)
            time_of(costs[frame]) = means[frame];
    };
    smooth([](FrameCost& cost) -> double& { return cost.frame_ms; });
    for (std::size_t pass = 0; pass < std::size(vkpt::pass_names); ++pass)
        smooth([pass](FrameCost& cost) -> double& { return cost.pass_ms[pass]; });
    return costs;
}

StillCost QualityRenderer::stand(const Place& place, const QualityRow& row, int seed, int frames) {
    begin_run(row, seed);
    for (int frame = 0; frame < frames; ++frame)
        render(place.measured());
    StillCost cost;
    const std::vector<refresh::FrameTimes> times = renderer_->take_frame_times(true);
    for (const refresh::Upload& upload : times.back().uploads)
        cost.uploads[upload.name] += upload.bytes;
    cost.memory = renderer_->device().usage().memory();
    return cost;
}

LightFloor QualityRenderer::floor(const Place& place) {
    begin_run(technique_row("sll"), first_reference_seed - 1);
    render(place.measured());
    return measure_light_floor(*renderer_, {});
}

std::vector<std::vector<float>> QualityRenderer::stand_still(const Pose& pose, int frames) {
    std::vector<std::vector<float>> pictures;
    for (int frame = 0; frame < frames; ++frame)
        pictures.push_back(show(pose));
    return pictures;
}

std::vector<float> QualityRenderer::show(const Pose& pose) {
    render(pose);
    return renderer_->read_radiance().rgb;
}

std::vector<shader::PrimaryHit> QualityRenderer::surfaces() {
    const vkpt::FrameBuffers& buffers = renderer_->buffers();
    return gpu::download_now_as<shader::PrimaryHit>(renderer_->device(), buffers.primary_hits(), 0,
                                                    std::uint64_t{buffers.size().x} *
                                                        buffers.size().y);
}

shader::FrameParams QualityRenderer::camera(const Pose& pose) const {
    refresh::View view = session_->frame_at(pose.time_s).view;
    view.origin = pose.origin;
    view.angles = pose.angles;
    vkpt::FrameDescription params{};
    vkpt::set_camera(params, view, renderer_->buffers().size());
    return params;
}

std::vector<Door> QualityRenderer::doors() const {
    const Bsp& bsp = session_->level()->bsp;
    std::vector<Door> doors;
    const client::LevelEntities& placed = session_->entities();
    for (std::size_t i = 0; i < placed.entities().size(); ++i) {
        const refresh::Entity& entity = placed.entities()[i];
        const std::string& model = placed.models()[i];
        if (entity.model < 0 || !model.starts_with('*') ||
            bsp.entities[entity.number].classname() != "func_door")
            continue;
        const auto& bounds = bsp.models[std::stoul(model.substr(1))];
        doors.push_back({entity.number, bounds.mins + entity.origin, bounds.maxs + entity.origin});
    }
    return doors;
}

bool QualityRenderer::is_open(const glm::vec3& point) const {
    return cluster_at(session_->level()->bsp, point) >= 0;
}

void QualityRenderer::turn(const std::string& target, float yaw) {
    session_->turn_entities(target, {0.0f, yaw, 0.0f});
    turned_ = fmt::format(" turned {} {}", target, yaw);
}

void QualityRenderer::begin_reference(const Pose& pose, const QualityRow& row, int frames) {
    begin_run(row, first_reference_seed - 1);
    cvars().set("pt_spp", "1");
    for (int frame = 0; frame < frames; ++frame) // what is learned helps those that count
        render(pose);
}

std::vector<float> QualityRenderer::reference_batch(const Pose& pose, int number) {
    // A new seed begins a new running mean.
    cvars().set("pt_seed", std::to_string(first_reference_seed + number));
    cvars().set("pt_accumulate", "1");
    for (int path = 0; path < reference_batch_paths; ++path)
        render(pose);
    return renderer_->read_radiance().rgb;
}

std::string QualityRenderer::reference_key(const Pose& pose, const QualityRow& row) const {
    // A row's variables come before those that all rows have.
    const auto value_of = [&](std::string_view name) {
        for (const std::vector<Setting>* settings : {&row.settings, &base_}) {
            const auto own = std::ranges::find(*settings, name, &Setting::name);
            if (own != settings->end()) return own->value;
        }
        return cvars().get_text(name);
    };
    const std::string technique = value_of("pt_nee");
    std::string key =
        fmt::format("{} {:016x} at {} {} {} angles {} {} {} time {} by {} {:016x} paths {}",
                    level_name_, content_hash_, pose.origin.x, pose.origin.y, pose.origin.z,
                    pose.angles.x, pose.angles.y, pose.angles.z, pose.time_s, technique,
                    shader_hash(technique, value_of("pt_guide")), reference_batch_paths);
    key += turned_;
    key += change_.text();
    for (const CvarInfo& info : cvar_infos) {
        if (info.affects != Affects::Reference) continue;
        const std::string value = value_of(info.name);
        if (value != cvar_default_text(info)) key += fmt::format(" {} {}", info.name, value);
    }
    return key;
}

void QualityRenderer::complete(Reference& reference, const Pose& pose, const ReferenceJob& job) {
    // A picture being completed, and where it is kept.
    struct Kept {
        Reference& picture;
        std::string key;
        std::filesystem::path path;
    };
    const auto bring = [&](Reference& picture, std::string key) {
        std::filesystem::path path = output_path(
            fmt::format("cache/reference-{:016x}.bin", hash_bytes(std::as_bytes(std::span(key)))));
        if (!job.fresh && !picture.load(path, key) && std::filesystem::exists(path))
            log_warning("{}: damaged or of an older version; this reference is rendered anew",
                        path.string());
        return Kept{picture, std::move(key), std::move(path)};
    };
    const std::string key = reference_key(pose, job.row);
    const Kept kept = bring(reference, key);
    Reference pilot(reference.values());
    const Kept kept_pilot = bring(pilot, key + " pilot");

    bool is_begun = false;
    bool is_saved = true;
    const auto batch = [&](int number) {
        if (!is_begun) begin_reference(pose, job.row, job.warmup);
        is_begun = true;
        return reference_batch(pose, number);
    };
    const auto added = [&](bool is_pilot) {
        const Kept& to = is_pilot ? kept_pilot : kept;
        const int batches = to.picture.batches();
        // So that an interrupted run loses little.
        is_saved = is_pilot || batches % 16 == 0;
        if (is_saved) to.picture.save(to.path, to.key);
        job.noted(batches);
    };
    if (job.batches_wanted)
        complete_reference(pilot, reference, {batch, job.batches_wanted, added});
    else
        while (reference.batches() < job.batches) {
            reference.add(batch(reference.batches()));
            added(false);
        }
    if (!is_saved) reference.save(kept.path, kept.key);
}

} // namespace vigil::bench
