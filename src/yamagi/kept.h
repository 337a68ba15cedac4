// SPDX-License-Identifier: GPL-2.0-or-later
// Handles that are asked for again and again, of things that may not be there.
#pragma once

#include "common/error.h"
#include "common/log.h"

namespace vigil::yamagi {

/// The handle under `key`; `make` makes it at first. Where that fails it is `nothing` from then on,
/// and the log says why once.
template <typename Handles, typename Make>
auto kept(Handles& handles, const typename Handles::key_type& key,
          typename Handles::mapped_type nothing, const Make& make) {
    const auto [row, is_new] = handles.try_emplace(key, nothing);
    if (is_new) {
        try {
            row->second = make();
        } catch (const Error& error) {
            log_warning("{}", error.what());
        }
    }
    return row->second;
}

} // namespace vigil::yamagi
