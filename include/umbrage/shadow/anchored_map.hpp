// SPDX-License-Identifier: MIT
//
// A light's map for positions relative to an anchor, with the slack that comparisons on a receiver's plane need.
//
// Coordinates in float are rounded to 2^-24 of their magnitude. A matrix of the whole world cancels large terms. Far
// from the origin, a receiver and the vertices of its own surface would round differently. Both are therefore taken
// relative to an anchor: the light's position, or the middle of its map, of the far plane in a warped one. What is left
// is known from the map's numbers.
//
//     umbrage::anchored_map lamp = umbrage::make_anchored_map(light, {1024, 1024});
//     glm::vec3 way = world - glm::vec3(lamp.anchor);
//     umbrage::map_place at = umbrage::anchored_place(lamp.to_texels, lamp.planes, lamp.rounding, lamp.slack, way, n);
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
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/map_slack.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

/// Uniforms of a map for positions relative to an anchor.
struct anchored_map {
    glm::mat4 to_texels{0};  ///< texture_matrix of positions less the anchor, but its depth is less slack.w
    glm::mat4 planes{0};     ///< plane_matrix of the texture matrix of positions less the anchor
    glm::vec4 anchor{0};     ///< xyz: position that is subtracted
    glm::vec4 rounding{0};   ///< (k, d, g, s) of anchored_place; 0 under parallel rays, whose rounding slack has
    glm::vec4 slack{0};      ///< (t, p, q, a) of anchored_place
};

namespace detail {

/// Anchor of a light's map: the point where rays meet, or the middle of the map. Under a warp that is the middle of the
/// far plane, as receivers are near it: the rounding of w enters a depth by its distance from the anchor's.
[[nodiscard]] inline glm::dvec3 map_anchor(const light_space<double>& here) {
    const glm::ivec2 one_texel(1);
    const glm::dmat4 m = texture_matrix(here, one_texel);
    const double depth = row_of(m, 3) == glm::dvec3(0) ? 0.5 : double(cleared_depth(here.clip.direction));
    return in_binary32(anchor_of(m, one_texel, depth));
}

/// Refuses a map whose slack, at a corner of its far plane, hides more of the world than the plane is wide: below a
/// surface at 45 degrees, by rounding.
/// @param here   texture matrix of positions as they are given
/// @param m      to_texels, in double
inline void require_depths(const glm::dmat4& here, glm::ivec2 map_size, const clip_space& clip, const glm::dmat4& m,
                           const glm::dvec4& rounding, const glm::dvec4& slack) {
    const glm::dmat4 back = glm::inverse(here);
    const double far_depth = double(cleared_depth(clip.direction)), z = std::abs(far_depth - slack.w);  // |z| / w
    const auto corner = [&](int number) { return corner_of(back, map_size, number, far_depth); };
    const double wide = (glm::max)(glm::distance(corner(0), corner(3)), glm::distance(corner(1), corner(2)));
    for (int number = 0; number < 4; ++number) {
        const glm::dvec4 h = here * glm::dvec4(corner(number), 1.0);
        const double i = glm::length(row_of(here, 3)) / glm::length(row_of(m, 3)) / h.w;  // 1 / w
        if (!(i > 0.0)) continue;                                                         // beyond the horizon
        const glm::dvec2 units = units_at(here, corner(number));
        const double moves = rounding.x + rounding.y * i, steep = units.x * units.y;  // at 45 degrees
        const double hidden = moves * (rounding.z * steep + rounding.w + z) + slack.y * z + slack.z;
        const double hidden_world = hidden / units.y;
        require(hidden_world <= wide, "shadow", "light", "such that its bias hides less than its map is wide",
                hidden_world, "Fit it to a smaller box of casters, or warp it less.");
    }
}

/// Uniforms of a map for a given anchor.
/// @param anchor   as in_binary32 gives it
/// @param here     texture matrix of positions as they are given
[[nodiscard]] inline anchored_map anchored_at(const glm::dvec3& anchor, const glm::dmat4& here, glm::ivec2 map_size,
                                              const clip_space& clip) {
    glm::dmat4 m = moved_to(here, anchor);
    const bool parallel = row_of(m, 3) == glm::dvec3(0);
    if (rays_meet(m)) m /= glm::length(row_of(m, 3));
    anchored_map out;
    out.planes = glm::mat4(plane_matrix_of_shadow(m));  // refuses a matrix without an inverse
    glm::dvec4 rounding = rounding_of(m, map_size, anchor);
    const glm::dvec2 width = width_slack(m, map_size);
    const double depth = take_depth(m);
    glm::dvec4 slack(texels_beside_plane(clip, map_size), depth_rounding + width.x,
                     depth_rounding * std::abs(depth) + width.y, depth);
    if (parallel) slack.x += rounding.z, slack.z += rounding.w, rounding = glm::dvec4(0);
    out.to_texels = glm::mat4(m);
    out.anchor = glm::vec4(glm::vec3(anchor), 0.0f);
    out.rounding = glm::vec4(rounding);
    out.slack = glm::vec4(slack);
    if (!parallel && !is_lens(m)) require_depths(here, map_size, clip, m, rounding, slack);
    return out;
}

/// Uniforms of maps whose matrix takes positions in a face's axes, relative to a light. Their bound leaves out the
/// rounding of the light's own position. That is half the rounding of casters and receivers together.
/// @param m   from a face's axes to texels
[[nodiscard]] inline anchored_map anchored_axes(const glm::dmat4& m, glm::ivec2 map_size, const clip_space& clip,
                                                const glm::dvec3& light) {
    const glm::dmat4 back = glm::inverse(m);
    require_digits(glm::length(light), (glm::max)(glm::length(corner_of(back, map_size, 0, 0.0)),
                                                  glm::length(corner_of(back, map_size, 0, 1.0))));
    anchored_map out = anchored_at(glm::dvec3(0), m, map_size, clip);
    out.anchor = glm::vec4(glm::vec3(light), 0.0f);
    out.rounding.y = static_cast<float>(one_rounding * 3.0 * glm::length(light));
    return out;
}

}  // namespace detail

