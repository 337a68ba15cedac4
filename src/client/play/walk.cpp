// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/play/walk.h"

#include "common/ascii_case.h"
#include "common/binary_file.h"
#include "common/error.h"
#include "common/game_path.h"
#include "common/printable.h"
#include "console/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace vigil::client {

namespace {

constexpr std::string_view folder = "walks/";
constexpr std::string_view extension = ".walk";
constexpr size_t columns = 8;
constexpr float most = 10'000.0f;

bool in_range(std::span<const float> v) {
    const bool whole = v[0] >= 1.0f && v[0] <= 1e6f && v[0] == std::floor(v[0]);
    const bool switched = v[7] == 0.0f || v[7] == 1.0f;
    return whole && switched && std::all_of(v.begin() + 1, v.end(), [](float number) {
               return std::abs(number) <= most;
           });
}

} // namespace

Walk Walk::parse(std::string_view name, std::string_view text) {
    Walk walk;
    for_each_number_line(
        name, text, columns,
        fmt::format("`ticks forward side up pitch yaw roll attack`, whole ticks from 1 to a "
                    "million, numbers up to {:g}, attack 0 or 1",
                    most),
        in_range, [&](std::span<const float> v, int line) {
            const auto ticks = static_cast<int64_t>(v[0]);
            if (walk.ticks_ + ticks > most_ticks)
                fail("{}, line {}: the walk is longer than {} ticks", name, line, most_ticks);
            walk.add({{v[4], v[5], v[6]}, v[1], v[2], v[3], v[7] != 0.0f}, ticks);
        });
    if (walk.runs_.empty()) fail("{}: the walk has no ticks", name);
    return walk;
}

std::string Walk::text() const {
    std::string text = "# ticks forward side up pitch yaw roll attack\n";
    for (size_t i = 0; i < runs_.size(); ++i) {
        constexpr int64_t longest_line = 1'000'000;
        const PlayerCommand& c = runs_[i].command;
        int64_t left = (i + 1 < runs_.size() ? runs_[i + 1].begin : ticks_) - runs_[i].begin;
        for (; left > 0; left -= longest_line)
            text +=
                fmt::format("{} {} {} {} {} {} {} {}\n", std::min(left, longest_line), c.forward,
                            c.side, c.up, c.angles.x, c.angles.y, c.angles.z, c.attack ? 1 : 0);
    }
    return text;
}

void Walk::add(const PlayerCommand& command, int64_t ticks) {
    ticks = std::min(ticks, most_ticks - ticks_);
    if (ticks <= 0) return;
    if (runs_.empty() || runs_.back().command != command) runs_.push_back({ticks_, command});
    ticks_ += ticks;
}

const PlayerCommand& Walk::command_at(int64_t tick) const {
    const auto after = std::ranges::upper_bound(runs_, tick, {}, &Run::begin);
    return std::prev(after)->command;
}

std::string walk_path(std::string_view name) {
    if (starts_nocase(name, folder)) name.remove_prefix(folder.size());
    if (ends_nocase(name, extension)) name.remove_suffix(extension.size());
    return fmt::format("{}{}{}", folder, name, extension);
}

Walk load_walk(const FileSystem& files, const std::string& outdir, std::string_view name) {
    const std::string path = walk_path(name);
    if (const auto fault = game_path_fault(path); !fault.empty())
        fail("\"{}\" is no name of a walk: it {}", printable(path), fault);
    const std::filesystem::path recorded = std::filesystem::path(outdir) / path;
    std::error_code none;
    if (std::filesystem::is_regular_file(recorded, none)) {
        const BinaryFile file(recorded);
        if (file.size() > max_file_bytes) fail("{}: the file is too large", file.name());
        const std::vector<uint8_t> bytes = file.read(0, file.size());
        return Walk::parse(file.name(),
                           {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    if (!files.exists(path))
        fail("there is no walk {}, neither in the game's folders nor in {}", path,
             recorded.parent_path().string());
    return Walk::parse(path, files.read_text(path));
}

} // namespace vigil::client
