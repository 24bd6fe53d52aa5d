// SPDX-License-Identifier: MIT
//
// Place of a receiver in one map of cascaded shadow maps (CSM). A shader chooses the maps first and finds a place in
// each, so that it has the instructions of a place once.
//
// See also: cascade_choice.hpp, the choice; cascaded_maps.hpp, the setup.
#pragma once

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/bias/slope.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

/// Place of a point in one cascade.
/// @param light    the point, rotated into the light's axes
/// @param across   its normal, rotated likewise
/// @param scale    scale of the cascade. w: slack of a plane in texels of slope
/// @param offset   its offset. w: slack of a plane in depth
/// @param number   number of the cascade. Above `last` the place is outside all maps, where filters are lit
/// @param last     number of the last cascade
/// @exactness      C, n = 14: as cascade_slope. S of each
[[nodiscard]] UMBRAGE_INLINE inline map_place cascade_place(glm::vec3 light, glm::vec3 across, const glm::vec4& scale,
                                                            const glm::vec4& offset, float number, float last) {
    glm::vec3 at = cascade_coordinate(light, scale, offset);
    if (!(number <= last)) at.x = outside_all_maps;
    const glm::vec2 slope = cascade_slope(across, scale);
    const float steep = glm::abs(slope.x) + glm::abs(slope.y);
    return {static_cast<int>((glm::min)(number, last)), at, slope, 1.0f, steep * scale.w + offset.w};
}

/// Place of a point of the world in one of up to four cascades.
/// @param rotation   rotation from the world to the light's axes
/// @param scales     scales of four cascades, one a column, as for cascade_place
/// @param offsets    their offsets, likewise
/// @param anchor     xyz: position that is subtracted from the point's
/// @param blending   y: number of the last cascade
/// @param world      position of the point
/// @param normal     normal of its surface
/// @param number     as for cascade_place
/// @exactness        C, n = 38: as cascade_place, of rotated vectors
[[nodiscard]] UMBRAGE_INLINE inline map_place cascaded_maps_place(const glm::mat4& rotation, const glm::mat4& scales,
                                                                  const glm::mat4& offsets, const glm::vec4& anchor,
                                                                  const glm::vec4& blending, const shadow_terms&,
                                                                  glm::vec3 world, glm::vec3 normal, float number) {
    const glm::vec3 light(shadow_coordinate(rotation, world - glm::vec3(anchor))),
        across(shadow_coordinate(rotation, normal));
    const float own = (glm::min)(number, blending.y);
    return cascade_place(light, across, cascade_column(scales, own), cascade_column(offsets, own), number, blending.y);
}

/// cascaded_maps_place for up to eight cascades.
/// @exactness   C, n = 38: as cascade_place, of rotated vectors
[[nodiscard]] UMBRAGE_INLINE inline map_place cascaded_maps_place_8(
    const glm::mat4& rotation, const glm::mat4& scales, const glm::mat4& offsets, const glm::mat4& farther_scales,
    const glm::mat4& farther_offsets, const glm::vec4& anchor, const glm::vec4& blending, const shadow_terms&,
    glm::vec3 world, glm::vec3 normal, float number) {
    const glm::vec3 light(shadow_coordinate(rotation, world - glm::vec3(anchor))),
        across(shadow_coordinate(rotation, normal));
    const float own = (glm::min)(number, blending.y);
    return cascade_place(light, across, cascade_column_8(scales, farther_scales, own),
                         cascade_column_8(offsets, farther_offsets, own), number, blending.y);
}

