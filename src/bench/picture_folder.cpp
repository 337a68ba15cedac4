// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/picture_folder.h"

#include "client/measure/picture_file.h"
#include "common/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vigil::bench {

PictureFolder::PictureFolder(const QualityOptions& options, const std::string& level,
                             std::size_t view)
    : path_(std::filesystem::path(options.pictures) / level / fmt::format("view{}", view)),
      size_(options.size) {
    std::error_code fault;
    std::filesystem::create_directories(path_, fault);
    if (fault) fail("{}: {}", path_.string(), fault.message());
}

void PictureFolder::write(std::string name, std::vector<float> rgb) const {
    std::ranges::replace(name, '/', '_');
    client::write_exr(path_ / (name + ".exr"), {size_.x, size_.y, 1, std::move(rgb)});
}

void PictureFolder::write_surfaces(std::span<const shader::PrimaryHit> surfaces) const {
    std::vector<float> albedo, normal;
    for (const shader::PrimaryHit& hit : surfaces)
        for (int c = 0; c < 3; ++c) {
            const bool lit = hit.primitive != shader::NONE;
            albedo.push_back(lit ? hit.albedo[c] : 0.0f);
            normal.push_back(lit ? hit.normal[c] : 0.0f);
        }
    write("albedo", std::move(albedo));
    write("normal", std::move(normal));
}

} // namespace vigil::bench
