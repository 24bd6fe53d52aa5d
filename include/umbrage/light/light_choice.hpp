// SPDX-License-Identifier: MIT
//
// Choice of the shadow map that serves a view best: a warp where it pays, else a uniform map. The choice does not
// flicker.
//
//     // one receiver in 64 x 64 pixels or so. Points that the camera saw a frame ago will do
//     std::vector<umbrage::seen_point> seen = ...;
//     const std::array lights{umbrage::fit_directional_light(tight), umbrage::fit_light_space_perspective(fit).light};
//     choice = umbrage::choose_light<float>(lights, seen, {.to_pixels = pixels, .map_size = map.size()}, choice.kept);
//     draw_depths(lights[choice.kept]);
//
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/pixels_per_texel.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace umbrage {

/// Point of a visible surface, in world units.
struct seen_point {
    glm::dvec3 position{0};
    glm::dvec3 normal{0, 1, 0};  ///< any length > 0
};

/// Settings of choose_light.
struct choice_terms {
    glm::dmat4 to_pixels{1};  ///< world to pixels: texture_matrix of the camera
    glm::ivec2 map_size{1};   ///< texels, each >= 1
    double better = 0.1;      ///< share by which another light must be better to replace the present one, 0 .. 1
};

/// Light to use, and how well each light does.
struct light_choice {
    std::size_t kept = 0;     ///< index of the light to use
    std::vector<double> p95;  ///< per light: pixels that a texel's longer axis covers at 95 of 100 points, at most.
                              ///< The largest double if the map has fewer of them, 0 without points
};

/// Measures each light over the points. Keeps the present light unless another is better by a margin.
///
/// @param lights   one or more, of any kinds
/// @param seen     coarse grid of points over the screen; some hundred suffice. Surfaces parallel to the light are
///                 skipped
/// @param terms    camera's matrix, size of the map, and the margin
/// @param before   index of the present light: light_choice::kept
/// @throws std::invalid_argument  no lights; before out of range; map_size below 1; better out of range; a matrix that
///                                is not finite
template <real T>
[[nodiscard]] light_choice choose_light(std::span<const light_space<T>> lights, std::span<const seen_point> seen,
                                        const choice_terms& terms, std::size_t before = 0) {
    constexpr auto function = "choose_light";
    detail::require(!lights.empty(), function, "lights", "one light or more", lights.size());
    detail::require(before < lights.size(), function, "before", "the index of one of the lights", before);
    detail::require(terms.map_size.x >= 1 && terms.map_size.y >= 1, function, "map_size", "above 0", terms.map_size);
    detail::require(terms.better >= 0 && terms.better <= 1, function, "better", "from 0 to 1", terms.better);
    detail::require(detail::all_finite(terms.to_pixels), function, "to_pixels", "finite", terms.to_pixels);
    light_choice choice{before, {}};
    for (const light_space<T>& light : lights) {
        const glm::dmat4 to_texels =
            texture_matrix<double>({glm::dmat4(light.view), glm::dmat4(light.projection), light.clip}, terms.map_size);
        std::vector<double> extents;
        for (const seen_point& p : seen) {
            const glm::dvec4 h = shadow_coordinate(to_texels, p.position);
            const glm::dvec2 at = glm::dvec2(h) / h.w;
            const bool held = h.w > 0 && at.x >= 0 && at.y >= 0 && at.x <= terms.map_size.x && at.y <= terms.map_size.y;
            const double extent = longest_extent(pixels_per_texel(to_texels, terms.to_pixels, p.position, p.normal));
            if (!held) extents.push_back(detail::highest<double>);
            else if (is_finite(extent)) extents.push_back(extent);
        }
        choice.p95.push_back(0);
        if (extents.empty()) continue;
        const auto p95 = extents.begin() + static_cast<std::ptrdiff_t>(double(extents.size() - 1) * 0.95);
        std::nth_element(extents.begin(), p95, extents.end());
        choice.p95.back() = *p95;
    }
    std::size_t best = 0;
    for (std::size_t i = 1; i < lights.size(); ++i)
        if (choice.p95[i] < choice.p95[best]) best = i;
    if (choice.p95[best] < choice.p95[before] * (1 - terms.better)) choice.kept = best;
    return choice;
}

}  // namespace umbrage
