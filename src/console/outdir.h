// SPDX-License-Identifier: GPL-2.0-or-later
// The folder of the variable `outdir`.
#pragma once

#include "common/output.h"
#include "console/cvar.h"

namespace vigil {

/// Path of the output file `name` below the program's `outdir` (common/output.h).
inline std::filesystem::path output_path(std::string_view name) {
    return output_path(cvars()->outdir, name);
}

} // namespace vigil
