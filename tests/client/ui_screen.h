// SPDX-License-Identifier: GPL-2.0-or-later
// Console and menu in a real ImGui context, without a window or a GPU: events go in as a window
// reports them, one frame of widgets after each, as the client does it.
#pragma once

#include "client/play/camera.h"
#include "client/ui/input.h"
#include "client/ui/overlay.h"

#include <string>
#include <vector>

namespace vigil::client {

class UiScreen {
public:
    UiScreen(CommandRegistry& commands, KeyBindings& bindings, Clipboard clipboard = {},
             std::vector<std::string> levels = {"one", "two words", "three"})
        : overlay(std::move(clipboard)), console(commands),
          menu({commands, bindings, [levels] { return levels; },
                [] { return std::vector<std::string>(); }, [] { return glm::ivec2(640, 360); }}),
          input(commands, bindings, console, menu, camera) {}

    void send(const platform::Event& event) {
        if (console.is_open() && !console.has_keyboard()) draw();
        if (!input.handle(event, !console.is_open() && !menu.is_open())) return;
        draw();
        console.run_entered();
        menu.run_clicked();
    }
    void press(platform::Key key, int times = 1) {
        for (int i = 0; i < times; ++i) {
            send(platform::KeyEvent{key, true, false});
            send(platform::KeyEvent{key, false, false});
        }
    }
    void press_with(platform::Key held, platform::Key key) {
        send(platform::KeyEvent{held, true, false});
        press(key);
        send(platform::KeyEvent{held, false, false});
    }
    void type(const std::string& text) { send(platform::TextEvent{text}); }
    void point(glm::vec2 place) { send(platform::MouseMoveEvent{place, {}}); }
    /// One frame of `seconds`. Returns what it draws; null: nothing.
    ImDrawData* draw(double seconds = 0.0) {
        console.update(time_s += seconds);
        return overlay.draw({console, menu, stats, notify_s}, size, seconds);
    }

    glm::ivec2 size{640, 360};
    double time_s = 0.0;
    double notify_s = 3.0;
    std::vector<std::string> stats;
    Overlay overlay;
    Console console;
    Camera camera;
    Menu menu;
    Input input;
};

} // namespace vigil::client
