// SPDX-License-Identifier: MIT
//
// Checks of a filter's numbers, for functions that take the filter for many lookups. A filter alone does not check.
#pragma once

#include <string_view>

#include <umbrage/core/check.hpp>
#include <umbrage/filter/blocker/dpcf.hpp>
#include <umbrage/filter/blocker/pcss.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/filter/pcf/disc.hpp>

namespace umbrage::detail {

/// Refuses a number of points for which there is no disc.
inline void require_points(std::string_view function, int points) {
    require(points == points_of_disc(points).count(), function, "filter.points", "8, 16 or 32", points);
}

inline void require_filter(std::string_view function, const filters::disc& filter) {
    require_points(function, filter.points);
}
inline void require_filter(std::string_view function, const filters::pcss& filter) {
    require_points(function, filter.points);
}
inline void require_filter(std::string_view function, const filters::dpcf& filter) {
    require_points(function, filter.points);
}

}  // namespace umbrage::detail
