// SPDX-License-Identifier: GPL-2.0-or-later
// Set 0: what a hit is made of. Declares the scene's buffers and turns them into texels; nothing here traces rays.
#ifndef VIGIL_SCENE_SCENE_GLSL
#define VIGIL_SCENE_SCENE_GLSL

#include "scene/frame.glsl"
#include "trace/records.glsl"

layout(set = SET_SCENE, binding = BINDING_INSTANCES) uniform utextureBuffer instances;   // Instance[]
layout(set = SET_SCENE, binding = BINDING_PRIMITIVES) uniform utextureBuffer primitives; // Primitive[]
layout(set = SET_SCENE, binding = BINDING_MATERIALS) uniform utextureBuffer materials;   // Material[]
layout(set = SET_SCENE, binding = BINDING_TEXTURES) uniform utextureBuffer textures;     // Texture[]
layout(set = SET_SCENE, binding = BINDING_TEXELS) uniform utextureBuffer texels;         // words
layout(set = SET_SCENE, binding = BINDING_LIGHTS) uniform utextureBuffer lights;         // Light[]

// Fields that a caller does not use cost no loads.
Instance load_instance(uint index) {
    const int at = int(index) * INSTANCE_TEXELS;
    const uvec4 words = texelFetch(instances, at + 9);
    return Instance(load_transform(instances, at), load_transform(instances, at + 3), load_transform(instances, at + 6), words.x, words.y,
                    words.z, words.w, load_floats(instances, at + 10).xyz);
}

Primitive load_primitive(uint index) {
    const int at = int(index) * PRIMITIVE_TEXELS;
    const vec4 a = load_floats(primitives, at);
    const uvec4 b = texelFetch(primitives, at + 1);
    return Primitive(a.xy, a.zw, uintBitsToFloat(b.xy), b.z, b.w, texelFetch(primitives, at + 2).x);
}

Material load_material(uint index) {
    const int at = int(index) * MATERIAL_TEXELS;
    const uvec4 a = texelFetch(materials, at);
    const vec4 b = load_floats(materials, at + 1);
    return Material(a.x, a.y, a.z, uintBitsToFloat(a.w), b.x, b.yzw);
}

Texture load_texture(uint index) {
    const uvec4 words = texelFetch(textures, int(index));
    return Texture(words.x, words.y, words.z, words.w);
}

Light load_light(uint id) {
    const int at = int(id) * LIGHT_TEXELS;
    const vec4 a = load_floats(lights, at), b = load_floats(lights, at + 1), c = load_floats(lights, at + 2);
    return Light(a.xyz, vec3(a.w, b.xy), vec3(b.zw, c.x), c.yzw, texelFetch(lights, at + 3).x);
}

/// Where what is at a position now, on an instance, was a frame ago.
vec3 previous_position(vec3 position, uint instance) {
    if (instance == 0u) return position;
    const Instance moved = load_instance(instance);
    return moved.previous_world_from_object * vec4(moved.object_from_world * vec4(position, 1.0), 1.0);
}

/// RGB9E5 to linear RGB.
vec3 decode_texel(uint texel) {
    // 2^(e - 24), built from its bits; e = 0 is a denormal step below and stands for exact black here.
    const float scale = uintBitsToFloat(((texel >> 27) + 103u) << 23);
    return vec3(texel & 511u, (texel >> 9) & 511u, (texel >> 18) & 511u) * scale;
}

vec3 fetch_texel(Texture header, uint level, ivec2 position) {
    uint width = header.width;
    uint height = header.height;
    uint first = header.first_texel;
    for (uint i = 0u; i < level; ++i) {
        first += width * height;
        width = max(width >> 1, 1u);
        height = max(height >> 1, 1u);
    }
    return decode_texel(load_word(texels, first + uint(position.y) * width + uint(position.x)));
}

ivec2 wrap_texel(ivec2 position, ivec2 size) {
    const ivec2 rest = position % size; // sign of the dividend where it is negative: mended next
    return rest + size * ivec2(lessThan(rest, ivec2(0)));
}

/// Repeating texture at `uv` (in repeats); `footprint` is the width of the area looked at, in repeats of the larger side.
/// One mip level (the nearest), bilinear or nearest texels inside it. With pt_texture_filter full the level is always the
/// picture itself, as in renderers that only interpolate: smaller levels mix the reflectance of places that the light does not
/// reach with that of places it does.
vec3 sample_texture(Texture header, vec2 uv, float footprint) {
    const bool full = frame.settings.pt_texture_filter == 2;
    const float texels_wide = full ? 1.0 : footprint * float(max(header.width, header.height));
    const uint level = uint(clamp(int(round(log2(max(texels_wide, 1.0)))), 0, int(header.mip_count) - 1));
    const ivec2 size = max(ivec2(header.width, header.height) >> int(level), ivec2(1));
    const vec2 place = fract(uv) * vec2(size);
    if (frame.settings.pt_texture_filter == 0) return fetch_texel(header, level, wrap_texel(ivec2(place), size));
    const vec2 corner = floor(place - 0.5);
    const vec2 weight = place - 0.5 - corner;
    const ivec2 low = wrap_texel(ivec2(corner), size);
    const ivec2 high = wrap_texel(ivec2(corner) + 1, size);
    const vec3 top = mix(fetch_texel(header, level, low), fetch_texel(header, level, ivec2(high.x, low.y)), weight.x);
    const vec3 bottom = mix(fetch_texel(header, level, ivec2(low.x, high.y)), fetch_texel(header, level, high), weight.x);
    return mix(top, bottom, weight.y);
}

/// Texture coordinates of a liquid: Quake II's turbulence (amplitude 8 texels of 64, period 2 pi / 0.125 texels, one radian a
/// second) and its scrolling (64 texels every two seconds, as warped faces flow at half that speed).
vec2 animate_uv(vec2 uv, uint material_flags) {
    if ((material_flags & MATERIAL_WARP) != 0u) {
        const vec2 phase = 8.0 * uv.yx + turn.time_s;
        uv += (8.0 / 64.0) * 0.5 * sin(phase);
    }
    if ((material_flags & MATERIAL_FLOWING) != 0u) uv.x -= fract(turn.time_s * 0.5);
    return uv;
}

Texture material_texture(Material material) {
    uint index = material.texture;
    // Quake II shows two animation frames per second.
    if (material.frame_count > 1u) index += uint(turn.time_s * 2.0) % material.frame_count;
    return load_texture(index);
}

#endif
