// SPDX-License-Identifier: MIT
//
// Places of a receiver in cascaded shadow maps (CSM). It has one in the first map that holds it and its filter. Where
// two maps blend it has another in the next one. Near the border of the last map the second place lies outside, so
// shadows fade to light.
//
// See also: cascaded_maps.hpp, the setup; light/cascades, the search and the weights alone.
#pragma once

#include <array>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/bias/slope.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

/// Distance of a point beyond the part of a cascade's map in which a filter stays inside the map.
/// @param coordinate   position in the cascade's map: texels, texels, depth
/// @param size         size of the map, in texels
/// @param reach        filter radius, in texels
/// @return             texels, at most 0 inside that part. 65536 for a depth outside [0, 1], for NaN, and where the
///                     distances along x and y add up to 65536 or more
/// @formula            max(|x - size.x / 2| - (size.x / 2 - reach), the same of y)
/// @exactness          B, n = 11
[[nodiscard]] UMBRAGE_INLINE inline float cascade_edge(glm::vec3 coordinate, glm::vec2 size, float reach) {
    const glm::vec2 half_size = size * 0.5f;
    const float x = glm::abs(coordinate.x - half_size.x) - (half_size.x - reach);
    const float y = glm::abs(coordinate.y - half_size.y) - (half_size.y - reach);
    const bool between = !is_nan(coordinate.z) && coordinate.z >= 0.0f && coordinate.z <= 1.0f;
    const bool near_map = !is_nan(x + y) && x + y < 65536.0f;
    return between && near_map ? (glm::max)(x, y) : 65536.0f;
}

/// Places in a cascade and in the next one, whose weight grows towards the border of the map.
/// @param across                    normal, rotated into the light's axes
/// @param found                     (texels, texels, depth, index) in the cascade, as cascade_by_projection has it
/// @param there                     (texels, texels, depth) in the next cascade
/// @param edges                     cascade_edge of both
/// @param slacks                    w of the offsets of both: slack of a plane in depth
/// @param scale                     scale of that cascade, or of the last one; w: slack of a plane in texels of slope
/// @param next_scale                scale of the next cascade
/// @param blending                  x: weight per texel, 1 / width of the band, or 0; y: index of the last cascade
/// @return                          both places. The second has a weight of 0 where only the first counts
/// @exactness                       C, n = 14: as cascade_border_fade and cascade_slope. S of each
[[nodiscard]] UMBRAGE_INLINE inline std::array<map_place, 2> cascade_pair(glm::vec3 across, glm::vec4 found,
                                                                          glm::vec3 there, glm::vec2 edges,
                                                                          glm::vec2 slacks, const glm::vec4& scale,
                                                                          const glm::vec4& next_scale,
                                                                          const glm::vec4& blending) {
    const bool last = !(found.w < blending.y);
    const int number = static_cast<int>(last ? blending.y : found.w);
    const auto place = [&](int map, glm::vec3 at, const glm::vec4& of, float slack, float weight) {
        const glm::vec2 slope = cascade_slope(across, of);
        const float steep = glm::abs(slope.x) + glm::abs(slope.y);
        return map_place{map, at, slope, weight, steep * of.w + slack};
    };
    std::array<map_place, 2> both{place(number, glm::vec3(found), scale, slacks.x, 1.0f), map_place{.weight = 0.0f}};
    if (!(blending.x > 0.0f && found.w <= blending.y)) return both;
    const float leaves = cascade_weight(edges.x * blending.x + 1.0f);
    if (!(leaves > 0.0f)) return both;
    if (last) {
        both[1] = place(number, outside_all_maps, next_scale, slacks.y, leaves);
        return both;
    }
    if (!(edges.y <= 0.0f)) return both;
    const float held = 1.0f - cascade_weight(edges.y * blending.x + 1.0f);
    both[1] = place(number + 1, there, next_scale, slacks.y, (glm::min)(leaves, held));
    return both;
}

