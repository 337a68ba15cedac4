// SPDX-License-Identifier: GPL-2.0-or-later
// How likely the static lights that may be seen from a PVS cluster are to be looked at by samples
// that search for new lights there: power over squared distance, an alias table for each cluster.
// What is near but faint is found, which a table over all lights of the level can hardly do (the
// paper, section 8, on its global strategy).
#pragma once

#include "refresh/vkpt/light/light_lists.h"
#include "shared/alias_table.h"
#include "shared/scene_types.h"

#include <span>
#include <vector>

namespace vigil {

/// Tables of all clusters, one after another; each entry belongs to the id at the same index.
struct LocalExploration {
    std::vector<LightRange>
        ranges;                // cluster_count + 1; the last, for points in no cluster, is empty
    std::vector<uint32_t> ids; // ascending within a range
    std::vector<shader::AliasEntry> entries;
};

/// Tables for lights 0 .. static_count - 1 of `lights`, whose radiance counts as it is when this is
/// called (a light that is dark now counts as the faintest of its cluster: it may be switched on).
/// Clusters whose tables would bring all of them above `most_entries` get none.
LocalExploration explore_clusters(const LightLister& lister, std::span<const shader::Light> lights,
                                  uint32_t static_count, size_t most_entries);

} // namespace vigil
