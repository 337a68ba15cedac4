// SPDX-License-Identifier: GPL-2.0-or-later
// Runs a parser on faulty bytes and hands back its message, for tests that expect one clear Error.
// Any other exception, a crash or success fails the test.
#pragma once

#include "common/error.h"

#include <gtest/gtest.h>

#include <string>

namespace vigil {

template <typename Parse> std::string fault_of(Parse parse) {
    try {
        parse();
    } catch (const Error& error) {
        return error.what();
    }
    ADD_FAILURE() << "the fault was not noticed";
    return {};
}

/// Expects that `parse` throws an Error whose message starts with `name` and holds `part`.
template <typename Parse>
void expect_fault(std::string_view name, std::string_view part, Parse parse) {
    const std::string message = fault_of(parse);
    EXPECT_TRUE(message.starts_with(std::string(name) + ":")) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message << "\nwanted: " << part;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

} // namespace vigil
