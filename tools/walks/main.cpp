// SPDX-License-Identifier: GPL-2.0-or-later
// vigil_make_walk BASEDIR LEVEL FILE [SECONDS]: makes a walk through BASEDIR/baseq2/maps/LEVEL.bsp
// and writes it as FILE. `--check` in place of SECONDS says what the walk in FILE does.
#include "common/error.h"
#include "common/file_system.h"
#include "walks/walk_maker.h"
#include "walks/walk_report.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

int run(int argc, char** argv) {
    using namespace vigil;
    if (argc < 4 || argc > 5) fail("usage: vigil_make_walk BASEDIR LEVEL FILE [SECONDS | --check]");
    const std::string path = argv[3], last = argc > 4 ? argv[4] : "";
    FileSystem files;
    files.mount_game(argv[1], "baseq2");
    const std::shared_ptr<const Level> level = load_level(files, argv[2]);
    if (last == "--check") {
        std::ifstream file(path, std::ios::binary);
        if (!file) fail("{}: cannot be read", path);
        const std::string text(std::istreambuf_iterator<char>(file), {});
        const auto report = walks::report_walk(level, client::Walk::parse(path, text));
        fmt::print("{}: {}\n", path, report.text());
        return 0;
    }
    walks::MakerOptions options;
    options.verbose = true;
    if (!last.empty()) options.seconds = std::strtof(last.c_str(), nullptr);
    const client::Walk walk = walks::WalkMaker(level, options).make();
    const walks::WalkReport report = walks::report_walk(level, walk);
    std::ofstream file(path, std::ios::binary);
    file << "# A walk through " << level->name << ", made by vigil_make_walk.\n"
         << walks::goal_text({report.end.origin, report.doors_opened}) << walk.text();
    file.close();
    if (!file) fail("{}: cannot be written", path);
    fmt::print("{}: {}\n", path, report.text());
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "vigil_make_walk: {}\n", error.what());
        return 1;
    }
}
