// SPDX-License-Identifier: GPL-2.0-or-later
// Random numbers of the tests: a 32-bit Mersenne Twister, the same numbers on every platform.
// Quality beyond that is not asked for here.
#pragma once

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace vigil::test {

class Dice {
public:
    explicit Dice(uint32_t seed) : engine_(seed) {}
    uint32_t word() { return static_cast<uint32_t>(engine_()); }
    /// 0 .. limit - 1.
    uint32_t below(uint32_t limit) { return static_cast<uint32_t>(uint64_t{limit} * word() >> 32); }
    bool chance(double probability) { return word() < probability * 4294967296.0; }
    /// In [lowest, highest).
    float between(float lowest, float highest) {
        return lowest + (highest - lowest) * static_cast<float>(word() >> 8) / 16777216.0f;
    }
    template <typename T> void shuffle(std::vector<T>& values) {
        for (auto left = static_cast<uint32_t>(values.size()); left > 1; --left)
            std::swap(values[left - 1], values[below(left)]);
    }

private:
    std::mt19937 engine_;
};

} // namespace vigil::test
