// SPDX-License-Identifier: GPL-2.0-or-later
// The host side of a guider: how large what it keeps per node of the octree is, and how that
// begins. Its shader (shaders/guiding/NAME.glsl) draws directions and learns. Adding one: a shader
// file, a file here, and a row in shaders/shared/guiders.h (docs/research/adding-a-guider.md).
#pragma once

#include "refresh/settings.h"
#include "shared/guiding_types.h"

#include <glm/glm.hpp>

namespace vigil::vkpt {

class Guider {
public:
    virtual ~Guider() = default;

    /// GUIDER_SIZE of its shader: what these settings ask for.
    virtual uint32_t size(const refresh::Settings&) const { return 0; }
    /// NODE_GUIDE of a node that has no experience.
    virtual glm::uvec4 first_words(uint32_t /*size*/) const { return glm::uvec4(0); }
    /// Words per node that it remembers beyond those; 0 at first.
    virtual uint32_t memory_words() const { return 0; }
    /// Fills in what its pass alone reads of the settings.
    virtual void set(shader::GuidingSettings&, const refresh::Settings&) const {}
};

/// A guider, and the size of what it keeps.
struct GuideChoice {
    Guide guide = Guide::brdf;
    uint32_t size = 0;
    bool operator==(const GuideChoice&) const = default;
    /// Whether it draws rays at all.
    bool guides() const { return guide != Guide::brdf; }
};

/// Null for `brdf`, which draws none.
const Guider* guider_of(Guide guide);

std::string_view guider_name(Guide guide);

/// What these settings ask of a guider.
GuideChoice choose_guide(Guide guide, const refresh::Settings& settings);

// One per row of shaders/shared/guiders.h, each defined in guiding/NAME.cpp.
#define VIGIL_DECLARE_GUIDER(name, help) const Guider* guider_##name();
VIGIL_GUIDER_TABLE(VIGIL_DECLARE_GUIDER)
#undef VIGIL_DECLARE_GUIDER

} // namespace vigil::vkpt
