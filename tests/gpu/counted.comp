#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Every invocation adds a constant to a counter.
layout(local_size_x = 8) in;
layout(constant_id = 3) const uint STEP = 1u;
layout(set = 0, binding = 0) buffer Counter { uint counter; };

void main() { atomicAdd(counter, STEP); }
