// SPDX-License-Identifier: GPL-2.0-or-later
// The renderer from outside, in one page: opens a level, draws a frame of it with a picture on top,
// and saves it. It knows refresh.h, the file system and the level loader; no variables, no console,
// no window.
//
//     one_frame BASEDIR LEVEL PICTURE FILE.ppm      one_frame baseq2/.. warehouse pics/tag1.pcx
//     out.ppm
#include "common/error.h"
#include "common/file_system.h"
#include "level/level.h"
#include "refresh/refresh.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <span>
#include <vector>

using namespace vigil;

namespace {

/// Where a player starts, looking along the angle that the level says.
refresh::View start_of(const Level& level) {
    refresh::View view;
    for (const vigil::Entity& entity : level.bsp.entities)
        if (entity.classname() == "info_player_start") {
            view.origin = entity.get_vec3("origin") + glm::vec3(0, 0, 22);
            view.angles.y = entity.get_float("angle");
        }
    return view;
}

void save(const refresh::Picture& picture, const char* path) {
    std::ofstream file(path, std::ios::binary);
    file << "P6 " << picture.width << ' ' << picture.height << " 255\n";
    for (size_t i = 0; i < picture.rgba.size(); i += 4)
        file.write(reinterpret_cast<const char*>(&picture.rgba[i]), 3);
    if (!file.flush()) fail("{}: cannot write", path);
}

void draw(const char* basedir, const char* name, const char* picture_name, const char* path) {
    FileSystem files;
    files.mount_game(basedir, "baseq2");

    // The settings come with the renderer, with levels and with frames. Here they stay the same.
    refresh::Settings settings;
    settings.vid_width = 320;
    settings.vid_height = 180;
    settings.pt_spp = 2;
    const auto renderer = refresh::make_vkpt_renderer(files, nullptr, settings);
    const std::shared_ptr<const Level> level = load_level(files, name);
    renderer->load_level(level, settings);

    // Brush models are entities: all that the level has stand where they were built.
    std::vector<refresh::Entity> entities;
    for (const vigil::Entity& entity : level->bsp.entities)
        if (const std::string model = entity.get_string("model"); model.starts_with('*')) {
            refresh::Entity& placed = entities.emplace_back();
            placed.number = static_cast<int>(entities.size());
            placed.model = renderer->register_model(model);
        }

    // What the first Quake II would show at full brightness, half transparent, and a light whose
    // body is not to be seen.
    const refresh::View view = start_of(*level);
    const refresh::Particle spark{view.origin + glm::vec3(40, 0, 0), 2.0f, {1, 0.6f, 0.2f}, 0.5f};
    refresh::DynamicLight light;
    light.origin = view.origin + glm::vec3(0, 0, 20);
    light.radiance = glm::vec3(20.0f);
    light.visible = false;

    // Red over all: a player is hurt. Then a picture in the upper left corner, four times as large,
    // on a dark ground.
    refresh::Draw blend;
    blend.size = {settings.vid_width, settings.vid_height};
    blend.color = {1, 0, 0, 0.1f};
    refresh::Draw picture;
    picture.picture = renderer->register_picture(picture_name);
    picture.corner = {16, 16};
    picture.size = 4 * renderer->picture_size(picture.picture);
    refresh::Draw ground;
    ground.corner = picture.corner - 4;
    ground.size = picture.size + 8;
    ground.color = {0, 0, 0, 0.6f};
    const refresh::Draw draws[] = {blend, ground, picture};

    refresh::Frame frame;
    frame.settings = settings;
    frame.view = view;
    frame.entities = entities;
    frame.dynamic_lights = std::span(&light, 1);
    frame.particles = std::span(&spark, 1);
    frame.draws = draws;
    frame.light_styles.fill(1.0f);
    for (int i = 0; i < 8; ++i) // each learns from the one before
        renderer->render(frame);

    const refresh::Picture result = renderer->read_picture(false);
    save(result, path);
    if (std::ranges::count_if(result.rgba, [](uint8_t value) { return value > 8 && value < 255; }) <
        1000)
        fail("{}: nothing is to be seen", path);
}

} // namespace

/// What main() does, for whoever loads this as a module.
extern "C" [[gnu::visibility("default")]] int one_frame(int argc, char** argv) {
    if (argc != 5) {
        std::fprintf(stderr, "usage: one_frame BASEDIR LEVEL PICTURE FILE.ppm\n");
        return 2;
    }
    try {
        draw(argv[1], argv[2], argv[3], argv[4]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "one_frame: %s\n", error.what());
        return 1;
    }
}

int main(int argc, char** argv) {
    return one_frame(argc, argv);
}
