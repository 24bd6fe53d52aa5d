// SPDX-License-Identifier: MIT
//
// Split distances, which divide a camera's range into cascades.
//
//     auto splits = umbrage::practical_splits<4>(0.5f, 300.0f, 0.9f);  // five distances, from 0.5 to 300
//
// Any increasing distances work, such as your own. You can also replace the first distance of these, so that the space
// right in front of the camera claims no cascades.
// Also called: practical split scheme, PSSM splits, lambda, split distances (practical_splits).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <umbrage/core/check.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

/// Split distances between uniform and logarithmic ones (practical split scheme).
///
/// Logarithmic splits grow by one factor, so that a texel covers the same number of pixels in every cascade.
/// @tparam Count           number of cascades
/// @param z_near           distance along the camera's axis, world units, 0 < z_near < z_far
/// @param z_far            distance along the camera's axis, world units
/// @param lambda           0 for uniform, 1 for logarithmic splits
/// @return                 Count + 1 distances, strictly increasing; the first and the last are z_near and z_far
/// @throws std::invalid_argument  values outside these ranges; a range too short to be split
/// @formula                lambda n (f / n)^(i / Count) + (1 - lambda) (n + (f - n) i / Count)
/// @cite                   Zhang, Sun, Xu, Lun: Parallel-split shadow maps for large-scale virtual environments, 2006
template <std::size_t Count, real T>
[[nodiscard]] std::array<T, Count + 1> practical_splits(T z_near, T z_far, T lambda) {
    static_assert(Count > 0);
    constexpr auto function = "practical_splits";
    detail::require(is_finite(z_near) && z_near > T(0), function, "z_near", "finite and above 0", z_near);
    detail::require(is_finite(z_far) && z_far > z_near, function, "z_far", "finite and above z_near", z_far);
    detail::require(is_finite(lambda) && lambda >= T(0) && lambda <= T(1), function, "lambda", "from 0 to 1", lambda);
    const double n = static_cast<double>(z_near), f = static_cast<double>(z_far), log_n = std::log(n);
    const double share = static_cast<double>(lambda), log_range = std::log(f) - log_n;  // f / n may overflow
    std::array<T, Count + 1> splits;
    splits[0] = z_near;
    for (std::size_t i = 1; i < Count; ++i) {
        const double at = static_cast<double>(i) / static_cast<double>(Count);
        splits[i] = static_cast<T>(share * std::exp(log_n + log_range * at) + (1 - share) * (n + (f - n) * at));
    }
    splits[Count] = z_far;
    for (std::size_t i = 0; i < Count; ++i)
        detail::require(splits[i] < splits[i + 1], function, "z_near and z_far", "farther apart",
                        glm::vec<2, T>(z_near, z_far));
    return splits;
}

}  // namespace umbrage
