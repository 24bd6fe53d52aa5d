// SPDX-License-Identifier: MIT
//
// A light's map for positions relative to an anchor, with a bound of what rounding does to a receiver's place in it.
//
// Coordinates in float are rounded to 2^-24 of their magnitude. A matrix of the whole world cancels large terms, so far
// from the origin a receiver and the vertices of its own surface would round apart. Both are therefore taken relative
// to an anchor: the light's position, or the middle of its map. What is left is known from the map's numbers.
//
//     umbrage::anchored_map lamp = umbrage::make_anchored_map(light, {1024, 1024});
//     umbrage::map_place at = umbrage::anchored_place(lamp.to_texels, lamp.planes, lamp.anchor, lamp.rounding, p, n);
//
// See also: single_map.hpp, which has nothing else; depth_pass.hpp, whose vertices take the same anchor.
#pragma once

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/bias/slope.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

/// Uniforms of a map for positions relative to an anchor.
struct anchored_map {
    glm::mat4 to_texels{0};  ///< texture_matrix of positions less the anchor, but its depth is less anchor.w
    glm::mat4 planes{0};     ///< plane_matrix of the texture matrix of positions less the anchor
    glm::vec4 anchor{0};     ///< xyz: position that is subtracted; w: depth that is added
    glm::vec4 rounding{0};   ///< (k, d, g, s) of anchored_place
};

namespace detail {

/// Largest relative error of one rounding in binary32.
inline constexpr double one_rounding = 0x1p-24;
/// Scale of k and d under parallel rays, so small that |z| adds nothing to the bound. g and s are divided by it.
inline constexpr float unmoved = 0x1p-40f;

[[nodiscard]] inline glm::dvec3 row_of(const glm::dmat4& m, glm::length_t row) {
    return {m[0][row], m[1][row], m[2][row]};
}
/// Sum of the magnitudes that a row of a matrix adds.
[[nodiscard]] inline double magnitudes(const glm::dvec3& row, const glm::dvec3& p) {
    return glm::dot(glm::abs(row), glm::abs(p));
}

/// True for directional lights, warped or not. Along some direction neither x, y nor w changes.
[[nodiscard]] inline bool has_parallel_rays(const light_space<double>& light) {
    const glm::dmat4 rows = glm::transpose(light.projection * light.view);
    const glm::dvec3 x(rows[0]), y(rows[1]), w(rows[3]);
    return std::abs(glm::dot(glm::cross(x, y), w)) <= 1e-4 * glm::length(x) * glm::length(y) * glm::length(w);
}

/// True where depth depends on w alone, as under every perspective along the axis of a view.
[[nodiscard]] inline bool is_lens(const glm::dmat4& m) {
    const glm::dvec3 z = row_of(m, 2), w = row_of(m, 3);
    return w != glm::dvec3(0) && glm::length(glm::cross(z, w)) <= 1e-9 * glm::length(w) * (glm::length(z) + 1e-30);
}

/// Point where the rays of a lens meet, or else the middle of the map.
/// @param m   texture matrix of the map
[[nodiscard]] inline glm::dvec3 anchor_of(const glm::dmat4& m, glm::ivec2 map_size) {
    if (is_lens(m)) {
        const glm::dmat3 rows = glm::transpose(glm::dmat3(row_of(m, 0), row_of(m, 1), row_of(m, 3)));
        return glm::inverse(rows) * -glm::dvec3(m[3][0], m[3][1], m[3][3]);
    }
    const glm::dvec4 middle = glm::inverse(m) * glm::dvec4(0.5 * glm::dvec2(map_size), 0.5, 1.0);
    return glm::dvec3(middle) / middle.w;
}

/// Matrix for positions relative to a point.
[[nodiscard]] inline glm::dmat4 moved_to(glm::dmat4 m, glm::dvec3 anchor) {
    m[3] = m * glm::dvec4(anchor, 1.0);
    return m;
}

/// Takes a multiple of w from the row of depth, which is left without directions under a lens and without an offset
/// elsewhere. Rounding then enters the depth by z or by w alone.
/// @return   the multiple: depth to add after the division
[[nodiscard]] inline double take_depth(glm::dmat4& m) {
    const glm::dvec3 z = row_of(m, 2), w = row_of(m, 3);
    const bool lens = is_lens(m);
    const double depth = lens ? glm::dot(z, w) / glm::dot(w, w) : m[3][2] / m[3][3];
    for (glm::length_t i = 0; i < 4; ++i) m[i][2] -= depth * m[i][3];
    if (lens) m[0][2] = m[1][2] = m[2][2] = 0.0;
    else m[3][2] = 0.0;
    return depth;
}

/// Corner of a map's box at a depth, less the anchor.
/// @param back   inverse of the texture matrix of positions less the anchor
[[nodiscard]] inline glm::dvec3 corner_of(const glm::dmat4& back, glm::ivec2 map_size, int number, double depth) {
    const glm::dvec4 p = back * glm::dvec4(number & 1 ? map_size.x : 0, number & 2 ? map_size.y : 0, depth, 1.0);
    return glm::dvec3(p) / p.w;
}

/// Refuses a light so far from the origin that float is too coarse for what it covers.
/// @param away           distance of the anchor from the origin of positions
/// @param extent         size of what the light covers
inline void require_digits(double away, double extent) {
    require(!(away > 2048.0 * extent), "shadow", "light", "within 2048 times its extent of the positions' origin", away,
            "Pass an origin near it.");
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
    double sums[3]{}, way = 0.0, farthest = 0.0;  // largest over the box: of rows, of positions in w, of corners
    double nearest_w = highest<double>, farthest_w = 0.0;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 p = corner_of(back, map_size, i, i / 4);
        const double w = glm::dot(rows[3], p) + m[3][3];
        nearest_w = (glm::min)(nearest_w, w), farthest_w = (glm::max)(farthest_w, w);
        for (glm::length_t r = 0; r < 3; ++r) sums[r] = (glm::max)(sums[r], magnitudes(rows[r], p));
        way = (glm::max)(way, glm::length(p) / w), farthest = (glm::max)(farthest, 2.0 * glm::length(p));
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
        return (glm::min)((glm::max)(at_unit / k, with_i / d), (at_unit + with_i / nearest_w) / (k + d / farthest_w));
    };
    const double x = map_size.x + share(glm::length(rows[0]), m[3][0]),
                 y = map_size.y + share(glm::length(rows[1]), m[3][1]);
    glm::dmat4 without_depth = m;
    static_cast<void>(take_depth(without_depth));
    const double z = share(glm::length(row_of(without_depth, 2)), 0.0);
    return {one_rounding * k, one_rounding * d, (glm::max)(x, y), z};
}

