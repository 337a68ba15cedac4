// SPDX-License-Identifier: GPL-2.0-or-later
// How often each interval of the benchmark holds the truth, over synthetic experiments whose
// measurements have tails like those of fireflies, at the numbers of views and seeds in use. Each
// test prints its table, and records its extremes, which docs/research/quality.md quotes.
#include "bench/quality_estimate.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace vigil::bench {

namespace {

using Random = std::mt19937;

constexpr int experiments = 1000;

/// The least coverage at which an interval is printed.
constexpr double least_coverage = 0.9;

/// Four standard errors of a share over the experiments.
double tolerance(double share) {
    return 4.0 * std::sqrt(share * (1.0 - share) / experiments);
}

/// How one run's error differs from that of a usual run; the usual run has 1.
struct Tail {
    std::string name;
    double sigma = 0.0;     // of the logarithm
    double fireflies = 0.0; // share of runs that have one, which makes the error 100 times as large
    double mean = 0.0;

    double draw(Random& random) const {
        const double value = std::exp(std::normal_distribution<double>(0.0, sigma)(random));
        const bool has_firefly = fireflies > 0.0 && std::bernoulli_distribution(fireflies)(random);
        return has_firefly ? 100.0 * value : value;
    }
};

Tail lognormal(double sigma) {
    return {fmt::format("lognormal {}", sigma), sigma, 0.0, std::exp(0.5 * sigma * sigma)};
}

Tail mixture(double share) {
    constexpr double sigma = 0.1;
    return {fmt::format("{}% of 100x", 100.0 * share), sigma, share,
            std::exp(0.5 * sigma * sigma) * (1.0 + 99.0 * share)};
}

/// What is compared: tails of the one technique and of the other.
struct Family {
    Tail above, below;
};

const std::vector<Family>& families() {
    static const std::vector<Family> table = {
        {lognormal(2.0), lognormal(2.0)}, {lognormal(3.0), lognormal(3.0)},
        {mixture(0.01), mixture(0.01)},   {mixture(0.05), mixture(0.01)},
        {lognormal(2.0), mixture(0.01)},
    };
    return table;
}

struct Size {
    int views, seeds;
};

/// Of `scale` and `trade`, of `quality` and `adapt`, of `confirm`, and one more.
constexpr Size sizes[] = {{4, 2}, {4, 4}, {4, 6}, {4, 8}};

constexpr double ratio = 0.8; // of usual runs

Strata draw(Random& random, const Tail& tail, Size size, double scale) {
    Strata values(static_cast<std::size_t>(size.views));
    for (std::vector<double>& view : values)
        for (int seed = 0; seed < size.seeds; ++seed)
            view.push_back(scale * tail.draw(random));
    return values;
}

/// Median of above / below for single pairs, from so many that its error is far below an interval.
double median_of_pairs(const Family& family) {
    if (family.above.name == family.below.name) return ratio;
    Random random(1);
    std::vector<double> ratios(200000);
    for (double& value : ratios)
        value = ratio * family.above.draw(random) / family.below.draw(random);
    return median(std::move(ratios));
}

/// Share of experiments whose interval holds the truth; one without bounds does not.
double coverage(double truth, const std::function<Interval(Random&)>& experiment) {
    Random random(5);
    int covered = 0;
    for (int i = 0; i < experiments; ++i) {
        const Interval interval = experiment(random);
        covered += interval.low <= truth && truth <= interval.high;
    }
    return covered / static_cast<double>(experiments);
}

/// Coverage for every family and size, printed; `check` looks at each. The report of this program
/// has the lowest and the highest.
void tabulate(const std::string& name,
              const std::function<double(const Family&, Size)>& coverage_of,
              const std::function<void(double, const std::string&)>& check) {
    std::string text = fmt::format("{:<40}", name);
    std::vector<double> shares;
    for (const Size size : sizes)
        text += fmt::format("{:>7} x {}", size.views, size.seeds);
    for (const Family& family : families()) {
        text += fmt::format("\n  {:<38}", family.above.name + " over " + family.below.name);
        for (const Size size : sizes) {
            const double share = shares.emplace_back(coverage_of(family, size));
            text += fmt::format("{:>10.1f}%", 100.0 * share);
            check(share, fmt::format("{}, {} over {}, {} x {}", name, family.above.name,
                                     family.below.name, size.views, size.seeds));
        }
    }
    std::cout << text << '\n';
    const auto [lowest, highest] = std::ranges::minmax(shares);
    testing::Test::RecordProperty("measured/" + name + "/lowest", fmt::format("{}", lowest));
    testing::Test::RecordProperty("measured/" + name + "/highest", fmt::format("{}", highest));
}

/// What the interval promises, and so at least what is asked for.
void expect_promised(double share, const std::string& name) {
    EXPECT_GE(share, 0.95 - tolerance(0.95)) << name;
    static_assert(least_coverage <= 0.95);
}

/// Chance that order statistics of these many values are wider than 95%, at most this.
void expect_no_wider_than(double most, double share, const std::string& name) {
    EXPECT_LE(share, most + tolerance(most)) << name;
}

} // namespace

