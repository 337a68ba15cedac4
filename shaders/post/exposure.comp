#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `exposure`: one work group turns the tiles' luminances into the factor from radiance to display. The mean lightness of the
// tiles, which grows with the cube root of luminance (CIE 1976), comes out at that of middle grey (18%). A geometric mean (Reinhard et
// al. 2002) takes dark corners for a dark picture, and the rest turns white. Each picture is exposed by itself, so that it does not
// depend on the frames before it; but filtered frames, which do, may follow slowly (exposure_part).
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "post/picture.glsl"

layout(local_size_x = 256) in;

shared vec2 sums[256];

void main() {
    const uint lane = gl_LocalInvocationIndex;
    const uvec2 tiles = (frame.size + 7u) / 8u;
    vec2 sum = vec2(0.0);
    for (uint i = lane; i < tiles.x * tiles.y; i += 256u) sum += exposure_tiles[i];
    sums[lane] = sum;
    for (uint step = 128u; step > 0u; step >>= 1) {
        barrier();
        if (lane < step) sums[lane] += sums[lane + step];
    }
    if (lane != 0u) return;
    float value = frame.settings.pt_exposure;
    if (value == 0.0) {
        const float root = sums[0].y > 0.0 ? sums[0].x / sums[0].y : 1.0;
        value = 0.18 / (root * root * root);
        // As eyes do: by a part of the difference in stops.
        const float before = exposure / exp2(frame.settings.pt_exposure_bias);
        if (turn.exposure_part < 1.0 && before > 1e-7 && before < 1e7)
            value = before * pow(clamp(value, 1e-6, 1e6) / before, turn.exposure_part);
    }
    exposure = clamp(value, 1e-6, 1e6) * exp2(frame.settings.pt_exposure_bias);
}
