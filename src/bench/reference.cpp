// SPDX-License-Identifier: GPL-2.0-or-later
// File: a line of text with the format's name, the key in a second line, then the number of batches
// and of values (64 bits) and the arrays in the machine's byte order; a cache for this machine.
#include "bench/reference.h"

#include "common/output.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numeric>

namespace vigil::bench {

namespace {

std::string header(const std::string& key, std::uint64_t batches, std::uint64_t values) {
    std::string text = "vigil reference 1\n" + key + "\n";
    for (const std::uint64_t count : {batches, values})
        text.append(reinterpret_cast<const char*>(&count), sizeof(count));
    return text;
}

void append(std::string& text, const std::vector<double>& values) {
    text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
}

void take(const char*& cursor, std::vector<double>& values) {
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
    // The key is compared as a part of the header that this picture would have.
    std::uint64_t count = 0;
    const std::size_t begin = header(key, 0, means_.size()).size();
    if (text.size() < begin) return false;
    std::memcpy(&count, text.data() + begin - 2 * sizeof(count), sizeof(count));
    if (text.compare(0, begin, header(key, count, means_.size())) != 0) return false;
    if ((text.size() - begin) / sizeof(double) != count + 2 * means_.size()) return false;
    const char* cursor = text.data() + begin;
    batch_means_.resize(count);
    take(cursor, batch_means_);
    take(cursor, means_);
    take(cursor, squares_);
    return true;
}

void Reference::save(const std::filesystem::path& path, const std::string& key) const {
    std::string text = header(key, batch_means_.size(), means_.size());
    append(text, batch_means_);
    append(text, means_);
    append(text, squares_);
    write_file(path, text);
}

std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t hash) {
    for (const std::byte byte : bytes)
        hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3u;
    return hash;
}

} // namespace vigil::bench