/// Places of a point of the world in up to four cascades.
/// @param rotation          rotation from the world to the light's axes
/// @param scales            one column per cascade, as for cascade_by_projection; w as for cascade_pair
/// @param offsets           likewise
/// @param anchor            xyz: position that is subtracted from the point's
/// @param blending          as for cascade_pair
/// @param terms             size of a map and reach of the filter, texels
/// @param world             position of the point
/// @param normal            its normal
/// @return                  places of cascade_pair. In no cascade: a place that every filter takes as lit
/// @exactness               C, n = 38: as cascade_pair, of rotated vectors
[[nodiscard]] UMBRAGE_INLINE inline std::array<map_place, 2> cascaded_maps_places(
    const glm::mat4& rotation, const glm::mat4& scales, const glm::mat4& offsets, const glm::vec4& anchor,
    const glm::vec4& blending, const shadow_terms& terms, glm::vec3 world, glm::vec3 normal) {
    const glm::vec3 light(shadow_coordinate(rotation, world - glm::vec3(anchor))),
        across(shadow_coordinate(rotation, normal));
    glm::vec3 at(0.0f);
    float edge = 65536.0f;
    glm::length_t i = 0;
    for (; i < 4; ++i) {
        at = cascade_coordinate(light, scales[i], offsets[i]);
        edge = cascade_edge(at, terms.map_size, terms.reach);
        if (edge <= 0.0f) break;
    }
    const glm::vec4 found = i < 4 ? glm::vec4(at, float(i)) : glm::vec4(65536.0f, 65536.0f, 0.0f, 4.0f);
    const glm::length_t last = 3, here = (glm::min)(i, last), next = (glm::min)(i + 1, last);
    const glm::vec3 there = cascade_coordinate(light, scales[next], offsets[next]);
    const glm::vec2 edges(edge, cascade_edge(there, terms.map_size, terms.reach));
    const glm::vec2 slacks(offsets[here].w, offsets[next].w);
    return cascade_pair(across, found, there, edges, slacks, scales[here], scales[next], blending);
}

/// Places of a world position in up to eight cascades. As cascaded_maps_places, with further columns for the cascades
/// from the fifth on.
/// @exactness   C, n = 38: as cascade_pair, of rotated vectors
[[nodiscard]] UMBRAGE_INLINE inline std::array<map_place, 2> cascaded_maps_places_8(
    const glm::mat4& rotation, const glm::mat4& scales, const glm::mat4& offsets, const glm::mat4& farther_scales,
    const glm::mat4& farther_offsets, const glm::vec4& anchor, const glm::vec4& blending, const shadow_terms& terms,
    glm::vec3 world, glm::vec3 normal) {
    const glm::vec3 light(shadow_coordinate(rotation, world - glm::vec3(anchor))),
        across(shadow_coordinate(rotation, normal));
    const glm::vec4 found =
        cascade_by_projection_8(light, scales, offsets, farther_scales, farther_offsets, terms.map_size, terms.reach);
    const float number = (glm::min)(found.w, blending.y), next = (glm::min)(number + 1.0f, blending.y);
    const glm::vec4 next_scale = cascade_column_8(scales, farther_scales, next),
                    next_offset = cascade_column_8(offsets, farther_offsets, next);
    const glm::vec3 there = cascade_coordinate(light, next_scale, next_offset);
    const glm::vec2 edges(cascade_edge(glm::vec3(found), terms.map_size, terms.reach),
                          cascade_edge(there, terms.map_size, terms.reach));
    const glm::vec2 slacks(cascade_column_8(offsets, farther_offsets, number).w, next_offset.w);
    return cascade_pair(across, found, there, edges, slacks, cascade_column_8(scales, farther_scales, number),
                        next_scale, blending);
}

namespace glsl {

inline constexpr snippet cascade_edge{
    .name = "cascade_edge",
    .summary = "texels beyond the part of a cascade where a filter stays inside",
    .exactness = tier::b,
    .operations = 11,
    .source = R"GLSL(
// umbrage_cascade_edge: texels beyond the part of a cascade's map where a filter stays inside, at most 0.0 inside
//   coordinate   position in the cascade's map: texels, texels, depth
//   size, reach  size of the map and filter radius, in texels
// Returns 65536.0 for a depth outside [0, 1], far from the map, and for NaN
UMBRAGE_HIGHP float umbrage_cascade_edge(UMBRAGE_HIGHP vec3 coordinate, UMBRAGE_HIGHP vec2 size,
                                         UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec2 half_size = size * 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 beyond =
        abs(vec2(coordinate.x, coordinate.y) - half_size) - (half_size - reach);
    bool near_map = beyond.x + beyond.y < 65536.0;  // false for NaN
    return coordinate.z >= 0.0 && coordinate.z <= 1.0 && near_map ? max(beyond.x, beyond.y) : 65536.0;
}
)GLSL",
};

