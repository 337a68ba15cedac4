// SPDX-License-Identifier: GPL-2.0-or-later
// Lets one text compile as GLSL and as C++ (GLM): every header in shaders/shared includes this first.
// Write functions as `SHADER_FN float f(float x, INOUT(uint) state)`, literals with the suffix f or u,
// no swizzle assignments, and wrap declarations in SHADER_BEGIN / SHADER_END (namespace vigil::shader).
// SHADER_PADDING(words) ends a structure whose buffer is read as NAME_TEXELS texels of 16 bytes (trace/records.glsl).
#ifndef VIGIL_SHARED_GLSL_H
#define VIGIL_SHARED_GLSL_H

#ifdef __cplusplus

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#define SHADER_BEGIN namespace vigil::shader {
#define SHADER_END }
#define SHADER_FN inline
#define SHADER_CONST inline constexpr
#define INOUT(type) type&
#define OUT(type) type&
#define PRECISE
#define SHADER_PADDING(words) std::uint32_t unused[words] = {};

namespace vigil::shader {
using namespace glm;
using uint = std::uint32_t;
} // namespace vigil::shader

#else

#define SHADER_BEGIN
#define SHADER_END
#define SHADER_FN
#define SHADER_CONST const
#define INOUT(type) inout type
#define OUT(type) out type
#define PRECISE precise
#define SHADER_PADDING(words)

#endif
#endif
