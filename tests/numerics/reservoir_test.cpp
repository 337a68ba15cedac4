// SPDX-License-Identifier: GPL-2.0-or-later
// A walk's choice for each of the 2^24 numbers that may decide it: how far from its probability a
// candidate can be.
#include "record.h"
#include "shared/random.h"
#include "shared/reservoir.h"

#include <vector>

namespace vigil::shader {
namespace {

using test::record;
using test::slowdown;
using test::Worst;

/// Largest difference between a candidate's share of all numbers and its probability, in numbers
/// (2^-24).
double worst_difference(const std::vector<float>& importances) {
    constexpr uint step = 17 * (slowdown - 1) + 1;
    std::vector<uint64_t> counts(importances.size());
    uint64_t numbers = 0;
    for (uint i = 0; i < 1u << 24; i += step, ++numbers) {
        Reservoir reservoir = new_reservoir(unit_float(i << 8));
        for (uint k = 0; k < importances.size(); ++k)
            reservoir_add(reservoir, k, importances[k]);
        EXPECT_LT(reservoir.chosen, importances.size());
        EXPECT_GT(reservoir.chosen_importance, 0.0f);
        EXPECT_TRUE(reservoir.u >= 0.0f && reservoir.u <= 1.0f);
        ++counts[reservoir.chosen];
    }
    double sum = 0.0;
    for (const float importance : importances)
        sum += double(importance);
    Worst worst;
    for (size_t k = 0; k < importances.size(); ++k) {
        const double exact = double(importances[k]) / sum * double(numbers);
        worst.add(std::abs(double(counts[k]) - exact));
        EXPECT_TRUE(importances[k] > 0.0f || counts[k] == 0);
    }
    return worst.value();
}

TEST(Reservoir, CandidatesAreDrawnAsOftenAsTheyShould) {
    // A number is stretched once per candidate: what each stretch rounds away adds up.
    Random random = random_begin(uvec2(0, 0), 0, 1);
    struct Row {
        const char* name;
        std::vector<float> importances;
        double limit;
    };
    std::vector<Row> rows{{"two alike", {1, 1}, 2},
                          {"one of 2^-20", {1, 0x1p-20f}, 2},
                          {"one of 2^-20, first", {0x1p-20f, 1}, 2},
                          {"far below a number, after", {1, 1e-12f}, 2},
                          {"far below a number, first", {1e-12f, 1}, 2},
                          {"1e-30 to 1e18", {1e-30f, 1e18f, 0, 1e-12f, 1e12f}, 2}};
    std::vector<float> alike(32, 0.3f), mixed, rising;
    for (int i = 0; i < 32; ++i) {
        mixed.push_back(std::pow(10.0f, 6.0f * random_next(random)));
        rising.push_back(std::exp2(float(i) - 16.0f));
    }
    rows.push_back({"32 alike", alike, 2048});
    rows.push_back({"32 over six powers of ten", mixed, 2048});
    rows.push_back({"32, each twice the one before", rising, 2048});
    Worst few, many;
    for (const Row& row : rows) {
        const double worst = worst_difference(row.importances);
        if (slowdown > 1) continue; // too few numbers to judge by
        EXPECT_LE(worst, row.limit) << row.name;
        (row.limit < 10 ? few : many).add(worst);
    }
    record("light choice", "walks of up to 5 candidates with importances from 1e-30 to 1e18",
           "each probability off by at most 2 * 2^-24", fmt::format("{:.2f} * 2^-24", few.value()));
    record("light choice", "walks of 32 candidates, over 1 to 10 powers of ten",
           "each probability off by at most 2^-13", fmt::format("{:.0f} * 2^-24", many.value()));
}

} // namespace
} // namespace vigil::shader
