// SPDX-License-Identifier: GPL-2.0-or-later
// GetRefAPI, the one function that the module shows, and the C functions that the engine calls. No
// exception leaves them: what one says is told at the engine's console, and the call does nothing.
#include "common/log.h"
#include "yamagi/module.h"

#include <algorithm>
#include <cstring>
#include <exception>

namespace vigil::yamagi {

namespace {

EngineFunctions engine_functions{};
std::unique_ptr<Module> module; // between init and shutdown
int api = 0;

/// Runs `call` on the module; `otherwise` where there is none, or where it fails.
template <typename Call, typename Result>
Result guarded(const Call& call, Result otherwise) noexcept {
    if (!module) return otherwise;
    try {
        module->tell_pending();
        return call(*module);
    } catch (const std::exception& error) {
        module->engine().print(error.what());
    } catch (...) {
        module->engine().print("vigil: an unknown failure");
    }
    return otherwise;
}

template <typename Call> void guarded(const Call& call) noexcept {
    guarded(
        [&](Module& running) {
            call(running);
            return true;
        },
        false);
}

std::string_view text_of(const char* text) {
    return text != nullptr ? text : "";
}

/// A command of the console that calls a member.
template <void (Module::*member)()> void command() {
    guarded([](Module& running) { (running.*member)(); });
}

struct Command {
    const char* name;
    void (*run)();
};
constexpr Command commands[] = {
    {"screenshot", command<&Module::take_screenshot>},
    {"scene", command<&Module::say_scene>},
    {"guiding", command<&Module::say_guiding>},
    {"guidingreset", command<&Module::reset_guiding>},
    {"vlcinfo", command<&Module::say_light_cache>},
    {"cdqinfo", command<&Module::say_quadtree>},
    {"passes", command<&Module::say_passes>},
};

void shut_down() {
    if (!module) return;
    for (const Command& one : commands)
        engine_functions.remove_command(one.name);
    module.reset();
}

Flag init() {
    shut_down();
    try {
        module = std::make_unique<Module>(engine_functions);
    } catch (const std::exception& error) {
        Engine(engine_functions).print(error.what());
        return 0;
    }
    for (const Command& one : commands)
        engine_functions.add_command(one.name, one.run);
    const bool works = guarded([](Module& running) { return running.init(); }, false);
    if (!works) shut_down();
    return works ? 1 : 0;
}

int prepare_for_window() {
    return guarded([](Module& running) { return running.prepare_for_window(); }, -1);
}

int init_context(void* window) {
    return guarded(
        [&](Module& running) {
            running.init_context(window);
            return 1;
        },
        0);
}

void shutdown_context() {
    guarded([](Module& running) { running.shutdown_context(); });
}

void drawable_size(int* width, int* height) {
    const glm::ivec2 size =
        guarded([](Module& running) { return running.drawable_size(); }, glm::ivec2(0));
    *width = size.x;
    *height = size.y;
}

Flag is_vsync_active() {
    return guarded([](Module& running) { return running.vsync() ? 1 : 0; }, 0);
}

void begin_registration(const char* level) {
    guarded([&](Module& running) { running.begin_registration(text_of(level)); });
}

ModelObject* register_model(const char* name) {
    return guarded([&](Module& running) { return running.register_model(text_of(name)); },
                   static_cast<ModelObject*>(nullptr));
}

PictureObject* register_skin(const char* name) {
    return guarded(
        [&](Module& running) -> PictureObject* {
            return running.screen().find_skin(text_of(name));
        },
        static_cast<PictureObject*>(nullptr));
}

void set_sky(const char* name, float degrees_per_second, float axis[3]) {
    guarded([&](Module& running) {
        running.set_sky(text_of(name), degrees_per_second, {axis[0], axis[1], axis[2]});
    });
}

void end_registration() {}

void render_view(const EngineView* view) {
    guarded([&](Module& running) { running.render_view(*view); });
}

PictureObject* find_picture(const char* name) {
    return guarded(
        [&](Module& running) -> PictureObject* { return running.screen().find(text_of(name)); },
        static_cast<PictureObject*>(nullptr));
}

void picture_size(int* width, int* height, const char* name) {
    const glm::ivec2 size = guarded(
        [&](Module& running) { return running.screen().size_of(text_of(name)); }, glm::ivec2(0));
    *width = size.x;
    *height = size.y;
}

void draw_picture(int x, int y, const char* name, float factor) {
    guarded([&](Module& running) { running.screen().picture({x, y}, text_of(name), factor); });
}

void draw_coloured(int x, int y, const char* name, float factor, const float* color) {
    guarded([&](Module& running) {
        const glm::vec3 tint =
            color != nullptr ? glm::vec3(color[0], color[1], color[2]) : glm::vec3(1.0f);
        running.screen().picture({x, y}, text_of(name), factor, tint);
    });
}

void draw_stretched(int x, int y, int width, int height, const char* name) {
    guarded([&](Module& running) {
        running.screen().stretched({x, y}, {width, height}, text_of(name));
    });
}

void draw_character(int x, int y, int character, float scale) {
    guarded([&](Module& running) { running.screen().character({x, y}, character, scale); });
}

void draw_tiles(int x, int y, int width, int height, const char* name) {
    guarded([&](Module& running) {
        running.screen().tiles({x, y}, {width, height}, text_of(name));
    });
}

void draw_fill(int x, int y, int width, int height, int color) {
    guarded([&](Module& running) { running.screen().fill({x, y}, {width, height}, color); });
}

void draw_fade() {
    guarded([](Module& running) { running.screen().fade(); });
}

void draw_film(int x, int y, int width, int height, int columns, int rows, const uint8_t* texels,
               int bits) {
    guarded([&](Module& running) {
        running.screen().film({x, y}, {width, height}, {columns, rows}, texels,
                              api >= 6 ? bits : 8); // before, there was no such argument
    });
}

void set_palette(const uint8_t* palette) {
    guarded([&](Module& running) { running.screen().set_film_palette(palette); });
}

void begin_frame(float) {
    guarded([](Module& running) { running.begin_frame(); });
}

void end_frame() {
    guarded([](Module& running) { running.end_frame(); });
}

Flag end_level_view() {
    return 1;
}

} // namespace

} // namespace vigil::yamagi

