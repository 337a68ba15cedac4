// SPDX-License-Identifier: GPL-2.0-or-later
// A folder of its own for a test: game data with one small level and one route, places for the
// program's output, configuration and caches. Everything disappears with it.
#pragma once

#include "formats/small_level.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <span>
#include <string>
#include <string_view>

namespace vigil::client {

/// Entities of the level "tiny": a start, a brush model "lamp", a switched light that starts off.
inline constexpr std::string_view tiny_entities = R"({
"classname" "worldspawn"
}
{
"classname" "info_player_start"
"origin" "32 32 24"
"angle" "90"
}
{
"classname" "func_wall"
"model" "*1"
"origin" "1 2 3"
"targetname" "lamp"
}
{
"classname" "light"
"style" "32"
"spawnflags" "1"
}
)";

class TestGame {
public:
    TestGame() {
        root_ = std::filesystem::temp_directory_path() /
                ("vigil_client_test_" + std::to_string(std::random_device{}()));
        write_level_file("tiny", tiny_entities);
        write("data/baseq2/routes/line.route", "# seconds, place, direction\n"
                                               "0   0 0 10  0 0 0\n"
                                               "0.5 100 0 10  0 90 0  # halfway\n");
        setenv("XDG_CONFIG_HOME", (root_ / "config").c_str(), 1);
        setenv("XDG_CACHE_HOME", (root_ / "cache").c_str(), 1);
        unsetenv("DISPLAY");
        unsetenv("WAYLAND_DISPLAY");
    }
    ~TestGame() {
        std::error_code ignored;
        std::filesystem::remove_all(root_, ignored);
    }
    TestGame(const TestGame&) = delete;
    TestGame& operator=(const TestGame&) = delete;

    std::filesystem::path path(std::string_view name) const { return root_ / name; }
    std::string basedir() const { return path("data").string(); }
    std::string outdir() const { return path("out").string(); }

    void write(std::string_view name, std::string_view text) const {
        std::filesystem::create_directories(path(name).parent_path());
        std::ofstream(path(name), std::ios::binary) << text;
    }
    std::string read(std::string_view name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    bool exists(std::string_view name) const { return std::filesystem::exists(path(name)); }

    void write_level_file(std::string_view name, std::string_view entities) const {
        LevelLumps lumps = small_level();
        lumps[level_entities].clear();
        append_text(lumps[level_entities], entities, entities.size() + 1);
        const Bytes bytes = write_level(lumps);
        write("data/baseq2/maps/" + std::string(name) + ".bsp",
              {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }

private:
    std::filesystem::path root_;
};

} // namespace vigil::client
