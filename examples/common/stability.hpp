// SPDX-License-Identifier: MIT
//
// Stability of a light's maps while the camera moves. Points of the world should keep their positions between texels,
// and their visibility.
//
//     auto report = example::measure_stability(frames, points.size(), [&](int frame) {
//         const auto maps = draw_maps(camera_at(frame));
//         return [&, maps](std::size_t i) {
//             return example::placed_point{0, maps.texel(points[i]), maps.lit(points[i])};
//         };
//     });
//     std::printf("drift %g texels, %g %% flicker\n", report.drift, 100 * report.share());
//
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace example {

/// A point of the world in a frame's maps.
struct placed_point {
    int map = -1;          ///< number of the map or cascade that it is looked up in; below 0: in none
    glm::dvec2 texel{0};   ///< where in it, finite
    double visibility{0};  ///< visibility by the filter
};

/// Over all points and frames.
struct stability_report {
    double change = 0;  ///< greatest, of a point's visibility in one map
    double drift = 0;   ///< drift of the grid against the world, texels: 0 where maps move by whole texels, at most 1/2
    std::size_t compared = 0;  ///< points that a map held in two frames or more
    std::size_t changed = 0;   ///< those of them whose visibility changed in one map

    /// Fraction of points whose visibility changed.
    [[nodiscard]] double share() const { return compared ? double(changed) / double(compared) : 0; }
};

/// Measures a setup over the frames of a moving camera, each point against the first frame in which the same map holds
/// it: what passes from one map to another is not compared.
///
/// @param frame   (int) -> what places points in that frame: (std::size_t point) -> placed_point
/// @formula       drift = max |m - nearest whole number to m|, m what a point has moved by through a map, in x or in y
template <class Frame>
[[nodiscard]] stability_report measure_stability(int frames, std::size_t points, Frame&& frame) {
    std::vector<placed_point> first;  // places in a map, point by point
    std::vector<char> compared(points), changed(points);
    stability_report report;
    for (int i = 0; i < frames; ++i) {
        auto&& place = frame(i);
        for (std::size_t k = 0; k < points; ++k) {
            const placed_point now = place(k);
            if (now.map < 0) continue;
            const std::size_t before = points * static_cast<std::size_t>(now.map);
            if (before >= first.size()) first.resize(before + points);
            placed_point& then = first[before + k];
            if (then.map < 0) {
                then = now;
                continue;
            }
            const glm::dvec2 moved = now.texel - then.texel, off = glm::abs(moved - glm::round(moved));
            report.drift = std::max({report.drift, off.x, off.y});
            compared[k] = 1;
            const double change = glm::abs(now.visibility - then.visibility);
            report.change = std::max(report.change, change);
            if (change != 0.0) changed[k] = 1;
        }
    }
    for (std::size_t k = 0; k < points; ++k) report.compared += compared[k] != 0, report.changed += changed[k] != 0;
    return report;
}

}  // namespace example