/// The engine's declaration returns a structure by value and takes one, which on x86-64 is a
/// pointer to the former as a first argument that is returned, and the latter on the stack. So only
/// as many bytes are written as this version of the engine made room for.
extern "C" [[gnu::visibility("default")]] void*
GetRefAPI(void* result, vigil::yamagi::EngineFunctions functions) {
    using namespace vigil::yamagi;
    engine_functions = functions;
    const Engine engine(functions);
    const std::string version = engine.text("version", "");
    const int asked = static_cast<int>(engine.value("vigil_api", "0"));
    api = asked >= 5 && asked <= 8 ? asked : api_of(version);
    if (api == 0)
        engine.print(fmt::format("vigil: version \"{}\" of the engine is not known; "
                                 "`set vigil_api 5`, 6, 7 or 8 says which one it is like",
                                 version));
    ModuleFunctions exported{};
    exported.api_version = api;
    exported.framework_version = api >= 7 ? sdl_version() : 0;
    exported.init = init;
    exported.shutdown = shut_down;
    exported.prepare_for_window = prepare_for_window;
    exported.init_context = init_context;
    exported.drawable_size = drawable_size;
    exported.shutdown_context = shutdown_context;
    exported.is_vsync_active = is_vsync_active;
    exported.begin_registration = begin_registration;
    exported.register_model = register_model;
    exported.register_skin = register_skin;
    exported.set_sky = set_sky;
    exported.end_registration = end_registration;
    exported.render_view = render_view;
    exported.find_picture = find_picture;
    exported.picture_size = picture_size;
    exported.draw_picture = draw_picture;
    exported.draw_stretched = draw_stretched;
    exported.draw_character = draw_character;
    exported.draw_tiles = draw_tiles;
    exported.draw_fill = draw_fill;
    exported.draw_fade = draw_fade;
    exported.draw_film = draw_film;
    exported.set_palette = set_palette;
    exported.begin_frame = begin_frame;
    exported.end_frame = end_frame;
    exported.end_level_view = end_level_view;
    exported.draw_coloured = draw_coloured;
    write_api(exported, result);
    return result;
}
