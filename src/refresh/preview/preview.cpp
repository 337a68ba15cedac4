// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/preview/preview.h"

#include "common/error.h"
#include "common/file_system.h"
#include "common/log.h"
#include "common/rotation.h"
#include "formats/image.h"
#include "formats/md2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace vigil::refresh {

namespace {

/// Samples of a pixel in each direction.
constexpr int samples = 2;

/// Light on a white surface with this normal; `view` has the camera's axes. A lamp over the
/// viewer's left shoulder, a weaker one from behind on the right, and light from all around, more
/// of it from above. 1 is white in the picture.
float light_on(const glm::vec3& normal, const glm::mat3& view) {
    const glm::vec3 key = glm::normalize(view * glm::vec3(-1.0f, 0.6f, 0.9f));
    const glm::vec3 rim = glm::normalize(view * glm::vec3(1.0f, -0.8f, 0.5f));
    return 0.35f + 0.15f * normal.z + 0.85f * std::max(glm::dot(normal, key), 0.0f) +
           0.25f * std::max(glm::dot(normal, rim), 0.0f);
}

/// A corner as the camera sees it.
struct Corner {
    glm::vec2 place{0.0f}; // samples, from the top left
    float nearness = 0.0f; // 1 / depth
    glm::vec2 uv{0.0f};
    float light = 0.0f;
};

struct Canvas {
    glm::ivec2 size{0};           // samples
    std::vector<glm::vec4> color; // linear, with coverage
    std::vector<float> nearness;  // of what is seen; 0: nothing
};

float cross(const glm::vec2& a, const glm::vec2& b) {
    return a.x * b.y - a.y * b.x;
}

void fill(Canvas& canvas, const std::array<Corner, 3>& corners, const Image& skin, float alpha) {
    const auto& [a, b, c] = corners;
    // Counter-clockwise from outside; rows grow downwards.
    const float area = -cross(b.place - a.place, c.place - a.place);
    if (!(area > 0.0f)) return;
    const glm::vec2 low = glm::min(a.place, glm::min(b.place, c.place));
    const glm::vec2 high = glm::max(a.place, glm::max(b.place, c.place));
    const glm::vec2 last(canvas.size - 1);
    const glm::ivec2 from(glm::clamp(glm::floor(low), glm::vec2(0.0f), last));
    const glm::ivec2 to(glm::clamp(glm::ceil(high), glm::vec2(0.0f), last));
    for (int y = from.y; y <= to.y; ++y) {
        for (int x = from.x; x <= to.x; ++x) {
            const glm::vec2 point(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const float wa = -cross(b.place - point, c.place - point) / area;
            const float wb = -cross(c.place - point, a.place - point) / area;
            // Not 1 - wa - wb: a point on an edge is in one of the two triangles that share it.
            const float wc = -cross(a.place - point, b.place - point) / area;
            if (wa < 0.0f || wb < 0.0f || wc < 0.0f) continue;
            const float nearness = wa * a.nearness + wb * b.nearness + wc * c.nearness;
            const size_t index = static_cast<size_t>(y) * static_cast<size_t>(canvas.size.x) +
                                 static_cast<size_t>(x);
            if (nearness <= canvas.nearness[index]) continue;
            const float pa = wa * a.nearness / nearness, pb = wb * b.nearness / nearness;
            const float pc = wc * c.nearness / nearness;
            const glm::vec2 uv = pa * a.uv + pb * b.uv + pc * c.uv;
            const glm::ivec2 most(static_cast<int>(skin.width) - 1,
                                  static_cast<int>(skin.height) - 1);
            const glm::ivec2 texel =
                glm::clamp(glm::ivec2(glm::floor(uv * glm::vec2(most + 1))), glm::ivec2(0), most);
            const uint8_t* const rgba = &skin.rgba[4 * (static_cast<size_t>(texel.y) * skin.width +
                                                        static_cast<size_t>(texel.x))];
            const float light = pa * a.light + pb * b.light + pc * c.light;
            const glm::vec3 color =
                light * glm::vec3(srgb_to_linear(rgba[0]), srgb_to_linear(rgba[1]),
                                  srgb_to_linear(rgba[2]));
            canvas.color[index] = glm::vec4(color, alpha);
            canvas.nearness[index] = nearness;
        }
    }
}

size_t wrap(int frame, size_t count) {
    const int rest = frame % static_cast<int>(count);
    return static_cast<size_t>(rest < 0 ? rest + static_cast<int>(count) : rest);
}

void draw_model(Canvas& canvas, const Preview& preview, const PreviewModel& placed, const Md2& md2,
                const Image& skin) {
    const glm::mat3 view = rotation_from_angles(preview.view.angles),
                    turn = rotation_from_angles(placed.angles);
    const glm::vec2 half = 0.5f * glm::radians(glm::vec2(preview.view.fov, preview.view.fov_y));
    const glm::vec2 scale = 0.5f * glm::vec2(canvas.size) / glm::tan(half);
    const Md2Frame& now = md2.frames[wrap(placed.frame, md2.frames.size())];
    const Md2Frame& before = md2.frames[wrap(placed.old_frame, md2.frames.size())];

    // Every corner once, then the triangles.
    std::vector<Corner> corners(md2.uvs.size());
    for (size_t i = 0; i < corners.size(); ++i) {
        const glm::vec3 place =
            placed.origin + turn * glm::mix(now.positions[i], before.positions[i], placed.backlerp);
        const glm::vec3 normal =
            turn * glm::mix(now.normals[i], before.normals[i], placed.backlerp);
        const glm::vec3 seen = glm::transpose(view) * (place - preview.view.origin);
        if (!(seen.x >= PreviewPainter::nearest)) continue; // nearness stays 0
        const glm::vec2 offset(-seen.y, -seen.z);
        corners[i] = {0.5f * glm::vec2(canvas.size) + scale * offset / seen.x, 1.0f / seen.x,
                      md2.uvs[i], light_on(normal, view)};
    }
    for (size_t i = 0; i + 2 < md2.indices.size(); i += 3) {
        const std::array<Corner, 3> triangle{corners[md2.indices[i]], corners[md2.indices[i + 1]],
                                             corners[md2.indices[i + 2]]};
        if (std::ranges::all_of(triangle, [](const Corner& c) { return c.nearness > 0.0f; }))
            fill(canvas, triangle, skin, placed.alpha);
    }
}

/// The mean of each pixel's samples.
Picture reduce(const Canvas& canvas) {
    Picture picture;
    picture.width = canvas.size.x / samples;
    picture.height = canvas.size.y / samples;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            glm::vec4 sum(0.0f); // colours weighted by their coverage
            for (int i = 0; i < samples * samples; ++i) {
                const int row = samples * y + i / samples, column = samples * x + i % samples;
                const glm::vec4& one =
                    canvas.color[static_cast<size_t>(row) * static_cast<size_t>(canvas.size.x) +
                                 static_cast<size_t>(column)];
                sum += glm::vec4(glm::vec3(one.x, one.y, one.z) * one.w, one.w);
            }
            const glm::vec3 color =
                sum.w > 0.0f ? glm::vec3(sum.x, sum.y, sum.z) / sum.w : glm::vec3(0.0f);
            const float coverage = sum.w / static_cast<float>(samples * samples);
            for (glm::length_t i = 0; i < 3; ++i)
                picture.rgba.push_back(linear_to_srgb(color[i]));
            picture.rgba.push_back(
                static_cast<uint8_t>(std::lround(255.0f * std::clamp(coverage, 0.0f, 1.0f))));
        }
    return picture;
}

} // namespace

