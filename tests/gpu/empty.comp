// SPDX-License-Identifier: GPL-2.0-or-later
// A shader that does nothing, for tests of what surrounds shaders.
#version 460
layout(local_size_x = 1) in;
void main() {}
