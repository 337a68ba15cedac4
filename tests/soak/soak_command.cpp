// SPDX-License-Identifier: GPL-2.0-or-later
// The console command soak.
#include "soak/soak_command.h"

#include "client/client.h"
#include "common/error.h"
#include "common/log.h"
#include "console/arguments.h"
#include "console/outdir.h"
#include "level/level.h"
#include "soak/soak.h"
#include "soak/soak_script.h"

namespace vigil::client {

namespace {

void report(const Soak& soak, const refresh::Health& health, double seconds) {
    const std::string text = fmt::format(
        "soak: {:.1f} minutes, {} frames, {} levels and demos, {} switches of variables; {} values "
        "that were not finite, {} messages of the validation layer",
        seconds / 60.0, soak.frames(), soak.levels(), soak.switches(), health.nonfinite,
        health.validation_messages);
    if (health.nonfinite > 0 || health.validation_messages > 0) fail("{}", text);
    log_info("{}", text);
}

void add(refresh::Health& sum, const refresh::Health& more) {
    sum.nonfinite += more.nonfinite;
    sum.validation_messages += more.validation_messages;
}

void run_soak(Client& client, CommandArguments arguments) {
    const double minutes = static_cast<double>(number_at(arguments, 0, "the minutes"));
    const auto seed =
        arguments.size() > 1 ? static_cast<uint32_t>(number_at(arguments, 1, "the seed")) : 1u;
    const FileSystem& files = client.session().files();
    SoakChoices choices{list_levels(files), files.list("demos/", ".dm2")};
    if (choices.levels.empty()) fail("there are no levels to play");
    const auto soak = std::make_shared<Soak>(std::move(choices), seed);
    const auto script = std::make_shared<SoakScript>(
        output_path("soak.cfg"), fmt::format("Typed by `soak {:g} {}`.", minutes, seed));
    const auto watch = std::make_shared<Stopwatch>();
    const auto health = std::make_shared<refresh::Health>(); // of renderers that are gone
    const Trust trust = client.commands().trust();
    client.commands().pause_script_until([&client, soak, script, watch, health, minutes, trust] {
        if (watch->seconds() >= 60.0 * minutes) {
            add(*health, client.session().renderer().health());
            client.attempt("soak", [&] { report(*soak, *health, watch->seconds()); });
            return true;
        }
        const bool walks = client.play() != nullptr && !client.playing() && !client.flying();
        const std::string commands = soak->next(walks);
        if (!client.attempt("soak", [&] { script->add_frame(commands); })) return true;
        if (commands == Soak::restart) add(*health, client.session().renderer().health());
        client.commands().execute_text(commands, "soak", trust);
        return false;
    });
}

} // namespace

void add_soak_command(Client& client) {
    client.commands().add(
        "soak",
        "MINUTES [SEED]: plays at random, switching levels, demos and variables, and "
        "writes what it types to soak.cfg; fails when a value was not finite "
        "or validation had a message",
        [&client](CommandArguments arguments) { run_soak(client, arguments); });
}

} // namespace vigil::client
