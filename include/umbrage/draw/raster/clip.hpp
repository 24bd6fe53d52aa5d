// SPDX-License-Identifier: MIT
//
// Clipping of a triangle to the part that can be drawn: behind the near plane, within the guard band.
//
//     clipped_polygon polygon = clip_triangle(project, a, b, c);
//
#pragma once

#include <array>
#include <cstddef>

#include <glm/vec4.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/draw/raster/projection.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Convex polygon on the grid, its smallest vertex first. A fan around that vertex is the same for every first vertex
/// and winding of the triangle.
struct clipped_polygon {
    std::array<snapped_vertex, 3 + projection::planes> vertices;
    int count = 0;  ///< 0 or 3..9
};

/// Side of the near plane on which a polygon is kept. Both sides cut an edge at the same point.
enum class near_side { behind, before };

/// Part of a triangle inside all planes, or outside the near plane, where snap() gives it that plane's depth.
/// @param a       first point, in homogeneous texels
/// @param b       second point
/// @param c       third point
/// @param planes  a bit for each plane to clip against; those with all three points inside may be left out
template <class = on_use>
[[nodiscard]] inline clipped_polygon clip_triangle(const projection& project, const glm::dvec4& a, const glm::dvec4& b,
                                                   const glm::dvec4& c, unsigned planes = ~0u,
                                                   near_side side = near_side::behind) {
    std::array<glm::dvec4, 3 + projection::planes> points{a, b, c};
    int count = 3;
    for (int plane = 0; plane < projection::planes; ++plane) {
        if (!(planes >> plane & 1u)) continue;
        const auto before = points;
        const int count_before = count;
        count = 0;
        for (int i = 0; i < count_before; ++i) {
            const auto& p = before[std::size_t(i)];
            const auto& q = before[std::size_t(i + 1 < count_before ? i + 1 : 0)];
            const bool p_inside = !(project.distance(plane, p) < 0.0), q_inside = !(project.distance(plane, q) < 0.0);
            const bool keeps_inside = plane != projection::z_near || side == near_side::behind;
            if (p_inside == keeps_inside) points[std::size_t(count++)] = p;
            if (p_inside != q_inside && count < int(points.size()))
                points[std::size_t(count++)] = p_inside ? project.cut(plane, p, q) : project.cut(plane, q, p);
        }
    }
    clipped_polygon polygon;
    if (count < 3) return polygon;
    polygon.count = count;
    std::array<snapped_vertex, 3 + projection::planes> snapped;
    int smallest = 0;
    for (int i = 0; i < count; ++i) {
        snapped[std::size_t(i)] = project.snap(points[std::size_t(i)]);
        if (snapped[std::size_t(i)] < snapped[std::size_t(smallest)]) smallest = i;
    }
    for (int i = 0; i < count; ++i) polygon.vertices[std::size_t(i)] = snapped[std::size_t((smallest + i) % count)];
    return polygon;
}

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
