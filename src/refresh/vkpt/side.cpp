// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/side.h"

namespace vigil::vkpt {

bool Side::select(Technique technique, const TechniqueContext& context) {
    if (technique_ && technique == id_) return false;
    device_.wait_idle();
    technique_ = make_technique(technique, context);
    id_ = technique;
    return true;
}

void Side::forget(const glm::vec3& corner, float size) {
    if (technique_) technique_->forget();
    guiding_.restart(corner, size);
}

void Side::prepare_guiding(glm::uvec2 picture_size, const refresh::Settings& settings) {
    if (!guided()) return;
    Guiding::Options options = Guiding::options(picture_size, guide_.guide, settings);
    options.lights = technique_->uses_guiding();
    guiding_.prepare(options);
}

void Side::update_guiding(gpu::FrameCommands& commands, size_t slot, Change change,
                          std::span<const glm::vec3> places) {
    if (guided()) guiding_.record(commands, slot, change, places);
}

} // namespace vigil::vkpt