inline constexpr snippet cascade_pair{
    .name = "cascade_pair",
    .summary = "places in a cascade and in the next one, with their weights",
    .exactness = tier::c,
    .operations = 14,
    .needs = list<&cascade_slope, &cascade_weight>,
    .source = R"GLSL(
// umbrage_cascade_pair: places in a cascade and in the next one, whose weight grows towards the border of the map
//   across                    normal, rotated into the light's axes
//   found                     (texels, texels, depth, index) in the cascade; an index above the last: in none
//   there                     (texels, texels, depth) in the next one
//   edges                     umbrage_cascade_edge of both
//   slacks                    w of the offsets of both: slack of a plane in depth
//   scale                     scale of the cascade; w: slack of a plane in texels of slope
//   next_scale                that of the next one
//   blending                  1.0 / width of the band in texels, or 0.0; index of the last cascade
//   returns (texels, texels, depth, number), (slope, slope, weight, slack) of both. After the last: outside, lit
UMBRAGE_HIGHP mat4 umbrage_cascade_pair(UMBRAGE_HIGHP vec3 across, UMBRAGE_HIGHP vec4 found, UMBRAGE_HIGHP vec3 there,
                                        UMBRAGE_HIGHP vec2 edges, UMBRAGE_HIGHP vec2 slacks,
                                        UMBRAGE_HIGHP vec4 scale, UMBRAGE_HIGHP vec4 next_scale,
                                        UMBRAGE_HIGHP vec4 blending) {
    bool last = found.w >= blending.y;
    UMBRAGE_HIGHP vec2 v = edges * blending.x + 1.0;
    UMBRAGE_HIGHP float leaves = blending.x > 0.0 && found.w <= blending.y ? umbrage_cascade_weight(v.x) : 0.0;
    UMBRAGE_HIGHP float held = edges.y <= 0.0 ? 1.0 - umbrage_cascade_weight(v.y) : 0.0;
    UMBRAGE_HIGHP float weight = last ? leaves : min(leaves, held);
    UMBRAGE_HIGHP vec3 next = last ? vec3(-65536.0, -65536.0, 0.0) : there;
    UMBRAGE_HIGHP vec2 slope = umbrage_cascade_slope(across, scale);
    UMBRAGE_HIGHP vec2 next_slope = umbrage_cascade_slope(across, next_scale);
    UMBRAGE_HIGHP float slack = (abs(slope.x) + abs(slope.y)) * scale.w + slacks.x;
    UMBRAGE_HIGHP float next_slack = (abs(next_slope.x) + abs(next_slope.y)) * next_scale.w + slacks.y;
    return mat4(vec4(found.x, found.y, found.z, min(found.w, blending.y)), vec4(slope, 1.0, slack),
                vec4(next, min(found.w + 1.0, blending.y)), vec4(next_slope, weight, next_slack));
}
)GLSL",
};

inline constexpr snippet cascaded_maps_places{
    .name = "cascaded_maps_places",
    .summary = "places of a point of the world in up to four cascades",
    .exactness = tier::c,
    .operations = 38,
    .needs = list<&cascade_edge, &cascade_pair>,
    .source = R"GLSL(
// umbrage_cascaded_maps_places: places of a point of the world in one or two of up to four cascades
//   rotation          rotation from the world to the light's axes
//   scales, offsets   scales and offsets of the cascades
//   anchor            position that is subtracted from world
//   blending, terms   as for umbrage_cascade_pair, whose columns it returns; size of a map and reach of the filter
UMBRAGE_HIGHP mat4 umbrage_cascaded_maps_places(UMBRAGE_HIGHP mat4 rotation, UMBRAGE_HIGHP mat4 scales,
                                                UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP vec4 anchor,
                                                UMBRAGE_HIGHP vec4 blending, UMBRAGE_HIGHP vec4 terms,
                                                UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec2 size = vec2(terms.x, terms.y);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 light = rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    UMBRAGE_HIGHP vec4 across =
        rotation[3] + rotation[0] * normal.x + rotation[1] * normal.y + rotation[2] * normal.z;
    UMBRAGE_HIGHP vec4 a = light * scales[0] + offsets[0];
    UMBRAGE_HIGHP vec4 b = light * scales[1] + offsets[1];
    UMBRAGE_HIGHP vec4 c = light * scales[2] + offsets[2];
    UMBRAGE_HIGHP vec4 d = light * scales[3] + offsets[3];
    UMBRAGE_HIGHP float edge_a = umbrage_cascade_edge(vec3(a.x, a.y, a.z), size, terms.z);
    UMBRAGE_HIGHP float edge_b = umbrage_cascade_edge(vec3(b.x, b.y, b.z), size, terms.z);
    UMBRAGE_HIGHP float edge_c = umbrage_cascade_edge(vec3(c.x, c.y, c.z), size, terms.z);
    UMBRAGE_HIGHP float edge_d = umbrage_cascade_edge(vec3(d.x, d.y, d.z), size, terms.z);
    bool in_a = edge_a <= 0.0;
    bool in_b = edge_b <= 0.0;
    bool in_c = edge_c <= 0.0;
    UMBRAGE_HIGHP vec4 none = vec4(65536.0, 65536.0, 0.0, 4.0);
    UMBRAGE_HIGHP vec4 found = edge_d <= 0.0 ? vec4(d.x, d.y, d.z, 3.0) : none;
    found = in_c ? vec4(c.x, c.y, c.z, 2.0) : found;
    found = in_b ? vec4(b.x, b.y, b.z, 1.0) : found;
    found = in_a ? vec4(a.x, a.y, a.z, 0.0) : found;
    // the next cascade is already looked at; no column is chosen by number
    UMBRAGE_HIGHP vec4 there = in_a ? b : (in_b ? c : d);
    UMBRAGE_HIGHP float edge = in_a ? edge_a : (in_b ? edge_b : (in_c ? edge_c : edge_d));
    UMBRAGE_HIGHP float next_edge = in_a ? edge_b : (in_b ? edge_c : edge_d);
    UMBRAGE_HIGHP vec4 scale = in_a ? scales[0] : (in_b ? scales[1] : (in_c ? scales[2] : scales[3]));
    UMBRAGE_HIGHP vec4 next_scale = in_a ? scales[1] : (in_b ? scales[2] : scales[3]);
    UMBRAGE_HIGHP float next_slack = in_a ? offsets[1].w : (in_b ? offsets[2].w : offsets[3].w);
    UMBRAGE_HIGHP float slack = in_a ? offsets[0].w : (in_b ? offsets[1].w : (in_c ? offsets[2].w : offsets[3].w));
    return umbrage_cascade_pair(vec3(across.x, across.y, across.z), found, vec3(there.x, there.y, there.z),
                                vec2(edge, next_edge), vec2(slack, next_slack), scale, next_scale, blending);
}
)GLSL",
};

