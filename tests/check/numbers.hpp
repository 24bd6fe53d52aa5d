// SPDX-License-Identifier: MIT
//
// Random numbers that are the same on every machine, and short forms of numbers.
#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <string>

#include <umbrage/core/scalar.hpp>

namespace check {

/// Marsaglia's xorshift. The distributions of the standard library differ between machines.
class dice {
public:
    explicit dice(std::uint32_t seed) : state_(seed * 2654435761u + 1u) {}
    [[nodiscard]] std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(unit() * float(count)); }
    /// In [0, 1), a multiple of 2^-24.
    [[nodiscard]] float unit() {
        state_ ^= state_ << 13, state_ ^= state_ >> 17, state_ ^= state_ << 5;
        return static_cast<float>(state_ >> 8) * 0x1p-24f;
    }

private:
    std::uint32_t state_;
};

/// The same bits, or both NaN; 0 and -0 are the same.
[[nodiscard]] inline bool same_bits(float a, float b) { return a == b || (umbrage::is_nan(a) && umbrage::is_nan(b)); }

/// As few digits as show a slip: 0.5, -1, 0.00499.
[[nodiscard]] inline std::string shortened(double v) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.4g", v);
    return digits;
}

/// Digits from which the float comes back.
[[nodiscard]] inline std::string exact(float v) {
    char digits[32];
    for (int count : {6, 9}) {
        std::snprintf(digits, sizeof digits, "%.*g", count, double(v));
        float back = 0;
        if (std::sscanf(digits, "%f", &back) == 1 && back == v) break;
    }
    return digits;
}

}  // namespace check
