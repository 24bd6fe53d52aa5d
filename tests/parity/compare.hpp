// SPDX-License-Identifier: MIT
//
// The one comparison of all back ends.
//
// A and B: bit for bit; C: within an ulp, or the snippet's distance, as where operations are evaluated as written. NaN
// equals NaN. Unless the entry is about bits, -0 equals +0 and a denormal may act as zero, as IEEE 754 hardware modes
// and llvmpipe have it: results of flushed inputs, and flushed results, count as equal. Where an implementation may
// fuse or regroup, `allows` says what else the bounds of B and C promise.
#pragma once

#include <functional>
#include <map>
#include <ostream>

#include "backend.hpp"

namespace parity {

struct tally {
    std::map<std::string, std::uint64_t> inputs;  ///< per class
    std::uint64_t total = 0, different = 0, flushed = 0;
    std::uint64_t identical = 0;  ///< to the bit; NaN equals NaN
    std::uint64_t bounded = 0;    ///< as the bounds of B and C allow
    std::int64_t worst_ulp = 0;
    float worst_distance = 0.0f;  ///< where that is what counts
};

/// Results a twin may have.
struct expectation {
    std::vector<vec4> plain;
    const texels* flushed_map = nullptr;
    std::function<bool(std::size_t input, const vec4& result)> allows{};
};

/// Ulps between a and b; 0 for two NaN, a huge number when one is NaN.
[[nodiscard]] std::int64_t ulp_distance(float a, float b);

/// Denormals replaced by zero of their sign.
[[nodiscard]] float flush(float v);
[[nodiscard]] vec4 flush(vec4 v);
[[nodiscard]] texels flush(texels map);

/// Adds to the tally; describes the first few differences on `log`.
void compare(const job& j, const expectation& expected, const std::vector<vec4>& got, tally& t, std::ostream& log);

}  // namespace parity