inline constexpr snippet cascaded_maps_places_8{
    .name = "cascaded_maps_places_8",
    .summary = "places of a point of the world in up to eight cascades",
    .exactness = tier::c,
    .operations = 38,
    .needs = list<&shadow_coordinate, &cascade_by_projection_8, &cascade_column_8, &cascade_coordinate, &cascade_edge,
                  &cascade_pair>,
    .source = R"GLSL(
// umbrage_cascaded_maps_places_8: places of a point of the world in one or two of up to eight cascades
//   farther_scales, farther_offsets   those of the fifth cascade and of those after it
//   the others, and what it returns   as umbrage_cascaded_maps_places
UMBRAGE_HIGHP mat4 umbrage_cascaded_maps_places_8(UMBRAGE_HIGHP mat4 rotation, UMBRAGE_HIGHP mat4 scales,
                                                  UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP mat4 farther_scales,
                                                  UMBRAGE_HIGHP mat4 farther_offsets, UMBRAGE_HIGHP vec4 anchor,
                                                  UMBRAGE_HIGHP vec4 blending, UMBRAGE_HIGHP vec4 terms,
                                                  UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec2 size = vec2(terms.x, terms.y);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 turned = umbrage_shadow_coordinate(rotation, way);
    UMBRAGE_HIGHP vec4 turned_normal = umbrage_shadow_coordinate(rotation, normal);
    UMBRAGE_HIGHP vec3 light = vec3(turned.x, turned.y, turned.z);
    UMBRAGE_HIGHP vec3 across = vec3(turned_normal.x, turned_normal.y, turned_normal.z);
    UMBRAGE_HIGHP vec4 found = umbrage_cascade_by_projection_8(light, scales, offsets, farther_scales, farther_offsets,
                                                               size, terms.z);
    UMBRAGE_HIGHP float number = min(found.w, blending.y);
    UMBRAGE_HIGHP float next = min(number + 1.0, blending.y);
    UMBRAGE_HIGHP vec4 next_scale = umbrage_cascade_column_8(scales, farther_scales, next);
    UMBRAGE_HIGHP vec4 next_offset = umbrage_cascade_column_8(offsets, farther_offsets, next);
    UMBRAGE_HIGHP vec3 there = umbrage_cascade_coordinate(light, next_scale, next_offset);
    UMBRAGE_HIGHP vec4 offset = umbrage_cascade_column_8(offsets, farther_offsets, number);
    UMBRAGE_HIGHP float edge = umbrage_cascade_edge(vec3(found.x, found.y, found.z), size, terms.z);
    UMBRAGE_HIGHP float next_edge = umbrage_cascade_edge(there, size, terms.z);
    return umbrage_cascade_pair(across, found, there, vec2(edge, next_edge), vec2(offset.w, next_offset.w),
                                umbrage_cascade_column_8(scales, farther_scales, number), next_scale, blending);
}
)GLSL",
};

inline constexpr const snippet* cascade_places_snippets[]{&cascade_edge, &cascade_pair, &cascaded_maps_places,
                                                          &cascaded_maps_places_8};

}  // namespace glsl
}  // namespace umbrage
