#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Asks for the importance of some lights at each surface: all answers for comparison with the
// host, or their sum for the benchmark. Also the first random numbers of each invocation's stream.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "importance_query.h"
#include "light/ltc.glsl"
#include "shared/random.h"

layout(local_size_x = 64) in;

layout(constant_id = 0) const uint MODE = 0u;
layout(constant_id = 1) const bool STORE_ALL = true;

layout(set = 0, binding = 0, scalar) readonly buffer QueryBlock { ImportanceQuery queries[]; };
struct LightRecord {
    Light light;
    uint unused[3]; // as the host's
};
layout(set = 0, binding = 1, scalar) readonly buffer LightBlock { LightRecord lights[]; };
layout(set = 0, binding = 2, scalar) writeonly buffer ResultBlock { float results[]; };
layout(set = 0, binding = 3, scalar) writeonly buffer RandomBlock { uvec3 words[]; };

layout(push_constant) uniform Push {
    uint query_count;
    uint light_count;
    uint lights_per_query;
};

float ask(LtcSurface surface, Light light) {
    if (MODE == IMPORTANCE_SHIPPED) return ltc_importance(surface, light, false);
    if (MODE == IMPORTANCE_GLOSSY) return ltc_importance(surface, light, true);
    return alternative_importance(MODE, surface, light);
}

void main() {
    const uint index = gl_GlobalInvocationID.x;
    if (index >= query_count) return;
    const ImportanceQuery query = queries[index];
    LtcSurface surface = ltc_prepare_diffuse(query.position, query.normal, query.albedo);
    if (MODE == IMPORTANCE_GLOSSY && query.f0 > 0.0) {
        Brdf brdf = brdf_lambert(vec3(query.albedo));
        brdf.f0 = query.f0;
        brdf.alpha = query.alpha;
        surface = ltc_prepare_glossy(query.position, query.normal, query.view, brdf);
    }
    float sum = 0.0;
    for (uint k = 0u; k < lights_per_query; ++k) {
        const float importance = ask(surface, lights[(query.first_light + 7u * k) % light_count].light);
        sum += importance;
        if (STORE_ALL) results[index * lights_per_query + k] = importance;
    }
    if (!STORE_ALL) results[index] = sum;
    Random random = random_begin(uvec2(index, 5u), 6u, 7u);
    random_next(random);
    if (STORE_ALL) words[index] = random_next_words(random);
}