/// Uniforms of a map for a given anchor.
/// @param here   texture matrix of positions as they are given
[[nodiscard]] inline anchored_map anchored_at(const glm::vec3& anchor, const glm::dmat4& here, glm::ivec2 map_size) {
    const glm::dvec3 exact(anchor);
    glm::dmat4 m = moved_to(here, exact);
    if (is_lens(m)) m /= glm::length(row_of(m, 3));
    anchored_map out;
    out.planes = glm::mat4(plane_matrix_of_shadow(m));
    out.rounding = glm::vec4(rounding_of(m, map_size, exact));
    if (row_of(m, 3) == glm::dvec3(0)) out.rounding *= glm::vec4(1.0f, unmoved, 1.0f / unmoved, 1.0f / unmoved);
    out.anchor = glm::vec4(anchor, static_cast<float>(take_depth(m)));
    out.to_texels = glm::mat4(m);
    return out;
}

/// Uniforms of maps whose matrix takes positions in a face's axes, relative to a light. Their bound leaves out the
/// rounding of the light's own position. That is half the rounding of casters and receivers together.
/// @param m   from a face's axes to texels
[[nodiscard]] inline anchored_map anchored_axes(const glm::dmat4& m, glm::ivec2 map_size, const glm::dvec3& light) {
    const glm::dmat4 back = glm::inverse(m);
    require_digits(glm::length(light), (glm::max)(glm::length(corner_of(back, map_size, 0, 0.0)),
                                                  glm::length(corner_of(back, map_size, 0, 1.0))));
    anchored_map out = anchored_at(glm::vec3(0), m, map_size);
    out.anchor = glm::vec4(glm::vec3(light), out.anchor.w);
    out.rounding.y = static_cast<float>(one_rounding * 3.0 * glm::length(light));
    return out;
}

}  // namespace detail

