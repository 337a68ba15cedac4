// SPDX-License-Identifier: GPL-2.0-or-later
// Loading a level by its name.
#include "level/level.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "common/file_system.h"

namespace vigil {

namespace {

constexpr std::string_view folder = "maps/";
constexpr std::string_view extension = ".bsp";

std::string_view strip(std::string_view name) {
    if (starts_nocase(name, folder)) name.remove_prefix(folder.size());
    if (ends_nocase(name, extension)) name.remove_suffix(extension.size());
    return name;
}

} // namespace

std::shared_ptr<const Level> load_level(const FileSystem& files, std::string_view name) {
    auto level = std::make_shared<Level>();
    level->name = strip(name);
    const std::string path = fmt::format("{}{}{}", folder, level->name, extension);
    if (level->name.empty() || !files.exists(path)) {
        fail("there is no level {}. `maps` lists the levels.", path);
    }
    level->bsp = parse_bsp(path, files.read(path));
    level->pvs = Pvs(level->bsp);
    return level;
}

std::vector<std::string> list_levels(const FileSystem& files) {
    std::vector<std::string> names;
    for (const std::string& path : files.list(folder, extension)) {
        names.emplace_back(strip(path));
    }
    return names;
}

} // namespace vigil
