// SPDX-License-Identifier: MIT
//
// Placement of maps for a camera. A directional light's single map is fitted tightly, warped, or chosen as the best.
// A point light has the maps of a cube, two paraboloids or a tetrahedron. Independent of OpenGL.
//
//     viewer::sun_map map = viewer::place_map("best", fit, seen, terms, kept);
//     viewer::lamp_maps maps = viewer::place_lamp("cube", position, range, 2048, reach);
//
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/light/light_choice.hpp>
#include <umbrage/light/warp/warp_fit.hpp>

namespace viewer {

inline constexpr std::string_view in_cascades = "cascades";  ///< four maps in place of the one,
inline constexpr std::string_view in_pages = "pages";        ///< an adaptive one
inline constexpr std::string_view in_cube = "cube", in_paraboloids = "paraboloid", in_tetrahedron = "tetrahedron";
inline constexpr std::array lamp_placements{in_cube, in_paraboloids, in_tetrahedron};

/// These, what place_map takes, and what place_lamp does.
[[nodiscard]] const std::vector<std::string>& placement_names();

[[nodiscard]] bool is_lamp(std::string_view placement);

/// True when there is more than one map, or a map of parts.
[[nodiscard]] bool has_parts(std::string_view placement);

struct sun_map {
    umbrage::light_space<double> light;
    std::string note;  ///< for people: what came of it
};

/// @param placement   one of placement_names() but cascades, pages and a lamp's
/// @param seen        points by which "best" measures maps
/// @param kept        which map was the best in the last picture, and then in this one
[[nodiscard]] sun_map place_map(std::string_view placement, const umbrage::warp_fit<double>& fit,
                                std::span<const umbrage::seen_point> seen, const umbrage::choice_terms& terms,
                                std::size_t& kept);

struct lamp_maps {
    int size, layers;                                  ///< texels along an edge of each
    int border;                                        ///< texels that filters read beyond a face
    std::vector<umbrage::light_space<double>> passes;  ///< faces, of a layer each or all of one; each paraboloid's
};

/// @param placement   one of lamp_placements
/// @param texels      as many as a square with this edge has, at least 32
/// @param reach       reach of the filter, texels
[[nodiscard]] lamp_maps place_lamp(std::string_view placement, glm::dvec3 position, double range, int texels,
                                   float reach);

}  // namespace viewer
