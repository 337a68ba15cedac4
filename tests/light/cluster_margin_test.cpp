// SPDX-License-Identifier: GPL-2.0-or-later
// Lights beside the bounds of a cluster. A level's file rounds the bounds of leaves to whole units,
// and surfaces are looked up half a unit off: a light that lies up to one and a half units beyond,
// and shines away from the cluster, may still shine on something in it.
#include "formats/bsp.h"
#include "level/pvs.h"
#include "refresh/vkpt/light/light_lists.h"

#include <gtest/gtest.h>

namespace vigil {
namespace {

/// Two cells of 100 units, parted at x = 0: cluster 0 below, cluster 1 above.
Bsp two_cells() {
    Bsp bsp;
    bsp.planes = {{glm::vec3(1, 0, 0), 0.0f, 0}};
    BspNode node;
    node.plane = 0;
    node.children = {-1 - 1, -1 - 0};
    bsp.nodes = {node};
    bsp.leafs.resize(2);
    for (int32_t cluster = 0; cluster < 2; ++cluster) {
        BspLeaf& leaf = bsp.leafs[static_cast<size_t>(cluster)];
        leaf.cluster = cluster;
        leaf.mins = glm::vec3(cluster == 0 ? -100 : 0, -50, -50);
        leaf.maxs = leaf.mins + 100.0f;
    }
    bsp.models.resize(1);
    bsp.cluster_count = 2;
    return bsp;
}

/// Whether a light in the plane `axis` = `at`, shining towards `side`, is in the list of cluster 1.
bool is_listed(glm::length_t axis, float at, float side) {
    const Bsp bsp = two_cells();
    const Pvs pvs(bsp);
    glm::vec3 v0(50.0f, 0.0f, 0.0f), along(0.0f), across(0.0f);
    v0[axis] = at;
    along[(axis + 1) % 3] = side;
    across[(axis + 2) % 3] = 1.0f;
    const LightTriangle light{v0, v0 + along, v0 + across, 7};
    const LightLists lists = LightLister(bsp, pvs).build(std::span(&light, 1));
    return !lists.list(1).empty();
}

TEST(LightsBesideAClustersBounds, AreListed) {
    const glm::vec3 mins(0, -50, -50), maxs(100, 50, 50);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        for (const float beyond : {-60.0f, -1.0f, 0.0f, 0.5f, 1.0f, 1.49f}) {
            EXPECT_TRUE(is_listed(axis, maxs[axis] + beyond, 1.0f)) << axis << " " << beyond;
            EXPECT_TRUE(is_listed(axis, mins[axis] - beyond, -1.0f)) << axis << " " << beyond;
        }
        // Farther away they cannot shine on it, and lists stay short.
        for (const float beyond : {3.0f, 60.0f}) {
            EXPECT_FALSE(is_listed(axis, maxs[axis] + beyond, 1.0f)) << axis << " " << beyond;
            EXPECT_FALSE(is_listed(axis, mins[axis] - beyond, -1.0f)) << axis << " " << beyond;
        }
    }
}

} // namespace
} // namespace vigil
