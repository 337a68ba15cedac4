// SPDX-License-Identifier: GPL-2.0-or-later
// Times, pictures and the report of a run.
#include "client/demo/timed_run.h"

#include "client/measure/commit.h"
#include "client/measure/picture_file.h"
#include "common/ascii_case.h"
#include "common/log.h"
#include "common/stopwatch.h"
#include "console/outdir.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace vigil::client {

namespace {

constexpr std::string_view radiance_extension = ".exr";

/// What the paper's figures 11 and 12 put together: preparation, and path tracing by technique.
std::vector<PassSum> pass_sums() {
    const std::string guide = cvar_text(*find_cvar("pt_guide"), cvars().values());
    std::string technique = cvar_text(*find_cvar("pt_nee"), cvars().values());
    if (guide != "brdf") technique += " + " + guide;
    return {{refresh::PassGroup::Preparation, "= preparation"},
            {refresh::PassGroup::PathTracing, "= path tracing, " + technique}};
}

nlohmann::ordered_json json_of(const PassSummary& pass) {
    std::string_view name = pass.name;
    if (name.starts_with("= ")) name.remove_prefix(2); // the table's mark of sums
    return {{"name", name},           {"frames", pass.frames},
            {"min_ms", pass.minimum}, {"median_ms", pass.median},
            {"mean_ms", pass.mean},   {"p99_ms", pass.p99},
            {"share", pass.share}};
}

std::string quake_line(size_t frames, double seconds) {
    return fmt::format("{} frames, {:.1f} seconds: {:.1f} fps", frames, seconds,
                       static_cast<double>(frames) / seconds);
}

} // namespace

void TimedRun::begin(Session& session) {
    session.take_frame_times(true);
    sums_ = pass_sums();
    begin_ = frames_.size();
    seconds_ = 0.0;
    repetition_statistics_.clear();
}

void TimedRun::tell_progress() {
    if (!progress_) {
        progress_ = std::make_unique<Progress>(expected_);
        progress_->begin(plan_.name);
    }
    progress_->advance("frames");
}

void TimedRun::end_frame(Session& session, double seconds) {
    const Stopwatch watch;
    FrameRecord record;
    record.number = session.last_frame();
    const bool pictured = !plan_.prefix.empty() && frame_count() % plan_.every == 0;

    // Waiting for the picture is rendering time; encoding and writing it is not.
    if (pictured && ends_nocase(plan_.prefix, radiance_extension)) {
        const refresh::RadiancePicture picture = session.renderer().read_radiance();
        record.seconds = seconds + watch.seconds();
        write_exr(picture_path(pictures_), picture);
        ++pictures_;
    } else if (pictured) {
        const refresh::Picture picture = session.renderer().read_picture(false);
        record.seconds = seconds + watch.seconds();
        write_png(picture_path(pictures_), picture);
        ++pictures_;
    } else {
        record.seconds = seconds + watch.seconds();
    }
    seconds_ += record.seconds;
    frames_.push_back(std::move(record));
    take_gpu_times(session, false);
    tell_progress();
}

void TimedRun::drop() {
    frames_.resize(begin_);
    progress_.reset();
}

void TimedRun::end(Session& session) {
    const Stopwatch watch;
    take_gpu_times(session, true);
    seconds_ += watch.seconds();
    finished_.push_back({frames_.size() - begin_, seconds_});
    begin_ = frames_.size();
    finished_totals_ = totals_;
    if (progress_) progress_->clear();
}

std::filesystem::path TimedRun::picture_path(int number) const {
    std::string_view name = plan_.prefix;
    const bool radiance = ends_nocase(name, radiance_extension);
    if (radiance) name.remove_suffix(radiance_extension.size());
    return output_path(fmt::format("{}_{:03}.{}", name, number, radiance ? "exr" : "png"));
}

void TimedRun::check_outputs() const {
    if (!plan_.prefix.empty()) check_output(picture_path(0));
    if (!plan_.json.empty()) check_output(output_path(plan_.json));
}