/// Makes the uniforms of a map.
/// @param light      light of the map
/// @param map_size   size of the map, texels
/// @param origin     origin of the positions, world units
/// @throws std::invalid_argument   as texture_matrix and plane_matrix; a light more than 2048 times its extent away
///                                 from the origin; a warped light whose bias hides more than its map is wide
[[nodiscard]] inline anchored_map make_anchored_map(const light_space<double>& light, glm::ivec2 map_size,
                                                    glm::dvec3 origin = glm::dvec3(0)) {
    const light_space<double> here = detail::relative_to(origin, light);
    return detail::anchored_at(detail::map_anchor(here), texture_matrix(here, map_size), map_size, light.clip);
}

/// Place of a point of the world in one map, with the slack of its plane.
/// @param to_texels   of an anchored_map
/// @param planes      likewise
/// @param rounding    likewise
/// @param slack       likewise
/// @param way         position less anchor.xyz, as the map's matrix takes it
/// @param normal      normal of the point
/// @return            its place in map 0, with weight 1
/// @edge        behind the light: a place that every filter takes as lit
/// @formula     place = (x, y, z) / w + (0, 0, a), where (x, y, z, w) = to_texels way. With i = 1 / w and
///              steep = |slope.x| + |slope.y|, slack = ((k + d i) g + t) steep + (k + d i) (s + |z| i) + p |z| i + q.
///              Positions in a lens move by k w + d, which is g texels and s of depth a unit where w is 1. In a warped
///              map w is off by (k + d i) w, and a texel and a depth by g and s times that share. Texels lie t texels
///              of slope beside the plane. p and q have the rounding of depths, and a texel's width along the light
/// @exactness   C, n = 121: as receiver_slope of way, and a division. S of each
[[nodiscard]] UMBRAGE_INLINE inline map_place anchored_place(const glm::mat4& to_texels, const glm::mat4& planes,
                                                             const glm::vec4& rounding, const glm::vec4& slack,
                                                             glm::vec3 way, glm::vec3 normal) {
    const glm::vec4 c = shadow_coordinate(to_texels, way);
    const glm::vec2 slope = receiver_slope(planes, normal, way);
    const auto magnitude = [](float v) { return v < 0.0f ? -v : v; };
    const bool before = !is_nan(c.w) && c.w > 0.0f;
    const float i = before ? 1.0f / c.w : 0.0f, z = c.z * i, steep = magnitude(slope.x) + magnitude(slope.y);
    const float moves = rounding.x + rounding.y * i, beside = moves * rounding.z + slack.x;
    const float off = moves * (rounding.w + magnitude(z)) + (magnitude(z) * slack.y + slack.z);
    return {.at = {before ? c.x * i : 65536.0f, c.y * i, z + slack.w}, .slope = slope, .slack = beside * steep + off};
}

