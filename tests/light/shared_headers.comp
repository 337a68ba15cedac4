#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Proves that every header of light sampling is GLSL too: it calls one function of each, and is
// compiled, not run.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/alias_table.h"
#include "shared/brdf.h"
#include "shared/cdq.h"
#include "shared/light_point.h"
#include "shared/light_hierarchy.h"
#include "shared/ltc.h"
#include "shared/octahedral.h"
#include "shared/random.h"
#include "shared/sampling.h"
#include "shared/triangle_light.h"
#include "light/ltc.glsl"

layout(set = 1, binding = 0, scalar) restrict buffer Block {
    Light light;
    AliasEntry entry;
    uvec4 tree;
    vec4 result;
};

void main() {
    Random random = random_begin(gl_GlobalInvocationID.xy, 1u, 2u);
    const AliasSlot slot = alias_slot(random_next_bits(random), 7u);
    Brdf brdf = brdf_lambert(vec3(0.5));
    brdf.f0 = 0.04;
    const vec3 normal = octahedral_decode(random_next2(random));
    const BrdfSample drawn = brdf_sample(brdf, normal, normal, random_next3(random));
    const LtcSurface diffuse = ltc_prepare_diffuse(vec3(0.0), normal, 0.5);
    const LtcSurface glossy = ltc_prepare_glossy(vec3(0.0), normal, normal, brdf);
    const vec3 origin = offset_ray_origin(vec3(0.0), normal);
    const LightSample seen = sample_light(light, origin, random_next2(random));
    const SphericalTriangle near = near_light(light, origin);
    const float share = lobe_share(glossy, normal, brdf, light);
    const LightSample glint = sample_light_glossy(light, near, origin, normal, normal, brdf, share, vec2(0.5));
    result = vec4(ltc_importance(diffuse, light, false), ltc_importance(glossy, light, true),
                  drawn.seen.pdf + seen.geometry + glint.geometry, alias_choose(entry, slot));
    tree = uvec4(cdq_leaf(tree, 128u, slot.column));
    const vec4 children = light_group_importance(light_node(tree), tree, tree, tree, origin, normal);
    const LightNodeWeights weights = light_node_weights(children, vec4(0.0));
    result.x += light_node_choose(weights, 0.5 * light_node_sum(weights)).weight + light_node_weight(weights, light_node_stride(2u) - 1u);
    result += cdq_pdf(tree, 128u, cdq_sample(tree, 128u, random_next3(random)));
}
