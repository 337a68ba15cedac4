// SPDX-License-Identifier: GPL-2.0-or-later
// Text for messages; see printable.h.
#include "common/printable.h"

#include <algorithm>

namespace vigil {

std::string printable(std::string_view text, std::size_t most) {
    std::string shown(text.substr(0, most));
    std::replace_if(shown.begin(), shown.end(), is_control, '?');
    if (text.size() > most) shown += "...";
    return shown;
}

} // namespace vigil
