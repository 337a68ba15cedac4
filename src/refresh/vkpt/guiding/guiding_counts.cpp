// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/guiding/guiding_counts.h"

#include <algorithm>

namespace vigil::vkpt {

std::vector<refresh::FrameCount> guiding_counts(const shader::GuidingWork& work) {
    const auto per_cache = [&](uint32_t count) {
        return static_cast<double>(count) / std::max(work.cached_leaves, 1u);
    };
    return {
        {"octree_leaves", static_cast<double>(octree_leaf_count(work.nodes))},
        {"octree_depth", static_cast<double>(work.depth)},
        {"splits", static_cast<double>(work.splits)},
        {"collapses", static_cast<double>(work.collapses)},
        {"splits_refused", static_cast<double>(work.splits_refused)},
        {"samples", static_cast<double>(work.samples)},
        {"samples_kept", static_cast<double>(work.samples - work.dropped)},
        {"samples_dropped", static_cast<double>(work.dropped)},
        {"rays", static_cast<double>(work.rays)},
        {"rays_dropped", static_cast<double>(work.rays_dropped)},
        {"leaves_with_samples", static_cast<double>(work.sampled_leaves)},
        {"caches", static_cast<double>(work.cached_leaves)},
        {"lights_per_cache", per_cache(work.cached_lights)},
        {"most_lights", static_cast<double>(work.most_lights)},
        {"buckets_per_cache", per_cache(work.cached_buckets)},
        {"cdq_migrations", static_cast<double>(work.cdq_migrations)},
        {"lights_left_out", static_cast<double>(work.lights_left_out)},
        {"caches_refused", static_cast<double>(work.caches_refused)},
    };
}

} // namespace vigil::vkpt
