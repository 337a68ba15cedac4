// SPDX-License-Identifier: GPL-2.0-or-later
// The sky panorama: directions, sides and radiance agree with formats/sky.h, all around and at the
// seams; the file comes back from tinyexr's reader.
#include "refresh/vkpt/export/export_pictures.h"

#include "export_folder.h"
#include "formats/sky.h"

#include <gtest/gtest.h>
#include <memory>
#include <tinyexr.h>

namespace vigil::vkpt {
namespace {

/// A sky whose texels hold their own direction, mapped to 0..1.
std::array<ExportTexture, 6> direction_sky(uint32_t size) {
    std::array<ExportTexture, 6> sides;
    for (size_t i = 0; i < 6; ++i) {
        sides[i] = {std::string(sky_sides[i].suffix), size, size, {}};
        for (uint32_t y = 0; y < size; ++y) {
            for (uint32_t x = 0; x < size; ++x) {
                const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(size);
                const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(size);
                const glm::vec3 direction = sky_sides[i].forward +
                                            (2.0f * u - 1.0f) * sky_sides[i].right -
                                            (2.0f * v - 1.0f) * sky_sides[i].up;
                sides[i].texels.push_back(0.5f + 0.5f * glm::normalize(direction));
            }
        }
    }
    return sides;
}

TEST(SkyPanorama, DirectionsAreTheDocumentedOnes) {
    const auto expect = [](float u, float v, glm::vec3 direction) {
        EXPECT_LT(glm::distance(panorama_direction(u, v), direction), 1e-6f) << u << " " << v;
    };
    expect(0.5f, 0.5f, {1, 0, 0});
    expect(0.25f, 0.5f, {0, 1, 0}); // left of the middle is yaw 90
    expect(0.75f, 0.5f, {0, -1, 0});
    expect(0.5f, 0.0f, {0, 0, 1});
    expect(0.5f, 1.0f, {0, 0, -1});
}

TEST(SkyPanorama, EveryPixelShowsItsDirection) {
    const ExportFolder folder;
    ExportSky sky;
    sky.radiance = {2.0f, 1.0f, 0.5f};
    sky.sides = direction_sky(64);
    write_sky_panorama(sky, folder / "sky.exr");
    float* raw = nullptr;
    int width = 0, height = 0;
    const char* reason = nullptr;
    ASSERT_EQ(LoadEXR(&raw, &width, &height, (folder / "sky.exr").c_str(), &reason),
              TINYEXR_SUCCESS);
    const std::unique_ptr<float, decltype(&std::free)> pixels(raw, std::free);
    ASSERT_EQ(width, 2048);
    ASSERT_EQ(height, 1024);
    float worst = 0.0f;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float* pixel = raw + 4 * (y * width + x);
            const glm::vec3 seen = glm::vec3(pixel[0], pixel[1], pixel[2]) / sky.radiance;
            const glm::vec3 wanted = panorama_direction((static_cast<float>(x) + 0.5f) / 2048.0f,
                                                        (static_cast<float>(y) + 0.5f) / 1024.0f);
            worst = std::max(worst, glm::distance(2.0f * seen - 1.0f, wanted));
        }
    }
    // At the edges of a side the outermost texel's centre is shown: half a texel, 1 / 64.
    EXPECT_LT(worst, 1.5f / 64.0f);
}

} // namespace
} // namespace vigil::vkpt
