// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/option_values.h"

#include "common/error.h"
#include "console/cvar.h"

#include <charconv>
#include <cstdlib>

namespace vigil::bench {

int parse_count(std::string_view option, std::string_view text, int low, int high) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < low || number > high)
        fail("{} {}: expected a whole number, {} to {}", option, text, low, high);
    return number;
}

glm::ivec2 parse_size(std::string_view option, std::string_view text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos) fail("{} {}: expected WIDTHxHEIGHT", option, text);
    return {parse_count(option, text.substr(0, cross), 16, 16384),
            parse_count(option, text.substr(cross + 1), 16, 16384)};
}

Setting parse_setting(std::string_view option, std::string_view name, std::string_view value) {
    if (!find_cvar(name)) fail("{} {}: no such variable", option, name);
    return {std::string(name), std::string(value)};
}

std::vector<std::filesystem::path> default_basedirs() {
    std::vector<std::filesystem::path> folders = {".", VIGIL_SOURCE_DIR};
    if (const char* shared = std::getenv("VIGIL_SHARED"))
        folders.push_back(std::filesystem::path(shared) / "levels");
    folders.push_back(std::filesystem::path(VIGIL_SOURCE_DIR) / "../shared/levels");
    return folders;
}

const std::string& OptionWords::value() {
    if (next_ >= words_.size()) fail("{} needs a value", words_.back());
    return words_[next_++];
}

void OptionWords::run(const Actions& actions, std::string_view usage) {
    while (next_ < words_.size()) {
        const std::string& option = words_[next_++];
        const auto action = actions.find(option);
        if (action == actions.end()) fail("{}: unknown option; known are {}", option, usage);
        action->second();
    }
}

} // namespace vigil::bench
