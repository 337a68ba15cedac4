// SPDX-License-Identifier: GPL-2.0-or-later
// A camera route: views at given times, and the smooth path through them (cubic Hermite segments
// with Catmull-Rom tangents; angles take the shorter way round). Text format: one `time x y z pitch
// yaw roll` per line, seconds and degrees, `#` begins a comment.
#pragma once

#include "common/file_system.h"
#include "refresh/refresh.h"

#include <string>
#include <string_view>
#include <vector>

namespace vigil::client {

class Route {
public:
    struct Key {
        double time_s = 0.0;
        glm::vec3 origin{0.0f};
        glm::vec3 angles{0.0f};
    };

    /// Parses the text of a route. Throws Error with `name` and the line when a line has not
    /// exactly seven numbers of at most a million, when times do not increase by a millisecond, and
    /// when there is no line at all.
    static Route parse(std::string_view name, std::string_view text);

    /// Keys with increasing times, at least one.
    explicit Route(std::vector<Key> keys);

    double begin_s() const { return keys_.front().time_s; }
    double duration_s() const { return keys_.back().time_s - keys_.front().time_s; }
    /// Frames at `fps` frames per second, the first and the last view included (at least 1).
    int frame_count(double fps) const;

    /// Origin and angles at `seconds` after the begin, clamped to the route.
    Key at(double seconds) const;

    const std::vector<Key>& keys() const { return keys_; }

private:
    glm::vec3 slope(size_t index, glm::vec3 Key::*member) const;

    std::vector<Key> keys_; // angles unwrapped: neighbours differ by at most 180 degrees
};

/// frame_count() of a route that is about to be flown or recorded, each frame of which takes
/// memory. Throws Error, with the route's name, beyond a million.
int checked_frame_count(const Route& route, std::string_view name, double fps);

/// Reads routes/NAME.route; `name` may be given with folder and extension. Throws Error, also with
/// the names there are.
Route load_route(const FileSystem& files, std::string_view name);
/// The names that load_route knows, sorted.
std::vector<std::string> list_routes(const FileSystem& files);
/// Without folder and extension.
std::string_view route_name(std::string_view path);

} // namespace vigil::client
