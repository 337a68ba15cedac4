// SPDX-License-Identifier: GPL-2.0-or-later
// Values of command line options that several benchmarks have.
#pragma once

#include "bench/quality_options.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::bench {

/// Throws Error when the text is no whole number from low to high.
int parse_count(std::string_view option, std::string_view text, int low, int high);
/// WIDTHxHEIGHT in pixels, each from 16 to 16384. Throws Error.
glm::ivec2 parse_size(std::string_view option, std::string_view text);
/// A variable and its value. Throws Error when there is no such variable.
Setting parse_setting(std::string_view option, std::string_view name, std::string_view value);
/// Where levels are looked for: here, the sources, the shared levels.
std::vector<std::filesystem::path> default_basedirs();

/// The words after a benchmark's name, one after the other.
class OptionWords {
public:
    explicit OptionWords(std::span<const std::string> words) : words_(words) {}

    /// The value that the option taken last needs. Throws Error when nothing follows.
    const std::string& value();
    /// Does what the words say. Throws Error, which lists `usage`, when an option is unknown.
    using Actions = std::map<std::string_view, std::function<void()>>;
    void run(const Actions& actions, std::string_view usage);

private:
    std::span<const std::string> words_;
    std::size_t next_ = 0;
};

} // namespace vigil::bench
