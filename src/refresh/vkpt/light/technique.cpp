// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/technique.h"

namespace vigil::vkpt {

std::unique_ptr<LightTechnique> make_technique(Technique technique,
                                               const TechniqueContext& context) {
    switch (technique) {
#define VIGIL_MAKE_TECHNIQUE(name, help)                                                           \
    case Technique::name:                                                                          \
        return make_##name(context);
        VIGIL_TECHNIQUE_TABLE(VIGIL_MAKE_TECHNIQUE)
#undef VIGIL_MAKE_TECHNIQUE
    }
    return nullptr;
}

} // namespace vigil::vkpt
