// SPDX-License-Identifier: GPL-2.0-or-later
// A reference picture that knows its own error: the mean of independent batches, and per value the
// variance of that mean. It is kept in a file, so that a later run goes on where this one stopped.
// It does not render; quality_renderer does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
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

/// FNV-1a, 64 bits; `hash` continues an earlier one. For file names and change detection.
std::uint64_t hash_bytes(std::span<const std::byte> bytes,
                         std::uint64_t hash = 0xcbf29ce484222325u);

} // namespace vigil::bench
