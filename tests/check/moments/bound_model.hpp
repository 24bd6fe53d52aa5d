// SPDX-License-Identifier: MIT
//
// Visibility from moments of depth, umbrage::chebyshev() and reduce_light_bleeding(), with slips.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "../verdict.hpp"

namespace check {

/// What the second channel of a map of moments holds, beside the mean of depths in the first.
enum class second_channel { mean_square, deviation, half_deviation, variance };
inline constexpr second_channel second_channels[]{second_channel::mean_square, second_channel::deviation,
                                                  second_channel::half_deviation, second_channel::variance};

/// The second channel for depths of this mean and variance.
[[nodiscard]] float second_of(second_channel, float mean, float variance);

struct bound_model {
    second_channel second = second_channel::mean_square;
    bool reversed = false;   ///< lit where the receiver is at the mean or beyond
    bool in_shadow = false;  ///< 1 in shadow, 0 lit
    bool one_sided = true;   ///< receivers nearer than the mean are lit; false: they are not compared with it
    double min_variance = 0;
    double from = 0, to = 1;  ///< of the bound, stretched to [0, 1]

    /// In reals, as functions differ in how they round.
    [[nodiscard]] double operator()(glm::vec2 moments, float receiver) const;
    /// The library's function with these numbers and without slips, to the bit.
    [[nodiscard]] float own(glm::vec2 moments, float receiver) const;
    /// Chebyshev's bound from a result; nothing where it is cut off.
    [[nodiscard]] std::optional<double> bound_of(float result) const;
    /// "chebyshev(1e-06), reduce_light_bleeding(0.1)"
    [[nodiscard]] std::string name() const;
    [[nodiscard]] std::vector<finding> slips() const;
};

}  // namespace check
