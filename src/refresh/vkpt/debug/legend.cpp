// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/debug/legend.h"

#include "shared/view_colors.h"
#include "shared/views.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/packing.hpp>
#include <imgui.h>
#include <span>

namespace vigil::vkpt {

namespace {

constexpr int bar_steps = 96;
constexpr float letter_pixels = 13.0f; // for which ImGui's own font is drawn
constexpr float pixels_per_scale = 720.0f;
constexpr glm::vec3 ground{0.045f, 0.05f, 0.06f};
constexpr glm::vec3 text_color{0.9f, 0.9f, 0.87f};

std::string_view name_of(Technique technique) {
    return technique_infos[static_cast<size_t>(technique)].name;
}

/// A bar of the colour map.
void add_color_bar(LegendContent& content) {
    for (int i = 0; i < bar_steps; ++i)
        content.bar.push_back(
            shader::color_map((static_cast<float>(i) + 0.5f) / static_cast<float>(bar_steps)));
    content.classes.push_back({shader::VIEW_EMPTY, "none"});
}

/// A bar of counts from 1 to `most`, marked at 1, `step`, step^2, ...
void add_count_bar(LegendContent& content, float most, float step) {
    add_color_bar(content);
    for (float count = 1.0f; count <= most * 1.0001f; count *= step)
        content.marks.push_back(
            {shader::count_on_scale(count, most), fmt::format("{:.0f}", count)});
}

void add_depth_bar(LegendContent& content) {
    // Grey is not linear in distance: the bar is even in grey, and the marks stand where their
    // distances are.
    for (int i = 0; i < bar_steps; ++i)
        content.bar.emplace_back(1.0f - (static_cast<float>(i) + 0.5f) / bar_steps);
    for (const float distance : {0.0f, 64.0f, 256.0f, 1024.0f})
        content.marks.push_back(
            {1.0f - shader::view_depth_grey(distance), fmt::format("{:.0f}", distance)});
}

/// A bar of densities per steradian, marked at powers of ten.
void add_density_bar(LegendContent& content) {
    add_color_bar(content);
    for (const float density : {0.1f, 1.0f, 10.0f, 100.0f})
        content.marks.push_back({shader::density_on_scale(density), fmt::format("{:g}", density)});
}

bool is_of_guiding(int view) {
    return view == shader::VIEW_OCTREE || view == shader::VIEW_SAMPLES ||
           view == shader::VIEW_VLC_LIGHTS || view == shader::VIEW_VLC_BUCKETS;
}

/// What the views of light samples say.
void add_sample_classes(LegendContent& content, const LegendSubject& subject) {
    if (!subject.samples_lights) {
        content.classes.push_back(
            {shader::VIEW_OFF, fmt::format("none: pt_nee {}", name_of(subject.technique))});
        return;
    }
    if (subject.view == shader::VIEW_ZERO) {
        content.classes.push_back({shader::VIEW_ZERO_SAMPLE, "contributed nothing"});
        content.classes.push_back({shader::VIEW_LIT_SAMPLE, "contributed"});
        return;
    }
    const std::string by = subject.caches ? "cache" : std::string(name_of(subject.technique));
    content.classes.push_back({shader::VIEW_CACHE, by});
    content.classes.push_back({shader::VIEW_CACHE_ZERO, by + ", contributed nothing"});
    if (!subject.caches) return; // the others do not explore
    content.classes.push_back({shader::VIEW_EXPLORED, "exploration"});
    content.classes.push_back({shader::VIEW_EXPLORED_ZERO, "exploration, contributed nothing"});
}

/// Letters in coverage, from ImGui's own font.
class Letters {
public:
    explicit Letters(float pixels) {
        ImFontConfig config;
        config.SizePixels = pixels;
        config.OversampleH = 1;
        config.PixelSnapH = true;
        font_ = atlas_.AddFontDefault(&config);
        atlas_.GetTexDataAsAlpha8(&coverage_, &width_, &height_);
    }

    uint32_t width_of(std::string_view text) const {
        float width = 0.0f;
        for (const char letter : text)
            width += glyph(letter).AdvanceX;
        return static_cast<uint32_t>(std::ceil(width));
    }

    /// Draws with the text's upper left corner at `place`.
    void draw(LegendPixels& pixels, glm::uvec2 place, std::string_view text) const {
        float baseline_x = static_cast<float>(place.x);
        for (const char letter : text) {
            const ImFontGlyph& shape = glyph(letter);
            blend(pixels, shape,
                  glm::ivec2(std::lround(baseline_x + shape.X0),
                             static_cast<float>(place.y) + shape.Y0));
            baseline_x += shape.AdvanceX;
        }
    }

private:
    const ImFontGlyph& glyph(char letter) const {
        const auto character = static_cast<ImWchar>(static_cast<unsigned char>(letter));
#if IMGUI_VERSION_NUM >= 19200
        return *font_->GetFontBaked(font_->LegacySize)->FindGlyph(character);
#else
        return *font_->FindGlyph(character);
#endif
    }

