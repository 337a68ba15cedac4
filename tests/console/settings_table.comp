// SPDX-License-Identifier: GPL-2.0-or-later
// Compiles the shared tables as a shader does, and reads a field of each type. It is never run.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/settings_table.h"
#include "shared/techniques.h"

layout(local_size_x = 1) in;
layout(set = 0, binding = 0, scalar) uniform Cvars { GpuSettings cvars; };
layout(set = 0, binding = 1, scalar) buffer Result { float result; };

void main() { result = cvars.pt_sky_scale + float(cvars.pt_seed) + float(cvars.pt_view); }
