// SPDX-License-Identifier: GPL-2.0-or-later
// What indirect rays are drawn by, besides the BRDF: the guider that a shader is compiled for (shared/guiders.h). Its file,
// guiding/NAME.glsl, defines
//   GUIDES              0: nothing more is defined, rays are drawn by the BRDF alone
//   struct Guide        what draws directions around one place
//   guide_prepare       makes it of the four words that the place's node of the octree has in NODE_GUIDE
//   guide_sample        draws a unit vector, and says its guide_pdf; u in [0, 1)^3
//   guide_pdf           the density of that, per steradian: of any unit vector, above 0 where light may come from
//   guide_border        for pt_view cdq: whether a line is drawn at `uv` of an octahedral map of `edge` pixels
// and, where GUIDE_LEARNS is defined (guide_adapt.comp), what follows from a frame's rays:
//   guide_learn         brings the words of a node whose leaves sent `rays` > 0 rays to them
// GUIDER_SIZE is the host's: refresh/vkpt/guiding/NAME.cpp.
#ifndef VIGIL_GUIDING_GUIDER_GLSL
#define VIGIL_GUIDING_GUIDER_GLSL

#include "selected_guider.glsl"

#endif
