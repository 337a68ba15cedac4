// SPDX-License-Identifier: GPL-2.0-or-later
// Writes the seeds of every target: fuzz_seeds OUT [GAME_FOLDERS...] makes OUT/TARGET/NUMBER. Game
// folders that do not exist are passed over.
#include "seeds.h"

#include "common/error.h"
#include "common/output.h"

#include <cstdio>
#include <exception>

namespace vigil::fuzz {
namespace {

void write_seeds(const Target& target, const std::filesystem::path& out,
                 std::span<const char* const> folders) {
    std::vector<Bytes> seeds = built_seeds(target);
    for (const char* folder : folders)
        for (Bytes& seed : found_seeds(target, folder))
            seeds.push_back(std::move(seed));
    if (seeds.empty()) seeds.emplace_back(); // libFuzzer wants a folder
    for (std::size_t i = 0; i < seeds.size(); ++i)
        write_file(out / target.name / fmt::format("{:03}", i), std::as_bytes(std::span(seeds[i])));
}

} // namespace
} // namespace vigil::fuzz

int main(int argc, char** argv) {
    if (argc < 2) {
        fmt::print(stderr, "usage: fuzz_seeds OUT [GAME_FOLDERS...]\n");
        return 2;
    }
    try {
        const std::span<const char* const> folders(argv + 2, static_cast<std::size_t>(argc - 2));
        for (const vigil::fuzz::Target& target : vigil::fuzz::targets())
            vigil::fuzz::write_seeds(target, argv[1], folders);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "fuzz_seeds: {}\n", error.what());
        return 1;
    }
}
