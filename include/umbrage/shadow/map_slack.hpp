// SPDX-License-Identifier: MIT
//
// Slack that comparisons on a receiver's plane need in a map, from the map's numbers. It covers the rounding of
// receivers and of their surface's vertices, texels beside the plane, and concave edges between texels.
//
// See also: anchored_map.hpp, which makes uniforms of it.
#pragma once

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/bias/light_units.hpp>
#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage::detail {

/// Largest relative error of one rounding in binary32.
inline constexpr double one_rounding = 0x1p-24;
/// Error of a depth by its products, sums, divisions and stores, and by those of plane_reference, as a share of it.
inline constexpr double depth_rounding = 8.0 * one_rounding;
/// Texels of slope that cover a slope's own rounding, where the light grazes a surface.
inline constexpr double grazing = 0.125;

/// Texels by which the rasterizer's snap (rasterizer_snap) and the rounding of coordinates may move a surface in a map.
[[nodiscard]] inline double texels_moved(const clip_space& clip, glm::ivec2 map_size) {
    return 2.0 / (1 << clip.subpixel_bits) + 0x1p-21 * (glm::max)(map_size.x, map_size.y);
}

/// Texels of slope by which a texel may lie beside a receiver's plane: those moved, and the rounding of the slope.
[[nodiscard]] inline double texels_beside_plane(const clip_space& clip, glm::ivec2 map_size) {
    return texels_moved(clip, map_size) + grazing;
}

[[nodiscard]] inline glm::dvec3 row_of(const glm::dmat4& m, glm::length_t row) {
    return {m[0][row], m[1][row], m[2][row]};
}
/// Sum of the magnitudes that a row of a matrix adds.
[[nodiscard]] inline double magnitudes(const glm::dvec3& row, const glm::dvec3& p) {
    return glm::dot(glm::abs(row), glm::abs(p));
}

/// True where depth depends on w alone, as under every perspective along the axis of a view. In double such rows are
/// parallel to some 1e-16. Those of strongly warped suns are so to 1e-9.
[[nodiscard]] inline bool is_lens(const glm::dmat4& m) {
    const glm::dvec3 z = row_of(m, 2), w = row_of(m, 3);
    return w != glm::dvec3(0) && glm::length(glm::cross(z, w)) <= 1e-13 * glm::length(w) * (glm::length(z) + 1e-30);
}

/// True where rays meet in a point: no row of x, y and w is a sum of the others, as under parallel rays. In a very wide
/// lens they nearly are.
[[nodiscard]] inline bool rays_meet(const glm::dmat4& m) {
    const glm::dvec3 x = row_of(m, 0), y = row_of(m, 1), w = row_of(m, 3);
    return is_lens(m) ||
           std::abs(glm::dot(glm::cross(x, y), w)) > 1e-4 * glm::length(x) * glm::length(y) * glm::length(w);
}

/// True for directional lights, warped or not.
[[nodiscard]] inline bool has_parallel_rays(const light_space<double>& light) {
    return !rays_meet(light.projection * light.view);
}

/// Point where the rays of a perspective meet.
[[nodiscard]] inline glm::dvec3 eye_of(const glm::dmat4& m) {
    const glm::dmat3 rows = glm::transpose(glm::dmat3(row_of(m, 0), row_of(m, 1), row_of(m, 3)));
    return glm::inverse(rows) * -glm::dvec3(m[3][0], m[3][1], m[3][3]);
}

/// Point where rays meet, or else the middle of the map at a depth.
/// @param m   texture matrix of the map
[[nodiscard]] inline glm::dvec3 anchor_of(const glm::dmat4& m, glm::ivec2 map_size, double depth = 0.5) {
    if (rays_meet(m)) return eye_of(m);
    const glm::dvec4 middle = glm::inverse(m) * glm::dvec4(0.5 * glm::dvec2(map_size), depth, 1.0);
    return glm::dvec3(middle) / middle.w;
}

/// Matrix for positions relative to a point.
[[nodiscard]] inline glm::dmat4 moved_to(glm::dmat4 m, glm::dvec3 anchor) {
    m[3] = m * glm::dvec4(anchor, 1.0);
    return m;
}

/// Subtracts a multiple of w from the row of depth. In a lens the row then has no directions, under parallel rays no
/// offset. Where rays meet otherwise, it is 0 on the far plane. So little of the rounding of w enters the depth.
/// @param m   matrix of positions less the anchor
/// @return    the multiple: depth to add after the division
[[nodiscard]] inline double take_depth(glm::dmat4& m) {
    const glm::dvec3 z = row_of(m, 2), w = row_of(m, 3);
    const bool meet = rays_meet(m), lens = is_lens(m);
    const double far_depth = m[3][2] < 0.0 ? 1.0 : 0.0;  // depth grows from below where rays start, or falls
    const double depth = lens ? glm::dot(z, w) / glm::dot(w, w) : meet ? far_depth : m[3][2] / m[3][3];
    for (glm::length_t i = 0; i < 4; ++i) m[i][2] -= depth * m[i][3];
    if (lens) m[0][2] = m[1][2] = m[2][2] = 0.0;
    else if (!meet) m[3][2] = 0.0;
    return depth;
}

