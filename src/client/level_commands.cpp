// SPDX-License-Identifier: GPL-2.0-or-later
// Console commands about the level and what is in it: map, gamemap, maps, turn, lightstyle, dlight,
// flashlight, dlight_clear, scene, device, passes, quit.
#include "client/client.h"
#include "client/measure/report_text.h"
#include "common/error.h"
#include "common/log.h"
#include "console/arguments.h"

namespace vigil::client {

namespace {

void turn(Client& client, CommandArguments arguments) {
    const float yaw = number_at(arguments, 1, "the yaw");
    const float pitch = arguments.size() > 2 ? number_at(arguments, 2, "the pitch") : 0.0f;
    const float roll = arguments.size() > 3 ? number_at(arguments, 3, "the roll") : 0.0f;
    client.session_in_level().turn_entities(arguments[0], {pitch, yaw, roll});
}

void lightstyle(Client& client, CommandArguments arguments) {
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

void scene(Client& client, CommandArguments) {
    const refresh::Renderer& renderer = client.session_in_level().renderer();
    const refresh::Settings& settings = client.commands().variables().values();
    log_info("{}", scene_text(renderer.report_scene(settings), renderer.report_guiding(),
                              renderer.health(), settings));
}

void passes(Client& client, CommandArguments) {
    client.session().take_frame_times(true);
    PassStatistics& statistics = client.session().pass_statistics();
    log_info("{}", statistics.table());
    statistics.clear();
}

/// `gamemap "*base2$lift"`, as levels of a game name the next: after the place where a unit begins
/// (*), before the place to start at.
void game_map(Client& client, CommandArguments arguments) {
    std::string_view name = arguments[0];
    if (name.starts_with('*')) name.remove_prefix(1);
    const size_t place = name.find('$');
    client.load_map(name.substr(0, place));
    if (place != std::string_view::npos)
        log_info("The level begins at its own start, not at {}.", name.substr(place + 1));
}

} // namespace

void log_names(const std::vector<std::string>& names, std::string_view of_what) {
    for (const std::string& name : names)
        log_info("  {}", name);
    log_info("{} {}", names.size(), of_what);
}

ClientCommands level_commands() {
    const auto levels = [](const Client& c) { return list_levels(c.session().files()); };
    const auto targets = [](const Client& c) { return c.session().entities().targets(); };
    return {
        {"map", "NAME: Loads a level and starts in it. `maps` lists the levels.",
         [](Client& c, CommandArguments arguments) { c.load_map(arguments[0]); }, levels},
        {"gamemap",
         "NAME: Loads a level, as map does. The forms `*NAME` and `NAME$PLACE` of games are taken "
         "too.",
         game_map, levels},
        {"maps", ": Lists the levels that can be loaded.",
         [levels](Client& c, CommandArguments) { log_names(levels(c), "levels"); }},
        {"turn", "TARGETNAME YAW [PITCH [ROLL]]: Turns a brush model of the level, in degrees.",
         turn, targets},
        {"lightstyle",
         "N [VALUE|PATTERN]: Sets the brightness of light style N. A VALUE is a factor. A PATTERN "
         "has ten letters a second, from a (dark) over m (normal) to z.",
         lightstyle},
        {"dlight", "ID x y z RADIUS r g b: Puts a glowing ball of radiance r g b at x y z.",
         dlight},
        {"dlight_clear", ": Removes the balls of dlight.",
         [](Client& c, CommandArguments) { c.session().clear_dynamic_lights(); }},
        {"flashlight", ": Switches the flashlight in your hand on or off.",
         [](Client& c, CommandArguments) {
             c.session_in_level().set_flashlight(!c.session().flashlight());
         }},
        {"scene", ": Lists what the level switched on in the renderer, and why.", scene},
        {"device", ": Names the graphics device and its driver.",
         [](Client& c, CommandArguments) { log_info("{}", c.session().renderer().device_name()); }},
        {"passes", ": Prints the GPU time of every pass since the last call.", passes},
        {"quit", ": Ends the program.", [](Client& c, CommandArguments) { c.quit(); }}};
}

} // namespace vigil::client
