// SPDX-License-Identifier: MIT
//
// Results that an entry promises for a job's inputs.
#pragma once

#include "compare.hpp"

namespace parity {

/// The twin's results.
/// @param flushed_map    the job's map without denormals; null where it has no map
/// @param may_reorder    true for implementations that may reorder sums. Tiers B and C then have to keep their bounds
[[nodiscard]] expectation expect(const job& j, const texels* flushed_map, bool may_reorder);

}  // namespace parity
