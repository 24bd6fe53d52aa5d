// SPDX-License-Identifier: MIT
//
// How the one map of a sun is placed for what a camera sees: tight around it, warped, or as serves it best. Knows
// nothing of OpenGL.
//
//     viewer::sun_map map = viewer::place_map("best", fit, seen, terms, kept);
//
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/images/light_choice.hpp>
#include <umbrage/light/warp/warp_fit.hpp>

namespace viewer {

inline constexpr std::string_view in_cascades = "cascades";  ///< four maps in place of the one,
inline constexpr std::string_view in_pages = "pages";        ///< an adaptive one

/// These, and what place_map takes.
[[nodiscard]] const std::vector<std::string>& placement_names();

struct sun_map {
    umbrage::light_space<double> light;
    std::string note;  ///< for people: what came of it
};

/// @param placement   one of placement_names() but cascades and pages
/// @param seen        what "best" measures maps by
/// @param kept        which map was the best in the last picture, and then in this one
[[nodiscard]] sun_map place_map(std::string_view placement, const umbrage::warp_fit<double>& fit,
                                std::span<const umbrage::seen_point> seen, const umbrage::choice_terms& terms,
                                std::size_t& kept);

}  // namespace viewer
