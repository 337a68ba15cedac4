// SPDX-License-Identifier: GPL-2.0-or-later
// The body of stb_image, alone in its file because it does not compile under the project's
// warnings. Only TGA is built in; files come as bytes, never by name.
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_MAX_DIMENSIONS 16384
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>