/// Makes the uniforms of a map.
/// @param light      light of the map
/// @param map_size   size of the map, texels
/// @param origin     origin of the positions, world units
/// @throws std::invalid_argument   as texture_matrix and plane_matrix; a light more than 2048 times its extent away
///                                 from the origin
[[nodiscard]] inline anchored_map make_anchored_map(const light_space<double>& light, glm::ivec2 map_size,
                                                    glm::dvec3 origin = glm::dvec3(0)) {
    const glm::dmat4 here = texture_matrix(detail::relative_to(origin, light), map_size);
    return detail::anchored_at(glm::vec3(detail::anchor_of(here, map_size)), here, map_size);
}

/// Place of a point of the world in one map, and a bound of its rounding.
/// @param to_texels                             of an anchored_map
/// @param planes                                likewise
/// @param anchor                                likewise
/// @param rounding                              likewise
/// @param way                                   position less anchor.xyz, as the map's matrix takes it
/// @param normal                                normal of the point
/// @return                                      its place in map 0, with weight 1
/// @edge                                        behind the light: a place that every filter takes as lit
/// @formula     place = (x, y, z) / w + (0, 0, anchor.w), where (x, y, z, w) = to_texels way. With i = 1 / w and
///              u = 2^-24, rounding = (k + d i) (g (|slope.x| + |slope.y|) + s + |z| i) + 8 u (|z| i + |anchor.w|):
///              positions in a lens move by k w + d, which is g texels and s of depth a unit where w is 1. In a warped
///              map w is off by (k + d i) w, and a texel and a depth by g and s times that share. The last term has
///              the products, sums, divisions and stores of depths themselves, and those of plane_reference
/// @exactness   C, n = 121: as receiver_slope of way, and a division. S of each
[[nodiscard]] UMBRAGE_INLINE inline map_place anchored_place(const glm::mat4& to_texels, const glm::mat4& planes,
                                                             const glm::vec4& anchor, const glm::vec4& rounding,
                                                             glm::vec3 way, glm::vec3 normal) {
    const glm::vec4 c = shadow_coordinate(to_texels, way);
    const glm::vec2 slope = receiver_slope(planes, normal, way);
    const auto magnitude = [](float v) { return v < 0.0f ? -v : v; };
    const bool before = !is_nan(c.w) && c.w > 0.0f;
    const float i = before ? 1.0f / c.w : 0.0f, z = c.z * i, steep = magnitude(slope.x) + magnitude(slope.y);
    const float moves = rounding.x + rounding.y * i;
    const float off = moves * (rounding.z * steep + (rounding.w + magnitude(z)));
    return {.at = {before ? c.x * i : 65536.0f, c.y * i, z + anchor.w},
            .slope = slope,
            .rounding = off + (magnitude(z) + magnitude(anchor.w)) * (8.0f / 16777216.0f)};
}

/// View of a depth pass for positions relative to an anchor: what the vertex function of bind_vertex_pass takes.
struct depth_view {
    glm::mat4 to_clip{0};  ///< projection * view of positions less the anchor, but z is less anchor.w times w
    glm::vec4 anchor{0};   ///< xyz: position that is subtracted; w: share of w in z, 0 for parallel rays
};

namespace detail {

/// View of a depth pass for a given anchor.
/// @param here   light for positions as they are given
[[nodiscard]] inline depth_view depth_view_at(const glm::vec3& anchor, const light_space<double>& here) {
    glm::dmat4 m = moved_to(here.projection * here.view, glm::dvec3(anchor));
    const bool parallel = row_of(m, 3) == glm::dvec3(0);
    const double share = parallel ? 0.0 : take_depth(m);
    return {glm::mat4(m), glm::vec4(anchor, static_cast<float>(share))};
}

}  // namespace detail

/// Makes the view of a light's depth pass.
/// @param light    light of the map
/// @param origin   origin of the positions, world units
[[nodiscard]] inline depth_view make_depth_view(const light_space<double>& light, glm::dvec3 origin = glm::dvec3(0)) {
    const light_space<double> here = detail::relative_to(origin, light);
    const glm::dmat4 m = texture_matrix(here, glm::ivec2(1));
    return detail::depth_view_at(glm::vec3(detail::anchor_of(m, glm::ivec2(1))), here);
}

