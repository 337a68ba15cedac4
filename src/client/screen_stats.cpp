// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/screen_stats.h"

#include <fmt/format.h>

namespace vigil::client {

std::string technique_text(const CvarRegistry& variables) {
    std::string text = technique_row_name({static_cast<Technique>(variables->pt_nee),
                                           variables->pt_guide == cvar_choice("pt_guide", "cdq")});
    if (variables->pt_compare != 0) text += " | " + variables.get_text("pt_compare");
    return text;
}

void ScreenStats::add_frame(double seconds, const RecentTimes& gpu, const CvarRegistry& variables,
                            glm::ivec2 picture_size) {
    ++frames_;
    seconds_ += seconds;
    if (seconds_ < interval_s && !lines_.empty()) return;
    lines_.clear();
    if (seconds_ > 0.0)
        lines_.push_back(
            fmt::format("{:.1f} ms  {:.1f} fps", 1e3 * seconds_ / frames_, frames_ / seconds_));
    if (!gpu.empty()) {
        const RecentTimes::Groups means = gpu.means();
        lines_.push_back(fmt::format("path tracing {:6.1f} ms", means.path_tracing));
        lines_.push_back(fmt::format("preparation  {:6.1f} ms", means.preparation));
        lines_.push_back(fmt::format("other passes {:6.1f} ms", means.other));
    }
    lines_.push_back(technique_text(variables));
    lines_.push_back(fmt::format("{} x {}, {} path{} per pixel", picture_size.x, picture_size.y,
                                 variables->pt_spp, variables->pt_spp == 1 ? "" : "s"));
    frames_ = 0;
    seconds_ = 0.0;
}

} // namespace vigil::client
