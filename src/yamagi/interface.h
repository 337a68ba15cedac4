// SPDX-License-Identifier: GPL-2.0-or-later
// What Yamagi Quake II and a renderer's module hand each other, as bytes: our own names for what
// was found by trying versions 8.20, 8.50 and 8.70 of the engine (API 5, 7 and 8) on x86-64. Every
// size and offset is asserted; docs/play/quake2.md says how they were found. Nothing here does
// anything.
#pragma once

#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace vigil::yamagi {

/// A truth value that some versions of the engine declare as an int and others as a byte: what is
/// returned is good for both.
using Flag = int32_t;

/// A variable of the engine. Only the engine makes them; `modified` may be 1 byte or 4.
struct EngineVariable {
    const char* name;
    const char* text;
    const char* latched_text;
    int32_t flags;
    int32_t modified;
    float value;
    EngineVariable* next;
    const char* default_text;
};
static_assert(sizeof(EngineVariable) == 56);
static_assert(offsetof(EngineVariable, text) == 8 && offsetof(EngineVariable, flags) == 24 &&
              offsetof(EngineVariable, value) == 32 && offsetof(EngineVariable, next) == 40);

/// EngineVariable::flags: kept in the engine's configuration file.
inline constexpr int variable_archived = 1;

/// What print() is for: all people, or developers.
inline constexpr int print_all = 0;

// What the engine's models and pictures are, to the engine: pointers that it gives back. A picture
// begins with its name.
struct ModelObject;
struct PictureObject {
    char name[64];
};
static_assert(sizeof(PictureObject) == 64);

/// One thing of a view. Angles in degrees as in Quake; alpha counts where the flag translucent is
/// set.
struct ViewEntity {
    const ModelObject* model;
    float angles[3];
    float origin[3];
    int32_t frame;
    float old_origin[3];
    int32_t old_frame;
    float backlerp;
    int32_t skin_number;
    int32_t light_style;
    float alpha;
    const PictureObject* skin;
    int32_t flags;
};
static_assert(sizeof(ViewEntity) == 88);
static_assert(offsetof(ViewEntity, angles) == 8 && offsetof(ViewEntity, origin) == 20 &&
              offsetof(ViewEntity, frame) == 32 && offsetof(ViewEntity, old_origin) == 36 &&
              offsetof(ViewEntity, old_frame) == 48 && offsetof(ViewEntity, backlerp) == 52 &&
              offsetof(ViewEntity, skin_number) == 56 && offsetof(ViewEntity, light_style) == 60 &&
              offsetof(ViewEntity, alpha) == 64 && offsetof(ViewEntity, skin) == 72 &&
              offsetof(ViewEntity, flags) == 80);

/// Bits of ViewEntity::flags, the game's own.
enum ViewEntityFlags : uint32_t {
    flag_min_light = 0x1,
    flag_viewer_model = 0x2,
    flag_weapon_model = 0x4,
    flag_full_bright = 0x8,
    flag_depth_hack = 0x10,
    flag_translucent = 0x20,
    flag_beam = 0x80,
    flag_glow = 0x200,
    flag_shell_red = 0x400,
    flag_shell_green = 0x800,
    flag_shell_blue = 0x1000,
    flag_infrared_visible = 0x8000,
    flag_shell_double = 0x10000,
    flag_shell_half_damage = 0x20000,
    flags_shell = flag_shell_red | flag_shell_green | flag_shell_blue | flag_shell_double |
                  flag_shell_half_damage,
};

struct ViewLight {
    float origin[3];
    float color[3];
    float intensity; // how far it reaches, map units
};
static_assert(sizeof(ViewLight) == 28 && offsetof(ViewLight, color) == 12 &&
              offsetof(ViewLight, intensity) == 24);

struct ViewParticle {
    float origin[3];
    int32_t color; // of the palette
    float alpha;
};
static_assert(sizeof(ViewParticle) == 20 && offsetof(ViewParticle, color) == 12 &&
              offsetof(ViewParticle, alpha) == 16);

/// `white` is the sum of the three.
struct ViewLightStyle {
    float rgb[3];
    float white;
};
static_assert(sizeof(ViewLightStyle) == 16);
inline constexpr int view_light_styles = 256;

/// One view: a rectangle of the screen, the camera, and all that is seen. Pointers are good for the
/// call alone.
struct EngineView {
    int32_t x, y, width, height;
    float fov_x, fov_y;
    float origin[3];
    float angles[3];
    float blend[4]; // colour and opacity over the view
    float time_s;
    uint32_t flags;
    const uint8_t* open_areas;
    const ViewLightStyle* light_styles;
    int32_t entity_count;
    const ViewEntity* entities;
    int32_t light_count;
    const ViewLight* lights;
    int32_t particle_count;
    const ViewParticle* particles;
};
static_assert(sizeof(EngineView) == 136);
static_assert(offsetof(EngineView, fov_x) == 16 && offsetof(EngineView, origin) == 24 &&
              offsetof(EngineView, angles) == 36 && offsetof(EngineView, blend) == 48 &&
              offsetof(EngineView, time_s) == 64 && offsetof(EngineView, flags) == 68 &&
              offsetof(EngineView, open_areas) == 72 && offsetof(EngineView, light_styles) == 80 &&
              offsetof(EngineView, entity_count) == 88 && offsetof(EngineView, entities) == 96 &&
              offsetof(EngineView, light_count) == 104 && offsetof(EngineView, lights) == 112 &&
              offsetof(EngineView, particle_count) == 120 &&
              offsetof(EngineView, particles) == 128);