/// Direction of parallel rays, or of the axis of rays that meet.
[[nodiscard]] inline glm::dvec3 direction_of(const glm::dmat4& m) {
    return rays_meet(m) ? row_of(m, 3) : glm::cross(row_of(m, 0), row_of(m, 1));
}

/// Longer edge of a texel's footprint across the light, and depth per world unit along it, at a point of the world.
[[nodiscard]] inline glm::dvec2 units_at(const glm::dmat4& m, const glm::dvec3& world) {
    return light_units_at(m, direction_of(m), world).units;
}

/// x: edge of a texel's footprint across the light, along the x of its map, at a point of the world. y: height over
/// that edge. Where texels are rectangles, it is the other edge.
[[nodiscard]] inline glm::dvec2 edges_at(const glm::dmat4& m, const glm::dvec3& world) {
    const auto sides = across(unit(direction_of(m)));
    const glm::dvec3 a = step(m, world, sides[0]), b = step(m, world, sides[1]);
    const double rows = std::hypot(a.y, b.y);  // of the map, for each unit of the world
    return {rows / std::abs(a.x * b.y - a.y * b.x), 1.0 / rows};
}

/// Point where a map's units are measured. Where rays meet, it is at a distance of 1 along the axis, where w may be of
/// any scale, as a matrix times a number is the same map. Else it is the middle.
[[nodiscard]] inline glm::dvec3 measured_at(const glm::dmat4& m, glm::ivec2 map_size) {
    const glm::dvec3 anchor = anchor_of(m, map_size);
    return rays_meet(m) ? anchor + glm::normalize(row_of(m, 3)) : anchor;
}

/// Units of a map.
[[nodiscard]] inline glm::dvec2 map_units(const glm::dmat4& m, glm::ivec2 map_size) {
    return units_at(m, measured_at(m, map_size));
}

/// Depth of a texel's width along the light, at map_units. It covers what a map's texels miss of a concave edge.
[[nodiscard]] inline double width_in_depth(const glm::dmat4& m, glm::ivec2 map_size) {
    const glm::dvec2 units = map_units(m, map_size);
    return units.x * units.y;
}

/// Corner of a map's box at a depth, less the anchor.
/// @param back   inverse of the texture matrix of positions less the anchor
[[nodiscard]] inline glm::dvec3 corner_of(const glm::dmat4& back, glm::ivec2 map_size, int number, double depth) {
    const glm::dvec4 p = back * glm::dvec4(number & 1 ? map_size.x : 0, number & 2 ? map_size.y : 0, depth, 1.0);
    return glm::dvec3(p) / p.w;
}

/// Slack for a texel's width along the light: x |z| / w + y at a place, with z less the anchor's depth. Parallel rays
/// have one width everywhere, y. The width of rays that meet falls with 1 / w, as |z| / w does up to the anchor's
/// depth. That is infinitely far in a lens. In other maps it is the far plane's, and y is the width there.
/// @param m   texture matrix of positions less the anchor
[[nodiscard]] inline glm::dvec2 width_slack(glm::dmat4 m, glm::ivec2 map_size) {
    const double width = width_in_depth(m, map_size);
    if (!rays_meet(m)) return {0.0, width};
    glm::dmat4 placed = m / glm::length(row_of(m, 3));
    const double depth = take_depth(placed), share = width / std::abs(placed[3][2]);
    if (is_lens(m)) return {share, 0.0};
    const glm::dvec4 far_middle = glm::inverse(m) * glm::dvec4(0.5 * glm::dvec2(map_size), depth, 1.0);
    const glm::dvec2 units = units_at(m, glm::dvec3(far_middle) / far_middle.w);
    return {share, units.x * units.y};
}

/// Part of a place's slack that is no error of texels: a texel's width along the light, and the rounding of the slope.
/// @param m   texture matrix of the map
[[nodiscard]] inline float spare_slack(glm::dmat4 m, glm::ivec2 map_size, const map_place& place) {
    const double steep = std::abs(double(place.slope.x)) + std::abs(double(place.slope.y));
    m = moved_to(m, anchor_of(m, map_size));
    const glm::dvec2 width = width_slack(m, map_size);
    const double width_here = width.x * std::abs(double(place.at.z) - take_depth(m)) + width.y;
    return static_cast<float>((glm::min)(width_here + grazing * steep, double(place.slack)));
}

