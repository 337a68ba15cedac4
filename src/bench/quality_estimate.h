// SPDX-License-Identifier: GPL-2.0-or-later
// Statistics of the quality benchmark: means and ratios over repeated, stratified measurements with
// their confidence intervals, and the error of a picture against a noisy reference. A stratum is a
// view, a repeat a seed. No GPU, no files; what the intervals assume is in docs/quality.md.
#pragma once

#include "bench/reference.h"

#include <span>
#include <vector>

namespace vigil::bench {

/// An estimate and its 95% confidence interval; low and high are NaN where the data do not give one
/// (one seed, or an estimate that is not positive where a ratio needs it).
struct Interval {
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
};

/// Measurements by view and seed, [view][seed]; every view has at least one.
using Strata = std::vector<std::vector<double>>;

/// x with P(T <= x) = probability for Student's t with `degrees` > 0 degrees of freedom (not
/// necessarily whole), for |x| < 40: relative error below 1e-5. `probability` in (0, 1).
double student_t_quantile(double probability, double degrees);

/// Mean of the views' means. The interval is about the seeds, for these very views: Student's t
/// with the degrees of freedom of Welch and Satterthwaite.
Interval mean_interval(const Strata& values);

/// mean(numerators) / mean(denominators), measured in pairs: the same view and seed of two
/// techniques. The interval is about the seeds: delta method on the logarithm of the ratio.
Interval ratio_interval(const Strata& numerators, const Strata& denominators);

/// Geometric mean of the views' own ratios, and an interval about other views like these: Student's
/// t over the logarithms, views - 1 degrees of freedom.
Interval ratio_over_views(const Strata& numerators, const Strata& denominators);

/// Median of paired ratios of times, for which single repeats can be far off. The interval is that
/// of the order statistics (binomial, no assumption on the distribution), NaN below six pairs.
Interval median_ratio(const Strata& numerators, const Strata& denominators);

/// a * b of independent, positive estimates whose intervals are as wide on both sides of the value
/// on a logarithmic scale: the widths' squares add up. NaN bounds where one of them has none.
Interval product(const Interval& a, const Interval& b);

/// The same interval widened by an independent error with this standard error.
Interval widened(const Interval& interval, double standard_error);

double median(std::vector<double> values);

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

/// When a curve of errors has settled: `level` is the mean of its last `tail` values, `frame`
/// counts from 1 and is the first from which all are at most `factor` times the level.
struct Settled {
    double level = 0.0;
    int frame = 0;
};
Settled settle(std::span<const double> curve, int tail, double factor);

} // namespace vigil::bench
