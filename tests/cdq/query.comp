#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Answers the queries of cdq_gpu_test, one per invocation.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "query.h"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, scalar) restrict readonly buffer QueryBlock { CdqQuery queries[]; };
layout(set = 0, binding = 1, scalar) restrict writeonly buffer AnswerBlock { CdqAnswer answers[]; };

void main() {
    const uint index = gl_GlobalInvocationID.x;
    if (index < queries.length()) answers[index] = cdq_answer(queries[index]);
}
