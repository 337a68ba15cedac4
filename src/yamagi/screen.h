// SPDX-License-Identifier: GPL-2.0-or-later
// What the engine draws over its views: pictures, characters, fills, films. It turns calls into
// refresh::Draw, in their order, and gives pictures their files. It draws nothing itself.
#pragma once

#include "common/file_system.h"
#include "formats/image.h"
#include "refresh/refresh.h"
#include "yamagi/interface.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::yamagi {

/// The picture file for a name of the engine: "help" is pics/help.pcx, "/pics/x.pcx" that file
/// itself; where it is not there, the same as .png, .tga or .jpg. Nothing where there is none.
std::optional<std::string> picture_file(const FileSystem& files, std::string_view name);

/// A picture or skin as the engine holds it.
struct Picture : PictureObject {
    std::string file; ///< that shows it
};

class Screen {
public:
    explicit Screen(const FileSystem& files);

    /// Draws go to this renderer from now on; null: there is none. Pictures of another are
    /// forgotten.
    void use(refresh::Renderer* renderer);
    /// Size that the engine draws for, and that of the picture, pixels: draws are scaled.
    void set_size(glm::ivec2 engine, glm::ivec2 shown);

    /// Null where there is no such picture; the same object for the same name, as long as this
    /// lives.
    Picture* find(std::string_view name);
    /// A skin or model's picture: `name` is its file.
    Picture* find_skin(std::string_view name);
    /// (0, 0) where there is no such picture, texels.
    glm::ivec2 size_of(std::string_view name);

    void begin_frame() { draws_.clear(); }
    const std::vector<refresh::Draw>& draws() const { return draws_; }

    // Corners and sizes in the engine's pixels. A picture that is not there draws nothing.
    void picture(glm::ivec2 corner, std::string_view name, float factor,
                 const glm::vec3& color = glm::vec3(1.0f));
    void stretched(glm::ivec2 corner, glm::ivec2 size, std::string_view name);
    /// One of the 256 of pics/conchars, 8 x 8 pixels times `scale`.
    void character(glm::ivec2 corner, int character, float scale);
    void tiles(glm::ivec2 corner, glm::ivec2 size, std::string_view name);
    /// `color` is an index of the game's palette.
    void fill(glm::ivec2 corner, glm::ivec2 size, int color);
    void tint(glm::ivec2 corner, glm::ivec2 size, const glm::vec4& color);
    /// Makes all that was drawn darker.
    void fade();
    /// `bits` 8: indices of the film's palette; 32: RGBA.
    void film(glm::ivec2 corner, glm::ivec2 size, glm::ivec2 texels, const uint8_t* data, int bits);
    /// A picture that was made for this place: a preview. `slot` tells those of a frame apart.
    void made(glm::ivec2 corner, glm::ivec2 size, const refresh::Picture& picture, int slot);
    /// How many of the picture's pixels such a rectangle covers.
    glm::ivec2 shown_size(glm::ivec2 size) const;

    /// RGB, 768 bytes; null: the game's.
    void set_film_palette(const uint8_t* palette);
    /// The game's colour, linear.
    glm::vec3 linear_color(int index) const;
    const Palette& palette() const { return palette_; }

private:
    Picture* keep(std::string_view name, std::string file);
    /// The renderer's handle; no_picture where it cannot be read, which is told once.
    refresh::PictureHandle handle_of(const Picture& picture);
    refresh::PictureHandle handle_of(std::string_view name);
    refresh::PictureHandle made_picture(int slot, glm::ivec2 size);
    void add(const refresh::Draw& draw);

    const FileSystem& files_;
    refresh::Renderer* renderer_ = nullptr;
    Palette palette_{};
    Palette film_palette_{};
    glm::vec2 scale_{1.0f}; // from the engine's pixels to the picture's
    glm::ivec2 engine_size_{0};
    std::map<std::string, std::unique_ptr<Picture>, std::less<>> pictures_; // null: not there
    std::map<std::string, refresh::PictureHandle> handles_;                 // by file
    std::map<std::pair<int, std::pair<int, int>>, refresh::PictureHandle> made_;
    std::vector<refresh::Draw> draws_;
    std::vector<uint8_t> texels_; // of a film's picture
};

} // namespace vigil::yamagi
