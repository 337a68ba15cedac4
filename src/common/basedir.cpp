// SPDX-License-Identifier: GPL-2.0-or-later
// Where game data is when nobody says so. The build passes the source folder and the installed data
// folder.
#include "common/error.h"
#include "common/file_system.h"

#include <system_error>

namespace vigil {

std::filesystem::path find_basedir(std::string_view basedir) {
    namespace fs = std::filesystem;
    if (!basedir.empty()) return basedir;

    std::vector<fs::path> places;
    std::error_code fault;
    if (const fs::path program = fs::read_symlink("/proc/self/exe", fault); !fault) {
        places.push_back(program.parent_path());
        places.push_back(program.parent_path().parent_path());
    }
    places.emplace_back(VIGIL_SOURCE_FOLDER);
    places.emplace_back(VIGIL_DATA_FOLDER);

    std::string looked_in;
    for (const fs::path& place : places) {
        if (fs::is_directory(place / "baseq2", fault)) return place;
        looked_in += (looked_in.empty() ? "" : ", ") + place.string();
    }
    fail("no folder baseq2 in {}; say where it is with +set basedir FOLDER", looked_in);
}

} // namespace vigil
