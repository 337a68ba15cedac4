// SPDX-License-Identifier: GPL-2.0-or-later
// Console commands about the view and the console itself: setviewpos, viewpos, centerview,
// flyspeed, flyfaster, flyslower, toggleconsole, clear, condump, and the key bindings.
#include "client/client.h"
#include "common/ascii_case.h"
#include "common/error.h"
#include "common/log.h"
#include "console/arguments.h"
#include "console/outdir.h"

#include <algorithm>

namespace vigil::client {

namespace {

constexpr float speed_step = 1.25f;

void set_view(Client& client, CommandArguments arguments) {
    Camera& camera = client.session().camera();
    const glm::vec3 origin = vector_at(arguments, 0, "the place");
    const glm::vec3 angles =
        arguments.size() == 6 ? vector_at(arguments, 3, "the direction") : camera.angles();
    // A player would fall from there; the eye stays where it was asked to be.
    if (Play* play = client.play(); play != nullptr) {
        play->stop_following();
        play->set_walking(false, client.session());
    }
    camera.set(origin, angles);
}

void change_speed(Client& client, float factor) {
    Camera& camera = client.session().camera();
    camera.set_speed(camera.speed() * factor);
    log_info("flying at {:.0f} units per second", camera.speed());
}

void fly_speed(Client& client, CommandArguments arguments) {
    Camera& camera = client.session().camera();
    if (!arguments.empty()) {
        const float speed = number_at(arguments, 0, "the speed");
        camera.set_speed(speed);
        if (camera.speed() != speed)
            log_warning("the flying speed must be from {:.0f} to {:.0f}", Camera::slowest,
                        Camera::fastest);
    }
    log_info("flying at {:.0f} units per second", camera.speed());
}

void center_view(Client& client, CommandArguments) {
    Camera& camera = client.session().camera();
    camera.set(camera.origin(), {0.0f, camera.angles().y, camera.angles().z});
}

void dump_console(Client& client, CommandArguments arguments) {
    const std::string name = arguments.empty() ? "condump" : arguments[0];
    const std::filesystem::path path =
        output_path(ends_nocase(name, ".txt") ? name : name + ".txt");
    const std::string text = client.console().text();
    write_file(path, text);
    log_info("wrote {} ({} lines)", path.string(), std::ranges::count(text, '\n'));
}

platform::Key key_argument(const std::string& name) {
    const std::optional<platform::Key> key = platform::key_from_name(name);
    if (!key)
        fail("there is no key \"{}\". Keys have names like w, F5, UPARROW, MOUSE2, PAD_A.", name);
    return *key;
}

std::vector<std::string> key_candidates(CommandArguments arguments) {
    if (!arguments.empty()) return {};
    const std::vector<std::string_view> names = platform::key_names();
    return {names.begin(), names.end()};
}

void bind(KeyBindings& bindings, CommandArguments arguments, Trust trust) {
    const platform::Key key = key_argument(arguments[0]);
    if (arguments.size() == 1) {
        const std::string& command = bindings.command(key);
        log_info("{} {}", arguments[0],
                 command.empty() ? "is not bound" : fmt::format("runs \"{}\"", command));
        return;
    }
    // Without quotes, the rest of the line is the command.
    std::string command = arguments[1];
    for (const std::string& word : arguments.subspan(2))
        command += " " + word;
    bindings.bind(key, command, trust);
}

} // namespace

ClientCommands view_commands() {
    return {{"setviewpos",
             "x y z [pitch yaw roll]: Puts the eye there. Angles are degrees, pitch down.",
             set_view},
            {"viewpos", ": Prints the command that brings the view back here.",
             [](Client& c, CommandArguments) {
                 log_info("{}", c.session().camera().setviewpos_text());
             }},
            {"centerview", ": Looks straight ahead.", center_view},
            {"flyspeed", "[SPEED]: Sets or prints the flying speed in map units per second.",
             fly_speed},
            {"flyfaster", ": Flies a quarter faster.",
             [](Client& c, CommandArguments) { change_speed(c, speed_step); }},
            {"flyslower", ": Flies a quarter slower.",
             [](Client& c, CommandArguments) { change_speed(c, 1.0f / speed_step); }},
            {"toggleconsole", ": Opens or closes the console.",
             [](Client& c, CommandArguments) { c.console().set_open(!c.console().is_open()); }},
            {"clear", ": Empties the console.",
             [](Client& c, CommandArguments) { c.console().clear_lines(); }},
            {"condump", "[NAME]: Writes what the console holds as outdir/NAME.txt.", dump_console}};
}

void add_binding_commands(CommandRegistry& commands, KeyBindings& bindings) {
    commands.add(
        "bind",
        "KEY [COMMAND...]: Runs the command when the key is pressed. Alone, it prints what the key "
        "runs.",
        [&](CommandArguments arguments) { bind(bindings, arguments, commands.trust()); },
        key_candidates);
    commands.add(
        "unbind", "KEY: Takes the command from a key.",
        [&](CommandArguments arguments) {
            bindings.bind(key_argument(arguments[0]), "", commands.trust());
        },
        key_candidates);
    commands.add("unbindall", ": Takes the commands from all keys.",
                 [&](CommandArguments) { bindings.unbind_all(commands.trust()); });
    commands.add("bindlist", ": Lists the keys and what they run.",
                 [&bindings](CommandArguments) { log_info("{}", bindings.list_text()); });
}

} // namespace vigil::client
