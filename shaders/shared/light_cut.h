// SPDX-License-Identifier: GPL-2.0-or-later
// What a group of near lamps may add to a surface: how the technique `cut` weighs a whole subtree of lights at once. Host
// side: refresh/vkpt/light/light_cuts.h; drawn from by light/cut_draw.glsl.
#ifndef VIGIL_SHARED_LIGHT_CUT_H
#define VIGIL_SHARED_LIGHT_CUT_H

#include "glsl.h"
#include "ltc.h"
#include "sampling.h"

SHADER_BEGIN

/// An entry of a cluster's cut is CUT_GROUP and the number of a group, or a run of single lights.
SHADER_CONST uint CUT_GROUP = 0x80000000u;
/// Most lights of a run. Runs start at one of the first 2^26 places of cut_order.
SHADER_CONST uint CUT_RUN = 31u;
SHADER_FN uint cut_run(uint first, uint count) { return first << 5u | count; }
SHADER_FN uint cut_run_first(uint run) { return run >> 5u; }
SHADER_FN uint cut_run_count(uint run) { return run & CUT_RUN; }

/// Groups of at most so many lights have no halves.
SHADER_CONST uint CUT_LEAF = 8u;
/// Lights of a group that was drawn are weighed one by one, if they are at most so many.
SHADER_CONST uint CUT_WALK = 16u;
/// Groups wider than this are opened: their halves are weighed, or their lights.
SHADER_CONST float CUT_NEAR = 0.35f;
/// How much wider they must be for each group or light that a draw has weighed so. As no width is
/// above 3, they are at most some 2,700.
SHADER_CONST float CUT_HARDER = 1.0f / 1024.0f;
/// Groups are opened for the GGX lobe where it may add so many times what they are taken to add.
SHADER_CONST float CUT_GLINT = 2.0f;
/// Least mean cosines: where a group's estimate is too low, its lights must not become fireflies.
SHADER_CONST float CUT_LEAST_COSINE = 0.03f;

/// A subtree of lights, as the GPU stores it.
struct CutGroup {
    vec3 middle;  // of the box around the lights
    float energy; // area times luminance, added up
    vec3 reach;   // half extents of the box
    float mean;   // length of the lights' mean normal, in [0, 1]
    vec3 axis;    // its direction; (0, 0, 0): none
    float spread; // largest distance of a normal from the axis, in [0, 2]
    uint first;   // of its lights, in cut_order
    uint count;
    uint next; // the group after all parts of this one; its first half comes right after itself
    uint unused;
};
SHADER_CONST int CUT_GROUP_TEXELS = 4;

/// Mean of max(x, 0) over x in middle - reach .. middle + reach.
SHADER_FN float cut_mean_above(float middle, float reach) {
    float top = max(middle + reach, 0.0f);
    return middle >= reach ? middle : top * top / (4.0f * max(reach, 1e-9f));
}

/// Most of max(z, 0) / |x|^4 over the points x of the box middle - reach .. middle + reach; of one that
/// reaches down to z = 0, about that.
SHADER_FN float cut_most(vec3 middle, vec3 reach) {
    float top = middle.z + reach.z;
    if (top <= 0.0f) return 0.0f;
    float x = max(abs(middle.x) - reach.x, 0.0f);
    float y = max(abs(middle.y) - reach.y, 0.0f);
    float aside = x * x + y * y;
    float z = clamp(sqrt(aside * (1.0f / 3.0f)), max(middle.z - reach.z, 0.125f * top), top);
    float squared = aside + z * z;
    return z / (squared * squared);
}

/// What a group may add to a surface, and its width.
struct CutWeight {
    float importance; // 0 only if no light of the group can shine on the surface
    float width;      // squared half diagonal over mean squared distance, in [0, 3]; in the world
                      // or, if that is more and the GGX lobe may glint, where that is a cosine
};

/// In the unit of ltc_importance().
SHADER_FN CutWeight cut_weight(CutGroup group, LtcSurface surface, bool glossy) {
    CutWeight weight;
    weight.importance = 0.0f;
    vec3 middle = group.middle - surface.position;
    float extent = dot(group.reach, group.reach);
    float squared = max(dot(middle, middle) + extent * (1.0f / 3.0f), 1e-8f);
    weight.width = extent / squared;
    float height = dot(surface.normal, middle);
    float height_reach = dot(abs(surface.normal), group.reach);
    float facing = -dot(group.axis, middle);
    float facing_reach = dot(abs(group.axis), group.reach);
    vec3 farthest = abs(middle) + group.reach;
    float across = farthest.x + farthest.y + farthest.z;
    vec3 place = abs(surface.position);
    float slack = 2e-6f * (across + place.x + place.y + place.z);
    if (height + height_reach <= -slack) return weight;
    if (facing + facing_reach + group.spread * across <= -slack) return weight;
    float inverse = inversesqrt(squared);
    float distance = squared * inverse;
    // Of lights that all face one way, and of lights that face anywhere.
    float toward = group.mean * cut_mean_above(facing, facing_reach) + (1.0f - group.mean) * 0.25f * distance;
    toward = max(toward, CUT_LEAST_COSINE * distance);
    float above = max(cut_mean_above(height, height_reach), CUT_LEAST_COSINE * distance);
    float diffuse = toward * above * (inverse * inverse) * (inverse * inverse) * INVERSE_PI;
    weight.importance = surface.diffuse * diffuse;
    if (glossy && surface.specular > 0.0f) {
        vec3 turned = surface.to_cosine * middle;
        mat3 rows = transpose(surface.to_cosine);
        vec3 wide = vec3(dot(abs(rows[0]), group.reach), dot(abs(rows[1]), group.reach), dot(abs(rows[2]), group.reach));
        float far = max(dot(turned, turned) + dot(wide, wide) * (1.0f / 3.0f), 1e-8f);
        float scale = surface.determinant * toward * INVERSE_PI;
        float lobe = scale * cut_mean_above(turned.z, wide.z) / (far * far);
        weight.importance += surface.specular * mix(lobe, diffuse, LTC_DEFENSIVE);
        // A narrow lobe sees lights apart that lie side by side.
        float most = surface.specular * scale * cut_most(turned, wide);
        if (most > CUT_GLINT * weight.importance) weight.width = max(weight.width, dot(wide, wide) / far);
    }
    weight.importance *= group.energy;
    return weight;
}

SHADER_END
#endif
