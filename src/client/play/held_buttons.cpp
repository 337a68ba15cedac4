// SPDX-License-Identifier: GPL-2.0-or-later
// The table of held commands, named as in Quake II.
#include "client/play/held_buttons.h"

#include <fmt/format.h>

namespace vigil::client {

void HeldButtons::add_commands(CommandRegistry& commands) {
    struct Row {
        Button button;
        std::string_view name;
        std::string_view help;
    };
    static constexpr Row rows[] = {
        {Forward, "forward", "Walks or flies forward"},
        {Back, "back", "Walks or flies backward"},
        {MoveLeft, "moveleft", "Walks or flies left"},
        {MoveRight, "moveright", "Walks or flies right"},
        {MoveUp, "moveup", "Jumps, swims or flies up"},
        {MoveDown, "movedown", "Crouches, dives or flies down"},
        {TurnLeft, "left", "Turns left"},
        {TurnRight, "right", "Turns right"},
        {LookUp, "lookup", "Looks up"},
        {LookDown, "lookdown", "Looks down"},
        {Fast, "speed", "Walks slowly, or flies three times as fast"},
        {Attack, "attack", "Shoots the blaster"},
    };
    for (const Row& row : rows) {
        State& state = states_[row.button];
        const auto key_of = [](CommandArguments arguments) {
            return arguments.empty() ? std::string() : arguments[0];
        };
        commands.add(fmt::format("+{}", row.name),
                     fmt::format("[KEY]: {} while the key is held.", row.help),
                     [&state, key_of](CommandArguments arguments) {
                         state.keys.insert(key_of(arguments));
                         state.pressed = true;
                     });
        commands.add(fmt::format("-{}", row.name), fmt::format("[KEY]: Ends +{}.", row.name),
                     [&state, key_of](CommandArguments arguments) {
                         // Typed without a key, it ends the command whoever holds it.
                         if (arguments.empty()) state.keys.clear();
                         state.keys.erase(key_of(arguments));
                     });
    }
}

float HeldButtons::take(Button button) {
    State& state = states_[button];
    const float amount = !state.keys.empty() ? 1.0f : state.pressed ? 0.5f : 0.0f;
    state.pressed = false;
    return amount;
}

FlightInput HeldButtons::take_frame() {
    FlightInput input;
    input.forward = take(Forward) - take(Back);
    input.right = take(MoveRight) - take(MoveLeft);
    input.up = take(MoveUp) - take(MoveDown);
    input.turn_left = take(TurnLeft) - take(TurnRight);
    input.look_up = take(LookUp) - take(LookDown);
    input.fast = take(Fast) > 0.0f;
    input.attack = take(Attack) > 0.0f;
    return input;
}

} // namespace vigil::client
