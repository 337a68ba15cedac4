// SPDX-License-Identifier: GPL-2.0-or-later
// What the GPU test asks of the Compressed Directional Quadtree, and the answer: one text for the
// host and the device, so that their results can be compared. C++ and GLSL.
#ifndef VIGIL_TESTS_CDQ_QUERY_H
#define VIGIL_TESTS_CDQ_QUERY_H

#include "shared/cdq.h"

SHADER_BEGIN

struct CdqQuery {
    uvec4 tree;
    uint bits;
    uint node;  // any node from 4 on, for parent
    uint inner; // for child
    uint order; // number of a leaf
    vec2 uv;    // to look up
    vec3 u;     // to sample with
};

struct CdqAnswer {
    uvec4 even;
    uint rank;
    uint child;
    uint parent;
    uint leaf;
    uint found;
    uint found_depth;
    vec2 corner; // of the square of CdqQuery::node
    float size;
    uint depth;
    vec3 direction; // drawn
    uint drawn;     // the leaf that u.x takes
    uint seen;      // the leaf that the look-up finds for the direction
    float pdf;
};

SHADER_FN CdqAnswer cdq_answer(CdqQuery query) {
    CdqAnswer answer;
    answer.even = cdq_even_tree(query.bits);
    answer.rank = cdq_rank(query.tree, query.node);
    answer.child = cdq_child(query.tree, query.inner, 3u);
    answer.parent = cdq_parent(query.tree, query.node);
    answer.leaf = cdq_leaf(query.tree, query.bits, query.order);
    const CdqPlace place = cdq_find(query.tree, query.uv);
    answer.found = place.node;
    answer.found_depth = place.depth;
    const CdqCell cell = cdq_cell(query.tree, query.node);
    answer.corner = cell.corner;
    answer.size = cell.size;
    answer.depth = cell.depth;
    const uint leaves = cdq_leaf_count(query.bits);
    const uint order = min(uint(query.u.x * float(leaves)), leaves - 1u);
    answer.drawn = cdq_leaf(query.tree, query.bits, order);
    answer.direction = cdq_sample(query.tree, query.bits, query.u);
    answer.seen = cdq_find(query.tree, octahedral_encode(answer.direction)).node;
    answer.pdf = cdq_pdf(query.tree, query.bits, answer.direction);
    return answer;
}

SHADER_END
#endif
