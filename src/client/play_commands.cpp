// SPDX-License-Identifier: GPL-2.0-or-later
// Console commands about playing a level: noclip, kill, playerinfo, walk, walkrecord, walkstop.
#include "client/client.h"
#include "common/error.h"
#include "common/log.h"
#include "console/arguments.h"
#include "console/outdir.h"

namespace vigil::client {

namespace {

void check_playable(const Client& client) {
    const Session& session = client.session();
    if (session.level() == nullptr) fail("no level is loaded. `map NAME` loads one.");
    if (client.flying()) fail("the camera flies along a route. Wait for its end.");
    if (session.played() != nullptr) fail("a demo is shown. `map NAME` begins something new.");
}

void noclip(Client& client, CommandArguments) {
    check_playable(client);
    const bool fresh = client.play() == nullptr;
    if (fresh) {
        client.start_play();
        client.play()->set_walking(false, client.session());
    }
    Play& play = *client.play();
    if (play.following()) fail("a recorded walk is followed. `walkstop` ends it.");
    if (play.recording()) fail("a walk is being recorded. `walkstop` ends it.");
    if (play.walking()) {
        play.set_walking(false, client.session());
        log_info("flying through walls");
    } else {
        const bool roomy = play.set_walking(true, client.session());
        log_info(
            "{}",
            roomy ? "walking"
                  : "walking. There is no room here, so the player returns to where flight began.");
    }
}

void kill(Client& client, CommandArguments) {
    check_playable(client);
    Play* play = client.play();
    if (play == nullptr || !play->walking()) fail("nobody walks. `noclip` starts a player.");
    if (play->following()) fail("a recorded walk is followed. `walkstop` ends it.");
    if (play->recording()) fail("a walk is being recorded. `walkstop` ends it.");
    play->kill(client.session());
}

void player_info(Client& client, CommandArguments) {
    if (client.play() == nullptr) fail("nobody walks. `noclip` starts a player.");
    const PlayerState& player = client.play()->game().player();
    log_info("player {} {} {}, velocity {} {} {}, {}{}{}, tick {}", player.origin.x,
             player.origin.y, player.origin.z, player.velocity.x, player.velocity.y,
             player.velocity.z,
             player.on_ladder              ? "on a ladder"
             : player.ground != owner_none ? "on the ground"
             : player.water_level >= 2     ? "swimming"
                                           : "in the air",
             player.ducked ? ", ducked" : "",
             player.water_level > 0 ? fmt::format(", water level {}", player.water_level) : "",
             client.play()->game().ticks());
}

void walk(Client& client, CommandArguments arguments) {
    check_playable(client);
    Walk walk = load_walk(client.session().files(), client.variables()->outdir, arguments[0]);
    client.start_play();
    client.play()->follow(std::move(walk));
    client.console().set_open(false);
    client.commands().pause_script_until(
        [&client] { return client.play() == nullptr || !client.play()->following(); });
}

void walk_record(Client& client, CommandArguments arguments) {
    check_playable(client);
    const std::string path = walk_path(arguments[0]);
    check_output(output_path(path));
    client.start_play();
    client.play()->record(path);
    log_info("recording {} from the level's start. `walkstop` ends it.", path);
}

void walk_stop(Client& client, CommandArguments) {
    if (client.play() != nullptr && client.play()->recording())
        client.write_walk();
    else if (client.play() != nullptr && client.play()->following())
        client.play()->stop_following();
    else
        fail("no walk is recorded or followed");
}

} // namespace

ClientCommands play_commands() {
    return {
        {"noclip",
         ": Switches between walking and flying through walls. Without a window, play begins with "
         "it.",
         noclip},
        {"kill", ": Ends the player's life. The player starts anew, and the level goes on.", kill},
        {"playerinfo", ": Prints place and speed of the player.", player_info},
        {"walk",
         "NAME: Starts the level anew and follows a recorded walk. It is outdir/walks/NAME.walk, "
         "or "
         "one of the game.",
         walk},
        {"walkrecord",
         "NAME: Starts the level anew and records keys and view of every tick. `walkstop` ends it.",
         walk_record},
        {"walkstop", ": Ends the walk that is recorded or followed.", walk_stop}};
}

} // namespace vigil::client
