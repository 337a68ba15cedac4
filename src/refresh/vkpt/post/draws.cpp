// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/post/draws.h"

#include "common/error.h"
#include "formats/image.h"
#include "shared/bindings.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace vigil::vkpt {

namespace {

/// So that looking for common pixels stays cheap.
constexpr uint32_t most_in_batch = 256;

/// Texels of a side of a picture that has no file.
constexpr int largest_made = 4096;

bool overlap(const shader::DrawRect& a, const shader::DrawRect& b) {
    return glm::all(glm::lessThan(a.shown_from, b.shown_to)) &&
           glm::all(glm::lessThan(b.shown_from, a.shown_to));
}

struct Push {
    uint32_t first_draw, screen_width;
};

} // namespace

Draws::Draws(const gpu::Device& device, gpu::PipelineCompiler& compiler)
    : device_(device), unused_(device, 16, gpu::MemoryUse::Device, "unused"),
      rect_buffer_(device, "draws"),
      set_(device, std::vector(DRAWS_BINDING_COUNT, gpu::BindingKind::Storage), unused_,
           "draw set"),
      layout_(device, {&set_}), pass_(Pass::Draws, compiler, layout_) {}

refresh::PictureHandle Draws::register_picture(const FileSystem& files, std::string_view name) {
    const auto known = handles_.find(name);
    if (known != handles_.end()) return known->second;
    const Image image = decode_image(name, files.read(name));
    const refresh::PictureHandle handle = keep({image.width, image.height});
    std::memcpy(&texels_[picture(handle).first_texel], image.rgba.data(), image.rgba.size());
    handles_.emplace(name, handle);
    return handle;
}

refresh::PictureHandle Draws::keep(glm::uvec2 size) {
    const size_t first = texels_.size();
    texels_.resize(first + size_t{size.x} * size.y);
    pictures_.push_back({static_cast<uint32_t>(first), size});
    new_texels_ = true;
    return static_cast<refresh::PictureHandle>(pictures_.size() - 1);
}

refresh::PictureHandle Draws::make_picture(glm::ivec2 size) {
    if (size.x < 1 || size.y < 1 || size.x > largest_made || size.y > largest_made)
        fail("a picture of {} x {} texels: sides are 1 to {}", size.x, size.y, largest_made);
    return keep(glm::uvec2(size));
}

void Draws::change_picture(refresh::PictureHandle handle, std::span<const uint8_t> rgba) {
    const Picture& changed = picture(handle);
    if (rgba.size() != 4 * size_t{changed.size.x} * changed.size.y)
        fail("picture {}: {} x {} texels, not {} bytes", handle, changed.size.x, changed.size.y,
             rgba.size());
    std::memcpy(&texels_[changed.first_texel], rgba.data(), rgba.size());
    changed_.insert(handle);
}

const Draws::Picture& Draws::picture(refresh::PictureHandle handle) const {
    if (handle < 0 || static_cast<size_t>(handle) >= pictures_.size())
        fail("picture {}: no picture was registered under this number", handle);
    return pictures_[static_cast<size_t>(handle)];
}

glm::ivec2 Draws::size_of(refresh::PictureHandle handle) const {
    return picture(handle).size;
}

void Draws::add(const refresh::Draw& draw, glm::ivec2 screen) {
    const Picture shown = draw.picture == refresh::no_picture ? Picture() : picture(draw.picture);
    // In 64 bits: corners and sizes may be anything.
    using Place = glm::i64vec2;
    const Place corner(draw.corner), clip(draw.clip_corner);
    const Place from = glm::max(glm::max(corner, clip), Place(0));
    const Place to =
        glm::min(glm::min(corner + Place(draw.size), clip + Place(draw.clip_size)), Place(screen));
    if (glm::any(glm::lessThanEqual(to, from))) return;
    const shader::DrawRect rect{draw.corner,    draw.size,         glm::ivec2(from),
                                glm::ivec2(to), draw.from,         draw.to,
                                draw.color,     shown.first_texel, shown.size};
    const glm::uvec2 groups = (glm::uvec2(to - from) + 7u) / 8u;
    Batch* last = batches_.empty() ? nullptr : &batches_.back();
    const bool joins =
        last != nullptr && last->groups == groups && last->count < most_in_batch &&
        std::none_of(rects_.begin() + last->first, rects_.end(),
                     [&](const shader::DrawRect& other) { return overlap(rect, other); });
    if (joins)
        ++last->count;
    else
        batches_.push_back({static_cast<uint32_t>(rects_.size()), 1, groups});
    rects_.push_back(rect);
}

void Draws::prepare(const gpu::Buffer& display, glm::uvec2 size,
                    std::span<const refresh::Draw> draws) {
    rects_.clear();
    batches_.clear();
    width_ = size.x;
    for (const refresh::Draw& draw : draws)
        add(draw, glm::ivec2(size));
    if (rects_.empty()) return;
    pass_.choose();
    bool rebind = display.handle() != display_;
    const auto bytes = gpu::bytes_of(rects_), before = gpu::bytes_of(copied_);
    if (!std::ranges::equal(bytes, before)) rebind |= rect_buffer_.set(bytes);
    if (new_texels_) {
        device_.wait_idle();
        texel_buffer_ = gpu::make_buffer(device_, gpu::bytes_of(texels_), "pictures");
        new_texels_ = false;
        changed_.clear();
        rebind = true;
    }
    if (!rebind) return;
    device_.wait_idle();
    display_ = display.handle();
    set_.bind(BINDING_DRAWS_DISPLAY, display);
    set_.bind(BINDING_DRAWS_RECTS, rect_buffer_.buffer());
    set_.bind(BINDING_DRAWS_TEXELS, texel_buffer_ ? texel_buffer_ : unused_);
}

void Draws::forget_copies() {
    copied_.clear();
    new_texels_ = !texels_.empty();
}

void Draws::record(gpu::FrameCommands& commands) {
    if (rects_.empty()) return;
    rect_buffer_.upload(commands);
    copied_ = rects_;
    for (const refresh::PictureHandle handle : changed_) {
        const Picture& changed = picture(handle);
        const size_t count = size_t{changed.size.x} * changed.size.y;
        commands.upload(texel_buffer_, uint64_t{4} * changed.first_texel,
                        gpu::bytes_of(std::span(&texels_[changed.first_texel], count)));
    }
    changed_.clear();
    const VkDescriptorSet set = set_.handle();
    for (const Batch& batch : batches_) {
        const Push push{batch.first, width_};
        pass_.record(commands, {std::span(&set, 1), gpu::bytes_of_value(push)},
                     {{batch.groups, batch.count}});
    }
}

} // namespace vigil::vkpt
