// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/filter/light_changes.h"

#include <algorithm>
#include <cmath>

namespace vigil::vkpt {

float light_change(const shader::Light& before, const shader::Light& now) {
    float greatest = 0.0f, difference = 0.0f;
    for (int channel = 0; channel < 3; ++channel) {
        const float a = before.radiance[channel], b = now.radiance[channel];
        greatest = std::max({greatest, a, b});
        difference = std::max(difference, std::abs(a - b));
    }
    if (!(greatest > 0.0f)) return 0.0f; // dark, before and now
    const bool moved = before.v0 != now.v0 || before.e1 != now.e1 || before.e2 != now.e2;
    return moved ? 1.0f : difference / greatest;
}

bool LightChanges::update(std::span<const shader::Light> lights, uint64_t revision) {
    if (revision == revision_) return false;
    const bool first = revision_ == 0;
    revision_ = revision;
    bool any = false;
    factors_.assign(lights.size(), 0.0f);
    for (size_t id = 0; id < lights.size() && !first; ++id) {
        factors_[id] = light_change(id < before_.size() ? before_[id] : shader::Light{}, lights[id]);
        any = any || factors_[id] > 0.0f;
    }
    before_.assign(lights.begin(), lights.end());
    return any;
}

void LightChanges::forget() {
    revision_ = 0;
    before_.clear();
}

} // namespace vigil::vkpt
