// SPDX-License-Identifier: MIT
//
// Probes an implementation's arithmetic: fusing, rounding, denormals, NaN. Small shaders run on any back end that
// compiles.
//
//     for (const std::string& line : described(probe(backend, dialect))) std::cout << line << '\n';
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "backend.hpp"

namespace parity {

/// Results of a probe. An empty optional was not probed: the dialect or the implementation lacks the feature.
struct observed_arithmetic {
    /// Changes of an expression by the compiler, without and with a `precise` variable. Dialects without `precise` have
    /// the same value in both.
    struct liberty {
        bool plain = false, precise = false;
        bool operator==(const liberty&) const = default;
    };
    liberty fuses;         ///< a * b + c rounds once
    liberty reassociates;  ///< (a + b) - a is b

    std::int64_t sum_ulp = 0, product_ulp = 0;  ///< largest error over random values
    std::int64_t quotient_ulp = 0, root_ulp = 0, inverse_root_ulp = 0, exp2_ulp = 0;

    bool flushes_inputs = false, flushes_results = false;  ///< denormals to zero
    bool keeps_minus_zero = false, keeps_infinity = false;
    bool sees_nan_unequal = false;       ///< a != a
    bool sees_nan_not_less = false;      ///< !(a < b)
    std::optional<bool> sees_nan_isnan;  ///< isnan(a)

    enum class store { rounds, truncates, neither };
    store unorm8_store = store::neither;
    std::optional<std::int64_t> unorm8_read_ulp;  ///< error of reading k / 255

    int highp_bits = 0;  ///< bits of the significand with its leading 1: 24 in a 32-bit float
    std::optional<int> mediump_bits;
    std::optional<int> weight_bits;  ///< fractional bits of a linear comparison sampler's weight
};

/// @throws std::runtime_error   with the compiler's words
[[nodiscard]] observed_arithmetic probe(backend& b, dialect d);

/// One line of text per property.
[[nodiscard]] std::vector<std::string> described(const observed_arithmetic& a);

}  // namespace parity
