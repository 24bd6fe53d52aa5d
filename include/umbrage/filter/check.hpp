// SPDX-License-Identifier: MIT
//
// Checks of a filter's numbers, for functions that take the filter for many lookups. A filter alone does not check.
#pragma once

#include <cmath>
#include <string_view>

#include <umbrage/core/check.hpp>
#include <umbrage/filter/blocker/dpcf.hpp>
#include <umbrage/filter/blocker/pcss.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/filter/pcf/disc.hpp>
#include <umbrage/filter/pcf/windows.hpp>

namespace umbrage::detail {

/// Refuses a number of points for which there is no disc.
inline void require_points(std::string_view function, int points) {
    require(points == 8 || points == 16 || points == 32, function, "filter.points", "8, 16 or 32", points);
}

/// Refuses what make_penumbra_params never makes. With other radii, an image's receivers and one alone would differ.
inline void require_softness(std::string_view function, const penumbra_params& softness) {
    require(is_finite(softness.per_code) && softness.per_code >= 0.0f && softness.per_code <= 4096.0f, function,
            "filter.softness.per_code", "from 0 to 4096", softness.per_code);
    const float low = softness.min_radius, high = softness.max_radius;
    const bool in_order = is_finite(low) && is_finite(high) && low >= 0.0f && low <= high && high <= 4095.0f;
    require(in_order && low == std::floor(low) && high == std::floor(high), function,
            "filter.softness.min_radius and max_radius", "integers in order, from 0 to 4095", glm::vec2(low, high),
            "They are in 1/16 texel: make_penumbra_params computes them.");
}

inline void require_filter(std::string_view function, const filters::window& filter) {
    require(is_made_row(filter.row), function, "filter.row", "of make_window_row", filter.row.size,
            "That is its size; its weights, steps and whole count, too.");
}
inline void require_filter(std::string_view function, const filters::disc& filter) {
    require_points(function, filter.points);
}
inline void require_filter(std::string_view function, const filters::pcss& filter) {
    require_points(function, filter.points);
    require_softness(function, filter.softness);
}
inline void require_filter(std::string_view function, const filters::dpcf& filter) {
    require_points(function, filter.points);
    require_softness(function, filter.softness);
}

}  // namespace umbrage::detail