    void blend(LegendPixels& pixels, const ImFontGlyph& shape, glm::ivec2 place) const {
        const glm::ivec2 first(std::lround(shape.U0 * static_cast<float>(width_)),
                               std::lround(shape.V0 * static_cast<float>(height_)));
        const glm::ivec2 size(std::lround(shape.X1 - shape.X0), std::lround(shape.Y1 - shape.Y0));
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec2 to = place + glm::ivec2(x, y);
                if (to.x < 0 || to.y < 0 || to.x >= static_cast<int>(pixels.width) ||
                    to.y >= static_cast<int>(pixels.height))
                    continue;
                const uint8_t covered = coverage_[(first.y + y) * width_ + first.x + x];
                const float part = static_cast<float>(covered) / 255.0f;
                pixels.rgba[static_cast<size_t>(to.y) * pixels.width + static_cast<size_t>(to.x)] =
                    glm::packUnorm4x8(glm::vec4(glm::mix(ground, text_color, part), 1.0f));
            }
        }
    }

    ImFontAtlas atlas_;
    ImFont* font_ = nullptr; // the atlas's
    unsigned char* coverage_ = nullptr;
    int width_ = 0, height_ = 0;
};

void fill(LegendPixels& pixels, glm::uvec2 corner, glm::uvec2 size, glm::vec3 color) {
    const uint32_t word = glm::packUnorm4x8(glm::vec4(color, 1.0f));
    for (uint32_t y = corner.y; y < corner.y + size.y; ++y) {
        const auto row = pixels.rgba.begin() + static_cast<ptrdiff_t>(y) * pixels.width;
        std::fill_n(row + corner.x, size.x, word);
    }
}

/// Measures of a legend, in pixels.
struct Layout {
    uint32_t line, pad, bar_width, bar_height, swatch;
    uint32_t width, height;
};

Layout lay_out(const LegendContent& content, const Letters& letters, uint32_t scale) {
    Layout layout{};
    layout.line = 14 * scale;
    layout.pad = 4 * scale;
    layout.bar_width = content.bar.empty() ? 0 : 2 * bar_steps * scale;
    layout.bar_height = 8 * scale;
    layout.swatch = 10 * scale;
    uint32_t inner = std::max(letters.width_of(content.title), layout.bar_width);
    for (const LegendContent::Class& row : content.classes)
        inner = std::max(inner, layout.swatch + layout.pad + letters.width_of(row.text));
    for (const std::string& note : content.notes)
        inner = std::max(inner, letters.width_of(note));
    layout.width = inner + 2 * layout.pad;
    const size_t lines = 1 + content.classes.size() + content.notes.size();
    layout.height = layout.pad + layout.line * static_cast<uint32_t>(lines);
    if (!content.bar.empty()) layout.height += layout.bar_height + 2 * scale + layout.line;
    layout.height += layout.pad;
    return layout;
}

/// The bar with its numbers; those at its ends stay inside the legend.
void draw_bar(LegendPixels& pixels, const LegendContent& content, const Letters& letters,
              const Layout& layout, uint32_t top, uint32_t scale) {
    const auto steps = static_cast<uint32_t>(content.bar.size());
    for (uint32_t i = 0; i < steps; ++i) {
        const uint32_t left = i * layout.bar_width / steps;
        const uint32_t right = (i + 1) * layout.bar_width / steps;
        fill(pixels, {layout.pad + left, top}, {right - left, layout.bar_height}, content.bar[i]);
    }
    for (const LegendContent::Mark& mark : content.marks) {
        const float along = std::clamp(mark.place, 0.0f, 1.0f);
        const auto place =
            static_cast<uint32_t>(along * static_cast<float>(layout.bar_width - scale));
        fill(pixels, {layout.pad + place, top + layout.bar_height}, {scale, 2 * scale}, text_color);
        const uint32_t width = letters.width_of(mark.text);
        const uint32_t half = std::min(place, width / 2);
        const uint32_t left = std::min(place - half, layout.bar_width - width);
        letters.draw(pixels, {layout.pad + left, top + layout.bar_height + 2 * scale}, mark.text);
    }
}

} // namespace

