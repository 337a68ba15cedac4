// SPDX-License-Identifier: GPL-2.0-or-later
// Statistics for tests of random processes: means with their standard errors, and chi-square as a
// z-score. Tests compare with limits in standard errors; at 4.5 of them one comparison in 150,000
// fails by chance.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace vigil::test {

inline constexpr double z_limit = 4.5;

/// Running mean and variance.
class Sample {
public:
    void add(double value) {
        ++count_;
        const double delta = value - mean_;
        mean_ += delta / static_cast<double>(count_);
        squares_ += delta * (value - mean_);
    }
    double mean() const { return mean_; }
    double variance() const { return squares_ / static_cast<double>(count_ - 1); }
    double standard_error() const { return std::sqrt(variance() / static_cast<double>(count_)); }
    /// Standard errors between the mean and what it should be.
    double z(double expected) const { return (mean_ - expected) / standard_error(); }

private:
    uint64_t count_ = 0;
    double mean_ = 0.0, squares_ = 0.0;
};

/// Chi-square of counts against expected probabilities (summing to 1), as a standard normal score
/// by Wilson and Hilferty's cube root. Both tails matter: counts that fit too well are not random
/// either.
inline double chi_square_z(std::span<const uint64_t> counts,
                           std::span<const double> probabilities) {
    double total = 0.0;
    for (const uint64_t count : counts)
        total += static_cast<double>(count);
    double chi = 0.0;
    for (size_t i = 0; i < counts.size(); ++i) {
        const double expected = total * probabilities[i];
        const double delta = static_cast<double>(counts[i]) - expected;
        chi += delta * delta / expected;
    }
    const double freedom = static_cast<double>(counts.size() - 1), spread = 2.0 / (9.0 * freedom);
    return (std::cbrt(chi / freedom) - (1.0 - spread)) / std::sqrt(spread);
}

inline double chi_square_z(std::span<const uint64_t> counts) {
    const std::vector<double> even(counts.size(), 1.0 / static_cast<double>(counts.size()));
    return chi_square_z(counts, even);
}

} // namespace vigil::test