/// Refuses a light so far from the origin that float is too coarse for what it covers.
/// @param away           distance of the anchor from the origin of positions
/// @param extent         size of what the light covers
inline void require_digits(double away, double extent) {
    require(!(away > 2048.0 * extent), "shadow", "light", "within 2048 times its extent of the positions' origin",
            away / extent, "Pass an origin near it.");
}

/// Bound of rounding in a map, for anchored_place. It adds the bound for a receiver to that for the vertices of its
/// surface.
///
/// A sum of three products is off by 3/2 of its magnitudes at most, in any order, fused or not. Its matrix, and the
/// positions less the anchor, each add one rounding of the same magnitudes. Given positions add that of their distance
/// from the origin. With both sides this makes 10 and 2. In a lens all are multiples of w or of that distance. In a
/// warped map z and w change nearly together, so z counts without the anchor's depth times w.
/// @param m        texture matrix of positions less the anchor. w has a gradient of 1 in a lens
/// @param anchor   as the shader gets it
[[nodiscard]] inline glm::dvec4 rounding_of(const glm::dmat4& m, glm::ivec2 map_size, const glm::dvec3& anchor) {
    const glm::dmat4 back = glm::inverse(m);
    const glm::dvec3 rows[]{row_of(m, 0), row_of(m, 1), row_of(m, 2), row_of(m, 3)};
    const double away = glm::length(anchor);
    if (is_lens(m)) {
        double wide = 0.0, farthest = 0.0;  // longest distance from the light, in w; the farthest corner
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 p = corner_of(back, map_size, i, 0.75);
            wide = (glm::max)(wide, glm::length(p) / glm::dot(rows[3], p));
            for (const double end : {0.0, 1.0})
                farthest = (glm::max)(farthest, glm::length(corner_of(back, map_size, i, end)));
        }
        require_digits(away, farthest);
        return {one_rounding * (7.0 * wide + 3.0), one_rounding * 2.0 * away,
                (glm::max)(glm::length(rows[0]), glm::length(rows[1])), 0.0};
    }
    double sums[3]{}, way = 0.0, farthest = 0.0;     // largest over the box: of rows, of positions in w, of corners
    double least_i = highest<double>, most_i = 0.0;  // of 1 / w
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 p = corner_of(back, map_size, i, i / 4);
        const double w = glm::dot(rows[3], p) + m[3][3];
        for (glm::length_t r = 0; r < 3; ++r) sums[r] = (glm::max)(sums[r], magnitudes(rows[r], p));
        // A warped box may reach beyond its horizon, where w is below 0. Still 1 / w and p / w are linear over the box,
        // so corners have the extremes.
        least_i = (glm::min)(least_i, 1.0 / w), most_i = (glm::max)(most_i, 1.0 / w);
        way = (glm::max)(way, glm::length(p) / std::abs(w)), farthest = (glm::max)(farthest, 2.0 * glm::length(p));
    }
    require_digits(away, farthest);
    if (rows[3] == glm::dvec3(0)) {
        const auto off = [&](int r) { return one_rounding * (10.0 * sums[r] + 2.0 * magnitudes(rows[r], anchor)); };
        return {0.0, 1.0, (glm::max)(off(0), off(1)), off(2)};
    }
    // The rounding of w is k + d i of w. It moves a texel by as much of its coordinate, and a depth by as much of its
    // distance from the anchor's depth.
    const double w = glm::length(rows[3]), k = 10.0 * w * way, d = 2.0 * w * away + 6.0 * std::abs(m[3][3]);
    // The rounding of another row is length (10 way + 2 away i) + 6 offset i. Returns the lower of two bounds of it
    // over k + d i: term by term, which a w that hardly varies makes infinite, and by the ends of the box.
    const auto share = [&](double length, double offset) {
        const double at_unit = 10.0 * length * way, with_i = 2.0 * length * away + 6.0 * std::abs(offset);
        return (glm::min)((glm::max)(at_unit / k, with_i / d),
                          (at_unit + with_i * most_i) / (k + d * (glm::max)(least_i, 0.0)));
    };
    const double x = map_size.x + share(glm::length(rows[0]), m[3][0]),
                 y = map_size.y + share(glm::length(rows[1]), m[3][1]);
    glm::dmat4 without_depth = m;
    static_cast<void>(take_depth(without_depth));
    const double z = share(glm::length(row_of(without_depth, 2)), 0.0);
    return {one_rounding * k, one_rounding * d, (glm::max)(x, y), z};
}

}  // namespace umbrage::detail
