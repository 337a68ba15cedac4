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
                            {refresh::PassGroup::Filter, "filter"},
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
        const size_t place = lines_.size();
        double sum = 0.0;
        for (const refresh::PassTime& pass : passes) {
            if (pass.group != group.group) continue;
            sum += pass.milliseconds;
            if (each)
                lines_.push_back(fmt::format("  {:<14} {:6.1f} ms", pass.name, pass.milliseconds));
        }
        lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(place),
                      fmt::format("{:<16} {:6.1f} ms", group.name, sum));
    }
}

void ScreenStats::add_frame(double seconds, const PassStatistics& gpu,
                            const CvarRegistry& variables, glm::ivec2 picture_size) {
    ++frames_;
    seconds_ += seconds;
    if (seconds_ < interval_s && !lines_.empty()) return;
    lines_.clear();
    if (seconds_ > 0.0)
        lines_.push_back(
            fmt::format("{:.1f} ms  {:.1f} fps", 1e3 * seconds_ / frames_, frames_ / seconds_));
    if (gpu.frame_count() > 0)
        add_passes(gpu.recent_means(most_frames), variables->scr_stats == stats_passes);
    lines_.push_back(technique_text(variables));
    lines_.push_back(fmt::format("{} x {}, {} path{} per pixel", picture_size.x, picture_size.y,
                                 variables->pt_spp, variables->pt_spp == 1 ? "" : "s"));
    frames_ = 0;
    seconds_ = 0.0;
}

} // namespace vigil::client
