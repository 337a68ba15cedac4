// SPDX-License-Identifier: GPL-2.0-or-later
#include "yamagi/screen.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "common/log.h"
#include "formats/game_palette.h"
#include "formats/pcx.h"
#include "yamagi/kept.h"

#include <algorithm>
#include <cmath>

namespace vigil::yamagi {

namespace {

constexpr int film_slot = -1; // of made pictures; previews count from 0
constexpr float fade_opacity = 0.6f;
constexpr int character_pixels = 8, characters_in_row = 16;

/// Where pics/colormap.pcx is missing: 16 greys from black to white, then about the colours that
/// the game's effects mean.
Palette own_palette() {
    Palette palette{};
    for (size_t i = 0; i < palette.size(); ++i) {
        if (i < 16) {
            palette.at(i).fill(static_cast<uint8_t>(17 * i));
            continue;
        }
        const glm::vec3 color = palette_color(static_cast<uint8_t>(i));
        palette.at(i) = {linear_to_srgb(color.x), linear_to_srgb(color.y), linear_to_srgb(color.z)};
    }
    return palette;
}

Palette game_palette(const FileSystem& files) {
    constexpr std::string_view name = "pics/colormap.pcx";
    try {
        if (files.exists(name)) return decode_pcx(name, files.read(name)).palette;
    } catch (const Error& error) {
        log_warning("{}; its palette is guessed", error.what());
    }
    return own_palette();
}

glm::vec4 color_of(const Palette& palette, int index) {
    const auto& rgb = palette[static_cast<size_t>(index & 255)];
    return glm::vec4(rgb[0], rgb[1], rgb[2], 255.0f) / 255.0f;
}

} // namespace

std::optional<std::string> picture_file(const FileSystem& files, std::string_view name) {
    std::string path;
    if (name.starts_with('/') || name.starts_with('\\'))
        path = name.substr(1);
    else
        path = fmt::format("pics/{}.pcx", name);
    std::ranges::replace(path, '\\', '/');
    if (files.exists(path)) return path;
    const size_t point = path.rfind('.');
    if (point == std::string::npos || path.find('/', point) != std::string::npos)
        return std::nullopt;
    for (const std::string_view extension : {"png", "tga", "jpg"}) {
        std::string other = path.substr(0, point + 1).append(extension);
        if (files.exists(other)) return other;
    }
    return std::nullopt;
}

Screen::Screen(const FileSystem& files)
    : files_(files), palette_(game_palette(files)), film_palette_(palette_) {}

void Screen::use(refresh::Renderer* renderer) {
    renderer_ = renderer;
    handles_.clear();
    made_.clear();
    draws_.clear();
}

void Screen::set_size(glm::ivec2 engine, glm::ivec2 shown) {
    engine_size_ = engine;
    scale_ = glm::vec2(shown) / glm::vec2(glm::max(engine, glm::ivec2(1)));
}

Picture* Screen::keep(std::string_view name, std::string file) {
    auto picture = std::make_unique<Picture>();
    std::ranges::fill(picture->name, '\0');
    std::ranges::copy(name.substr(0, sizeof(picture->name) - 1), picture->name);
    picture->file = std::move(file);
    return pictures_.insert_or_assign(std::string(name), std::move(picture)).first->second.get();
}

Picture* Screen::find(std::string_view name) {
    if (const auto known = pictures_.find(name); known != pictures_.end())
        return known->second.get();
    std::optional<std::string> file = picture_file(files_, name);
    if (file) return keep(name, std::move(*file));
    pictures_.emplace(name, nullptr); // asked for again and again
    return nullptr;
}

Picture* Screen::find_skin(std::string_view name) {
    return find(fmt::format("/{}", name));
}

refresh::PictureHandle Screen::handle_of(const Picture& picture) {
    return kept(handles_, picture.file, refresh::no_picture,
                [&] { return renderer_->register_picture(picture.file); });
}

refresh::PictureHandle Screen::handle_of(std::string_view name) {
    const Picture* const found = renderer_ != nullptr ? find(name) : nullptr;
    return found != nullptr ? handle_of(*found) : refresh::no_picture;
}

glm::ivec2 Screen::size_of(std::string_view name) {
    const refresh::PictureHandle handle = handle_of(name);
    return handle == refresh::no_picture ? glm::ivec2(0) : renderer_->picture_size(handle);
}

void Screen::add(const refresh::Draw& draw) {
    if (renderer_ == nullptr) return;
    // Corners are scaled, not sizes: neighbours stay neighbours.
    const auto scaled = [&](const glm::ivec2& place) {
        return glm::ivec2(glm::round(glm::vec2(place) * scale_));
    };
    refresh::Draw shown = draw;
    shown.corner = scaled(draw.corner);
    shown.size = scaled(draw.corner + draw.size) - shown.corner;
    if (draw.clip_size.x != refresh::Draw().clip_size.x) {
        shown.clip_corner = scaled(draw.clip_corner);
        shown.clip_size = scaled(draw.clip_corner + draw.clip_size) - shown.clip_corner;
    }
    draws_.push_back(shown);
}

void Screen::picture(glm::ivec2 corner, std::string_view name, float factor,
                     const glm::vec3& color) {
    refresh::Draw draw;
    draw.picture = handle_of(name);
    if (draw.picture == refresh::no_picture) return;
    draw.corner = corner;
    draw.size = glm::ivec2(
        glm::round(glm::vec2(renderer_->picture_size(draw.picture)) * std::max(factor, 0.0f)));
    draw.color = glm::vec4(color, 1.0f);
    add(draw);
}

void Screen::stretched(glm::ivec2 corner, glm::ivec2 size, std::string_view name) {
    refresh::Draw draw;
    draw.picture = handle_of(name);
    if (draw.picture == refresh::no_picture) return;
    draw.corner = corner;
    draw.size = size;
    add(draw);
}

void Screen::character(glm::ivec2 corner, int character, float scale) {
    constexpr int space = 32, without_color = 127; // the other half has another colour
    const int shown = character & 255;
    if ((shown & without_color) == space) return;
    refresh::Draw draw;
    draw.picture = handle_of("conchars");
    if (draw.picture == refresh::no_picture) return;
    draw.corner = corner;
    draw.size = glm::ivec2(static_cast<int>(std::lround(character_pixels * std::max(scale, 0.0f))));
    const glm::vec2 cell(static_cast<float>(shown % characters_in_row),
                         static_cast<float>(shown / characters_in_row));
    draw.from = cell / static_cast<float>(characters_in_row);
    draw.to = (cell + 1.0f) / static_cast<float>(characters_in_row);
    add(draw);
}

void Screen::tiles(glm::ivec2 corner, glm::ivec2 size, std::string_view name) {
    const glm::ivec2 tile = size_of(name);
    if (tile.x <= 0 || tile.y <= 0) return fill(corner, size, 0);
    // Tiles have their places on the screen, not in the rectangle.
    const glm::ivec2 from = glm::max(corner, glm::ivec2(0));
    const glm::ivec2 to = glm::min(corner + size, engine_size_);
    refresh::Draw draw;
    draw.picture = handle_of(name);
    draw.size = tile;
    draw.clip_corner = from;
    draw.clip_size = to - from;
    if (draw.clip_size.x <= 0 || draw.clip_size.y <= 0) return;
    for (int y = from.y / tile.y * tile.y; y < to.y; y += tile.y)
        for (int x = from.x / tile.x * tile.x; x < to.x; x += tile.x) {
            draw.corner = {x, y};
            add(draw);
        }
}

void Screen::fill(glm::ivec2 corner, glm::ivec2 size, int color) {
    tint(corner, size, color_of(palette_, color));
}

void Screen::tint(glm::ivec2 corner, glm::ivec2 size, const glm::vec4& color) {
    refresh::Draw draw;
    draw.corner = corner;
    draw.size = size;
    draw.color = color;
    add(draw);
}

void Screen::fade() {
    tint({0, 0}, engine_size_, {0.0f, 0.0f, 0.0f, fade_opacity});
}

refresh::PictureHandle Screen::made_picture(int slot, glm::ivec2 size) {
    return kept(made_, {slot, {size.x, size.y}}, refresh::no_picture,
                [&] { return renderer_->make_picture(size); });
}

void Screen::film(glm::ivec2 corner, glm::ivec2 size, glm::ivec2 texels, const uint8_t* data,
                  int bits) {
    if (renderer_ == nullptr || data == nullptr || texels.x <= 0 || texels.y <= 0) return;
    refresh::Draw draw;
    draw.picture = made_picture(film_slot, texels);
    if (draw.picture == refresh::no_picture) return;
    draw.corner = corner;
    draw.size = size;
    const size_t count = static_cast<size_t>(texels.x) * static_cast<size_t>(texels.y);
    texels_.resize(4 * count);
    for (size_t i = 0; i < count; ++i) {
        const uint8_t* const rgb = bits == 32 ? data + 4 * i : film_palette_[data[i]].data();
        std::copy_n(rgb, 3, &texels_[4 * i]);
        texels_[4 * i + 3] = 255;
    }
    renderer_->change_picture(draw.picture, texels_);
    add(draw);
}

void Screen::made(glm::ivec2 corner, glm::ivec2 size, const refresh::Picture& picture, int slot) {
    if (renderer_ == nullptr || picture.rgba.empty()) return;
    refresh::Draw draw;
    draw.picture = made_picture(slot, {picture.width, picture.height});
    if (draw.picture == refresh::no_picture) return;
    renderer_->change_picture(draw.picture, picture.rgba);
    draw.corner = corner;
    draw.size = size;
    add(draw);
}

glm::ivec2 Screen::shown_size(glm::ivec2 size) const {
    return glm::ivec2(glm::round(glm::vec2(size) * scale_));
}

void Screen::set_film_palette(const uint8_t* palette) {
    film_palette_ = palette_;
    if (palette == nullptr) return;
    for (auto& color : film_palette_) {
        std::copy_n(palette, 3, color.begin());
        palette += 3;
    }
}

glm::vec3 Screen::linear_color(int index) const {
    const auto& rgb = palette_[static_cast<size_t>(index & 255)];
    return {srgb_to_linear(rgb[0]), srgb_to_linear(rgb[1]), srgb_to_linear(rgb[2])};
}

} // namespace vigil::yamagi
