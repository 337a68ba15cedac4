// SPDX-License-Identifier: GPL-2.0-or-later
// Levels: whole files, and the two lumps that have a format of their own.
#include "formats/bsp.h"
#include "formats/entity.h"
#include "formats/level_walk.h"
#include "formats/small_level.h"
#include "target.h"

namespace vigil::fuzz {

namespace {

void keep(float value) {
    const volatile float kept = value;
    (void)kept;
}

} // namespace

void fuzz_bsp(Input bytes) {
    parse_or_refuse("x.bsp", [&] { keep(walk_level(parse_bsp("x.bsp", bytes))); });
}

void fuzz_pvs(Input bytes) {
    LevelLumps lumps = small_level();
    lumps[level_visibility].assign(bytes.begin(), bytes.end());
    const Bytes level = write_level(lumps);
    parse_or_refuse("x.bsp", [&] { keep(walk_level(parse_bsp("x.bsp", level))); });
}

void fuzz_entities(Input bytes) {
    parse_or_refuse("x.bsp", [&] {
        for (const Entity& entity : parse_entities("x.bsp", text_of(bytes)))
            for (const auto& [key, value] : entity.pairs)
                keep(entity.get_vec3(key).x + entity.get_float(key) +
                     static_cast<float>(entity.get_int(key)));
    });
}

} // namespace vigil::fuzz
