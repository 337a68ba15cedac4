// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/ui/screen_stats.h"

#include <fmt/format.h>

namespace vigil::client {

namespace {

constexpr int stats_passes = cvar_choice("scr_stats", "passes");

struct Group {
    refresh::PassGroup group;
    std::string_view name;
};
constexpr Group groups[] = {{refresh::PassGroup::PathTracing, "path tracing"},
                            {refresh::PassGroup::Preparation, "preparation"},
                            {refresh::PassGroup::Other, "other passes"}};

} // namespace

std::string technique_text(const CvarRegistry& variables) {
    std::string text = technique_row_name(
        {static_cast<Technique>(variables->pt_nee), static_cast<Guide>(variables->pt_guide)});
    if (variables->pt_compare != 0) text += " | " + variables.get_text("pt_compare");
    return text;
}

void ScreenStats::add_passes(const std::vector<refresh::PassTime>& passes, bool each) {
    for (const Group& group : groups) {
        lines_.push_back(fmt::format("{:<16} {:6.1f} ms", group.name, sum_of(passes, group.group)));
        if (!each) continue;
        for (const refresh::PassTime& pass : passes)
            if (pass.group == group.group)
                lines_.push_back(fmt::format("  {:<14} {:6.1f} ms", pass.name, pass.milliseconds));
    }
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
    if (!gpu.empty()) add_passes(gpu.means(), variables->scr_stats == stats_passes);
    lines_.push_back(technique_text(variables));
    lines_.push_back(fmt::format("{} x {}, {} path{} per pixel", picture_size.x, picture_size.y,
                                 variables->pt_spp, variables->pt_spp == 1 ? "" : "s"));
    frames_ = 0;
    seconds_ = 0.0;
}

} // namespace vigil::client
