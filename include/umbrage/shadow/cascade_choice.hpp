// SPDX-License-Identifier: MIT
//
// Choice of a receiver's cascades by projection: the first whose map holds it and its filter, and the weight of the
// next one. The weight grows towards the border of the first map, as far as the next one holds the receiver. After the
// last cascade comes light.
//
// See also: cascade_places.hpp, a place in each; light/cascades, the search and the weights alone.
#pragma once

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

/// Distance of a point beyond the part of a cascade's map in which a filter stays inside the map.
/// @param light    the point, rotated into the light's axes
/// @param scale    scale of the cascade, as for cascade_coordinate
/// @param offset   its offset
/// @param size     size of the map, in texels
/// @param reach    filter radius, in texels
/// @return         texels, at most 0 inside that part. 65536 for a depth outside [0, 1], and for NaN there
/// @edge           a NaN in x or y alone: either NaN or the other one's distance. A NaN position has NaN in all
/// @formula        max(|x - size.x / 2| - (size.x / 2 - reach), the same of y)
/// @exactness      C, n = 13
[[nodiscard]] UMBRAGE_INLINE inline float cascade_edge(glm::vec3 light, const glm::vec4& scale, const glm::vec4& offset,
                                                       glm::vec2 size, float reach) {
    const glm::vec3 at = cascade_coordinate(light, scale, offset);
    const glm::vec2 half_size = size * 0.5f;
    const glm::vec2 beyond = glm::abs(glm::vec2(at) - half_size) - (half_size - reach);
    const bool between = !is_nan(at.z) && glm::abs(at.z - 0.5f) <= 0.5f;
    return between ? (glm::max)(beyond.x, beyond.y) : 65536.0f;
}

/// cascade_edge of four cascades.
/// @param light     the point, rotated into the light's axes
/// @param scales    scales of the cascades, one a column
/// @param offsets   their offsets, likewise
/// @param size      size of the map, in texels
/// @param reach     filter radius, in texels
/// @exactness       C, n = 13, each
[[nodiscard]] UMBRAGE_INLINE inline glm::vec4 cascade_edges(glm::vec3 light, const glm::mat4& scales,
                                                            const glm::mat4& offsets, glm::vec2 size, float reach) {
    return {cascade_edge(light, scales[0], offsets[0], size, reach),
            cascade_edge(light, scales[1], offsets[1], size, reach),
            cascade_edge(light, scales[2], offsets[2], size, reach),
            cascade_edge(light, scales[3], offsets[3], size, reach)};
}

/// First of four cascades that holds a point and its filter.
/// @param edges   cascade_edge of each
/// @return        (number, its edge, edge of the next one). An edge of a cascade after the fourth is 65536
/// @edge          no cascade holds them: (4, 65536, 65536)
/// @exactness     A: comparisons
[[nodiscard]] UMBRAGE_INLINE inline glm::vec3 first_cascade(const glm::vec4& edges) {
    for (glm::length_t i = 0; i < 4; ++i)
        if (edges[i] <= 0.0f) return {float(i), edges[i], i < 3 ? edges[i + 1] : 65536.0f};
    return {4.0f, 65536.0f, 65536.0f};
}

/// Weight of the next cascade, which grows towards the border of a cascade's map as far as the next one holds the
/// point. After the last cascade comes light.
/// @param found      of first_cascade
/// @param blending   x: weight per texel, 1 / width of the band, or 0; y: number of the last cascade
/// @return           0 to 1 in steps of 1/256
/// @formula          min(1 + edge x, 1 - (1 + next edge x)), each rounded down to a step
/// @exactness        B, n = 3: S = |edge| x + 1. As cascade_border_fade
[[nodiscard]] UMBRAGE_INLINE inline float next_cascade_weight(glm::vec3 found, const glm::vec4& blending) {
    if (!(blending.x > 0.0f && found.x <= blending.y)) return 0.0f;
    const float leaves = cascade_weight(found.y * blending.x + 1.0f);
    if (found.x >= blending.y) return leaves;
    const float held = found.z <= 0.0f ? 1.0f - cascade_weight(found.z * blending.x + 1.0f) : 0.0f;
    return (glm::min)(leaves, held);
}

namespace detail {

/// cascade_edges as far as first_cascade needs them: up to the one behind the first cascade that holds the point. That
/// saves 5 % of the time of an image of three cascades.
[[nodiscard]] UMBRAGE_INLINE inline glm::vec4 first_edges(glm::vec3 light, const glm::mat4& scales,
                                                          const glm::mat4& offsets, const shadow_terms& terms) {
    glm::vec4 edges(65536.0f);
    for (glm::length_t i = 0; i < 4; ++i) {
        edges[i] = cascade_edge(light, scales[i], offsets[i], terms.map_size, terms.reach);
        if (i > 0 && edges[i - 1] <= 0.0f) break;
    }
    return edges;
}

}  // namespace detail