namespace glsl {

inline constexpr snippet cascade_place{
    .name = "cascade_place",
    .summary = "place of a point in one cascade",
    .exactness = tier::c,
    .operations = 14,
    .needs = list<&cascade_slope>,
    .source = R"GLSL(
// umbrage_cascade_place: place of a point in one cascade
//   light, across   the point and its normal, rotated into the light's axes
//   scale, offset   those of the cascade. w: slack of a plane in texels of slope, and in depth
//   number, last    number of the cascade and of the last one; above it the place is outside all maps, where all is lit
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
UMBRAGE_HIGHP mat4 umbrage_cascade_place(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP vec3 across,
                                         UMBRAGE_HIGHP vec4 scale, UMBRAGE_HIGHP vec4 offset,
                                         UMBRAGE_HIGHP float number, UMBRAGE_HIGHP float last) {
    UMBRAGE_HIGHP vec4 none = vec4(0.0, 0.0, 0.0, 0.0);
    UMBRAGE_HIGHP vec3 at = light * vec3(scale.x, scale.y, scale.z) + vec3(offset.x, offset.y, offset.z);
    UMBRAGE_HIGHP float x = number <= last ? at.x : -65536.0;
    UMBRAGE_HIGHP vec2 slope = umbrage_cascade_slope(across, scale);
    UMBRAGE_HIGHP float slack = (abs(slope.x) + abs(slope.y)) * scale.w + offset.w;
    return mat4(vec4(x, at.y, at.z, min(number, last)), vec4(slope, 1.0, slack), none, none);
}
)GLSL",
};

inline constexpr snippet cascaded_maps_place{
    .name = "cascaded_maps_place",
    .summary = "place of a point of the world in one of up to four cascades",
    .exactness = tier::c,
    .operations = 38,
    .needs = list<&cascade_column, &cascade_place>,
    .source = R"GLSL(
// umbrage_cascaded_maps_place: umbrage_cascade_place of a point of the world, in one of up to four cascades
//   number   number of the cascade
//   the others as for umbrage_cascaded_maps_choice
UMBRAGE_HIGHP mat4 umbrage_cascaded_maps_place(UMBRAGE_HIGHP mat4 rotation, UMBRAGE_HIGHP mat4 scales,
                                               UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP vec4 anchor,
                                               UMBRAGE_HIGHP vec4 blending, UMBRAGE_HIGHP vec4 terms,
                                               UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal,
                                               UMBRAGE_HIGHP float number) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 light =
        rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    UMBRAGE_HIGHP vec4 across =
        rotation[3] + rotation[0] * normal.x + rotation[1] * normal.y + rotation[2] * normal.z;
    UMBRAGE_HIGHP float own = min(number, blending.y);
    return umbrage_cascade_place(vec3(light.x, light.y, light.z), vec3(across.x, across.y, across.z),
                                 umbrage_cascade_column(scales, own), umbrage_cascade_column(offsets, own), number,
                                 blending.y);
}
)GLSL",
};

inline constexpr snippet cascaded_maps_place_8{
    .name = "cascaded_maps_place_8",
    .summary = "place of a point of the world in one of up to eight cascades",
    .exactness = tier::c,
    .operations = 38,
    .needs = list<&cascade_column_8, &cascade_place>,
    .source = R"GLSL(
// umbrage_cascaded_maps_place_8: umbrage_cascaded_maps_place for up to eight cascades
//   farther_scales, farther_offsets   those of the fifth cascade and of those after it
UMBRAGE_HIGHP mat4 umbrage_cascaded_maps_place_8(UMBRAGE_HIGHP mat4 rotation, UMBRAGE_HIGHP mat4 scales,
                                                 UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP mat4 farther_scales,
                                                 UMBRAGE_HIGHP mat4 farther_offsets, UMBRAGE_HIGHP vec4 anchor,
                                                 UMBRAGE_HIGHP vec4 blending, UMBRAGE_HIGHP vec4 terms,
                                                 UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal,
                                                 UMBRAGE_HIGHP float number) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 light =
        rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    UMBRAGE_HIGHP vec4 across =
        rotation[3] + rotation[0] * normal.x + rotation[1] * normal.y + rotation[2] * normal.z;
    UMBRAGE_HIGHP float own = min(number, blending.y);
    return umbrage_cascade_place(vec3(light.x, light.y, light.z), vec3(across.x, across.y, across.z),
                                 umbrage_cascade_column_8(scales, farther_scales, own),
                                 umbrage_cascade_column_8(offsets, farther_offsets, own), number, blending.y);
}
)GLSL",
};

inline constexpr const snippet* cascade_places_snippets[]{&cascade_place, &cascaded_maps_place, &cascaded_maps_place_8};

}  // namespace glsl
}  // namespace umbrage
