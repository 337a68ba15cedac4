// SPDX-License-Identifier: GPL-2.0-or-later
// Where --pictures puts what a view looks like, for the page of reports and for other programs: a
// folder of linear radiance (EXR).
#pragma once

#include "bench/options.h"
#include "shared/scene_types.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vigil::bench {

class PictureFolder {
public:
    /// LEVEL/viewN below the folder of --pictures; N is from 1. Throws Error.
    PictureFolder(const QualityOptions& options, const std::string& level, std::size_t view);

    std::string path() const { return path_.string(); }
    /// NAME.exr, with _ for every slash; RGB of the options' size. Throws Error.
    void write(std::string name, std::vector<float> rgb) const;
    /// albedo.exr and normal.exr; black where there is nothing to light.
    void write_surfaces(std::span<const shader::PrimaryHit> surfaces) const;

private:
    std::filesystem::path path_;
    glm::ivec2 size_;
};

} // namespace vigil::bench
