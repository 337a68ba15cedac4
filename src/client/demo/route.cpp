// SPDX-License-Identifier: GPL-2.0-or-later
// Parsing and interpolating camera routes.
#include "client/demo/route.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "console/arguments.h"
#include "console/command_text.h"

#include <algorithm>
#include <cmath>
#include <fmt/ranges.h>

namespace vigil::client {

namespace {

constexpr size_t columns = 7;
constexpr std::string_view route_folder = "routes/";
constexpr std::string_view route_extension = ".route";
/// Seconds, map units and degrees; sums, slopes and frame numbers stay finite.
constexpr float max_number = 1e6f;
/// Views nearer to each other in time than this would make the slope between them overflow.
constexpr double min_step_s = 1e-3;

/// Adds whole turns so that it lies within 180 degrees of `previous`.
float unwrap(float degrees, float previous) {
    return degrees - 360.0f * std::round((degrees - previous) / 360.0f);
}

} // namespace

Route Route::parse(std::string_view name, std::string_view text) {
    std::vector<Key> keys;
    const auto in_range = [](std::span<const float> v) {
        return std::ranges::all_of(v, [](float x) { return std::abs(x) <= max_number; });
    };
    for_each_number_line(
        name, text, columns,
        fmt::format("`time x y z pitch yaw roll`, numbers up to {:g}", max_number), in_range,
        [&](std::span<const float> v, int line) {
            if (!keys.empty() && static_cast<double>(v[0]) < keys.back().time_s + min_step_s)
                fail("{}, line {}: times must increase, by {} s at least", name, line, min_step_s);
            keys.push_back({v[0], {v[1], v[2], v[3]}, {v[4], v[5], v[6]}});
        });
    if (keys.empty()) fail("{}: the route has no views", name);
    return Route(std::move(keys));
}

Route::Route(std::vector<Key> keys) : keys_(std::move(keys)) {
    for (size_t i = 1; i < keys_.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            keys_[i].angles[axis] = unwrap(keys_[i].angles[axis], keys_[i - 1].angles[axis]);
        }
    }
}

int Route::frame_count(double fps) const {
    // A hair more, so that 2.0 s at 20 fps reach the last view in spite of rounding.
    const double frames = std::floor(duration_s() * fps + 1e-6);
    return 1 + static_cast<int>(std::min(frames, 2147483646.0));
}

glm::vec3 Route::slope(size_t index, glm::vec3 Key::*member) const {
    const size_t before = index > 0 ? index - 1 : 0;
    const size_t after = std::min(index + 1, keys_.size() - 1);
    const double seconds = keys_[after].time_s - keys_[before].time_s;
    return (keys_[after].*member - keys_[before].*member) / static_cast<float>(seconds);
}

Route::Key Route::at(double seconds) const {
    const double time = std::clamp(begin_s() + seconds, begin_s(), keys_.back().time_s);
    const auto next = std::ranges::upper_bound(keys_, time, {}, &Key::time_s);
    if (next == keys_.end()) return keys_.back();
    const size_t i = static_cast<size_t>(next - keys_.begin()) - 1;
    const Key& a = keys_[i];
    const Key& b = keys_[i + 1];

    // Hermite basis on [0, 1]; slopes are per second.
    const double step = b.time_s - a.time_s;
    const double u = (time - a.time_s) / step;
    const auto h00 = static_cast<float>((1.0 + 2.0 * u) * (1.0 - u) * (1.0 - u));
    const auto h10 = static_cast<float>(u * (1.0 - u) * (1.0 - u) * step);
    const auto h01 = static_cast<float>(u * u * (3.0 - 2.0 * u));
    const auto h11 = static_cast<float>(u * u * (u - 1.0) * step);
    const auto blend = [&](glm::vec3 Key::*member) {
        return h00 * (a.*member) + h10 * slope(i, member) + h01 * (b.*member) +
               h11 * slope(i + 1, member);
    };
    return {time, blend(&Key::origin), blend(&Key::angles)};
}

std::string_view route_name(std::string_view path) {
    if (starts_nocase(path, route_folder)) path.remove_prefix(route_folder.size());
    if (ends_nocase(path, route_extension)) path.remove_suffix(route_extension.size());
    return path;
}

std::vector<std::string> list_routes(const FileSystem& files) {
    std::vector<std::string> names;
    for (const std::string& path : files.list(route_folder, route_extension)) {
        names.emplace_back(route_name(path));
    }
    return names;
}

int checked_frame_count(const Route& route, std::string_view name, double fps) {
    constexpr int most = 1'000'000;
    const int frames = route.frame_count(fps);
    if (frames > most)
        fail("the route {} has more than {} frames at {} per second", name, most, fps);
    return frames;
}

Route load_route(const FileSystem& files, std::string_view name) {
    const std::string path = fmt::format("{}{}{}", route_folder, route_name(name), route_extension);
    if (!files.exists(path)) {
        const std::vector<std::string> names = list_routes(files);
        fail("there is no route {} (there are: {})", path, fmt::join(names, ", "));
    }
    return Route::parse(path, files.read_text(path));
}

} // namespace vigil::client
