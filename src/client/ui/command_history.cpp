// SPDX-License-Identifier: GPL-2.0-or-later
// Walking through earlier lines, and their file.
#include "client/ui/command_history.h"

#include "common/error.h"
#include "common/output.h"

#include <fstream>

namespace vigil::client {

void CommandHistory::add(std::string_view line) {
    if (!line.empty() && (lines_.empty() || lines_.back() != line)) lines_.emplace_back(line);
    while (lines_.size() > capacity)
        lines_.pop_front();
    position_ = lines_.size();
}

std::string CommandHistory::older(std::string_view current) {
    if (position_ == lines_.size()) typed_ = current;
    if (position_ == 0) return std::string(current);
    return lines_[--position_];
}

std::string CommandHistory::newer(std::string_view current) {
    if (position_ == lines_.size()) return std::string(current);
    ++position_;
    return position_ == lines_.size() ? typed_ : lines_[position_];
}

void CommandHistory::load(const std::filesystem::path& path) {
    std::error_code missing;
    if (!std::filesystem::exists(path, missing)) return;
    std::ifstream file(path);
    if (!file) fail("{}: cannot be read", path.string());
    for (std::string line; std::getline(file, line);)
        add(line);
}

void CommandHistory::save(const std::filesystem::path& path) const {
    std::string text;
    for (const std::string& line : lines_)
        text += line + "\n";
    write_file(path, text);
}

} // namespace vigil::client
