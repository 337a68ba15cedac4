// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of the tables in docs/internals/numerics.md: a test that has passed through an extreme says
// which, what was demanded, and what was seen. GoogleTest writes them into its XML;
// tools/numerics/numerics_page.py makes the page.
#pragma once

#include "light/statistics.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <string_view>

namespace vigil::test {

/// `area`: a table of the page, say "lights". `seen` may differ between machines, the others may
/// not.
inline void record(std::string_view area, std::string_view extreme, std::string_view demanded,
                   std::string_view seen = "") {
    testing::Test::RecordProperty(fmt::format("numerics/{}/{}", area, extreme),
                                  fmt::format("{} | {}", demanded, seen));
}

/// Unit of errors relative to a single-precision number: half a unit in its last place, at the
/// least (2^-24).
inline constexpr double half_ulp = 0x1p-24;

/// |value / exact - 1| in units of 2^-24; of 0 by its absolute error.
inline double relative_error(double value, double exact) {
    if (value == exact) return 0.0;
    return std::abs(value - exact) / std::abs(exact) / half_ulp;
}

/// Keeps the largest of many errors; what is not a number is larger than all.
class Worst {
public:
    void add(double error) {
        if (!(error <= value_)) value_ = std::isnan(error) ? INFINITY : error;
    }
    double value() const { return value_; }
    std::string text() const { return fmt::format("{:.2g}", value_); }

private:
    double value_ = 0.0;
};

/// Sanitizers slow everything down; the counts of random cases shrink with them.
#ifdef VIGIL_SANITIZED
inline constexpr int slowdown = 20;
#else
inline constexpr int slowdown = 1;
#endif

/// Any float at all: each bit pattern is as likely as any other, NaN and infinity among them.
inline float any_float(uint32_t word) {
    return std::bit_cast<float>(word);
}

} // namespace vigil::test