/// View of a depth pass for positions relative to an anchor: what the vertex function of bind_vertex_pass takes.
struct depth_view {
    glm::mat4 to_clip{0};  ///< projection * view of positions less the anchor, but z is less anchor.w times w
    glm::vec4 anchor{0};   ///< xyz: position that is subtracted; w: share of w in z, 0 for parallel rays
};

namespace detail {

/// View of a depth pass for a given anchor.
/// @param anchor   as in_binary32 gives it
/// @param here     light for positions as they are given
[[nodiscard]] inline depth_view depth_view_at(const glm::dvec3& anchor, const light_space<double>& here) {
    glm::dmat4 m = moved_to(here.projection * here.view, anchor);
    const bool parallel = row_of(m, 3) == glm::dvec3(0);
    const double share = parallel ? 0.0 : take_depth(m);
    return {glm::mat4(m), glm::vec4(glm::dvec4(anchor, share))};
}

}  // namespace detail

/// Makes the view of a light's depth pass.
/// @param light    light of the map
/// @param origin   origin of the positions, world units
[[nodiscard]] inline depth_view make_depth_view(const light_space<double>& light, glm::dvec3 origin = glm::dvec3(0)) {
    const light_space<double> here = detail::relative_to(origin, light);
    return detail::depth_view_at(detail::map_anchor(here), here);
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
    .summary = "place of a point in one map, and the slack of its plane",
    .exactness = tier::c,
    .operations = 121,
    .needs = list<&receiver_slope>,
    .source = R"GLSL(
// umbrage_anchored_place: place of a point in one map, and the slack of its plane
//   to_texels, planes   matrices from positions less the anchor to texels of the map, and to their planes
//   rounding, slack     of anchored_map; slack.w is added to depth
//   way                 position less the anchor
//   returns (texels, texels, depth, 0.0), (slope, slope, weight, slack); behind the light: a place taken as lit
UMBRAGE_HIGHP mat4 umbrage_anchored_place(UMBRAGE_HIGHP mat4 to_texels, UMBRAGE_HIGHP mat4 planes,
                                          UMBRAGE_HIGHP vec4 rounding, UMBRAGE_HIGHP vec4 slack,
                                          UMBRAGE_HIGHP vec3 way, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec4 none = vec4(0.0, 0.0, 0.0, 0.0);
    UMBRAGE_HIGHP vec4 c = to_texels[3] + to_texels[0] * way.x + to_texels[1] * way.y + to_texels[2] * way.z;
    UMBRAGE_HIGHP vec2 slope = umbrage_receiver_slope(planes, normal, way);
    bool before = c.w > 0.0;
    UMBRAGE_HIGHP float i = before ? 1.0 / c.w : 0.0;
    UMBRAGE_HIGHP vec3 at = vec3(c.x, c.y, c.z) * i;
    UMBRAGE_HIGHP float steep = abs(slope.x) + abs(slope.y);
    UMBRAGE_HIGHP float moves = rounding.x + rounding.y * i;
    UMBRAGE_HIGHP float off = moves * (rounding.w + abs(at.z)) + (abs(at.z) * slack.y + slack.z);
    UMBRAGE_HIGHP float all = (moves * rounding.z + slack.x) * steep + off;
    return mat4(vec4(before ? at.x : 65536.0, at.y, at.z + slack.w, 0.0), vec4(slope, 1.0, all), none, none);
}
)GLSL",
};

inline constexpr const snippet* anchored_map_snippets[]{&anchored_vertex, &anchored_place};

}  // namespace glsl
}  // namespace umbrage
