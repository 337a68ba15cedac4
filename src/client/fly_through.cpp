// SPDX-License-Identifier: GPL-2.0-or-later
// Flying along a route, its pictures and its report.
#include "client/fly_through.h"

#include "client/picture_file.h"
#include "common/log.h"
#include "common/output.h"
#include "common/stopwatch.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace vigil::client {

FlyThrough::FlyThrough(Route route, FlightPlan plan)
    : route_(std::move(route)), plan_(std::move(plan)),
      frame_count_(route_.frame_count(plan_.fps)) {}

void FlyThrough::begin_frame(Session& session) {
    if (frame_ == 0) session.take_frame_times(true); // those of frames before the flight
    const Route::Key view = route_.at(frame_ / plan_.fps);
    session.camera().set(view.origin, view.angles);
    if (frame_ > 0) session.advance(1.0 / plan_.fps);
}

void FlyThrough::end_frame(Session& session, double seconds) {
    const Stopwatch watch;
    FrameRecord record;
    record.number = session.last_frame();

    // Waiting for the picture is rendering time; encoding and writing it is not.
    if (!plan_.prefix.empty() && frame_ % plan_.every == 0) {
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
    ++frame_;
}

std::filesystem::path FlyThrough::picture_path(int number) const {
    return output_path(fmt::format("{}_{:03}.png", plan_.prefix, number));
}

void FlyThrough::take_gpu_times(Session& session, bool wait) {
    for (refresh::FrameTimes& times : session.take_frame_times(wait)) {
        if (frames_.empty() || times.frame < frames_.front().number) continue;
        // Frames of a flight follow one another.
        FrameRecord& record = frames_.at(times.frame - frames_.front().number);
        statistics_.add_frame(times.passes);
        counts_.add_frame(times.counts);
        record.passes = std::move(times.passes);
    }
}

void FlyThrough::report(Session& session, const CvarRegistry& variables) {
    const Stopwatch watch;
    take_gpu_times(session, true);
    seconds_ += watch.seconds();
    log_info("{} frames, {:.1f} seconds: {:.1f} fps", frame_count_, seconds_,
             frame_count_ / seconds_);
    log_info("{}", statistics_.table());
    if (pictures_ > 0) {
        log_info("wrote {} pictures, {} and on", pictures_, picture_path(0).string());
    }
    if (plan_.json.empty()) return;
    const std::filesystem::path path = output_path(plan_.json);
    write_file(path, json_text(session, session.renderer().describe_device(), variables));
    log_info("report: {}", path.string());
}

std::string FlyThrough::json_text(const Session& session, const std::string& device,
                                  const CvarRegistry& variables) const {
    using nlohmann::ordered_json;
    ordered_json report;
    report["level"] = session.level() != nullptr ? session.level()->name : "";
    report["route"] = plan_.name;
    report["route_fps"] = plan_.fps;
    report["device"] = device;
    report["width"] = plan_.size.x;
    report["height"] = plan_.size.y;
    report["frame_count"] = frame_count_;
    report["seconds"] = seconds_;
    report["fps"] = frame_count_ / seconds_;

    ordered_json settings = ordered_json::object();
    for (const CvarInfo& info : cvar_infos) {
        const std::string value = cvar_text(info, variables.values());
        if (value != cvar_default_text(info)) settings[std::string(info.name)] = value;
    }
    report["variables"] = settings;

    report["passes"] = ordered_json::array();
    for (const PassSummary& pass : statistics_.summarize()) {
        report["passes"].push_back({{"name", pass.name},
                                    {"frames", pass.frames},
                                    {"min_ms", pass.minimum},
                                    {"median_ms", pass.median},
                                    {"mean_ms", pass.mean},
                                    {"p99_ms", pass.p99},
                                    {"share", pass.share}});
    }
    // What guiding counted, means over the flight; empty while it was off.
    report["guiding"] = ordered_json::object();
    for (const refresh::FrameCount& count : counts_.means())
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
