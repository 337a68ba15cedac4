// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `power`: lights in proportion to area times luminance. Host side: refresh/vkpt/light/power.cpp.
#include "light/alias_choice.glsl"
