// SPDX-License-Identifier: GPL-2.0-or-later
// The level's textures as the GPU reads them: linear RGB9E5 texels with mip levels, one after
// another. Found by texinfo name, loaded once each; a missing or broken file becomes a checker and
// one log line.
#pragma once

#include "formats/image.h"
#include "shared/scene_types.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace vigil {
class FileSystem;
}

namespace vigil::vkpt {

/// Linear RGB to RGB9E5 (shared exponent): components are clamped to [0, 65408], NaN becomes 0; the
/// error is at most 1/512 of the largest component.
uint32_t encode_rgb9e5(glm::vec3 color);
glm::vec3 decode_rgb9e5(uint32_t texel);

class TextureSet {
public:
    struct Entry {
        uint32_t header = 0;      // index in headers()
        glm::vec3 mean{0.0f};     // mean linear colour of its texels
        glm::uvec2 uv_size{1, 1}; // texels that texinfo axes count in: the original's size
        std::string file;         // where it came from; empty: the checker
    };

    explicit TextureSet(const FileSystem& files);

    /// The texture a texinfo calls `name`.
    const Entry& texture(std::string_view name);
    /// A texture by its file path, such as a model's skin.
    const Entry& picture(const std::string& path);
    /// The same, with a texture of its alpha (0..1 in each channel) at the header behind it.
    const Entry& cutout(const std::string& path);
    /// A one-texel texture of a colour in linear RGB.
    const Entry& flat(glm::vec3 color);
    /// The frames of an animation as consecutive headers; returns the first index.
    uint32_t consecutive(const std::vector<const Entry*>& frames);
    /// Six consecutive headers in the order of formats/sky.h; nothing if any side is missing.
    std::optional<uint32_t> sky_box(std::string_view sky);

    /// Leaves out the largest levels of textures with mip levels, the largest first, until there
    /// are at most `most` texels. Returns how many textures lost any.
    std::size_t fit(std::size_t most);

    const std::vector<shader::Texture>& headers() const { return headers_; }
    const std::vector<uint32_t>& texels() const { return texels_; }
    /// Names that were looked for and not found.
    const std::vector<std::string>& missing() const { return missing_; }

private:
    std::optional<Image> load(const std::string& path);
    Entry add(const Image& image, bool mips);
    Entry add(std::vector<glm::vec3> texels, uint32_t width, uint32_t height, bool mips);
    const Palette* palette();

    const FileSystem& files_;
    std::unordered_map<std::string, Entry> entries_;
    std::map<std::vector<uint32_t>, uint32_t> animations_; // by the frames' headers
    std::vector<shader::Texture> headers_;
    std::vector<uint32_t> texels_;
    std::vector<std::string> missing_;
    std::optional<Palette> palette_;
    bool palette_tried_ = false;
};

} // namespace vigil::vkpt
