// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/ring_options.h"

#include "bench/option_values.h"
#include "common/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace vigil::bench {

namespace {

constexpr std::string_view usage = "--size WxH, --turn DEGREES, --bits N, --seeds S, --settle N, "
                                   "--frames N, --reference-paths N, --fresh, --keep, --quick, "
                                   "--set NAME VALUE, --json FILE";

int parse_quadtree_size(std::string_view text) {
    const int bits = parse_count("--bits", text, 32, 128);
    if (bits % 32 != 0)
        throw Error(fmt::format("--bits {}: quadtrees have 32, 64, 96 or 128", bits));
    return bits;
}

} // namespace

std::vector<QualityRow> ring_rows(std::span<const int> sizes) {
    std::vector<QualityRow> rows;
    for (const int bits : sizes)
        rows.push_back(
            {fmt::format("cdq{}", bits),
             {{"pt_nee", "vlc"}, {"pt_guide", "cdq"}, {"pt_cdq_bits", std::to_string(bits)}}});
    rows.push_back({"brdf", {{"pt_nee", "vlc"}, {"pt_guide", "brdf"}}});
    return rows;
}

RingOptions parse_ring_options(std::span<const std::string> arguments) {
    RingOptions options;
    if (std::ranges::find(arguments, "--quick") != arguments.end()) {
        options.size = {96, 54};
        options.turns = {36};
        options.bits = {64};
        options.seeds = 2;
        options.settle = 40;
        options.frames = 2 * ring_tail;
        options.reference_paths = 128;
    }
    std::vector<int> turns, sizes; // given ones replace the paper's
    OptionWords words(arguments);
    const auto count = [&](std::string_view option, int& number, int low, int high) {
        number = parse_count(option, words.value(), low, high);
    };
    words.run({{"--size", [&] { options.size = parse_size("--size", words.value()); }},
               {"--turn", [&] { turns.push_back(parse_count("--turn", words.value(), 1, 359)); }},
               {"--bits", [&] { sizes.push_back(parse_quadtree_size(words.value())); }},
               {"--seeds", [&] { count("--seeds", options.seeds, 1, 1000); }},
               {"--settle", [&] { count("--settle", options.settle, 1, 10000); }},
               {"--frames", [&] { count("--frames", options.frames, 2 * ring_tail, 10000); }},
               {"--reference-paths",
                [&] { count("--reference-paths", options.reference_paths, 48, 100000000); }},
               {"--fresh", [&] { options.fresh = true; }},
               {"--keep", [&] { options.keep = true; }},
               {"--quick", [] {}}, // above, before all others
               {"--set",
                [&] {
                    const std::string name = words.value();
                    options.settings.push_back(parse_setting("--set", name, words.value()));
                }},
               {"--json", [&] { options.json = words.value(); }}},
              usage);
    if (!turns.empty()) options.turns = std::move(turns);
    if (!sizes.empty()) options.bits = std::move(sizes);
    return options;
}

} // namespace vigil::bench
