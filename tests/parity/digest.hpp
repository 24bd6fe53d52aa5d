// SPDX-License-Identifier: MIT
//
// Digest of what an entry's twin gives. -0 counts as 0, and every NaN as one, in inputs too. Inputs depend only on the
// entry and the number of its map, not on its position.
#pragma once

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "../proof/hostile/digest.hpp"
#include "backend.hpp"

namespace parity {

/// Every NaN as the quiet one: 32-bit x86 returns no other.
[[nodiscard]] inline vec4 quiet(vec4 v) {
    for (int c = 0; c < 4; ++c)
        if (std::isnan(v[c])) v[c] = std::numeric_limits<float>::quiet_NaN();
    return v;
}

/// Name, number of inputs and digest, parted by tabs.
/// @param count   inputs of each map and of the enumeration
[[nodiscard]] inline std::string digest_line(const entry& e, std::size_t count) {
    hostile::digest sum;
    std::size_t inputs = 0;
    const auto take = [&](const job& j) {
        inputs += j.count;
        for (std::size_t i = 0; i < j.count; ++i) {
            sample s = j.at(i);
            for (vec4& x : s.x) x = quiet(x);
            const vec4 result = e.twin(s);
            sum(quiet(result));
        }
    };
    if (e.maps.empty()) take(make_job(e, nullptr, 0, count, 0));
    for (const texels& map : e.maps)
        take(make_job(e, &map, 0, count, static_cast<std::uint64_t>(&map - e.maps.data())));
    if (e.whole.count) take(make_whole_job(e, 0, std::min<std::size_t>(count, e.whole.count), 0));
    char numbers[64];
    std::snprintf(numbers, sizeof numbers, "\t%zu\t%016" PRIx64, inputs, sum.unsigned_zeros);
    return e.name() + numbers;
}

}  // namespace parity