PreviewPainter::PreviewPainter(const FileSystem& files) : files_(files) {}

PreviewPainter::~PreviewPainter() = default;

void PreviewPainter::clear() {
    models_.clear();
    skins_.clear();
}

const Md2* PreviewPainter::model(const std::string& name) {
    const auto [row, is_new] = models_.try_emplace(name);
    if (is_new) {
        try {
            row->second = std::make_unique<Md2>(parse_md2(name, files_.read(name)));
        } catch (const Error& error) {
            log_warning("{}. The preview lacks it.", error.what());
        }
    }
    return row->second.get();
}

const Image& PreviewPainter::skin(const std::string& name) {
    const auto [row, is_new] = skins_.try_emplace(name);
    if (is_new) {
        try {
            row->second = std::make_unique<Image>(decode_image(name, files_.read(name)));
        } catch (const Error& error) {
            log_warning("{}. The preview shows a checker.", error.what());
            row->second = std::make_unique<Image>(checker_image());
        }
    }
    return *row->second;
}

Picture PreviewPainter::draw(const Preview& preview) {
    const glm::ivec2 size = preview.size;
    if (size.x < 1 || size.y < 1 || size.x > largest || size.y > largest) return {};
    Canvas canvas;
    canvas.size = samples * size;
    const size_t count = static_cast<size_t>(canvas.size.x) * static_cast<size_t>(canvas.size.y);
    canvas.color.assign(count, glm::vec4(0.0f));
    canvas.nearness.assign(count, 0.0f);
    for (const PreviewModel& placed : preview.models) {
        const Md2* const md2 = model(placed.model);
        if (md2 == nullptr || placed.alpha <= 0.0f) continue;
        std::string skin_name = placed.skin;
        if (skin_name.empty() && !md2->skins.empty())
            skin_name = md2->skins[static_cast<size_t>(
                std::clamp(placed.skin_number, 0, static_cast<int>(md2->skins.size()) - 1))];
        draw_model(canvas, preview, placed, *md2, skin(skin_name));
    }
    return reduce(canvas);
}

} // namespace vigil::refresh
