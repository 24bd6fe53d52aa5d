// SPDX-License-Identifier: MIT
//
// Sorts an entry's results on an implementation by how they agree with C++. All tables and pages use these words.
#pragma once

#include <string_view>

#include "compare.hpp"

namespace parity {

/// identical: the same bits; NaN equals NaN. as promised: accepted by compare(): a flushed denormal, -0 for 0, an error
/// within the bound. different: anything else.
enum class verdict { identical, as_promised, different };

inline constexpr std::string_view verdict_names[]{"identical", "as promised", "different"};

/// The worst verdict of the results.
[[nodiscard]] inline verdict verdict_of(const tally& t) {
    if (t.different > 0) return verdict::different;
    return t.identical == t.total ? verdict::identical : verdict::as_promised;
}

}  // namespace parity
