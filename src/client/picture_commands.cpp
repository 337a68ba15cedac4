// SPDX-License-Identifier: GPL-2.0-or-later
// Console commands that write what is seen: screenshot, screenshot_hdr, exportscene, and fly. Names
// are relative to `outdir`; a missing extension is added.
#include "client/client.h"
#include "client/measure/picture_file.h"
#include "common/ascii_case.h"
#include "common/error.h"
#include "common/log.h"
#include "console/arguments.h"
#include "console/outdir.h"

namespace vigil::client {

namespace {

constexpr int most_numbered = 10000;

/// A name that cannot be written fails here, before the work.
std::filesystem::path path_of(std::string_view name, std::string_view extension) {
    std::filesystem::path path = ends_nocase(name, extension)
                                     ? output_path(name)
                                     : output_path(fmt::format("{}{}", name, extension));
    check_output(path);
    return path;
}

/// The first of vigil0000.png, vigil0001.png, ... that is free.
std::filesystem::path numbered_path() {
    for (int i = 0; i < most_numbered; ++i) {
        std::filesystem::path path = output_path(fmt::format("vigil{:04}.png", i));
        if (!std::filesystem::exists(path)) return path;
    }
    fail("all names vigil0000.png to vigil{}.png are taken. Give another name.", most_numbered - 1);
}

Session& current_picture(Client& client) {
    Session& session = client.session();
    if (session.level() == nullptr) fail("there is no picture before a level is loaded");
    // The last frame shows the view before `setviewpos`, `map`, ... of the same script.
    session.render_if_stale();
    return session;
}

void screenshot(Client& client, CommandArguments arguments) {
    const std::filesystem::path path =
        arguments.empty() ? numbered_path() : path_of(arguments[0], ".png");
    const refresh::Picture picture = current_picture(client).renderer().read_picture(false);
    write_png(path, picture);
    log_info("wrote {} ({} x {})", path.string(), picture.width, picture.height);
}

void screenshot_hdr(Client& client, CommandArguments arguments) {
    const std::filesystem::path path = path_of(arguments[0], ".exr");
    const refresh::RadiancePicture picture = current_picture(client).renderer().read_radiance();
    write_exr(path, picture);
    log_info("wrote {} ({} x {}, {} frames)", path.string(), picture.width, picture.height,
             picture.frames);
}

void export_scene(Client& client, CommandArguments arguments) {
    Session& session = client.session();
    if (session.level() == nullptr) fail("there is no scene before a level is loaded");
    const std::filesystem::path path = path_of(arguments[0], ".gltf");
    session.renderer().export_scene(session.frame(), path.string());
}

void fly(Client& client, CommandArguments arguments) {
    const FileSystem& files = client.session_in_level().files();
    RunPlan plan;
    plan.name = route_name(arguments[0]);
    if (arguments.size() > 1) {
        plan.fps = number_at(arguments, 1, "FPS");
        if (!(plan.fps >= 0.01 && plan.fps <= 10000.0)) fail("FPS must be from 0.01 to 10000");
    }
    if (arguments.size() == 4) {
        plan.prefix = arguments[2];
        plan.every = integer_at(arguments, 3, "EVERY", 1, 1'000'000);
    }
    plan.json = client.commands().variables()->timedemo_json;
    plan.size = client.picture_size();

    Route route = load_route(files, plan.name);
    checked_frame_count(route, plan.name, plan.fps);
    client.start_flight(std::move(route), std::move(plan));
    client.commands().pause_script_until([&client] { return !client.flying(); });
}

} // namespace

ClientCommands picture_commands() {
    const auto routes = [](const Client& c) { return list_routes(c.session().files()); };
    return {
        {"screenshot", "[NAME]: Writes the picture as outdir/NAME.png.", screenshot},
        {"screenshot_hdr", "NAME: Writes linear radiance as outdir/NAME.exr.", screenshot_hdr},
        {"exportscene", "NAME.gltf: Writes the level with this camera as glTF 2.0.", export_scene},
        {"fly",
         "ROUTE [FPS] [PREFIX EVERY]: Flies the camera along routes/ROUTE.route, and prints the "
         "times. Each second of the route has FPS frames. Each EVERY-th frame is kept as "
         "PREFIX_000.png and so on.",
         fly, routes}};
}

} // namespace vigil::client
