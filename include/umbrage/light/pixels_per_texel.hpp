// SPDX-License-Identifier: MIT
//
// Quality of a light setup for a view: screen pixels covered by the longer axis of a shadow map texel. At 1 or less the
// map resolves as much as the screen.
//
//     const glm::mat4 to_texels = umbrage::texture_matrix(light, map_size);
//     float pixels = umbrage::longest_extent(umbrage::pixels_per_texel(to_texels, to_pixels, position, normal));
//
#pragma once

#include <cmath>

#include <glm/mat2x2.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace umbrage {

/// Extent of a texel's step on the screen, in pixels.
///
/// @param texture_matrix   world to texels, of the light
/// @param to_pixels        world to pixels: texture_matrix of the camera
/// @param world            point in front of the camera and the light
/// @param normal           surface normal there, of any length > 0
/// @return                 columns: pixels of a step of one texel in x and in y
/// @edge                   surface parallel to the light: not finite
/// @formula                d(pixel) / d(texel) on the plane through the point
template <real T>
[[nodiscard]] glm::mat<2, 2, T> pixels_per_texel(const glm::mat<4, 4, T>& texture_matrix,
                                                 const glm::mat<4, 4, T>& to_pixels, glm::vec<3, T> world,
                                                 glm::vec<3, T> normal) {
    const auto along = detail::across(detail::unit(normal));
    const auto steps = [&](const glm::mat<4, 4, T>& m) {
        return glm::mat<2, 2, T>(glm::vec<2, T>(detail::step(m, world, along[0])),
                                 glm::vec<2, T>(detail::step(m, world, along[1])));
    };
    const glm::mat<2, 2, T> texels = steps(texture_matrix);
    const T det = glm::determinant(texels);
    const glm::mat<2, 2, T> back(texels[1][1] / det, -texels[0][1] / det, -texels[1][0] / det, texels[0][0] / det);
    return steps(to_pixels) * back;
}

/// Longer axis of the ellipse that a texel covers on the screen, in pixels.
/// @param pixels   from pixels_per_texel
/// @return         its largest singular value
/// @formula        s^2 = (t + sqrt(t^2 - 4 det^2)) / 2, t the sum of the squares
template <real T>
[[nodiscard]] T longest_extent(const glm::mat<2, 2, T>& pixels) {
    const T a = pixels[0][0], b = pixels[1][0], c = pixels[0][1], d = pixels[1][1];
    // t +- 2 det as sums of squares: no difference loses precision
    return (std::hypot(a + d, b - c) + std::hypot(a - d, b + c)) / T(2);
}

}  // namespace umbrage
