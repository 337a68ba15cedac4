// SPDX-License-Identifier: GPL-2.0-or-later
// The variables that techniques are tested with besides their defaults. A technique that is not
// named here is tested with its defaults: registering it is enough.
#pragma once

#include "shared/techniques.h"

#include <string_view>
#include <utility>
#include <vector>

namespace vigil::test {

struct TechniqueVariation {
    std::string_view label;
    std::vector<std::pair<std::string_view, std::string_view>> variables;
};

inline std::vector<TechniqueVariation> variations_of(std::string_view technique) {
    // Lists on both sides of the stride; caches of one bucket and of several; nodes of one and of
    // two groups of children, and leaves without a choice.
    if (technique == "sll") return {{"32", {{"pt_sll_max", "32"}}}, {"4", {{"pt_sll_max", "4"}}}};
    if (technique == "vlc")
        return {{"32", {{"pt_vlc_bucket", "32"}}}, {"4", {{"pt_vlc_bucket", "4"}}}};
    if (technique == "lh")
        return {{"8", {{"pt_lh_width", "8"}, {"pt_lh_leaf", "2"}}},
                {"3", {{"pt_lh_width", "3"}, {"pt_lh_leaf", "1"}}}};
    return {{"", {}}};
}

} // namespace vigil::test