namespace detail {

/// View of maps that bend lines: the projection alone, and the position of the light.
[[nodiscard]] inline depth_view make_bent_view(const light_space<double>& light, glm::dvec3 origin) {
    const glm::dvec3 position(glm::inverse(light.view)[3]);
    return {glm::mat4(light.projection), glm::vec4(glm::vec3(position - origin), 0.0f)};
}

}  // namespace detail

/// Vertex of a depth pass, in clip space.
/// @param to_clip           of a depth_view
/// @param anchor            likewise
/// @param world             position of the vertex
/// @formula                 (x, y, z + anchor.w w, w), where (x, y, z, w) = to_clip (world - anchor.xyz)
/// @exactness               B, n = 20
[[nodiscard]] inline glm::vec4 anchored_vertex(const glm::mat4& to_clip, glm::vec3 world, const glm::vec4& anchor) {
    glm::vec4 c = shadow_coordinate(to_clip, world - glm::vec3(anchor));
    c.z += anchor.w * c.w;
    return c;
}

namespace glsl {

inline constexpr snippet anchored_vertex{
    .name = "anchored_vertex",
    .summary = "vertex of a depth pass in clip space, far from the origin too",
    .exactness = tier::b,
    .operations = 20,
    .needs = list<&shadow_coordinate>,
    .source = R"GLSL(
// umbrage_anchored_vertex: clip space position of a vertex of a depth pass
//   to_clip, anchor   of a depth_view: anchor.xyz is subtracted from world, and anchor.w times w is added to z
UMBRAGE_HIGHP vec4 umbrage_anchored_vertex(UMBRAGE_HIGHP mat4 to_clip, UMBRAGE_HIGHP vec3 world,
                                           UMBRAGE_HIGHP vec4 anchor) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 c = umbrage_shadow_coordinate(to_clip, way);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.z + anchor.w * c.w;
    return vec4(c.x, c.y, depth, c.w);
}
)GLSL",
};

inline constexpr snippet anchored_place{
    .name = "anchored_place",
    .summary = "place of a point in one map, and a bound of its rounding",
    .exactness = tier::c,
    .operations = 121,
    .needs = list<&receiver_slope>,
    .source = R"GLSL(
// umbrage_anchored_place: place of a point in one map, and a bound of its rounding
//   to_texels, planes   matrices from positions less the anchor to texels of the map, and to their planes
//   anchor, rounding    anchor.w is added to depth; rounding of anchored_map
//   way                 position less anchor.xyz
//   returns (texels, texels, depth, 0.0), (slope, slope, weight, rounding); behind the light: a place taken as lit
UMBRAGE_HIGHP mat4 umbrage_anchored_place(UMBRAGE_HIGHP mat4 to_texels, UMBRAGE_HIGHP mat4 planes,
                                          UMBRAGE_HIGHP vec4 anchor, UMBRAGE_HIGHP vec4 rounding,
                                          UMBRAGE_HIGHP vec3 way, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec4 none = vec4(0.0, 0.0, 0.0, 0.0);
    UMBRAGE_HIGHP vec4 c = to_texels[3] + to_texels[0] * way.x + to_texels[1] * way.y + to_texels[2] * way.z;
    UMBRAGE_HIGHP vec2 slope = umbrage_receiver_slope(planes, normal, way);
    bool before = c.w > 0.0;
    UMBRAGE_HIGHP float i = before ? 1.0 / c.w : 0.0;
    UMBRAGE_HIGHP vec3 at = vec3(c.x, c.y, c.z) * i;
    UMBRAGE_HIGHP float steep = abs(slope.x) + abs(slope.y);
    UMBRAGE_HIGHP float moves = rounding.x + rounding.y * i;
    UMBRAGE_HIGHP float off = moves * (rounding.z * steep + (rounding.w + abs(at.z)));
    UMBRAGE_HIGHP float all = off + (abs(at.z) + abs(anchor.w)) * (8.0 / 16777216.0);
    return mat4(vec4(before ? at.x : 65536.0, at.y, at.z + anchor.w, 0.0), vec4(slope, 1.0, all), none, none);
}
)GLSL",
};

inline constexpr const snippet* anchored_map_snippets[]{&anchored_vertex, &anchored_place};

}  // namespace glsl
}  // namespace umbrage
