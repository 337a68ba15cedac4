// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/ring_options.h"

#include "bench/option_values.h"

#include <fmt/format.h>

namespace vigil::bench {

namespace {

constexpr std::string_view usage = "--size WxH, --seeds S, --settle N, --frames N, "
                                   "--reference-paths N, --fresh, --set NAME VALUE, "
                                   "--json FILE";

} // namespace

std::vector<QualityRow> ring_rows() {
    std::vector<QualityRow> rows;
    for (const int bits : ring_bits)
        rows.push_back(
            {fmt::format("cdq{}", bits),
             {{"pt_nee", "vlc"}, {"pt_guide", "cdq"}, {"pt_cdq_bits", std::to_string(bits)}}});
    rows.push_back({"brdf", {{"pt_nee", "vlc"}, {"pt_guide", "brdf"}}});
    return rows;
}

RingOptions parse_ring_options(std::span<const std::string> arguments) {
    RingOptions options;
    OptionWords words(arguments);
    const auto count = [&](std::string_view option, int& number, int low, int high) {
        number = parse_count(option, words.value(), low, high);
    };
    words.run({{"--size", [&] { options.size = parse_size("--size", words.value()); }},
               {"--seeds", [&] { count("--seeds", options.seeds, 1, 1000); }},
               {"--settle", [&] { count("--settle", options.settle, 1, 10000); }},
               {"--frames", [&] { count("--frames", options.frames, 2 * ring_tail, 10000); }},
               {"--reference-paths",
                [&] { count("--reference-paths", options.reference_paths, 48, 100000000); }},
               {"--fresh", [&] { options.fresh = true; }},
               {"--set",
                [&] {
                    const std::string name = words.value();
                    options.settings.push_back(parse_setting("--set", name, words.value()));
                }},
               {"--json", [&] { options.json = words.value(); }}},
              usage);
    return options;
}

} // namespace vigil::bench
