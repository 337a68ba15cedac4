// SPDX-License-Identifier: GPL-2.0-or-later
#include "technique_settings.h"

#include "console/cvar.h"
#include "shared/techniques.h"

namespace vigil::test {

namespace {

/// One walk: no draw is blank where a light can shine.
constexpr uint32_t all_lights = 0xffffffffu;

/// A technique that is not here is tested with its defaults.
const TechniqueSettings known[] = {
    {"sll", "Default", {}, {32, 1, 1.0, true}},
    {"sll", "FourAtMost", {{"pt_sll_max", "4"}}, {4, 1, 1.0, true}},
    {"sll", // baseq2/q2rtx_lists.cfg
     "AsShipped",
     {{"pt_sll_max", "8"},
      {"pt_sll_mass", "solid_angle"},
      {"pt_sll_stats", "1"},
      {"pt_light_points", "1"},
      {"pt_light_density", "solid_angle"}},
     {8, 1, 1.0, true}},
    {"lh", "Default", {}, {}},
    {"lh", "ThreeWide", {{"pt_lh_width", "3"}, {"pt_lh_leaf", "1"}}, {}, true, 0.3},
    {"cut", "Default", {}, {}},
    {"cut", "FourEntries", {{"pt_cut_size", "4"}}, {}, true, 0.2},
    // What looks for lights throws away those that the cache has.
    {"vlc", "Default", {}, {}},
    {"vlc", "FourAtMost", {{"pt_vlc_bucket", "4"}, {"pt_explore_local", "0.5"}}, {}, true, 0.2},
    {"vlc",
     "FourAtMostWithoutLists",
     {{"pt_vlc_bucket", "4"},
      {"pt_explore_local", "0"},
      {"pt_vlc_explore", "0.5"},
      {"pt_vlc_weigh", "0"},
      {"pt_vlc_beside", "0"}},
     {1, 16, 0.5},
     false},
    {"vlc", "CutsAlone", {{"pt_cut_size", "4"}}, {}, false, 0.15, false},
    {"uniform", "Default", {}, {all_lights, 1, 1.0}, true, 0.3},
    {"power", "Default", {}, {all_lights, 1, 1.0}, true, 0.3},
    {"ris", "Default", {}, {}},
    {"ris", "ThreeCandidates", {{"pt_ris_candidates", "3"}}, {}, false},
};

} // namespace

void TechniqueSettings::set() const {
    for (const TechniqueSettings& other : known)
        for (const auto& [name, value] : other.variables)
            cvars().reset(name);
    cvars().set("pt_nee", technique);
    for (const auto& [name, value] : variables)
        cvars().set(name, value);
}

std::vector<TechniqueSettings> technique_settings() {
    std::vector<TechniqueSettings> all;
    for (const TechniqueInfo& info : technique_infos) {
        const size_t before = all.size();
        for (const TechniqueSettings& settings : known)
            if (settings.technique == info.name) all.push_back(settings);
        if (all.size() == before) all.push_back({info.name, "Default", {}, {}});
    }
    return all;
}

} // namespace vigil::test
