// SPDX-License-Identifier: GPL-2.0-or-later
// Reads a value wherever it is told, for a test of the validation that must notice the buffer's end.
#version 460
layout(local_size_x = 1) in;
layout(set = 0, binding = 0) readonly buffer Values { uint values[]; };
layout(set = 0, binding = 1) buffer Answer { uint answer; };
layout(push_constant) uniform Push { uint at; };
void main() { answer = values[at]; }
