// SPDX-License-Identifier: GPL-2.0-or-later
// vigil_make_walk BASEDIR LEVEL FILE [SECONDS]: makes a walk through BASEDIR/baseq2/maps/LEVEL.bsp
// and writes it as FILE. `--check` in place of SECONDS says what the walk in FILE does.
#include "common/error.h"
#include "common/file_system.h"
#include "walks/walk_maker.h"
#include "walks/walk_report.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <string>

namespace {

using namespace vigil;

void check_walk(const std::shared_ptr<const Level>& level, const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    fmt::print("{}: {}\n", path, walks::report_walk(level, client::Walk::parse(path, text)).text());
}

void make_walk(const std::shared_ptr<const Level>& level, const std::string& path,
               const walks::MakerOptions& options) {
    const client::Walk walk = walks::WalkMaker(level, options).make();
    const walks::WalkReport report = walks::report_walk(level, walk);
    std::ofstream file(path, std::ios::binary);
    file << "# A walk through " << level->name << ", made by vigil_make_walk.\n"
         << walks::goal_text({report.end.origin, report.doors_opened}) << walk.text();
    file.close();
    if (!file) fail("{}: cannot be written", path);
    fmt::print("{}: {}\n", path, report.text());
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app("Makes a walk through BASEDIR/baseq2/maps/LEVEL.bsp.", "vigil_make_walk");
    std::string basedir, name, path;
    bool check = false;
    walks::MakerOptions options;
    options.verbose = true;
    app.add_option("BASEDIR", basedir)->required()->check(CLI::ExistingDirectory);
    app.add_option("LEVEL", name)->required();
    app.add_option("FILE", path, "the walk")->required();
    app.add_option("SECONDS", options.seconds, "its length")->capture_default_str();
    app.add_flag("--check", check, "say what the walk in FILE does");
    CLI11_PARSE(app, argc, argv)
    try {
        FileSystem files;
        files.mount_game(basedir, "baseq2");
        const std::shared_ptr<const Level> level = load_level(files, name);
        if (check)
            check_walk(level, path);
        else
            make_walk(level, path, options);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "vigil_make_walk: {}\n", error.what());
        return 1;
    }
}