/// Cascades that hold a point of the world.
/// @param rotation   rotation from the world to the light's axes
/// @param scales     scales of four cascades, one a column, as for cascade_place
/// @param offsets    their offsets, likewise
/// @param anchor     xyz: position that is subtracted from the point's
/// @param blending   as for next_cascade_weight
/// @param terms      size of a map and reach of the filter, texels
/// @param world      position of the point
/// @return           (number of the first one, weight of the next). In no cascade: (4, 0)
/// @exactness        C, n = 38: as cascade_edge, of a rotated vector
[[nodiscard]] UMBRAGE_INLINE inline glm::vec2 cascaded_maps_choice(const glm::mat4& rotation, const glm::mat4& scales,
                                                                   const glm::mat4& offsets, const glm::vec4& anchor,
                                                                   const glm::vec4& blending, const shadow_terms& terms,
                                                                   glm::vec3 world) {
    const glm::vec3 light(shadow_coordinate(rotation, world - glm::vec3(anchor)));
    const glm::vec3 found = first_cascade(detail::first_edges(light, scales, offsets, terms));
    return {found.x, next_cascade_weight(found, blending)};
}

/// cascaded_maps_choice for up to eight cascades, with further columns for those from the fifth on.
/// @return      in no cascade: (8, 0)
/// @exactness   C, n = 38: as cascade_edge, of a rotated vector
[[nodiscard]] UMBRAGE_INLINE inline glm::vec2 cascaded_maps_choice_8(const glm::mat4& rotation, const glm::mat4& scales,
                                                                     const glm::mat4& offsets,
                                                                     const glm::mat4& farther_scales,
                                                                     const glm::mat4& farther_offsets,
                                                                     const glm::vec4& anchor, const glm::vec4& blending,
                                                                     const shadow_terms& terms, glm::vec3 world) {
    const glm::vec3 light(shadow_coordinate(rotation, world - glm::vec3(anchor)));
    const glm::vec4 nearer = cascade_edges(light, scales, offsets, terms.map_size, terms.reach),
                    farther = cascade_edges(light, farther_scales, farther_offsets, terms.map_size, terms.reach);
    glm::vec3 found = first_cascade(nearer);
    if (found.x == 3.0f) found.z = farther.x;
    if (found.x == 4.0f) found = first_cascade(farther) + glm::vec3(4, 0, 0);
    return {found.x, next_cascade_weight(found, blending)};
}

namespace glsl {

inline constexpr snippet cascade_edge{
    .name = "cascade_edge",
    .summary = "texels beyond the part of a cascade where a filter stays inside",
    .exactness = tier::c,
    .operations = 13,
    .source = R"GLSL(
// umbrage_cascade_edge: texels beyond the part of a cascade's map where a filter stays inside, at most 0.0 inside
//   light          the point, rotated into the light's axes
//   scale, offset  those of the cascade
//   size, reach    size of the map and filter radius, in texels
// Returns 65536.0 for a depth outside [0, 1], and for NaN there
UMBRAGE_HIGHP float umbrage_cascade_edge(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP vec4 scale, UMBRAGE_HIGHP vec4 offset,
                                         UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec3 at = light * vec3(scale.x, scale.y, scale.z) + vec3(offset.x, offset.y, offset.z);
    UMBRAGE_HIGHP vec2 half_size = size * 0.5;
    UMBRAGE_HIGHP vec2 beyond = abs(vec2(at.x, at.y) - half_size) - (half_size - reach);
    return abs(at.z - 0.5) <= 0.5 ? max(beyond.x, beyond.y) : 65536.0;
}
)GLSL",
};

inline constexpr snippet cascade_edges{
    .name = "cascade_edges",
    .summary = "cascade_edge of four cascades",
    .exactness = tier::c,
    .operations = 13,
    .needs = list<&cascade_edge>,
    .source = R"GLSL(
// umbrage_cascade_edges: umbrage_cascade_edge of four cascades
//   scales, offsets   one column per cascade
UMBRAGE_HIGHP vec4 umbrage_cascade_edges(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP mat4 scales,
                                         UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP vec2 size,
                                         UMBRAGE_HIGHP float reach) {
    return vec4(umbrage_cascade_edge(light, scales[0], offsets[0], size, reach),
                umbrage_cascade_edge(light, scales[1], offsets[1], size, reach),
                umbrage_cascade_edge(light, scales[2], offsets[2], size, reach),
                umbrage_cascade_edge(light, scales[3], offsets[3], size, reach));
}
)GLSL",
};

inline constexpr snippet first_cascade{
    .name = "first_cascade",
    .summary = "first of four cascades that holds a point and its filter",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_first_cascade: number of the first of four cascades that holds a point and its filter, its edge, and the edge
// of the next one; (4.0, 65536.0, 65536.0) for none
//   edges   umbrage_cascade_edge of each
UMBRAGE_HIGHP vec3 umbrage_first_cascade(UMBRAGE_HIGHP vec4 edges) {
    UMBRAGE_HIGHP vec3 found = edges.w <= 0.0 ? vec3(3.0, edges.w, 65536.0) : vec3(4.0, 65536.0, 65536.0);
    found = edges.z <= 0.0 ? vec3(2.0, edges.z, edges.w) : found;
    found = edges.y <= 0.0 ? vec3(1.0, edges.y, edges.z) : found;
    return edges.x <= 0.0 ? vec3(0.0, edges.x, edges.y) : found;
}
)GLSL",
};

