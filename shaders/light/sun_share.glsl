// SPDX-License-Identifier: GPL-2.0-or-later
// The sun has no place among lamps: techniques that know nothing of what is hidden give it a part of their draws for itself, where it
// can shine.
#ifndef VIGIL_LIGHT_SUN_SHARE_GLSL
#define VIGIL_LIGHT_SUN_SHARE_GLSL

#include "light/importance.glsl"

/// Part of the draws that are of the sun; `others` is whether there is another light.
float sun_share(Surface surface, bool others) {
    if (!HAS_ENVIRONMENT || frame.sun_light == NONE) return 0.0;
    if (!(light_importance(prepare_importance(surface), frame.sun_light) > 0.0)) return 0.0;
    return others ? 0.5 : 1.0;
}

#endif
