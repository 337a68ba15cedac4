// SPDX-License-Identifier: GPL-2.0-or-later
// The body of stb_image_write, where the system has no library of it (cmake/ThirdParty.cmake).
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
