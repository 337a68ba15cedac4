// SPDX-License-Identifier: GPL-2.0-or-later
// A reference picture that knows its own error: the mean of independent batches, and per value the
// variance of that mean. It is kept in a file, so that a later run goes on where this one stopped.
// It does not render; quality_renderer does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace vigil::bench {

class Reference {
public:
    /// A picture of `values` = pixels x 3 values without any batch yet.
    explicit Reference(std::size_t values) : means_(values), squares_(values) {}

    /// Adds the mean picture of one batch; all batches have equally many paths.
    void add(std::span<const float> picture);

    std::size_t values() const { return means_.size(); }
    int batches() const { return static_cast<int>(batch_means_.size()); }
    /// Mean of value i over the batches.
    double mean(std::size_t i) const { return means_[i]; }
    /// Estimated variance of mean(i), from how the batches differ; needs two of them.
    double variance(std::size_t i) const {
        const auto count = static_cast<double>(batches());
        return squares_[i] / (count * (count - 1.0));
    }
    /// variance() averaged over the picture: what the reference adds to every MSE.
    double mean_variance() const;
    /// Mean over the picture, and the standard error of it.
    double picture_mean() const;
    double picture_mean_error() const;

    /// Reads what save() wrote for exactly this key; returns false and changes nothing where there
    /// is no such file, or a damaged one, or one of another key or size.
    bool load(const std::filesystem::path& path, const std::string& key);
    /// The same with the bytes of the file.
    bool parse(std::span<const std::byte> file, const std::string& key);
    /// Writes the file whole. Throws Error.
    void save(const std::filesystem::path& path, const std::string& key) const;

private:
    // Welford's recurrence: mean, and sum of squared differences from it.
    std::vector<double> means_, squares_;
    std::vector<double> batch_means_; // of whole pictures
};

/// Batches of a pilot, whose variance decides how many batches a reference gets.
inline constexpr int pilot_batches = 6;

/// So many batches as good as the pilot's have a mean of this variance; from 2 to `most`, and
/// `most` where the variance is not positive.
int batches_for(const Reference& pilot, double variance, int most);

/// Where batches come from, and who decides how many there are.
struct ReferenceSource {
    /// The mean picture of a batch; another number, other random numbers. Pilots have numbers of
    /// their own, from first_pilot_number on.
    std::function<std::vector<float>(int number)> batch;
    std::function<int(const Reference& pilot)> batches_wanted;
    std::function<void(bool is_pilot)> added; // called after every batch
};
inline constexpr int first_pilot_number = 1 << 24;

/// Completes the pilot, then the reference until it has the batches wanted. A reference that
/// stopped when its own batches looked good would stop before a rare bright one, and be too dark;
/// so batches of the pilot decide, and are not part of it. Both may have batches already.
void complete_reference(Reference& pilot, Reference& reference, const ReferenceSource& source);

/// FNV-1a, 64 bits; `hash` continues an earlier one. For file names and change detection.
std::uint64_t hash_bytes(std::span<const std::byte> bytes,
                         std::uint64_t hash = 0xcbf29ce484222325u);

} // namespace vigil::bench
