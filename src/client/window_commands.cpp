// SPDX-License-Identifier: GPL-2.0-or-later
// Console commands about the window: togglemenu and the menu's pages, resolution, vid_restart.
#include "client/client.h"
#include "common/log.h"
#include "console/arguments.h"

namespace vigil::client {

namespace {

void open_menu(Client& client, MenuPage page) {
    client.console().set_open(false);
    client.menu().open(page);
}

void toggle_menu(Client& client, CommandArguments) {
    if (client.menu().is_open())
        client.menu().close();
    else
        open_menu(client, MenuPage::Main);
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
        log_info("The window has this size. In full screen the picture has the screen's size.");
    client.set_window_size(size);
}

} // namespace

ClientCommands window_commands() {
    const auto page = [](MenuPage which) {
        return [which](Client& c, CommandArguments) { open_menu(c, which); };
    };
    return {{"togglemenu", ": Opens or closes the menu.", toggle_menu},
            {"menu_main", ": Opens the menu's first page.", page(MenuPage::Main)},
            {"menu_video", ": Opens the menu's page of window and picture.", page(MenuPage::Video)},
            {"menu_options", ": Opens the menu's page of mouse, controller and keys.",
             page(MenuPage::Controls)},
            {"menu_keys", ": Opens the menu's page of keys.", page(MenuPage::Keys)},
            {"menu_quit", ": Asks whether to end the program.", page(MenuPage::Quit)},
            {"resolution",
             "[WIDTH HEIGHT]: Sets or prints the size of the window, or of headless pictures.",
             resolution},
            {"vid_restart",
             ": Makes window and renderer anew, by the variables vid_ and vk_ as they are now.",
             [](Client& c, CommandArguments) { c.restart_video(); }}};
}

} // namespace vigil::client