TEST(Coverage, OfATypicalRatio) {
    std::vector<double> shares;
    tabulate(
        "typical ratio",
        [](const Family& family, Size size) {
            return coverage(median_of_pairs(family), [&](Random& random) {
                return typical_ratio(draw(random, family.above, size, ratio),
                                     draw(random, family.below, size, 1.0))
                    .ratio;
            });
        },
        [&](double share, const std::string& name) {
            expect_promised(share, name);
            shares.push_back(share);
        });
    // By the binomial: [1st, 8th] of 8, [4th, 13th] of 16, [7th, 18th] of 24, [10th, 23rd] of 32.
    constexpr double exact[] = {0.9922, 0.9787, 0.9773, 0.9799};
    for (std::size_t i = 0; i < shares.size(); ++i)
        expect_no_wider_than(exact[i % 4], shares[i], fmt::format("typical ratio {}", i));
}

TEST(Coverage, OfATypicalRatioWhereViewsDiffer) {
    // Half of the views have twice the ratio of the others: the median of their mix lies between.
    for (const Size size : sizes) {
        const double share = coverage(ratio * std::sqrt(2.0), [&](Random& random) {
            Strata above = draw(random, lognormal(0.3), size, ratio);
            for (std::size_t view = 0; view < above.size(); view += 2)
                for (double& value : above[view])
                    value *= 2.0;
            return typical_ratio(above, draw(random, lognormal(0.3), size, 1.0)).ratio;
        });
        EXPECT_GE(share, 0.95 - tolerance(0.95)) << size.seeds;
    }
}

TEST(Coverage, OfATypicalRun) {
    tabulate(
        "typical run",
        [](const Family& family, Size size) {
            Random random(1);
            std::vector<double> values(200000);
            for (double& value : values)
                value = family.above.draw(random);
            return coverage(median(std::move(values)), [&](Random& more) {
                return typical_run(draw(more, family.above, size, 1.0));
            });
        },
        expect_promised);
}

TEST(Coverage, OfEqualTime) {
    // Error times time, where one frame in eight is interrupted.
    const auto time = [](Random& random, Size size, double scale) {
        Strata values(static_cast<std::size_t>(size.views));
        for (std::vector<double>& view : values)
            for (int seed = 0; seed < size.seeds; ++seed)
                view.push_back(std::normal_distribution<double>(10.0, 0.2)(random) * scale *
                               (random() % 8 == 0 ? 5.0 : 1.0));
        return values;
    };
    for (const Tail& tail : {lognormal(2.0), lognormal(3.0), mixture(0.01)})
        for (const Size size : sizes) {
            const double share = coverage(1.1 * ratio, [&](Random& random) {
                return typical_ratio(
                           times(draw(random, tail, size, ratio), time(random, size, 1.1)),
                           times(draw(random, tail, size, 1.0), time(random, size, 1.0)))
                    .ratio;
            });
            expect_promised(share, fmt::format("equal time, {}, {}", tail.name, size.seeds));
        }
}

TEST(Coverage, OfOtherViews) {
    // Views differ by a factor of their own; the truth is the median of all there could be.
    tabulate(
        "other views",
        [](const Family& family, Size size) {
            return coverage(median_of_pairs(family), [&](Random& random) {
                Strata above = draw(random, family.above, size, ratio);
                for (std::vector<double>& view : above) {
                    const double own = std::exp(std::normal_distribution<double>(0.0, 0.5)(random));
                    for (double& value : view)
                        value *= own;
                }
                return ratio_over_views(above, draw(random, family.below, size, 1.0));
            });
        },
        [](double share, const std::string& name) {
            EXPECT_GE(share, least_coverage) << name;
            expect_promised(share, name);
            expect_no_wider_than(0.97, share, name);
        });
}