/// Bits of EngineView::flags.
enum EngineViewFlags : uint32_t {
    view_underwater = 1,
    view_without_level = 2,
    view_infrared = 4,
};

/// What the engine offers. Texts that it takes it does not change.
struct EngineFunctions {
    void (*error)(int level, const char* text, ...);
    void (*add_command)(const char* name, void (*command)());
    void (*remove_command)(const char* name);
    int (*argument_count)();
    const char* (*argument)(int index);
    void (*execute)(int when, const char* text);
    void (*print)(int level, const char* format, va_list arguments);
    int (*load_file)(const char* name, void** content); // its bytes; below 0 or null: no such file
    void (*free_file)(void* content);
    const char* (*game_folder)();
    EngineVariable* (*variable)(const char* name, const char* default_text, int flags);
    EngineVariable* (*set_variable)(const char* name, const char* text);
    void (*set_variable_value)(const char* name, float value);
    Flag (*mode_size)(int* width, int* height, int mode);
    void (*init_menu)();
    void (*write_screenshot)(int width, int height, int components, const void* texels);
    Flag (*open_window)(int fullscreen, int* width, int* height);
    Flag (*desktop_size)(int* width, int* height);
    void (*request_restart)(int what);
};
static_assert(sizeof(EngineFunctions) == 152);

/// The module's side, as API 8 has it. What of it a version knows is in `ApiLayout`.
struct ModuleFunctions {
    int32_t api_version;
    int32_t
        framework_version; // from API 7 on: the main version of SDL; room that is not read before
    Flag (*init)();
    void (*shutdown)();
    int (*prepare_for_window)(); // flags of SDL_CreateWindow, or -1
    int (*init_context)(void* window);
    void (*drawable_size)(int* width, int* height); // from API 6 on
    void (*shutdown_context)();
    Flag (*is_vsync_active)();
    void (*begin_registration)(const char* level);
    ModelObject* (*register_model)(const char* name);
    PictureObject* (*register_skin)(const char* name);
    void (*set_sky)(const char* name, float degrees_per_second, float axis[3]);
    void (*end_registration)();
    void (*render_view)(const EngineView* view);
    PictureObject* (*find_picture)(const char* name);
    void (*picture_size)(int* width, int* height, const char* name);
    void (*draw_picture)(int x, int y, const char* name, float factor);
    void (*draw_stretched)(int x, int y, int width, int height, const char* name);
    void (*draw_character)(int x, int y, int character, float scale);
    void (*draw_tiles)(int x, int y, int width, int height, const char* name);
    void (*draw_fill)(int x, int y, int width, int height, int color);
    void (*draw_fade)();
    // `bits` from API 6 on: 8, or 32 where texels are RGBA.
    void (*draw_film)(int x, int y, int width, int height, int columns, int rows,
                      const uint8_t* texels, int bits);
    void (*set_palette)(const uint8_t* palette); // 768 bytes; null: the game's
    void (*begin_frame)(float camera_separation);
    void (*end_frame)();
    Flag (*end_level_view)();
    // From API 8 on; the colour has three parts of 0..1.
    void (*draw_coloured)(int x, int y, const char* name, float factor, const float* color);
};
static_assert(sizeof(ModuleFunctions) == 224);
static_assert(offsetof(ModuleFunctions, drawable_size) == 40 &&
              offsetof(ModuleFunctions, draw_coloured) == 216);

/// Bytes of the structure that GetRefAPI returns, by API version: 208 for 5, 216 for 6 and 7, 224
/// for 8.
inline constexpr size_t smallest_api = 208;
constexpr size_t bytes_of_api(int version) {
    return version <= 5 ? smallest_api : version <= 7 ? 216 : 224;
}

/// Writes the structure as its version has it: without drawable_size before API 6, and no more than
/// bytes_of_api().
inline void write_api(const ModuleFunctions& functions, void* target) {
    auto* const to = static_cast<std::byte*>(target);
    const auto* const from = reinterpret_cast<const std::byte*>(&functions);
    constexpr size_t added = offsetof(ModuleFunctions, drawable_size), pointer = sizeof(void*);
    const size_t left_out = functions.api_version <= 5 ? pointer : 0;
    std::memcpy(to, from, added);
    std::memcpy(to + added, from + added + left_out, bytes_of_api(functions.api_version) - added);
}

} // namespace vigil::yamagi
