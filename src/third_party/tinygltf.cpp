// SPDX-License-Identifier: GPL-2.0-or-later
// The body of tinygltf, where the system has no library of it (cmake/ThirdParty.cmake). Pictures
// are decoded by a body of stb_image of its own, which no other file sees.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

#include <nlohmann/json.hpp>

#define TINYGLTF_NO_INCLUDE_JSON
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
