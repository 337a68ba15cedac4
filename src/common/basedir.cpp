// SPDX-License-Identifier: GPL-2.0-or-later
// Where game data is when nobody says so. The build passes the source folder, and the way from the
// installed program's folder to the installed data: an installation can be moved as a whole.
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
        const fs::path folder = program.parent_path();
        places.push_back(folder);
        places.push_back(folder.parent_path());
        places.push_back((folder / VIGIL_DATA_FROM_PROGRAM).lexically_normal());
    }
    places.emplace_back(VIGIL_SOURCE_FOLDER);

    std::string looked_in;
    for (const fs::path& place : places) {
        if (fs::is_directory(place / "baseq2", fault)) return place;
        looked_in += (looked_in.empty() ? "" : ", ") + place.string();
    }
    fail("no folder baseq2 in {}. Say where it is with +set basedir FOLDER.", looked_in);
}

} // namespace vigil
