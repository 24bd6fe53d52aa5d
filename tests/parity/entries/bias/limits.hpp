// SPDX-License-Identifier: MIT
//
// Limits of biases: 2^-64, 2 and 2^64, and the neighboring floats.
#pragma once

#include <array>
#include <cmath>

#include "../entries.hpp"

namespace parity {

[[nodiscard]] inline float limit(std::uint64_t i) {
    constexpr std::array limits{0x1p-64f, 2.0f, 0x1p64f};
    const float v = limits[i / 2 % 3], beside[] = {v, std::nextafter(v, 0.0f), std::nextafter(v, 0x1p65f)};
    return (i % 2 ? -1.0f : 1.0f) * beside[i / 6 % 3];
}

/// The kinds of special_values, and one more.
[[nodiscard]] inline std::vector<value_class> values_and_limits() {
    auto kinds = special_values();
    kinds.push_back({"limits", [](std::uint64_t i, random&) { return limit(i); }});
    return kinds;
}

}  // namespace parity
