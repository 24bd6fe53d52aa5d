// SPDX-License-Identifier: MIT
//
// Certainty of a ratio. Each round times both programs one right after the other, so a slow machine slows both. It
// gives one ratio. The estimate is the median of the ratios. Its spread is the width of the median's 95 % confidence
// interval over the median. The interval comes from ranks of the sorted ratios (binomial), without assuming a
// distribution. The spread describes one run. Several runs show how far runs differ (compare.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace bench {

struct estimate {
    double median, low, high;
    [[nodiscard]] double spread() const { return (high - low) / median; }
};

[[nodiscard]] inline double median_of_sorted(const std::vector<double>& sorted) {
    const std::size_t n = sorted.size();
    return (sorted[(n - 1) / 2] + sorted[n / 2]) / 2;
}

[[nodiscard]] inline double median(std::vector<double> values) {
    std::ranges::sort(values);
    return median_of_sorted(values);
}

/// Index from either end of the n sorted values between which the median lies with probability 0.95 or more; 0 where
/// n < 6, which is too few for that.
[[nodiscard]] inline std::size_t interval_rank(std::size_t n) {
    const double count = static_cast<double>(n);
    double below = 0;  // probability that at most `rank` of n values lie below the median
    for (std::size_t rank = 0;; ++rank) {
        const double i = static_cast<double>(rank);
        below += std::exp(std::lgamma(count + 1) - std::lgamma(i + 1) - std::lgamma(count - i + 1) -
                          count * std::numbers::ln2);
        if (below > 0.025) return rank == 0 ? 0 : rank - 1;
    }
}

[[nodiscard]] inline estimate estimate_median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t rank = interval_rank(values.size());
    return {median_of_sorted(values), values[rank], values[values.size() - 1 - rank]};
}

}  // namespace bench