inline constexpr snippet next_cascade_weight{
    .name = "next_cascade_weight",
    .summary = "weight of the next cascade, by both edges",
    .exactness = tier::b,
    .operations = 3,
    .needs = list<&cascade_weight>,
    .source = R"GLSL(
// umbrage_next_cascade_weight: weight of the next cascade, which grows towards the border of a cascade's map
//   found      of umbrage_first_cascade
//   blending   1.0 / width of the band in texels, or 0.0; number of the last cascade, after which comes light
UMBRAGE_HIGHP float umbrage_next_cascade_weight(UMBRAGE_HIGHP vec3 found, UMBRAGE_HIGHP vec4 blending) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 v = vec2(found.y, found.z) * blending.x + 1.0;
    UMBRAGE_HIGHP float leaves = umbrage_cascade_weight(v.x);
    UMBRAGE_HIGHP float held = found.z <= 0.0 ? 1.0 - umbrage_cascade_weight(v.y) : 0.0;
    UMBRAGE_HIGHP float weight = found.x >= blending.y ? leaves : min(leaves, held);
    return blending.x > 0.0 && found.x <= blending.y ? weight : 0.0;
}
)GLSL",
};

inline constexpr snippet cascaded_maps_choice{
    .name = "cascaded_maps_choice",
    .summary = "those of up to four cascades that hold a point of the world",
    .exactness = tier::c,
    .operations = 38,
    .needs = list<&cascade_edges, &first_cascade, &next_cascade_weight>,
    .source = R"GLSL(
// umbrage_cascaded_maps_choice: number of the first of up to four cascades that holds a point, and weight of the next
//   rotation          rotation from the world to the light's axes
//   scales, offsets   scales and offsets of the cascades
//   anchor            position that is subtracted from world
//   blending, terms   as for umbrage_next_cascade_weight; size of a map and reach of the filter
UMBRAGE_HIGHP vec2 umbrage_cascaded_maps_choice(UMBRAGE_HIGHP mat4 rotation, UMBRAGE_HIGHP mat4 scales,
                                                UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP vec4 anchor,
                                                UMBRAGE_HIGHP vec4 blending, UMBRAGE_HIGHP vec4 terms,
                                                UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_HIGHP vec2 size = vec2(terms.x, terms.y);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 turned =
        rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    UMBRAGE_HIGHP vec3 light = vec3(turned.x, turned.y, turned.z);
    UMBRAGE_HIGHP vec3 found = umbrage_first_cascade(umbrage_cascade_edges(light, scales, offsets, size, terms.z));
    return vec2(found.x, umbrage_next_cascade_weight(found, blending));
}
)GLSL",
};

inline constexpr snippet cascaded_maps_choice_8{
    .name = "cascaded_maps_choice_8",
    .summary = "those of up to eight cascades that hold a point of the world",
    .exactness = tier::c,
    .operations = 38,
    .needs = list<&cascade_edges, &first_cascade, &next_cascade_weight>,
    .source = R"GLSL(
// umbrage_cascaded_maps_choice_8: umbrage_cascaded_maps_choice for up to eight cascades
//   farther_scales, farther_offsets   those of the fifth cascade and of those after it
UMBRAGE_HIGHP vec2 umbrage_cascaded_maps_choice_8(UMBRAGE_HIGHP mat4 rotation, UMBRAGE_HIGHP mat4 scales,
                                                  UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP mat4 farther_scales,
                                                  UMBRAGE_HIGHP mat4 farther_offsets, UMBRAGE_HIGHP vec4 anchor,
                                                  UMBRAGE_HIGHP vec4 blending, UMBRAGE_HIGHP vec4 terms,
                                                  UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_HIGHP vec2 size = vec2(terms.x, terms.y);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 turned =
        rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    UMBRAGE_HIGHP vec3 light = vec3(turned.x, turned.y, turned.z);
    UMBRAGE_HIGHP vec4 nearer = umbrage_cascade_edges(light, scales, offsets, size, terms.z);
    UMBRAGE_HIGHP vec4 farther = umbrage_cascade_edges(light, farther_scales, farther_offsets, size, terms.z);
    UMBRAGE_HIGHP vec3 found = umbrage_first_cascade(nearer);
    UMBRAGE_HIGHP vec3 after = umbrage_first_cascade(farther);
    UMBRAGE_HIGHP float next = found.x == 3.0 ? farther.x : found.z;
    found = found.x < 3.5 ? vec3(found.x, found.y, next) : vec3(after.x + 4.0, after.y, after.z);
    return vec2(found.x, umbrage_next_cascade_weight(found, blending));
}
)GLSL",
};

inline constexpr const snippet* cascade_choice_snippets[]{&cascade_edge,         &cascade_edges,
                                                          &first_cascade,        &next_cascade_weight,
                                                          &cascaded_maps_choice, &cascaded_maps_choice_8};

}  // namespace glsl
}  // namespace umbrage
