// SPDX-License-Identifier: GPL-2.0-or-later
// Levels of few brushes without a compiler: one node whose plane lies far away, and all brushes of
// a model in one leaf. What a leaf's contents say is given by hand.
#pragma once

#include "formats/bsp.h"
#include "game/trace.h"

#include <span>

namespace vigil {

class BoxLevel {
public:
    BoxLevel();

    /// Adds a brush to the world. Returns its index.
    uint32_t add_box(const Box& box, uint32_t contents = CONTENTS_SOLID, uint32_t surface = 0);
    /// The half spaces behind planes (normal, dist).
    uint32_t add_brush(std::span<const glm::vec4> planes, uint32_t contents = CONTENTS_SOLID,
                       uint32_t surface = 0);
    /// Adds a brush model of one box. Returns N of "*N".
    uint32_t add_model(const Box& box, uint32_t contents = CONTENTS_SOLID);
    /// Adds an entity "key" "value" pair list. Returns its number.
    int add_entity(std::initializer_list<std::pair<const char*, std::string>> pairs);
    /// Everything below `z` is water (or what `contents` says), for questions about points.
    void flood(float z, uint32_t contents);

    /// A level with a floor whose top is at z = 0, 8192 units wide.
    static BoxLevel with_floor(uint32_t surface = 0);

    Bsp build() const;

private:
    struct Model {
        Box bounds;
        std::vector<uint32_t> brushes;
    };
    Bsp bsp_;
    std::vector<Model> models_;
    float water_z_ = -4096.0f;
    uint32_t water_contents_ = 0;
};

} // namespace vigil
