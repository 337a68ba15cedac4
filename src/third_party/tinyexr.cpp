// SPDX-License-Identifier: GPL-2.0-or-later
// The body of tinyexr, where the system has no library of it (cmake/ThirdParty.cmake). It
// compresses with zlib.
#include <zlib.h>

#define TINYEXR_USE_MINIZ 0
#define TINYEXR_IMPLEMENTATION
#include <tinyexr.h>
