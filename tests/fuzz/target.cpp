// SPDX-License-Identifier: GPL-2.0-or-later
// What all targets share: the table as data, and what counts as a finding besides a crash.
#include "target.h"

#include "common/error.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace vigil::fuzz {

namespace {

constexpr Target rows[] = {
#define VIGIL_FUZZ_ROW(name, extension, max_bytes, runs, what)                                     \
    {#name, extension, max_bytes, fuzz_##name},
    VIGIL_FUZZ_TARGETS(VIGIL_FUZZ_ROW)
#undef VIGIL_FUZZ_ROW
};

bool is_one_line(std::string_view text) {
    for (const char c : text)
        if (static_cast<unsigned char>(c) < 32 || c == 127) return false;
    return true;
}

} // namespace

std::span<const Target> targets() {
    return rows;
}

void require(bool kept, std::string_view what) {
    if (kept) return;
    fmt::print(stderr, "finding: {}\n", what);
    std::abort();
}

void parse_or_refuse(std::string_view name, const std::function<void()>& parse) {
    try {
        parse();
    } catch (const Error& error) {
        const std::string_view text = error.what();
        require(text.find(name) != std::string_view::npos,
                fmt::format("the message does not name the file: {}", text));
        require(is_one_line(text), fmt::format("the message is not one line of text: {}", text));
        require(text.size() < 1000, fmt::format("the message is too long: {}", text));
    }
}

std::string_view text_of(Input bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace vigil::fuzz
