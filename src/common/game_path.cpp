// SPDX-License-Identifier: GPL-2.0-or-later
// The rules for safe paths.
#include "common/game_path.h"

#include "common/ascii_case.h"
#include "common/printable.h"

namespace vigil {

std::string_view game_path_fault(std::string_view path) {
    if (path.empty()) return "is empty";
    for (const char c : path) {
        if (is_control(c)) return "holds a control character";
        if (c == '\\') return "holds a backslash";
    }
    if (path[0] == '/') return "is absolute";
    if (path.size() > 1 && path[1] == ':' && ascii_lower(path[0]) >= 'a' &&
        ascii_lower(path[0]) <= 'z')
        return "begins with a drive letter";

    for (;;) {
        const auto slash = path.find('/');
        const std::string_view part = path.substr(0, slash);
        if (part == "..") return "goes up with ..";
        if (part.empty() || part == ".") return "has an empty part";
        if (slash == std::string_view::npos) return {};
        path.remove_prefix(slash + 1);
    }
}

} // namespace vigil
