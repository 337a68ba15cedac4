// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/judge.h"

#include "client/measure/picture_file.h"
#include "common/error.h"
#include "console/outdir.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace vigil::bench {

JudgeFolder::JudgeFolder(const QualityOptions& options, const std::string& level, std::size_t view)
    : path_((options.pictures.empty() ? output_path("picture")
                                      : std::filesystem::path(options.pictures)) /
            level / fmt::format("view{}", view)),
      size_(options.size) {
    std::error_code fault;
    std::filesystem::create_directories(path_, fault);
    if (fault) fail("{}: {}", path_.string(), fault.message());
}

void JudgeFolder::write(std::string name, const std::vector<float>& rgb) const {
    std::ranges::replace(name, '/', '_');
    std::ranges::replace(name, ' ', '_');
    client::write_exr(path_ / (name + ".exr"), {size_.x, size_.y, 1, rgb});
}

void JudgeFolder::write_surfaces(std::span<const shader::PrimaryHit> surfaces) const {
    std::vector<float> albedo, normal;
    for (const shader::PrimaryHit& hit : surfaces)
        for (int c = 0; c < 3; ++c) {
            const bool lit = hit.primitive != shader::NONE;
            albedo.push_back(lit ? hit.albedo[c] : 0.0f);
            normal.push_back(lit ? hit.normal[c] : 0.0f);
        }
    write("albedo", albedo);
    write("normal", normal);
}

void JudgeFolder::judge(const std::string& program) const {
    // The program is what the command line asked for; the folder's name is the level's.
    const std::string command = fmt::format("'{}' '{}' >&2", program, path_.string());
    if (std::system(command.c_str()) != 0) fail("--judge: {} failed", command);
}

std::vector<float> JudgeFolder::read(const std::string& name) const {
    const std::filesystem::path file = path_ / (name + ".exr");
    refresh::RadiancePicture picture = client::read_exr(file);
    if (picture.width != size_.x || picture.height != size_.y)
        fail("{}: {} x {} pixels, not {} x {}", file.string(), picture.width, picture.height,
             size_.x, size_.y);
    return std::move(picture.rgb);
}

} // namespace vigil::bench
