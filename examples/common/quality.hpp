// SPDX-License-Identifier: MIT
//
// Quality of a light's setup for a view, as an image and as five numbers.
//
//     auto report = example::measure_quality({.screen = size, .map_size = {2048, 2048}}, [&](glm::ivec2 pixel) {
//         return umbrage::pixels_per_texel(to_texels, to_pixels, position[pixel], normal[pixel]);
//     });
//     std::printf("mean %.2f, 95 of 100 below %.2f, greatest %.2f\n", report.mean, report.p95, report.greatest);
//
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/light/pixels_per_texel.hpp>

namespace example {

/// A setup in numbers, over all pixels that were measured.
struct quality_report {
    double mean = 0, p95 = 0, greatest = 0;  ///< of longest_extent, pixels
    double storage_factor = 0;               ///< texels over pixels, of maps that would resolve all of the screen
    std::size_t measured = 0, skipped = 0;   ///< pixels; skipped: of surfaces parallel to the light
};

/// View over which a setup is measured.
struct measured_view {
    glm::ivec2 screen{1};    ///< pixels, each >= 1
    glm::ivec2 map_size{1};  ///< texels of a map, each >= 1
    int maps = 1;            ///< number of maps, such as cascades
    int step = 1;            ///< from pixel to pixel, >= 1
};

/// Measures a setup over a view.
///
/// @param at        (glm::ivec2 pixel) -> pixels_per_texel of the pixel's map, float or double; zeros where there is
///                  nothing to see
/// @param extents   gets longest_extent of each pixel measured, 0 where there was nothing to measure; empty, or of the
///                  screen's size over the step, rounded up
/// @formula         storage_factor = maps (width max |dp/dx|) (height max |dp/dy|) / pixels, dp/dx and dp/dy columns
/// @cite            Lloyd, Govindaraju, Quammen, Molnar, Manocha: Practical Logarithmic Rasterization for Low-Error
///                  Shadow Maps, Graphics Hardware 2007
template <class At>
[[nodiscard]] quality_report measure_quality(const measured_view& view, At&& at,
                                             umbrage::image_view<float> extents = {}) {
    const auto [screen, map_size, maps, step] = view;
    const glm::ivec2 size((screen.x - 1) / step + 1, (screen.y - 1) / step + 1);
    quality_report report;
    std::vector<double> all;
    glm::dvec2 longest(0);
    double sum = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::dmat2 pixels(at(glm::ivec2(x, y) * step));
            if (!extents.empty()) extents[{x, y}] = 0.0f;
            if (pixels == glm::dmat2(0)) continue;
            const double extent = umbrage::longest_extent(pixels);
            if (!umbrage::is_finite(extent)) {
                ++report.skipped;
                continue;
            }
            if (!extents.empty()) extents[{x, y}] = static_cast<float>(extent);
            all.push_back(extent);
            sum += extent;
            longest = glm::max(longest, glm::dvec2(glm::length(pixels[0]), glm::length(pixels[1])));
        }
    report.measured = all.size();
    if (all.empty()) return report;
    const auto p95 = all.begin() + static_cast<std::ptrdiff_t>(double(all.size() - 1) * 0.95);
    std::nth_element(all.begin(), p95, all.end());
    report.mean = sum / double(all.size());
    report.p95 = *p95;
    report.greatest = *std::max_element(p95, all.end());
    report.storage_factor = maps * (map_size.x * longest.x) * (map_size.y * longest.y) / (double(screen.x) * screen.y);
    return report;
}

}  // namespace example
