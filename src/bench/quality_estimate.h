// SPDX-License-Identifier: GPL-2.0-or-later
// Statistics of the quality benchmark: what repeated measurements by view and seed say, and the
// error of a picture against a noisy reference. Squared errors have heavy tails, so an interval is
// about the typical run (a median), never about a mean; docs/research/quality.md says why. No GPU,
// no files.
#pragma once

#include "bench/reference.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace vigil::bench {

/// An estimate and its 95% confidence interval; low and high are NaN where the data do not give
/// one.
struct Interval {
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
};

/// Measurements by view and seed, [view][seed]; every view has at least one.
using Strata = std::vector<std::vector<double>>;

/// Fewest views for an interval over runs: few places do not speak for a level.
inline constexpr std::size_t least_views = 4;

/// x with P(T <= x) = probability for Student's t with `degrees` >= 1 degrees of freedom (not
/// necessarily whole), for |x| < 40: relative error below 1e-5. `probability` in (0, 1).
double student_t_quantile(double probability, double degrees);

/// Mean of the views' means.
double mean_over_views(const Strata& values);

/// mean_over_views of both, divided; NaN where one of them is not positive.
double ratio_of_means(const Strata& numerators, const Strata& denominators);

/// Median of independent repeats. The interval is that of the order statistics: it holds for any
/// distribution, and for repeats of different distributions it is about the median of their mix
/// (Hoeffding 1956). NaN bounds below six values, of which the extremes hold 96.9%.
Interval median_interval(std::vector<double> values);

/// Median over all runs, about other seeds at these very views: median_interval from least_views
/// on.
Interval typical_run(const Strata& values);

/// How two rows differ in a typical run.
struct Comparison {
    Interval ratio; // as typical_run
    double p = 1.0; // probability of pairs so unevenly split if the median ratio were 1 (sign test)
};

/// Median of numerator / denominator over pairs of the same view and seed. Where a denominator is
/// not positive, all is NaN. `p` needs no least_views: it belongs to these views.
Comparison typical_ratio(const Strata& numerators, const Strata& denominators);

/// Geometric mean over the views of their median ratios, and an interval about other views like
/// these: Student's t over the logarithms, views - 1 degrees of freedom; from least_views on.
Interval ratio_over_views(const Strata& numerators, const Strata& denominators);

/// Median over flights of each flight's median ratio over its frames, [frame][flight]. What else
/// the machine does lasts for many frames, so a flight counts once: six of them have an interval.
Interval ratio_over_flights(const Strata& numerators, const Strata& denominators);

/// Which of a table's comparisons are not chance, by their p: at most 5% of tables name a false one
/// (Holm 1979). NaN is none of the comparisons.
std::vector<bool> stands_out(std::span<const double> p);

/// Products of single runs.
Strata times(const Strata& a, const Strata& b);

/// NaN without values, or where one is NaN.
double median(std::vector<double> values);
/// Each value's mean with the `width` - 1 before it, as far as there are any.
std::vector<double> running_means(std::span<const double> values, std::size_t width);
/// Of all runs.
double median_of(const Strata& values);

/// Share of the reference's light that frames may lack before their errors say too little.
inline constexpr double missing_share = 0.05;

/// Whether the frames of some view hold less light than the reference, by more than missing_share
/// and than chance explains: `mean_ratio` is PictureError's. What they lack comes in few, bright
/// frames that no seed met, and how much those add to the mean error these frames cannot tell.
bool misses_light(const Strata& mean_ratio);

/// Of the pixels, largest errors that trimmed_mse leaves out: fireflies.
inline constexpr double trimmed_share = 0.001;

/// Pixels above so many times the reference's mean are its bright part: what the sun shines on in a
/// cave.
inline constexpr double bright_factor = 4.0;

struct PictureError {
    double mse = 0.0;              // mean over pixels and channels of (x - r)^2 - var(r)
    double trimmed_mse = 0.0;      // mse without the trimmed_share of pixels whose error is largest
    double trimmed_variance = 0.0; // the reference's mean variance in the pixels that are left
    double bright_mse = 0.0;       // mse of the bright part; NaN where there is none
    double bright_variance = 0.0;  // the reference's there
    double relative_mse = 0.0;     // mse with each term over r^2 + relative_floor
    double mean_ratio = 0.0;       // mean(x) / mean(r): shows energy that is lost or made
};

/// The members, by the names that reports have for them.
inline constexpr std::pair<const char*, double PictureError::*> picture_errors[] = {
    {"mse", &PictureError::mse},
    {"trimmed_mse", &PictureError::trimmed_mse},
    {"trimmed_variance", &PictureError::trimmed_variance},
    {"bright_mse", &PictureError::bright_mse},
    {"bright_variance", &PictureError::bright_variance},
    {"relative_mse", &PictureError::relative_mse},
    {"mean_ratio", &PictureError::mean_ratio}};

/// Error of `picture` (RGB, as many values as the reference has; at least two batches), without
/// that of the reference: unbiased for `mse` if the two are independent.
PictureError picture_error(std::span<const float> picture, const Reference& reference);

/// Means over the pictures of a run, of which there must be one.
PictureError mean_error(std::span<const std::vector<float>> pictures, const Reference& reference);

/// Added to r^2 in the relative error: (a tenth of the reference's mean value)^2, so that black
/// pixels do not decide, whatever unit radiance is in.
double relative_floor(const Reference& reference);
/// What the reference's variance would add to the relative MSE, were it not taken off.
double relative_variance(const Reference& reference);

/// Number, from 1, of the first value of a curve from which all are at most `limit`; one more than
/// there are if the last one is above it.
int stays_below(std::span<const double> curve, double limit);

/// What counts as settled: the mean of the last 8 frames; reached at 1.1 times that.
inline constexpr int settled_tail = 8;
inline constexpr double settled_factor = 1.1;
/// The same of a curve after a turn of the lamp, which is longer.
inline constexpr int ring_tail = 20;
inline constexpr double ring_factor = 1.1;

/// When a curve of errors has settled: `level` is the mean of its last `tail` values, `frame`
/// counts from 1 and is the first from which all are at most `factor` times the level.
struct Settled {
    double level = 0.0;
    int frame = 0;
};
Settled settle(std::span<const double> curve, int tail, double factor);

} // namespace vigil::bench
