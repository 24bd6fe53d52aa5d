// SPDX-License-Identifier: MIT
//
// How an implementation's results agree with C++, in the three words that every table and page has.
#pragma once

#include <string_view>

#include "compare.hpp"

namespace parity {

/// identical: the same bits, NaN equal to NaN. as promised: what compare() accepts besides, a flushed denormal, -0 for
/// 0, an error within its bound. different: anything else.
enum class verdict { identical, as_promised, different };

inline constexpr std::string_view verdict_names[]{"identical", "as promised", "different"};

/// The worst of the results'.
[[nodiscard]] inline verdict verdict_of(const tally& t) {
    if (t.different > 0) return verdict::different;
    return t.identical == t.total ? verdict::identical : verdict::as_promised;
}

}  // namespace parity
