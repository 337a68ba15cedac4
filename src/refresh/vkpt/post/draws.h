// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures and fills over the finished picture (refresh::Draw): keeps the pictures that were
// registered, and records the pass that lays them over the display buffer.
#pragma once

#include "common/file_system.h"
#include "refresh/refresh.h"
#include "refresh/vkpt/gpu/compute_pass.h"
#include "refresh/vkpt/gpu/growing_buffer.h"
#include "shared/draw.h"

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace vigil::vkpt {

class Draws {
public:
    Draws(const gpu::Device& device, gpu::PipelineCompiler& compiler);

    /// Handle of a picture file; loads it at first. Throws Error naming the file and the fault.
    refresh::PictureHandle register_picture(const FileSystem& files, std::string_view name);
    /// Handle of a new picture that is transparent. Throws Error if a side is not 1 to 4,096
    /// texels.
    refresh::PictureHandle make_picture(glm::ivec2 size);
    /// Gives it other texels, RGBA8. Throws Error if there is no such picture or if their number
    /// is another.
    void change_picture(refresh::PictureHandle picture, std::span<const uint8_t> rgba);
    /// In texels. Throws Error if there is no such picture.
    glm::ivec2 size_of(refresh::PictureHandle picture) const;

    /// Brings what record() will draw over `display` (RGBA8, rows of `size.x` words). Throws Error
    /// if there is no such picture.
    void prepare(const gpu::Buffer& display, glm::uvec2 size, std::span<const refresh::Draw> draws);
    /// Records the pass, and copies of what differs from what was recorded before.
    void record(gpu::FrameCommands& commands);
    /// Nobody knows whether what was recorded was done: all is copied again.
    void forget_copies();
    /// The display buffer of before is gone: another may have its handle.
    void forget_display() { display_ = VK_NULL_HANDLE; }

private:
    struct Picture {
        uint32_t first_texel = 0;
        glm::uvec2 size{0, 0};
    };
    const Picture& picture(refresh::PictureHandle handle) const;
    refresh::PictureHandle keep(glm::uvec2 size);
    void add(const refresh::Draw& draw, glm::ivec2 screen);

    const gpu::Device& device_;
    std::map<std::string, refresh::PictureHandle, std::less<>> handles_;
    std::vector<Picture> pictures_;
    std::vector<uint32_t> texels_; // of all pictures, RGBA8
    bool new_texels_ = false;
    std::set<refresh::PictureHandle> changed_; // since the texels were copied
    gpu::Buffer texel_buffer_;
    gpu::Buffer unused_;
    gpu::GrowingBuffer rect_buffer_;
    gpu::DescriptorSet set_;
    gpu::PipelineLayout layout_;
    ComputePass pass_;

    /// Rectangles that one dispatch draws: of as many work groups each, and without a common pixel.
    struct Batch {
        uint32_t first = 0, count = 0;
        glm::uvec2 groups{0, 0};
    };
    std::vector<shader::DrawRect> rects_;  // of this frame
    std::vector<shader::DrawRect> copied_; // that the buffer has
    std::vector<Batch> batches_;
    uint32_t width_ = 0;
    VkBuffer display_ = VK_NULL_HANDLE; // that the set is of
};

} // namespace vigil::vkpt
