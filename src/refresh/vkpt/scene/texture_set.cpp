// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/scene/texture_set.h"

#include "common/error.h"
#include "common/file_system.h"
#include "common/log.h"
#include "formats/pcx.h"
#include "formats/sky.h"
#include "formats/texture_name.h"
#include "formats/wal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

namespace vigil::vkpt {

namespace {

std::vector<glm::vec3> linear_texels(const Image& image) {
    std::vector<glm::vec3> texels(size_t{image.width} * image.height);
    for (size_t i = 0; i < texels.size(); ++i)
        for (size_t channel = 0; channel < 3; ++channel)
            texels[i][channel] = srgb_to_linear(image.rgba[4 * i + channel]);
    return texels;
}

/// Half the size in both directions, rounded down, by a box filter; odd sizes lose their last row
/// or column.
std::vector<glm::vec3> half_size(const std::vector<glm::vec3>& source, uint32_t width,
                                 uint32_t height) {
    const uint32_t half_width = std::max(width / 2, 1u);
    const uint32_t half_height = std::max(height / 2, 1u);
    std::vector<glm::vec3> target(size_t{half_width} * half_height);
    for (uint32_t y = 0; y < half_height; ++y) {
        for (uint32_t x = 0; x < half_width; ++x) {
            const uint32_t x0 = std::min(2 * x, width - 1), x1 = std::min(2 * x + 1, width - 1);
            const uint32_t y0 = std::min(2 * y, height - 1), y1 = std::min(2 * y + 1, height - 1);
            const auto at = [&](uint32_t u, uint32_t v) { return source[size_t{v} * width + u]; };
            target[size_t{y} * half_width + x] =
                0.25f * (at(x0, y0) + at(x1, y0) + at(x0, y1) + at(x1, y1));
        }
    }
    return target;
}

} // namespace

uint32_t encode_rgb9e5(glm::vec3 color) {
    // The format of EXT_texture_shared_exponent: 9-bit mantissas without a hidden one, exponent
    // bias 15.
    for (glm::length_t i = 0; i < 3; ++i)
        color[i] = color[i] > 0.0f ? std::min(color[i], 65408.0f) : 0.0f;
    const float largest = std::max({color.x, color.y, color.z});
    if (largest < 1e-9f) return 0;
    int exponent = 0;
    std::frexp(largest, &exponent); // largest = m * 2^exponent, m in [0.5, 1)
    exponent = std::max(exponent, -15);
    float scale = std::ldexp(1.0f, 9 - exponent);
    if (std::lround(largest * scale) == 512) { // rounds up to the next power of two
        ++exponent;
        scale *= 0.5f;
    }
    const auto mantissa = [&](float value) {
        return static_cast<uint32_t>(std::lround(value * scale));
    };
    return mantissa(color.x) | mantissa(color.y) << 9 | mantissa(color.z) << 18 |
           static_cast<uint32_t>(exponent + 15) << 27;
}

glm::vec3 decode_rgb9e5(uint32_t texel) {
    const float scale = std::ldexp(1.0f, static_cast<int>(texel >> 27) - 24);
    return scale * glm::vec3(static_cast<float>(texel & 511u),
                             static_cast<float>((texel >> 9) & 511u),
                             static_cast<float>((texel >> 18) & 511u));
}

TextureSet::TextureSet(const FileSystem& files) : files_(files) {}

const Palette* TextureSet::palette() {
    if (!palette_tried_) {
        palette_tried_ = true;
        try {
            if (files_.exists("pics/colormap.pcx"))
                palette_ =
                    decode_pcx("pics/colormap.pcx", files_.read("pics/colormap.pcx")).palette;
        } catch (const Error& error) {
            log_warning("{}", error.what());
        }
    }
    return palette_ ? &*palette_ : nullptr;
}

std::optional<Image> TextureSet::load(const std::string& path) {
    if (!files_.exists(path)) return std::nullopt;
    try {
        return decode_image(path, files_.read(path), palette());
    } catch (const Error& error) {
        log_warning("{}", error.what());
        return std::nullopt;
    }
}

TextureSet::Entry TextureSet::add(const Image& image, bool mips) {
    return add(linear_texels(image), image.width, image.height, mips);
}

TextureSet::Entry TextureSet::add(std::vector<glm::vec3> level, uint32_t width, uint32_t height,
                                  bool mips) {
    Entry entry;
    entry.header = static_cast<uint32_t>(headers_.size());
    entry.uv_size = {width, height};
    shader::Texture header{};
    header.first_texel = static_cast<uint32_t>(texels_.size());
    header.width = width;
    header.height = height;
    glm::dvec3 sum(0.0);
    while (true) {
        ++header.mip_count;
        for (const glm::vec3& texel : level) {
            texels_.push_back(encode_rgb9e5(texel));
            if (header.mip_count == 1) sum += glm::dvec3(decode_rgb9e5(texels_.back()));
        }
        if (!mips || (width == 1 && height == 1)) break;
        level = half_size(level, width, height);
        width = std::max(width / 2, 1u);
        height = std::max(height / 2, 1u);
    }
    entry.mean = glm::vec3(sum / static_cast<double>(size_t{header.width} * header.height));
    headers_.push_back(header);
    return entry;
}

const TextureSet::Entry& TextureSet::texture(std::string_view name) {
    const std::string key = "textures/" + std::string(name);
    if (const auto known = entries_.find(key); known != entries_.end()) return known->second;
    std::string original; // its size is what texinfo axes were made for
    Entry entry;
    bool found = false;
    for (const std::string& path : texture_candidates(name)) {
        if (path.ends_with(".wal")) original = path;
        if (found) continue;
        if (const std::optional<Image> image = load(path)) {
            entry = add(*image, true);
            entry.file = path;
            found = true;
        }
    }
    if (!found) {
        missing_.emplace_back(name);
        entry = add(checker_image(), true);
    } else if (entry.file != original && !original.empty()) {
        if (const std::optional<Image> image = load(original))
            entry.uv_size = {image->width, image->height};
    }
    return entries_.emplace(key, entry).first->second;
}

const TextureSet::Entry& TextureSet::picture(const std::string& path) {
    if (const auto known = entries_.find(path); known != entries_.end()) return known->second;
    const std::optional<Image> image = load(path);
    if (!image) missing_.push_back(path);
    Entry entry = add(image ? *image : checker_image(), true);
    if (image) entry.file = path;
    return entries_.emplace(path, entry).first->second;
}

const TextureSet::Entry& TextureSet::cutout(const std::string& path) {
    const std::string key = "cutout " + path;
    if (const auto known = entries_.find(key); known != entries_.end()) return known->second;
    std::optional<Image> image = load(path);
    if (!image) missing_.push_back(path);
    if (!image) image = checker_image();
    const Entry entry = add(*image, true);
    std::vector<glm::vec3> alpha(size_t{image->width} * image->height);
    for (size_t i = 0; i < alpha.size(); ++i)
        alpha[i] = glm::vec3(static_cast<float>(image->rgba[4 * i + 3]) / 255.0f);
    add(std::move(alpha), image->width, image->height, true);
    return entries_.emplace(key, entry).first->second;
}

const TextureSet::Entry& TextureSet::flat(glm::vec3 color) {
    const std::string key = fmt::format("flat {:a} {:a} {:a}", color.x, color.y, color.z);
    if (const auto known = entries_.find(key); known != entries_.end()) return known->second;
    Entry entry;
    entry.header = static_cast<uint32_t>(headers_.size());
    headers_.push_back({static_cast<uint32_t>(texels_.size()), 1, 1, 1});
    texels_.push_back(encode_rgb9e5(color));
    entry.mean = decode_rgb9e5(texels_.back());
    return entries_.emplace(key, entry).first->second;
}

uint32_t TextureSet::consecutive(const std::vector<const Entry*>& frames) {
    if (frames.size() == 1) return frames.front()->header;
    std::vector<uint32_t> key;
    for (const Entry* frame : frames)
        key.push_back(frame->header);
    const auto first = static_cast<uint32_t>(headers_.size());
    const auto [row, added] = animations_.emplace(key, first);
    if (!added) return row->second;
    for (const Entry* frame : frames)
        headers_.push_back(shader::Texture(headers_[frame->header]));
    return first;
}

std::optional<uint32_t> TextureSet::sky_box(std::string_view sky) {
    std::array<std::optional<Image>, 6> sides;
    for (size_t side = 0; side < sides.size(); ++side) {
        for (const std::string& path : sky_candidates(sky, side)) {
            sides[side] = load(path);
            if (sides[side]) break;
        }
        if (!sides[side]) {
            missing_.push_back(sky_candidates(sky, side).front());
            return std::nullopt;
        }
    }
    const auto first = static_cast<uint32_t>(headers_.size());
    for (const std::optional<Image>& side : sides)
        add(*side, false);
    return first;
}

std::size_t TextureSet::fit(std::size_t most) {
    if (texels_.size() <= most) return 0;
    struct Picture {
        shader::Texture kept; // first_texel as before
        std::size_t count;    // of all that is kept
    };
    std::map<uint32_t, Picture> pictures; // by the first texel: frames of animations share theirs
    for (const shader::Texture& header : headers_)
        pictures.try_emplace(header.first_texel, Picture{header, 0});
    for (auto picture = pictures.begin(); picture != pictures.end(); ++picture) {
        const auto next = std::next(picture);
        const std::size_t end = next != pictures.end() ? next->first : texels_.size();
        picture->second.count = end - picture->first;
    }
    const auto smaller = [](const Picture* a, const Picture* b) {
        const auto area = [](const shader::Texture& of) {
            return of.mip_count > 1 ? size_t{of.width} * of.height : 0;
        };
        return area(a->kept) < area(b->kept);
    };
    std::vector<Picture*> by_size;
    for (auto& [first, picture] : pictures)
        by_size.push_back(&picture);
    std::ranges::make_heap(by_size, smaller);
    std::set<const Picture*> cut;
    std::size_t count = texels_.size();
    while (count > most && by_size.front()->kept.mip_count > 1) {
        std::ranges::pop_heap(by_size, smaller);
        Picture& picture = *by_size.back();
        shader::Texture& kept = picture.kept;
        const uint32_t texels = kept.width * kept.height;
        kept.first_texel += texels;
        kept.width = std::max(kept.width / 2, 1u);
        kept.height = std::max(kept.height / 2, 1u);
        --kept.mip_count;
        picture.count -= texels;
        count -= texels;
        cut.insert(&picture);
        std::ranges::push_heap(by_size, smaller);
    }
    std::vector<uint32_t> texels;
    texels.reserve(count);
    for (auto& [first, picture] : pictures) {
        const auto from = texels_.begin() + picture.kept.first_texel;
        picture.kept.first_texel = static_cast<uint32_t>(texels.size());
        texels.insert(texels.end(), from, from + static_cast<std::ptrdiff_t>(picture.count));
    }
    for (shader::Texture& header : headers_)
        header = pictures.at(header.first_texel).kept;
    texels_ = std::move(texels);
    return cut.size();
}

} // namespace vigil::vkpt
