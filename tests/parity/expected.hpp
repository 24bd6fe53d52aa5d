// SPDX-License-Identifier: MIT
//
// Results that an entry promises for a job's inputs.
#pragma once

#include "compare.hpp"

namespace parity {

/// What the twin returns for each of the job's inputs.
[[nodiscard]] inline std::vector<vec4> twin_results(const job& j) {
    std::vector<vec4> all;
    all.reserve(j.count);
    for (std::size_t i = 0; i < j.count; ++i) all.push_back(j.what->twin(j.at(i)));
    return all;
}

/// The twin's results, and what else is allowed.
/// @param flushed_map    the job's map without denormals; null where it has no map
/// @param may_reorder    true for implementations that may reorder sums. Tiers B and C then have to keep their bounds
[[nodiscard]] expectation expect(const job& j, const texels* flushed_map, bool may_reorder);

}  // namespace parity
