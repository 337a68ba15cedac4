// SPDX-License-Identifier: GPL-2.0-or-later
// Console commands about the level and what is in it: map, maps, turn, lightstyle, dlight,
// flashlight, dlight_clear, scene, device, passes, quit.
#include "client/client.h"
#include "client/measure/report_text.h"
#include "common/error.h"
#include "common/log.h"
#include "console/arguments.h"

namespace vigil::client {

namespace {

void list_maps(Client& client) {
    const std::vector<std::string> names = list_levels(client.session().files());
    for (const std::string& name : names)
        log_info("  {}", name);
    log_info("{} levels", names.size());
}

void turn(Client& client, CommandArguments arguments) {
    check_count(arguments, 2, 4, "turn TARGETNAME YAW [PITCH ROLL]");
    const float yaw = number_at(arguments, 1, "the yaw");
    const float pitch = arguments.size() > 2 ? number_at(arguments, 2, "the pitch") : 0.0f;
    const float roll = arguments.size() > 3 ? number_at(arguments, 3, "the roll") : 0.0f;
    client.session_in_level().turn_entities(arguments[0], {pitch, yaw, roll});
}

void lightstyle(Client& client, CommandArguments arguments) {
    check_count(arguments, 1, 2, "lightstyle N [VALUE|PATTERN]");
    Session& session = client.session_in_level();
    const int style = integer_at(arguments, 0, "the style", 0, refresh::light_style_count - 1);
    LightStyles styles = session.light_styles();
    if (arguments.size() == 1) {
        log_info("lightstyle {} {}", style, styles.text(style));
        return;
    }
    float value = 0.0f;
    if (parse_number(arguments[1], value)) {
        styles.set_value(style, value);
    } else {
        styles.set_pattern(style, arguments[1]);
    }
    session.set_light_styles(std::move(styles));
}

void dlight(Client& client, CommandArguments arguments) {
    check_count(arguments, 8, 8, "dlight ID x y z RADIUS r g b");
    refresh::DynamicLight light;
    light.id = static_cast<uint32_t>(integer_at(arguments, 0, "the id", 0, 1'000'000));
    light.origin = vector_at(arguments, 1, "the place");
    light.radius = number_at(arguments, 4, "the radius");
    light.radiance = vector_at(arguments, 5, "the radiance");
    if (light.radius <= 0.0f) fail("the radius must be greater than 0");
    if (glm::any(glm::lessThan(light.radiance, glm::vec3(0.0f)))) {
        fail("the radiance must not be negative");
    }
    client.session_in_level().set_dynamic_light(light);
}

void scene(Client& client) {
    const refresh::Renderer& renderer = client.session_in_level().renderer();
    const refresh::Settings& settings = client.commands().variables().values();
    log_info("{}", scene_text(renderer.report_scene(settings), renderer.report_guiding(),
                              renderer.health(), settings));
}

} // namespace

void add_level_commands(Client& client) {
    CommandRegistry& commands = client.commands();
    commands.add(
        "map", "NAME: loads a level and starts in it",
        [&client](CommandArguments arguments) {
            check_count(arguments, 1, 1, "map NAME (`maps` lists the levels)");
            client.load_map(arguments[0]);
        },
        [&client](CommandArguments arguments) {
            return arguments.empty() ? list_levels(client.session().files())
                                     : std::vector<std::string>();
        });
    commands.add("maps", ": lists the levels that can be loaded",
                 [&client](CommandArguments) { list_maps(client); });
    commands.add(
        "turn", "TARGETNAME YAW [PITCH ROLL]: turns a brush model of the level, in degrees",
        [&client](CommandArguments arguments) { turn(client, arguments); },
        [&client](CommandArguments arguments) {
            return arguments.empty() ? client.session().entities().targets()
                                     : std::vector<std::string>();
        });
    commands.add("lightstyle",
                 "N [VALUE|PATTERN]: brightness of light style N, a factor or letters a (dark), m "
                 "(normal) to z, ten per second",
                 [&client](CommandArguments arguments) { lightstyle(client, arguments); });
    commands.add("dlight", "ID x y z RADIUS r g b: puts a glowing ball of that radiance somewhere",
                 [&client](CommandArguments arguments) { dlight(client, arguments); });
    commands.add("dlight_clear", ": removes what dlight put there",
                 [&client](CommandArguments) { client.session().clear_dynamic_lights(); });
    commands.add("flashlight", ": switches the flashlight in your hand on or off",
                 [&client](CommandArguments) {
                     client.session_in_level().set_flashlight(!client.session().flashlight());
                 });
    commands.add("scene", ": says what the level switched on in the renderer, and why",
                 [&client](CommandArguments) { scene(client); });
    commands.add(
        "device", ": names the graphics device and its driver",
        [&client](CommandArguments) { log_info("{}", client.session().renderer().device_name()); });
    commands.add("passes", ": table of GPU times since the last call or the level's start",
                 [&client](CommandArguments) {
                     client.session().take_frame_times(true);
                     PassStatistics& statistics = client.session().pass_statistics();
                     log_info("{}", statistics.table());
                     statistics.clear();
                 });
    commands.add("quit", ": ends the program", [&client](CommandArguments) { client.quit(); });
}

} // namespace vigil::client
