// SPDX-License-Identifier: GPL-2.0-or-later
// What is only read, and by each invocation elsewhere, is bound as texels of four words (records) or of one. On lavapipe such a
// load from a storage buffer is a branch per lane and word (docs/internals/tracing.md). Structures of records end in SHADER_PADDING
// where they would not be whole texels.
#ifndef VIGIL_TRACE_RECORDS_GLSL
#define VIGIL_TRACE_RECORDS_GLSL

#extension GL_EXT_samplerless_texture_functions : require

uint load_word(utextureBuffer words, uint index) { return texelFetch(words, int(index)).x; }

vec4 load_floats(utextureBuffer records, int texel) { return uintBitsToFloat(texelFetch(records, texel)); }

/// Three texels as the columns of a transform.
mat4x3 load_transform(utextureBuffer records, int texel) {
    const vec4 a = load_floats(records, texel), b = load_floats(records, texel + 1), c = load_floats(records, texel + 2);
    return mat4x3(a.xyz, vec3(a.w, b.xy), vec3(b.zw, c.x), c.yzw);
}

#endif
