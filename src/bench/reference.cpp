// SPDX-License-Identifier: GPL-2.0-or-later
// File: sealed under the format's name and the key; the number of values (64 bits), then the means
// of the batches and the two arrays of values in the machine's byte order. A cache for this
// machine.
#include "bench/reference.h"

#include "common/output.h"
#include "common/sealed.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numeric>

namespace vigil::bench {

namespace {

std::string kind_of(const std::string& key) {
    return "vigil reference 3\n" + key;
}

void append(std::string& text, const std::vector<double>& values) {
    text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
}

void take(const std::byte*& cursor, std::vector<double>& values) {
    std::memcpy(values.data(), cursor, values.size() * sizeof(double));
    cursor += values.size() * sizeof(double);
}

} // namespace

void Reference::add(std::span<const float> picture) {
    const double count = batches() + 1.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < means_.size(); ++i) {
        const auto value = static_cast<double>(picture[i]);
        const double difference = value - means_[i];
        means_[i] += difference / count;
        squares_[i] += difference * (value - means_[i]);
        sum += value;
    }
    batch_means_.push_back(sum / static_cast<double>(means_.size()));
}

double Reference::mean_variance() const {
    const auto count = static_cast<double>(batches());
    return std::accumulate(squares_.begin(), squares_.end(), 0.0) /
           (count * (count - 1.0) * static_cast<double>(squares_.size()));
}

double Reference::picture_mean() const {
    return std::accumulate(batch_means_.begin(), batch_means_.end(), 0.0) / batches();
}

double Reference::picture_mean_error() const {
    const double center = picture_mean();
    double sum = 0.0;
    for (const double mean : batch_means_)
        sum += (mean - center) * (mean - center);
    return std::sqrt(sum / (batches() * (batches() - 1.0)));
}

bool Reference::load(const std::filesystem::path& path, const std::string& key) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return parse(std::as_bytes(std::span(text)), key);
}

bool Reference::parse(std::span<const std::byte> file, const std::string& key) {
    const auto content = unseal(kind_of(key), file);
    if (!content || content->size() < sizeof(std::uint64_t)) return false;
    std::uint64_t values = 0;
    std::memcpy(&values, content->data(), sizeof(values));
    const std::size_t bytes = content->size() - sizeof(values);
    const std::size_t numbers = bytes / sizeof(double);
    // At least one batch, and nothing behind the last number.
    if (values != means_.size() || numbers <= 2 * values || bytes % sizeof(double) != 0)
        return false;
    const std::byte* cursor = content->data() + sizeof(values);
    batch_means_.resize(numbers - 2 * values);
    take(cursor, batch_means_);
    take(cursor, means_);
    take(cursor, squares_);
    return true;
}

void Reference::save(const std::filesystem::path& path, const std::string& key) const {
    const std::uint64_t values = means_.size();
    std::string text(reinterpret_cast<const char*>(&values), sizeof(values));
    append(text, batch_means_);
    append(text, means_);
    append(text, squares_);
    write_file(path, seal(kind_of(key), std::as_bytes(std::span(text))));
}

int batches_for(const Reference& pilot, double variance, int most) {
    const double wanted = pilot.batches() * pilot.mean_variance() / variance;
    if (!(variance > 0.0 && wanted < most)) return most;
    return std::max(2, static_cast<int>(std::ceil(wanted)));
}

void complete_reference(Reference& pilot, Reference& reference, const ReferenceSource& source) {
    while (pilot.batches() < pilot_batches) {
        pilot.add(source.batch(first_pilot_number + pilot.batches()));
        source.added(true);
    }
    const int wanted = source.batches_wanted(pilot);
    while (reference.batches() < wanted) {
        reference.add(source.batch(reference.batches()));
        source.added(false);
    }
}

std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t hash) {
    for (const std::byte byte : bytes)
        hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3u;
    return hash;
}

} // namespace vigil::bench
