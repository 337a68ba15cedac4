// SPDX-License-Identifier: GPL-2.0-or-later
// Parsing and interpolating camera routes.
#include "client/demo/route.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "console/arguments.h"
#include "console/command_text.h"

#include <algorithm>
#include <array>
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

/// The words of a line up to its comment.
std::vector<std::string_view> words_of(std::string_view line) {
    constexpr std::string_view spaces = " \t\r";
    line = line.substr(0, line.find('#'));
    std::vector<std::string_view> words;
    for (size_t begin = line.find_first_not_of(spaces); begin != std::string_view::npos;
         begin = line.find_first_not_of(spaces, begin)) {
        const size_t end = std::min(line.find_first_of(spaces, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = end;
    }
    return words;
}

/// Adds whole turns so that it lies within 180 degrees of `previous`.
float unwrap(float degrees, float previous) {
    return degrees - 360.0f * std::round((degrees - previous) / 360.0f);
}

} // namespace

Route Route::parse(std::string_view name, std::string_view text) {
    std::vector<Key> keys;
    int line_number = 0;
    while (!text.empty()) {
        const size_t end = std::min(text.find('\n'), text.size());
        const std::vector<std::string_view> words = words_of(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        ++line_number;
        if (words.empty()) continue;
        std::array<float, columns> v{};
        bool good = words.size() == columns;
        for (size_t i = 0; good && i < columns; ++i)
            good = parse_number(words[i], v[i]) && std::abs(v[i]) <= max_number;
        if (!good)
            fail("{}, line {}: expected `time x y z pitch yaw roll`, numbers up to {:g}", name,
                 line_number, max_number);
        if (!keys.empty() && static_cast<double>(v[0]) < keys.back().time_s + min_step_s) {
            fail("{}, line {}: times must increase, by {} s at least", name, line_number,
                 min_step_s);
        }
        keys.push_back({v[0], {v[1], v[2], v[3]}, {v[4], v[5], v[6]}});
    }
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
