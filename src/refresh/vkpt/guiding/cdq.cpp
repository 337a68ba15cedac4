// SPDX-License-Identifier: GPL-2.0-or-later
// Guider `cdq`: Compressed Directional Quadtrees (shaders/guiding/cdq.glsl). Its size is their
// number of bits.
#include "shared/cdq.h"
#include "refresh/vkpt/guiding/guider.h"

namespace vigil::vkpt {

namespace {

class Quadtrees : public Guider {
public:
    uint32_t size(const refresh::Settings& settings) const override {
        return 32 * (static_cast<uint32_t>(settings.pt_cdq_bits) + 1);
    }
    glm::uvec4 first_words(uint32_t bits) const override { return shader::cdq_even_tree(bits); }
    uint32_t memory_words() const override { return shader::CDQ_SUM_WORDS; }
    void set(shader::GuidingSettings& to, const refresh::Settings& settings) const override {
        to.migrations = static_cast<uint32_t>(settings.pt_cdq_migrations);
        to.margin = settings.pt_cdq_margin;
    }
};

} // namespace

const Guider* guider_cdq() {
    static const Quadtrees quadtrees;
    return &quadtrees;
}

} // namespace vigil::vkpt
