// SPDX-License-Identifier: GPL-2.0-or-later
// The renderer's variables as variables of the engine, which is where people set them: pt_nee at
// its console, with its completion. Names, ranges and defaults are those of
// shaders/shared/settings_table.h.
#pragma once

#include "console/cvar.h"
#include "yamagi/engine.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vigil::yamagi {

class Variables {
public:
    /// Makes what the engine lacks, and takes over what it has.
    explicit Variables(const Engine& engine);

    /// Takes over what was set at the engine's console. A number out of range is brought into it,
    /// and a text that means nothing is put back; both are told. A choice that was given by its
    /// number becomes its name. The other way, the engine sees what pt_preset sets, and what ends a
    /// preset.
    void update();

    const CvarValues& values() const { return registry_.values(); }
    const CvarRegistry& registry() const { return registry_; }

private:
    struct Row {
        const CvarInfo* info;
        const EngineVariable* variable;
        std::string text; // that both had last
        std::string name;
    };
    static std::string text_of(const Row& row);
    void begin_with_preset();
    void take(Row& row);
    void show_changes();

    const Engine& engine_;
    CvarRegistry registry_;
    std::vector<Row> rows_;
    std::uint64_t shown_changes_ = 0;
};

} // namespace vigil::yamagi
