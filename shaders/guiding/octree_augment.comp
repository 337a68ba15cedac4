#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `octree_augment`, step 4 of the octree (paper, section 6.2, "augment" and "populate"): one invocation per child of a new node fills in its leaf: the
// old leaf it comes from, whose cache it takes over, the neighbours beyond its faces, and room for samples. A node takes over what its guider
// knows.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "guiding/passes.glsl"

layout(local_size_x = 64) in;

shared uint group_room; // samples of all leaves of this group
shared uint group_first;

/// The old leaf that a new leaf comes from, with SOURCE_SPLIT if the new one is a part of it; and how many samples the new one is to
/// expect.
uint find_source(uint node, uint child, out uint demand) {
    const uint source = plan[plan_source(node)];
    if ((source & SOURCE_SPLIT) != 0u) {
        demand = demand_of_part(old_leaf_count(source & ~SOURCE_SPLIT));
        return source;
    }
    const uint old_node = old_nodes[source];
    if (octree_is_leaf(old_node, child)) {
        demand = old_leaf_count(octree_leaf(source, child));
        return octree_leaf(source, child);
    }
    // A collapsed node's leaf expects the samples of all its children, and follows the one that saw most.
    uint most = octree_leaf(octree_inner_child(old_node, child), 0u);
    demand = 0u;
    for (uint i = 0u, leaf = most; i < 8u; ++i, ++leaf) {
        demand += old_leaf_count(leaf);
        if (old_leaf_count(leaf) > old_leaf_count(most)) most = leaf;
    }
    return most;
}

/// The leaf just beyond the centre of a face (-x +x -y +y -z +z), or NONE outside the root.
uint find_neighbour(OctreeCell cell, uint face) {
    const uint size = octree_cell_size(cell.depth);
    const uint axis = face >> 1u;
    uvec3 grid = cell.corner + size / 2u;
    if ((face & 1u) == 0u) {
        if (cell.corner[axis] == 0u) return NONE;
        grid[axis] = cell.corner[axis] - 1u;
    } else {
        grid[axis] = cell.corner[axis] + size;
        if (grid[axis] >> OCTREE_MAX_DEPTH != 0u) return NONE;
    }
    OctreeDescent descent = octree_root();
    while (descent.leaf == NONE) octree_descend(descent, new_nodes[descent.node], grid);
    return descent.leaf;
}

/// The words that a leaf, or a node, has of its source.
void carry(LeafArray array, uint leaf, uint source) {
    for (uint word = 0u; word < array.words; ++word)
        new_leaves[leaf_word(array, leaf) + word] = old_leaves[leaf_word(array, source) + word];
}
void carry(NodeArray array, uint node, uint source) {
    for (uint word = 0u; word < array.words; ++word)
        new_leaves[node_word(array, node) + word] = old_leaves[node_word(array, source) + word];
}

void zero(LeafArray array, uint leaf) {
    for (uint word = 0u; word < array.words; ++word) new_leaves[leaf_word(array, leaf) + word] = 0u;
}

void store(uint first, uvec2 words) {
    new_leaves[first] = words.x;
    new_leaves[first + 1u] = words.y;
}

/// First sample and room; sums of floats may overshoot the capacity by a few.
uvec2 storage_of(uint first, uint room, uint capacity) { return uvec2(min(first, capacity), min(room, capacity - min(first, capacity))); }

/// What a new node's guider knows, and room for its rays.
void make_guide(uint node) {
    const uint marked = plan[plan_source(node)];
    const bool split = (marked & SOURCE_SPLIT) != 0u;
    const uint source = split ? octree_node_of(marked & ~SOURCE_SPLIT) : marked;
    carry(NODE_GUIDE, node, source);
    carry(guide_memory(settings.memory_words), node, source);
    const ShareMemory share = load_share(source);
    store(node_word(NODE_SHARE, node), share_pack(split ? share_of_part(share) : share));
    const uint tail = node_word(NODE_TAIL, source);
    const uvec2 memory = uvec2(old_leaves[tail], old_leaves[tail + 1u]);
    store(node_word(NODE_TAIL, node), split ? tail_pack(tail_of_part(tail_unpack(memory))) : memory);
    store(node_word(NODE_RAYS, node), uvec2(0u));
    const uint rays = expected_rays(source);
    const uint room = room_for(split ? demand_of_part(rays) : rays, work.ray_demand, header.ray_capacity, new_node_count);
    store(node_word(NODE_RAY_STORAGE, node), storage_of(atomicAdd(work.ray_used, room), room, header.ray_capacity));
}

// By the table's last column; visible lights are 0 until samples are deduplicated.
#define LEAF_MADE(array)
#define LEAF_ZEROED(array) zero(array, leaf);
#define LEAF_CARRIED(array) carry(array, leaf, source);
#define FILL_ARRAY(name, words, before, value, new_leaf) new_leaf(name)

void main() {
    const uint node = gl_GlobalInvocationID.x >> 3u;
    const uint child = gl_GlobalInvocationID.x & 7u;
    const bool is_leaf = node < new_node_count && octree_is_leaf(new_nodes[node], child);
    const uint leaf = octree_leaf(node, child);

    uint room = 0u;
    uint marked_source = NONE;
    if (is_leaf) {
        uint demand;
        marked_source = find_source(node, child, demand);
        room = room_for(demand, work.demand, header.sample_capacity, 7u * new_node_count + 1u);
    }
    if (gl_LocalInvocationID.x == 0u) group_room = 0u;
    barrier();
    const uint before = room > 0u ? atomicAdd(group_room, room) : 0u;
    barrier();
    if (gl_LocalInvocationID.x == 0u) group_first = atomicAdd(work.sample_used, group_room);
    barrier();
    if (settings.guided != 0u && node < new_node_count && child == 0u) make_guide(node);
    if (!is_leaf) return;

    const uint storage = leaf_word(LEAF_STORAGE, leaf);
    store(storage, storage_of(group_first + before, room, header.sample_capacity));

    const uint source = marked_source & ~SOURCE_SPLIT;
    LEAF_ARRAY_TABLE(FILL_ARRAY)
    new_leaves[leaf_word(LEAF_SOURCE, leaf)] = marked_source;

    const OctreeCell cell = octree_child_cell(octree_unpack_cell(new_cells[node]), child);
    if (leaf == octree_leaf(new_node_count - 1u, 7u)) work.depth = cell.depth; // the last leaf is a deepest
    const uint neighbours = leaf_word(LEAF_NEIGHBOURS, leaf);
    for (uint face = 0u; face < 6u; ++face) new_leaves[neighbours + face] = find_neighbour(cell, face);
}
