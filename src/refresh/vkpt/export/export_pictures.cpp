// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/export/export_pictures.h"

#include "common/error.h"
#include "formats/image.h"
#include "formats/sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stb/stb_image_write.h>
#include <tinyexr.h>

namespace vigil::vkpt {

namespace {

// Readers interpolate between our pixels, so that the creases between texels are rounded off: at
// two pixels per texel a 64-texel side was seen to be off by 0.35% around a glow. The least width
// gives such sides eight.
constexpr uint32_t panorama_min_width = 2048, panorama_max_width = 4096;

/// Bilinear, clamped at the edges: what the path tracer's sky.glsl does.
glm::vec3 sample(const ExportTexture& texture, glm::vec2 uv) {
    const glm::vec2 size(texture.width, texture.height);
    const glm::vec2 place = glm::clamp(uv * size - 0.5f, glm::vec2(0.0f), size - 1.0f);
    const auto x = static_cast<size_t>(place.x), y = static_cast<size_t>(place.y);
    const size_t right = std::min<size_t>(x + 1, texture.width - 1);
    const size_t below = std::min<size_t>(y + 1, texture.height - 1);
    const glm::vec2 weight = place - glm::floor(place);
    const auto at = [&](size_t u, size_t v) { return texture.texels[v * texture.width + u]; };
    return glm::mix(glm::mix(at(x, y), at(right, y), weight.x),
                    glm::mix(at(x, below), at(right, below), weight.x), weight.y);
}

} // namespace

std::vector<std::byte> encode_png(const ExportTexture& texture) {
    std::vector<uint8_t> rgb;
    rgb.reserve(3 * texture.texels.size());
    for (const glm::vec3& texel : texture.texels) {
        for (glm::length_t i = 0; i < 3; ++i)
            rgb.push_back(linear_to_srgb(texel[i]));
    }
    std::vector<std::byte> bytes;
    const auto append = [](void* context, void* data, int size) {
        auto& out = *static_cast<std::vector<std::byte>*>(context);
        const auto* first = static_cast<const std::byte*>(data);
        out.insert(out.end(), first, first + size);
    };
    const int width = static_cast<int>(texture.width), height = static_cast<int>(texture.height);
    if (!stbi_write_png_to_func(append, &bytes, width, height, 3, rgb.data(), 3 * width))
        fail("texture {}: the PNG encoder ran out of memory", texture.name);
    return bytes;
}

glm::vec3 sky_box_radiance(const std::array<ExportTexture, 6>& sides, glm::vec3 direction) {
    // The side whose axis is nearest to the direction; the others lie behind it or farther out.
    size_t nearest = 0;
    for (size_t side = 1; side < sky_sides.size(); ++side) {
        if (glm::dot(direction, sky_sides[side].forward) >
            glm::dot(direction, sky_sides[nearest].forward))
            nearest = side;
    }
    const SkySide& side = sky_sides[nearest];
    const glm::vec3 on_plane = direction / glm::dot(direction, side.forward);
    return sample(sides[nearest], {0.5f + 0.5f * glm::dot(on_plane, side.right),
                                   0.5f - 0.5f * glm::dot(on_plane, side.up)});
}

glm::vec3 panorama_direction(float u, float v) {
    const float yaw = (0.5f - u) * 2.0f * std::numbers::pi_v<float>;
    const float polar = v * std::numbers::pi_v<float>; // from straight up
    return {std::sin(polar) * std::cos(yaw), std::sin(polar) * std::sin(yaw), std::cos(polar)};
}

void write_sky_panorama(const ExportSky& sky, const std::filesystem::path& path) {
    // A side covers a quarter of the horizon: at least two pixels per texel.
    uint32_t width = panorama_min_width;
    for (const ExportTexture& side : *sky.sides)
        width = std::max(width, 8 * std::max(side.width, side.height));
    width = std::min(width, panorama_max_width);
    const uint32_t height = width / 2;
    std::vector<glm::vec3> pixels;
    pixels.reserve(size_t{width} * height);
    for (uint32_t y = 0; y < height; ++y) {
        for (uint32_t x = 0; x < width; ++x) {
            const glm::vec3 direction =
                panorama_direction((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                                   (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
            pixels.push_back(sky.radiance * sky_box_radiance(*sky.sides, direction));
        }
    }
    const char* reason = nullptr;
    constexpr int rgb = 3, full_floats = 0;
    const int result = SaveEXR(&pixels[0].x, static_cast<int>(width), static_cast<int>(height), rgb,
                               full_floats, path.c_str(), &reason);
    if (result == TINYEXR_SUCCESS) return;
    const std::string text = reason ? reason : "unknown reason";
    FreeEXRErrorMessage(reason);
    fail("{}: cannot write: {}", path.string(), text);
}

} // namespace vigil::vkpt
