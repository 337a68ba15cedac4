// SPDX-License-Identifier: GPL-2.0-or-later
// Models and skins as the engine holds them: objects that stay where they are for as long as the
// module lives, while the renderer's handles end with each level. It reads no file itself.
#pragma once

#include "yamagi/screen.h"

namespace vigil::yamagi {

/// A model by its file, or "*3": a part of the level.
struct ModelObject {
    std::string name;
    refresh::ModelHandle handle = -1; ///< in the level that `level` counts; -1: shows nothing
    uint64_t level = 0;
};

class Models {
public:
    explicit Models(const FileSystem& files) : files_(files) {}

    /// Handles come from this renderer, where it has a level; null: there is none.
    void use(refresh::Renderer* renderer);
    /// A level was loaded, or failed to be: earlier handles are nothing.
    void begin_level(bool loaded);

    /// Null where there is no such file. The level's own file has an object that shows nothing.
    ModelObject* find(std::string_view name);
    /// -1 where it shows nothing; that a file is wrong is told once a level.
    refresh::ModelHandle handle_of(const ModelObject& model);
    /// -1 where there is none.
    refresh::SkinHandle skin_of(const PictureObject* skin);

private:
    const FileSystem& files_;
    refresh::Renderer* renderer_ = nullptr;
    bool has_level_ = false;
    uint64_t level_ = 1;
    std::map<std::string, std::unique_ptr<ModelObject>, std::less<>> models_;
    std::map<std::string, refresh::SkinHandle> skins_; // of this level, by file
};

} // namespace vigil::yamagi
