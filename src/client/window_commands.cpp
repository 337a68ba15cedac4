// SPDX-License-Identifier: GPL-2.0-or-later
// Console commands about the window: togglemenu, resolution.
#include "client/client.h"
#include "common/log.h"
#include "console/arguments.h"

namespace vigil::client {

namespace {

void toggle_menu(Client& client, CommandArguments) {
    if (client.menu().is_open()) {
        client.menu().close();
        return;
    }
    client.console().set_open(false);
    client.menu().open();
}

void resolution(Client& client, CommandArguments arguments) {
    if (arguments.empty()) {
        const glm::ivec2 size = client.picture_size();
        log_info("the picture has {} x {} pixels", size.x, size.y);
        return;
    }
    const auto& width = *find_cvar("vid_width");
    const int least = static_cast<int>(width.minimum), most = static_cast<int>(width.maximum);
    const glm::ivec2 size(integer_at(arguments, 0, "WIDTH", least, most),
                          integer_at(arguments, 1, "HEIGHT", least, most));
    CommandRegistry& commands = client.commands();
    commands.set_variable("vid_width", std::to_string(size.x));
    commands.set_variable("vid_height", std::to_string(size.y));
    if (!client.headless() && client.variables()->vid_fullscreen != 0)
        log_info("in full screen the picture has the screen's size; this is the window's");
    client.set_window_size(size);
}

} // namespace

void add_window_commands(Client& client) {
    add_commands(client, {{"togglemenu", ": opens or closes the menu", toggle_menu},
                          {"resolution",
                           "[WIDTH HEIGHT]: size of the window, or, without one, of the pictures",
                           resolution}});
}

} // namespace vigil::client
