// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `uniform`: every light that shines with equal probability. Host side: refresh/vkpt/light/uniform.cpp.
#include "light/alias_choice.glsl"
