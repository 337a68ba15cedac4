// SPDX-License-Identifier: GPL-2.0-or-later
// Guider `brdf`: none. Rays are drawn by the BRDF alone.
#define GUIDES 0
