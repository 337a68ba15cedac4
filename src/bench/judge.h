// SPDX-License-Identifier: GPL-2.0-or-later
// The folder of a view through which another program judges: pictures (EXR) go in, what it makes of
// the raw ones comes back. tools/picture/denoise.py is such a program.
#pragma once

#include "bench/options.h"
#include "shared/scene_types.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vigil::bench {

/// Of its row and its pictures; it makes oidn_SEED.exr of raw_SEED.exr.
inline constexpr const char* judge_label = "oidn";

class JudgeFolder {
public:
    /// LEVEL/viewN below the folder for pictures, or below outdir without one. Throws Error.
    JudgeFolder(const QualityOptions& options, const std::string& level, std::size_t view);

    const std::filesystem::path& path() const { return path_; }
    /// NAME.exr; linear RGB of the options' size.
    void write(std::string name, const std::vector<float>& rgb) const;
    /// albedo.exr and normal.exr; black where there is nothing to light.
    void write_surfaces(std::span<const shader::PrimaryHit> surfaces) const;
    /// Runs the program with the folder as its argument. Throws Error where it fails.
    void judge(const std::string& program) const;
    /// A picture that the judge made. Throws Error.
    std::vector<float> read(const std::string& name) const;

private:
    std::filesystem::path path_;
    glm::ivec2 size_;
};

} // namespace vigil::bench
