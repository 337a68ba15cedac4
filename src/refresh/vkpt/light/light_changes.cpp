// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/light_changes.h"

#include <algorithm>
#include <cmath>

namespace vigil {

namespace {

/// Changes below it are over.
constexpr float least_change = 0.05f;

} // namespace

bool same_place(const shader::Light& a, const shader::Light& b) {
    return a.v0 == b.v0 && a.e1 == b.e1 && a.e2 == b.e2;
}

float light_change(const shader::Light& before, const shader::Light& now) {
    float greatest = 0.0f, difference = 0.0f;
    for (int channel = 0; channel < 3; ++channel) {
        const float a = before.radiance[channel], b = now.radiance[channel];
        greatest = std::max({greatest, a, b});
        difference = std::max(difference, std::abs(a - b));
    }
    if (!(greatest > 0.0f)) return 0.0f; // dark, before and now
    return same_place(before, now) ? difference / greatest : 1.0f;
}

bool LightChanges::update(std::span<const shader::Light> lights, uint64_t revision) {
    if (revision == revision_ && !lasting_) return false;
    const bool first = revision_ == 0;
    factors_.resize(lights.size());
    lasting_ = false;
    for (size_t id = 0; id < lights.size(); ++id) {
        float& factor = factors_[id];
        factor = factor > least_change ? 0.5f * factor : 0.0f;
        if (revision != revision_ && !first)
            factor =
                std::max(factor, light_change(id < before_.size() ? before_[id] : shader::Light{},
                                              lights[id]));
        lasting_ = lasting_ || factor > 0.0f;
    }
    if (revision != revision_) before_.assign(lights.begin(), lights.end());
    revision_ = revision;
    return lasting_;
}

void LightChanges::forget() {
    revision_ = 0;
    lasting_ = false;
    before_.clear();
    factors_.clear();
}

} // namespace vigil
