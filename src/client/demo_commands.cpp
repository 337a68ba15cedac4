// SPDX-License-Identifier: GPL-2.0-or-later
// Console commands about demos: demomap, demos, record, stop.
#include "client/client.h"
#include "common/ascii_case.h"
#include "common/binary_file.h"
#include "common/error.h"
#include "common/game_path.h"
#include "common/log.h"
#include "common/printable.h"
#include "console/arguments.h"
#include "console/outdir.h"
#include "formats/dm2_protocol.h"

#include <algorithm>

namespace vigil::client {

namespace {

constexpr std::string_view folder = "demos/";
constexpr std::string_view extension = ".dm2";

std::string_view demo_name(std::string_view path) {
    if (starts_nocase(path, folder)) path.remove_prefix(folder.size());
    if (ends_nocase(path, extension)) path.remove_suffix(extension.size());
    return path;
}

std::string demo_path(std::string_view name) {
    return fmt::format("{}{}{}", folder, demo_name(name), extension);
}

/// Where `record` writes it. Unlike output_path() this makes no folder.
std::filesystem::path recorded_path(const Client& client, std::string_view path) {
    return std::filesystem::path(client.variables()->outdir) / path;
}

/// A demo that was recorded here comes before one of the game's with the same name.
std::vector<uint8_t> read_demo(const Client& client, const std::string& path) {
    if (const auto fault = game_path_fault(path); !fault.empty())
        fail("\"{}\" is no name of a demo: it {}", printable(path), fault);
    const std::filesystem::path recorded = recorded_path(client, path);
    std::error_code none;
    if (std::filesystem::is_regular_file(recorded, none)) {
        const BinaryFile file(recorded);
        if (file.size() > max_file_bytes) fail("{}: the file is too large", file.name());
        return file.read(0, file.size());
    }
    const FileSystem& files = client.session().files();
    if (!files.exists(path))
        fail("there is no demo {}, neither in the game's folders nor in {}. `demos` lists the "
             "demos.",
             path, recorded.parent_path().string());
    return files.read(path);
}

void demomap(Client& client, CommandArguments arguments) {
    const int repetitions = client.variables()->timedemo;
    RunPlan plan;
    plan.kind = "demo";
    plan.name = demo_name(arguments[0]);
    plan.fps = dm2::frames_per_second;
    if (arguments.size() == 3) {
        if (repetitions == 0) fail("only a timedemo keeps pictures. Set `timedemo 1` first.");
        plan.prefix = arguments[1];
        plan.every = integer_at(arguments, 2, "EVERY", 1, 1'000'000);
    }
    plan.json = client.variables()->timedemo_json;
    plan.size = client.picture_size();
    const std::string path = demo_path(arguments[0]);
    client.start_demo(DemoPlayback(path, read_demo(client, path), repetitions, std::move(plan)));
    // A measurement is over before what follows it; while a demo plays with the time, `wait` and
    // `screenshot` may follow.
    if (repetitions > 0)
        client.commands().pause_script_until([&client] { return !client.playing(); });
}

void record(Client& client, CommandArguments arguments) {
    const std::string path = demo_path(arguments[0]);
    const Session& session = client.session();
    if (session.level() == nullptr) fail("no level is loaded. `map NAME` loads one.");
    if (session.played() != nullptr) fail("a demo is shown. `map NAME` begins something new.");
    if (client.recording()) fail("a demo is being recorded. `stop` ends it.");
    check_output(output_path(path));
    if (arguments.size() == 1) {
        client.start_recording(path);
        log_info("recording {}. `stop` ends it.", path);
        return;
    }
    // A route: all of it at once, nothing is rendered.
    const Route route = load_route(session.files(), arguments[1]);
    DemoRecorder recorder = client.make_recorder();
    refresh::Frame frame = session.frame();
    const int frames = checked_frame_count(route, route_name(arguments[1]), dm2::frames_per_second);
    const double begin_s = frame.time_s;
    for (int i = 0; i < frames; ++i) {
        const double seconds = i / dm2::frames_per_second;
        const Route::Key view = route.at(seconds);
        frame.view.origin = view.origin;
        frame.view.angles = view.angles;
        frame.time_s = begin_s + seconds;
        recorder.add(frame, session.light_styles());
    }
    client.write_recording(path, recorder);
}

void stop(Client& client, CommandArguments) {
    if (client.recording())
        client.stop_recording();
    else if (client.playing())
        client.end_demo();
    else
        fail("nothing is recorded or played");
}

} // namespace

std::vector<std::string> list_demos(const Client& client) {
    std::vector<std::string> names;
    for (const std::string& path : client.session().files().list(folder, extension))
        names.emplace_back(demo_name(path));
    std::error_code none;
    for (const auto& entry :
         std::filesystem::directory_iterator(recorded_path(client, folder), none)) {
        const std::string name = entry.path().filename().string();
        if (ends_nocase(name, extension)) names.emplace_back(demo_name(name));
    }
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

ClientCommands demo_commands() {
    return {
        {"demomap",
         "NAME.dm2 [PREFIX EVERY]: Plays a demo. After `timedemo 1` it measures every frame. Then "
         "each EVERY-th frame is kept as PREFIX_000.png and so on. PREFIX.exr keeps radiance.",
         demomap, list_demos},
        {"demos", ": Lists the demos that can be played.",
         [](Client& c, CommandArguments) { log_names(list_demos(c), "demos"); }},
        {"record",
         "NAME [ROUTE]: Records outdir/demos/NAME.dm2 until `stop`. With ROUTE it records "
         "routes/ROUTE.route at once.",
         record},
        {"stop", ": Ends the recording, or the demo that plays.", stop}};
}

} // namespace vigil::client
