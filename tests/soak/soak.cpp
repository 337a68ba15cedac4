// SPDX-License-Identifier: GPL-2.0-or-later
#include "soak/soak.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vigil::client {

namespace {

// Of each frame.
constexpr double key_chance = 0.1, variable_chance = 0.1, size_chance = 0.01, level_chance = 0.005,
                 demo_chance = 0.002, other_chance = 0.02, restart_chance = 0.0005;
/// Half of the switches go back to the default, or soon nothing would be as players have it.
constexpr double default_chance = 0.5;

/// A whole day of one frame teaches little: values that only cost time end here.
struct Most {
    std::string_view variable;
    double value;
};
constexpr Most most[] = {{"pt_spp", 2},
                         {"pt_light_points", 16},
                         {"pt_subdivide", 1},
                         {"testlights", 64},
                         {"pt_preset", 2}};

constexpr std::string_view keys[] = {"forward", "back",     "moveleft", "moveright",
                                     "moveup",  "movedown", "speed",    "left",
                                     "right",   "lookup",   "lookdown", "attack"};

/// That only show or forget something.
constexpr std::string_view others[] = {"guidingreset",
                                       "flashlight",
                                       "guiding",
                                       "vlcinfo",
                                       "cdqinfo",
                                       "scene",
                                       "viewnext",
                                       "view none",
                                       "pt_preset paper",
                                       "pt_preset fast",
                                       "pt_preset balanced",
                                       "pt_preset accurate; pt_spp 1"};

} // namespace

Soak::Soak(SoakChoices choices, uint32_t seed) : choices_(std::move(choices)), random_(seed) {
    for (const CvarInfo& info : cvar_infos)
        if ((info.name.starts_with("pt_") || info.name.starts_with("testlights")) &&
            info.life != CvarLife::Start)
            variables_.push_back(&info);
}

bool Soak::chance(double probability) {
    return std::uniform_real_distribution<double>()(random_) < probability;
}

size_t Soak::pick(size_t count) {
    return random_() % count;
}

std::string Soak::random_value(const CvarInfo& info) {
    double high = info.maximum;
    for (const Most& limit : most)
        if (limit.variable == info.name) high = std::min(high, limit.value);
    const bool whole = info.type != CvarType::Real;
    const auto text = [&](double value) {
        return whole ? fmt::format("{:.0f}", value) : fmt::format("{:.6g}", value);
    };
    // The ends are where things break.
    if (chance(0.2)) return text(chance(0.5) ? info.minimum : high);
    const double part = std::uniform_real_distribution<double>()(random_);
    if (high - info.minimum < 64) return text(info.minimum + part * (high - info.minimum));
    // Over all magnitudes alike.
    const double low = std::max(info.minimum, 1e-6 * high);
    return text(low * std::pow(high / low, part));
}

std::string Soak::random_variable() {
    ++switches_;
    const CvarInfo& info = *variables_[pick(variables_.size())];
    if (chance(default_chance)) return fmt::format("reset {}\n", info.name);
    return fmt::format("set {} {}\n", info.name, random_value(info));
}

std::string Soak::random_key() {
    return fmt::format("{}{}\n", chance(0.5) ? '+' : '-', keys[pick(std::size(keys))]);
}

std::string Soak::random_level() {
    ++levels_;
    return fmt::format("map \"{}\"\nnoclip\n", choices_.levels[pick(choices_.levels.size())]);
}

std::string Soak::next(bool walks) {
    if (frames_++ == 0) return random_level();
    if (chance(level_chance)) return random_level();
    if (chance(restart_chance)) return std::string(restart);
    if (!choices_.demos.empty() && chance(demo_chance)) {
        ++levels_;
        return fmt::format("demomap \"{}\"\n", choices_.demos[pick(choices_.demos.size())]);
    }
    std::string text;
    if (chance(key_chance)) text += random_key();
    if (chance(variable_chance)) text += random_variable();
    if (chance(other_chance)) text += fmt::format("{}\n", others[pick(std::size(others))]);
    if (walks && chance(other_chance)) text += "noclip\n";
    if (chance(size_chance))
        text +=
            fmt::format("set vid_width {}\nset vid_height {}\n", 16 + pick(240), 16 + pick(140));
    return text;
}

} // namespace vigil::client
