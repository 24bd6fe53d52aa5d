// SPDX-License-Identifier: MIT
//
// The part of a triangle that can be drawn: in front of the near plane, within the guard band.
//
//     clipped_polygon polygon = clip_triangle(project, a, b, c);
//
#pragma once

#include <array>
#include <cstddef>

#include <glm/vec4.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/images/raster/projection.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// A convex polygon on the grid, its smallest vertex first: a fan around that vertex is the same whichever vertex
/// of the triangle came first, and whichever way round they went.
struct clipped_polygon {
    std::array<snapped_vertex, 3 + projection::planes> vertices;
    int count = 0;  ///< 0 or 3..9
};

/// On which side of the near plane a polygon is to be. Both sides cut an edge at the same point.
enum class near_side { behind, before };

/// The part of a triangle inside all planes, or of the near plane outside, where snap() gives it that plane's depth.
/// @param a,b,c   homogeneous texels
/// @param planes  a bit for each plane to clip against; those that all three points are inside of may be left out
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