TEST(Coverage, OfARingsSeeds) {
    // One place, six seeds: the extremes, 1 - 2 / 2^6.
    for (const Tail& tail : {lognormal(2.0), lognormal(3.0)}) {
        const double share = coverage(1.0, [&](Random& random) {
            return median_interval(draw(random, tail, {1, 6}, 1.0).front());
        });
        EXPECT_NEAR(share, 0.96875, tolerance(0.96875)) << tail.name;
    }
}

TEST(Coverage, OfFlightsThatAreInterruptedForManyFramesOn) {
    // Other work comes and goes, for 20 frames on average, and makes frames three times as long.
    const auto flight = [](Random& random, double scale, std::vector<double>& frames) {
        bool is_busy = random() % 4 == 0;
        for (double& frame : frames) {
            if (random() % 20 == 0) is_busy = random() % 4 == 0;
            frame =
                std::normal_distribution<double>(10.0, 0.2)(random) * scale * (is_busy ? 3.0 : 1.0);
        }
    };
    const double share = coverage(1.05, [&](Random& random) {
        constexpr std::size_t frames = 81, flights = 6;
        Strata above(frames, std::vector<double>(flights));
        Strata below = above;
        for (std::size_t i = 0; i < flights; ++i) {
            for (auto [strata, scale] : {std::pair(&above, 1.05), std::pair(&below, 1.0)}) {
                std::vector<double> column(frames);
                flight(random, scale, column);
                for (std::size_t frame = 0; frame < frames; ++frame)
                    (*strata)[frame][i] = column[frame];
            }
        }
        return ratio_over_flights(above, below);
    });
    EXPECT_NEAR(share, 0.96875, tolerance(0.96875));
}

TEST(Coverage, OfMarksInATable) {
    // No row differs: a table of 60 rows has a mark in at most 5 of 100 cases.
    for (const Size size : {Size{4, 4}, Size{4, 6}}) {
        Random random(7);
        int with_marks = 0;
        for (int table = 0; table < experiments / 2; ++table) {
            std::vector<double> chances;
            for (int row = 0; row < 60; ++row)
                chances.push_back(typical_ratio(draw(random, lognormal(2.0), size, 1.0),
                                                draw(random, lognormal(2.0), size, 1.0))
                                      .p);
            with_marks += std::ranges::count(stands_out(chances), true) > 0;
        }
        const double share = 2.0 * with_marks / experiments;
        EXPECT_LE(share, 0.05 + 4.0 * std::sqrt(0.05 * 0.95 * 2.0 / experiments)) << size.seeds;
    }
    // And one that is half of the others is found.
    Random random(8);
    int found = 0;
    for (int table = 0; table < 100; ++table) {
        std::vector<double> chances(60, 1.0);
        chances[17] = typical_ratio(draw(random, lognormal(0.2), {4, 6}, 0.5),
                                    draw(random, lognormal(0.2), {4, 6}, 1.0))
                          .p;
        found += stands_out(chances)[17] ? 1 : 0;
    }
    EXPECT_GT(found, 90);
}

TEST(Coverage, OfMeansIsTooLowToPrint) {
    // Student's t about the mean of the views' means, degrees of freedom by Welch and
    // Satterthwaite: where one run in a hundred decides the mean, most experiments have not seen
    // it.
    const auto t_interval = [](const Strata& values) {
        const auto views = static_cast<double>(values.size());
        double total = 0.0, weighted = 0.0;
        for (const std::vector<double>& view : values) {
            const auto count = static_cast<double>(view.size());
            double squares = 0.0;
            for (const double value : view)
                squares += std::pow(value - mean_over_views({view}), 2.0);
            const double part = squares / (count - 1.0) / (count * views * views);
            total += part;
            weighted += part * part / (count - 1.0);
        }
        const double half = student_t_quantile(0.975, total * total / weighted) * std::sqrt(total);
        const double center = mean_over_views(values);
        return Interval{center, center - half, center + half};
    };
    tabulate(
        "mean by Student's t",
        [&](const Family& family, Size size) {
            return coverage(family.above.mean, [&](Random& random) {
                return t_interval(draw(random, family.above, size, 1.0));
            });
        },
        [](double share, const std::string& name) { EXPECT_LT(share, least_coverage) << name; });
}

} // namespace vigil::bench
