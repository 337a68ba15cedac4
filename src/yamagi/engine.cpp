// SPDX-License-Identifier: GPL-2.0-or-later
#include "yamagi/engine.h"

#include <cctype>
#include <charconv>

namespace vigil::yamagi {

namespace {

/// Passes its arguments on as the list that the engine wants.
[[gnu::format(printf, 2, 3)]] void print_list(const EngineFunctions& functions, const char* format,
                                              ...) {
    va_list arguments;
    va_start(arguments, format);
    functions.print(print_all, format, arguments);
    va_end(arguments);
}

} // namespace

void Engine::print(std::string_view line) const {
    // The engine's own buffer has a few thousand bytes.
    constexpr size_t most = 1000;
    const std::string text(line.substr(0, most));
    print_list(functions_, "%s\n", text.c_str());
}

std::string Engine::text(const char* name, const char* default_text, int flags) const {
    const EngineVariable* const variable = functions_.variable(name, default_text, flags);
    return variable != nullptr && variable->text != nullptr ? variable->text : "";
}

float Engine::value(const char* name, const char* default_text, int flags) const {
    const EngineVariable* const variable = functions_.variable(name, default_text, flags);
    return variable != nullptr ? variable->value : 0.0f;
}

void Engine::set(const char* name, const std::string& text) const {
    functions_.set_variable(name, text.c_str());
}

std::optional<FileSource::File> EngineFiles::find(std::string_view path) const {
    const std::scoped_lock lock(mutex_);
    const std::string name(path);
    const int bytes = engine_.functions().load_file(name.c_str(), nullptr);
    if (bytes < 0) return std::nullopt;
    return File{name, static_cast<uint64_t>(bytes)};
}

std::optional<std::vector<uint8_t>> EngineFiles::read(std::string_view path) const {
    const std::scoped_lock lock(mutex_);
    const std::string name(path);
    void* content = nullptr;
    const int bytes = engine_.functions().load_file(name.c_str(), &content);
    if (bytes < 0 || content == nullptr) return std::nullopt;
    const auto* const first = static_cast<const uint8_t*>(content);
    std::vector<uint8_t> copy(first, first + bytes);
    engine_.functions().free_file(content);
    return copy;
}

int api_of(std::string_view version_text) {
    // The first number with a point: "8.20", also behind a name.
    for (size_t i = 0; i < version_text.size(); ++i) {
        if (std::isdigit(static_cast<unsigned char>(version_text[i])) == 0) continue;
        const char* const end = version_text.data() + version_text.size();
        int major = 0, minor = 0;
        const auto whole = std::from_chars(version_text.data() + i, end, major);
        if (whole.ec != std::errc() || whole.ptr == end || *whole.ptr != '.') continue;
        if (std::from_chars(whole.ptr + 1, end, minor).ec != std::errc()) continue;
        const int version = 100 * major + minor;
        // 8.20, 8.50 and 8.70 were tried; those of the same ten are taken for the same.
        if (version / 10 == 82) return 5;
        if (version / 10 == 85) return 7;
        if (version / 10 == 87) return 8;
        return 0;
    }
    return 0;
}

} // namespace vigil::yamagi