void TimedRun::take_gpu_times(Session& session, bool wait) {
    for (refresh::FrameTimes& times : session.take_frame_times(wait)) {
        const auto record =
            std::ranges::lower_bound(frames_, times.frame, {}, &FrameRecord::number);
        if (record == frames_.end() || record->number != times.frame) continue;
        repetition_statistics_.add_frame(times.passes);
        totals_.passes.add_frame(times.passes);
        totals_.counts.add_frame(times.counts);
        record->passes = std::move(times.passes);
    }
}

TimedRun::Repetition TimedRun::together() const {
    Repetition all;
    for (const Repetition& repetition : finished_) {
        all.frames += repetition.frames;
        all.seconds += repetition.seconds;
    }
    return all;
}

void TimedRun::log_repetition() const {
    log_info("{}", quake_line(finished_.back().frames, finished_.back().seconds));
    log_info("{}", repetition_statistics_.table(sums_));
}

void TimedRun::report(Session& session, const CvarRegistry& variables) const {
    if (finished_.size() > 1) {
        const Repetition all = together();
        log_info("all {} together: {}", finished_.size(), quake_line(all.frames, all.seconds));
        log_info("{}", finished_totals_.passes.table(sums_));
    }
    if (pictures_ > 0) {
        log_info("wrote {} pictures, {} and on", pictures_, picture_path(0).string());
    }
    if (plan_.json.empty()) return;
    const std::filesystem::path path = output_path(plan_.json);
    write_file(path, json_text(session, session.renderer().device_name(), variables));
    log_info("report: {}", path.string());
}

std::string TimedRun::json_text(const Session& session, const std::string& device,
                                const CvarRegistry& variables) const {
    using nlohmann::ordered_json;
    const Repetition all = together();
    ordered_json report;
    report["level"] = session.level() != nullptr ? session.level()->name : "";
    report[plan_.kind] = plan_.name;
    report[plan_.kind + "_fps"] = plan_.fps;
    report["commit"] = commit();
    report["device"] = device;
    report["width"] = plan_.size.x;
    report["height"] = plan_.size.y;
    report["frame_count"] = all.frames;
    report["seconds"] = all.seconds;
    report["fps"] = static_cast<double>(all.frames) / all.seconds;
    report["repetitions"] = ordered_json::array();
    for (const Repetition& repetition : finished_) {
        report["repetitions"].push_back(
            {{"frame_count", repetition.frames},
             {"seconds", repetition.seconds},
             {"fps", static_cast<double>(repetition.frames) / repetition.seconds}});
    }

    ordered_json settings = ordered_json::object();
    for (const CvarInfo& info : cvar_infos) {
        const std::string value = cvar_text(info, variables.values());
        if (value != cvar_default_text(info)) settings[std::string(info.name)] = value;
    }
    report["variables"] = settings;

    report["passes"] = ordered_json::array();
    for (const PassSummary& pass : finished_totals_.passes.summarize())
        report["passes"].push_back(json_of(pass));
    report["groups"] = ordered_json::array();
    for (const PassSum& wanted : sums_) {
        const PassSummary sum = finished_totals_.passes.summarize(wanted);
        if (sum.frames > 0) report["groups"].push_back(json_of(sum));
    }
    // What guiding counted, means over the run; empty while it was off.
    report["guiding"] = ordered_json::object();
    for (const refresh::FrameCount& count : finished_totals_.counts.means())
        report["guiding"][count.name] = count.value;
    report["frames"] = ordered_json::array();
    for (const FrameRecord& record : frames_) {
        ordered_json passes = ordered_json::object();
        for (const refresh::PassTime& pass : record.passes)
            passes[pass.name] = pass.milliseconds;
        report["frames"].push_back({{"ms", record.seconds * 1e3}, {"passes_ms", passes}});
    }
    // Folder names may hold bytes that are no UTF-8.
    return report.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

} // namespace vigil::client