LegendContent legend_content(const LegendSubject& subject) {
    LegendContent content;
    if (is_of_guiding(subject.view) && !subject.guided) {
        content.title = view_infos[subject.view].name;
        content.classes.push_back({shader::VIEW_OFF, fmt::format("guiding is off: pt_nee {}",
                                                                 name_of(subject.technique))});
        return content;
    }
    switch (subject.view) {
    case shader::VIEW_OCTREE:
        content.title = "octree: a colour per leaf";
        break;
    case shader::VIEW_SAMPLES:
        content.title = "samples in the leaf, this frame";
        add_count_bar(content, shader::view_most_samples(subject.picture_size), 10.0f);
        break;
    case shader::VIEW_VLC_LIGHTS:
        content.title = "lights in the leaf's cache";
        add_count_bar(content, shader::VIEW_MOST_LIGHTS, 4.0f);
        break;
    case shader::VIEW_VLC_BUCKETS:
        content.title = "buckets of the leaf's cache";
        add_count_bar(content, shader::VIEW_MOST_BUCKETS, 2.0f);
        break;
    case shader::VIEW_CDQ:
        content.title = "directions: density per sr";
        add_density_bar(content);
        content.classes.push_back({shader::VIEW_HORIZON, "horizon of the surface"});
        content.classes.push_back({shader::VIEW_OFF, subject.quadtrees
                                                         ? "nothing under the cross"
                                                         : "no guider: pt_guide brdf"});
        content.notes = {"left: drawn by what was learned", "right: light that arrives",
                         "middle: up; corners: down"};
        break;
    case shader::VIEW_TECHNIQUE:
        content.title = "light sample drawn by";
        add_sample_classes(content, subject);
        break;
    case shader::VIEW_ZERO:
        content.title = "light sample";
        add_sample_classes(content, subject);
        break;
    case shader::VIEW_NONFINITE:
        content.title = "radiance of this frame";
        content.classes = {{shader::VIEW_BAD, "not finite"}, {shader::VIEW_GOOD, "finite"}};
        break;
    case shader::VIEW_DEPTH:
        content.title = "distance in map units";
        add_depth_bar(content);
        break;
    case shader::VIEW_CLUSTER:
        content.title = "PVS cluster: a colour each";
        content.classes = {{shader::VIEW_NO_CLUSTER, "in no cluster"}};
        break;
    case shader::VIEW_TRIANGLE:
        content.title = "triangle: a colour each";
        break;
    case shader::VIEW_LIGHT:
        content.title = "light: a colour each";
        content.classes = {{shader::VIEW_NO_LIGHT, "not a light"}};
        break;
    default: // the picture, and what has neither numbers nor classes
        break;
    }
    return content;
}

LegendPixels draw_legend(const LegendContent& content, uint32_t picture_height) {
    const float tall = static_cast<float>(picture_height) / pixels_per_scale;
    const auto scale = static_cast<uint32_t>(std::clamp(std::lround(tall), 1L, 3L));
    const Letters letters(letter_pixels * static_cast<float>(scale));
    const Layout layout = lay_out(content, letters, scale);
    LegendPixels pixels{layout.width, layout.height, {}};
    pixels.rgba.resize(size_t{layout.width} * layout.height);
    fill(pixels, {0, 0}, {layout.width, layout.height}, ground);

    uint32_t y = layout.pad;
    letters.draw(pixels, {layout.pad, y}, content.title);
    y += layout.line;
    if (!content.bar.empty()) {
        draw_bar(pixels, content, letters, layout, y, scale);
        y += layout.bar_height + 2 * scale + layout.line;
    }
    for (const LegendContent::Class& row : content.classes) {
        // Framed: classes may be as dark as the ground.
        fill(pixels, {layout.pad, y + 2 * scale}, {layout.swatch, layout.swatch},
             0.5f * text_color);
        fill(pixels, {layout.pad + scale, y + 3 * scale},
             {layout.swatch - 2 * scale, layout.swatch - 2 * scale}, row.color);
        letters.draw(pixels, {2 * layout.pad + layout.swatch, y}, row.text);
        y += layout.line;
    }
    for (const std::string& note : content.notes) {
        letters.draw(pixels, {layout.pad, y}, note);
        y += layout.line;
    }
    return pixels;
}

void record_pixels(gpu::FrameCommands& commands, const gpu::Buffer& display,
                   glm::uvec2 picture_size, glm::uvec2 corner, const LegendPixels& pixels) {
    gpu::barrier(commands.commands(), gpu::access_of_shaders | gpu::access_of_copies,
                 gpu::access_of_copies);
    for (uint32_t row = 0; row < pixels.height; ++row) {
        const uint64_t first = uint64_t{corner.y + row} * picture_size.x + corner.x;
        const std::span<const uint32_t> words(&pixels.rgba[size_t{row} * pixels.width],
                                              pixels.width);
        commands.upload(display, first * sizeof(uint32_t), gpu::bytes_of(words));
    }
}

void Legend::record(gpu::FrameCommands& commands, const gpu::Buffer& display,
                    const LegendSubject& subject) {
    if (subject != subject_) {
        subject_ = subject;
        const LegendContent content = legend_content(subject);
        pixels_ =
            content.title.empty() ? LegendPixels{} : draw_legend(content, subject.picture_size.y);
        const glm::uvec2 size(pixels_.width, pixels_.height);
        const glm::uvec2 room(subject.end_column - subject.first_column, subject.picture_size.y);
        area_ = {};
        if (glm::all(glm::lessThanEqual(size, room)))
            area_ = {{subject.first_column, subject.picture_size.y - size.y}, size};
    }
    if (area_.size.y == 0) return;
    record_pixels(commands, display, subject.picture_size, area_.corner, pixels_);
}

} // namespace vigil::vkpt
