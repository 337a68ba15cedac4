// SPDX-License-Identifier: GPL-2.0-or-later
// A view of animated models with no level around them: the player that a menu shows. It is a
// picture with a transparent ground, drawn on the processor in a fixed light of its own, whatever
// the renderer does; shown, it is a Draw as any other (Renderer::make_picture). It traces no rays.
#pragma once

#include "refresh/refresh.h"

#include <map>
#include <memory>
#include <span>
#include <string>

namespace vigil {
struct Image;
struct Md2;
} // namespace vigil

namespace vigil::refresh {

/// One placed .md2 model; its numbers as an Entity's.
struct PreviewModel {
    std::string model; ///< "players/male/tris.md2"
    std::string skin;  ///< a picture file; empty: the model's own, by its number
    int skin_number = 0;
    glm::vec3 origin{0.0f};
    glm::vec3 angles{0.0f};
    int frame = 0;
    int old_frame = 0;
    float backlerp = 0.0f;
    float alpha = 1.0f;
};

/// Pixels need not be square: `fov_y` of the view is the height's angle, `fov` the width's.
struct Preview {
    View view;
    glm::ivec2 size{0}; ///< pixels
    std::span<const PreviewModel> models;
};

/// Draws previews, and keeps the files that they needed. Files that cannot be read are told of once
/// in the log: a model is left out then, a skin is a checker.
class PreviewPainter {
public:
    /// Most pixels of a side.
    static constexpr int largest = 4096;
    /// Triangles with a corner nearer to the eye than this are left out, map units.
    static constexpr float nearest = 1.0f;

    explicit PreviewPainter(const FileSystem& files);
    ~PreviewPainter();

    /// The picture; alpha is how much of a pixel models cover, in steps of a quarter of theirs. It
    /// is empty where the size is not 1 to `largest`.
    Picture draw(const Preview& preview);

    /// Forgets the files.
    void clear();

private:
    const Md2* model(const std::string& name);
    const Image& skin(const std::string& name);

    const FileSystem& files_;
    std::map<std::string, std::unique_ptr<Md2>> models_; // null: cannot be read
    std::map<std::string, std::unique_ptr<Image>> skins_;
};

} // namespace vigil::refresh
