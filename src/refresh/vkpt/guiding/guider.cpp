// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/guiding/guider.h"

namespace vigil::vkpt {

const Guider* guider_of(Guide guide) {
    switch (guide) {
#define VIGIL_GUIDER_CASE(name, help)                                                              \
    case Guide::name:                                                                              \
        return guider_##name();
        VIGIL_GUIDER_TABLE(VIGIL_GUIDER_CASE)
#undef VIGIL_GUIDER_CASE
    }
    return nullptr;
}

std::string_view guider_name(Guide guide) {
    return guider_infos[static_cast<size_t>(guide)].name;
}

GuideChoice choose_guide(Guide guide, const refresh::Settings& settings) {
    const Guider* guider = guider_of(guide);
    return {guide, guider == nullptr ? 0 : guider->size(settings)};
}

} // namespace vigil::vkpt
