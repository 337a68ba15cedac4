// SPDX-License-Identifier: GPL-2.0-or-later
// Axis-aligned bounds of points and triangles, as the builders of the bottom and the top level use
// them. Empty bounds are inverted, so that growing needs no special case. Nothing here is
// conservative: the encoders pad what they write.
#pragma once

#include <glm/glm.hpp>

#include <limits>

namespace vigil {

struct Bounds {
    glm::vec3 lower{std::numeric_limits<float>::infinity()};
    glm::vec3 upper{-std::numeric_limits<float>::infinity()};

    bool operator==(const Bounds&) const = default;
    bool empty() const { return lower.x > upper.x; }
    glm::vec3 center() const { return 0.5f * (lower + upper); }
    glm::vec3 extent() const { return upper - lower; }

    void grow(const glm::vec3& point) {
        lower = glm::min(lower, point);
        upper = glm::max(upper, point);
    }
    void grow(const Bounds& other) {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
    }
    void clip(const Bounds& other) {
        lower = glm::max(lower, other.lower);
        upper = glm::min(upper, other.upper);
    }
    bool contains(const Bounds& other) const {
        return glm::all(glm::lessThanEqual(lower, other.lower)) &&
               glm::all(glm::greaterThanEqual(upper, other.upper));
    }
    /// Half the surface area; 0 for empty bounds.
    float half_area() const {
        if (empty()) return 0.0f;
        const glm::vec3 e = extent();
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }
};

} // namespace vigil
