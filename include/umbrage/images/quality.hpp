// SPDX-License-Identifier: MIT
//
// How good a light's set-up is for a view: pixels that a texel's longer axis covers, 1 or less where the map resolves
// what the screen does. As an image, and in five numbers.
//
//     auto report = umbrage::measure_quality({.screen = size, .map_size = {2048, 2048}}, [&](glm::ivec2 pixel) {
//         return umbrage::pixels_per_texel(to_texels, to_pixels, position[pixel], normal[pixel]);
//     });
//     std::printf("mean %.2f, 95 of 100 below %.2f, greatest %.2f\n", report.mean, report.p95, report.greatest);
//
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/algorithm.hpp>
#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace umbrage {

/// How far on the screen a texel's step goes.
///
/// @param texture_matrix   world to texels: the light's
/// @param to_pixels        world to pixels: texture_matrix of the camera
/// @param world, normal    a point before both, and its surface's normal there, of any length > 0
/// @return                 columns: the pixels of a step of one texel in x and in y; not finite where the surface is
///                         parallel to the light
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

/// The longer axis of a texel's image on the screen, an ellipse's.
/// @param pixels   pixels_per_texel
/// @return         its greatest singular value
/// @formula        s^2 = (t + sqrt(t^2 - 4 det^2)) / 2, t the sum of the squares
template <real T>
[[nodiscard]] T longest_extent(const glm::mat<2, 2, T>& pixels) {
    const T a = pixels[0][0], b = pixels[1][0], c = pixels[0][1], d = pixels[1][1];
    // t +- 2 det as sums of squares, of which no difference loses digits
    return (std::hypot(a + d, b - c) + std::hypot(a - d, b + c)) / T(2);
}

/// A set-up in numbers, over all pixels that were measured.
struct quality_report {
    double mean = 0, p95 = 0, greatest = 0;  ///< of longest_extent, pixels
    double storage_factor = 0;               ///< texels over pixels, of maps that would resolve all of the screen
    std::size_t measured = 0, skipped = 0;   ///< pixels; skipped: of surfaces parallel to the light
};

/// What a set-up is measured over.
struct measured_view {
    glm::ivec2 screen{1};    ///< pixels, each >= 1
    glm::ivec2 map_size{1};  ///< texels of a map, each >= 1
    int maps = 1;            ///< how many of them there are: cascades
    int step = 1;            ///< from pixel to pixel, >= 1
};

/// Measures a set-up over a view.
///
/// @param at        (glm::ivec2 pixel) -> pixels_per_texel of the map that the pixel looks into, float or double; of
///                  zeros where there is nothing to see
/// @param extents   gets longest_extent of each pixel measured, 0 where there was nothing to measure; empty, or of the
///                  screen's size over the step, rounded up
/// @throws std::invalid_argument  sizes and counts below 1, extents of another size
/// @formula         storage_factor = maps (width max |dp/dx|) (height max |dp/dy|) / pixels, dp/dx and dp/dy columns
/// @cite            Lloyd, Govindaraju, Quammen, Molnar, Manocha: Practical Logarithmic Rasterization for Low-Error
///                  Shadow Maps, Graphics Hardware 2007
template <class At>
[[nodiscard]] quality_report measure_quality(const measured_view& view, At&& at, image_view<float> extents = {}) {
    constexpr auto function = "measure_quality";
    const auto [screen, map_size, maps, step] = view;
    detail::require(screen.x >= 1 && screen.y >= 1, function, "screen", "above 0", screen);
    detail::require(map_size.x >= 1 && map_size.y >= 1, function, "map_size", "above 0", map_size);
    detail::require(maps >= 1, function, "maps", "above 0", maps);
    detail::require(step >= 1, function, "step", "above 0", step);
    const glm::ivec2 size((screen.x - 1) / step + 1, (screen.y - 1) / step + 1);
    const bool draws = extents.size != glm::ivec2(0);
    detail::require(!draws || extents.size == size, function, "extents.size",
                    std::string("empty or the screen's over the step, ").append(detail::printed(size)), extents.size);
    quality_report report;
    std::vector<double> all;
    glm::dvec2 longest(0);
    double sum = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::dmat2 pixels(at(glm::ivec2(x, y) * step));
            if (draws) extents[{x, y}] = 0.0f;
            if (pixels == glm::dmat2(0)) continue;
            const double extent = longest_extent(pixels);
            if (!is_finite(extent)) {
                ++report.skipped;
                continue;
            }
            if (draws) extents[{x, y}] = static_cast<float>(extent);
            all.push_back(extent);
            sum += extent;
            longest = detail::greater(longest, glm::dvec2(glm::length(pixels[0]), glm::length(pixels[1])));
        }
    report.measured = all.size();
    if (all.empty()) return report;
    report.mean = sum / double(all.size());
    report.greatest = detail::ranked(all, all.size() - 1);
    report.p95 = detail::ranked(all, static_cast<std::size_t>(double(all.size() - 1) * 0.95));
    report.storage_factor = maps * (map_size.x * longest.x) * (map_size.y * longest.y) / (double(screen.x) * screen.y);
    return report;
}

}  // namespace umbrage
