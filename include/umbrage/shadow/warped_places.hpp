// SPDX-License-Identifier: MIT
//
// Places of a receiver in warped cascades (LiSPSM, TSM, PSM). The receiver's distance along the camera's axis chooses
// its map. A receiver in the band where two maps blend has a place in each of them. The end of the last map fades to
// light.
//
// See also: warped_maps.hpp, the setup.
#pragma once

#include <array>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

/// warped cascade that holds a point of the world, and weight of the next one.
/// @param fades    one column per map: scale and offset for cascade_fade
/// @param anchor   xyz: the one anchor of all maps
/// @param ahead    distance along the camera's axis: dot(ahead.xyz, world - anchor) + ahead.w
/// @param ends     xyz: ends of the first three cascades
/// @param world    position of the point
/// @return         (number of the cascade, 0 to 3; weight of the next one)
/// @exactness      C, n = 12: as cascade_fade
[[nodiscard]] UMBRAGE_INLINE inline glm::vec2 warped_maps_choice(const glm::mat4& fades, const glm::vec4& anchor,
                                                                 const glm::vec4& ahead, const glm::vec4& ends,
                                                                 glm::vec3 world) {
    const glm::vec3 way = world - glm::vec3(anchor);
    const float depth = ahead.x * way.x + ahead.y * way.y + ahead.z * way.z + ahead.w;
    const float number = cascade_by_depth(depth, glm::vec3(ends));
    const glm::vec4 own = cascade_column(fades, number);
    return {number, cascade_fade(depth, own.x, own.y)};
}

/// Place of a point of the world in one of up to four warped cascades.
/// @param to_texels   of the anchored_map of each map
/// @param planes      likewise
/// @param rounding    one column per map: rounding of its anchored_map
/// @param slack       likewise
/// @param anchor      xyz: the one anchor of all maps
/// @param ends        w: number of the last cascade
/// @param world       position of the point
/// @param normal      its normal
/// @param number      number of the cascade. After the last one the place is outside all maps, where filters are lit
/// @exactness         C, n = 121: as anchored_place
[[nodiscard]] UMBRAGE_INLINE inline map_place warped_maps_place(const std::array<glm::mat4, 4>& to_texels,
                                                                const std::array<glm::mat4, 4>& planes,
                                                                const glm::mat4& rounding, const glm::mat4& slack,
                                                                const glm::vec4& anchor, const glm::vec4& ends,
                                                                glm::vec3 world, glm::vec3 normal, float number) {
    const auto own = static_cast<int>((glm::min)(number, ends.w));
    const auto i = static_cast<std::size_t>(own);
    const auto column = static_cast<glm::length_t>(own);
    map_place place =
        anchored_place(to_texels[i], planes[i], rounding[column], slack[column], world - glm::vec3(anchor), normal);
    place.number = own;
    if (!(number <= ends.w)) place.at.x = outside_all_maps;
    return place;
}

namespace glsl {

inline constexpr snippet warped_maps_choice{
    .name = "warped_maps_choice",
    .summary = "warped cascade that holds a point of the world, and weight of the next one",
    .exactness = tier::c,
    .operations = 12,
    .needs = list<&cascade_by_depth, &cascade_column, &cascade_fade>,
    .source = R"GLSL(
// umbrage_warped_maps_choice: number of the warped cascade that holds a point of the world, and weight of the next one
//   fades    one column per map: scale and offset of the next one's weight
//   anchor   the one anchor of all maps
//   ahead    distance along the camera's axis: dot(ahead.xyz, world - anchor) + ahead.w
//   ends     ends of the first three cascades, number of the last one
UMBRAGE_HIGHP vec2 umbrage_warped_maps_choice(UMBRAGE_HIGHP mat4 fades, UMBRAGE_HIGHP vec4 anchor,
                                              UMBRAGE_HIGHP vec4 ahead, UMBRAGE_HIGHP vec4 ends,
                                              UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = ahead.x * way.x + ahead.y * way.y + ahead.z * way.z + ahead.w;
    UMBRAGE_HIGHP float number = umbrage_cascade_by_depth(depth, vec3(ends.x, ends.y, ends.z));
    UMBRAGE_HIGHP vec4 own = umbrage_cascade_column(fades, number);
    return vec2(number, umbrage_cascade_fade(depth, own.x, own.y));
}
)GLSL",
};

inline constexpr snippet warped_maps_place{
    .name = "warped_maps_place",
    .summary = "place of a point of the world in one of up to four warped cascades",
    .exactness = tier::c,
    .operations = 121,
    .needs = list<&anchored_place, &cascade_column>,
    .source = R"GLSL(
// umbrage_warped_maps_place: place of a point of the world in one of up to four warped cascades
//   to_texels_0 to planes_3   matrices of umbrage_anchored_place for each map
//   rounding, slack           one column per map: its rounding and slack there
//   fades, ahead              of umbrage_warped_maps_choice, not read
//   anchor                    the one anchor of all maps
//   ends                      w: number of the last cascade, after which the place is outside all maps, and lit
//   number                    number of the cascade
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
UMBRAGE_HIGHP mat4 umbrage_warped_maps_place(UMBRAGE_HIGHP mat4 to_texels_0, UMBRAGE_HIGHP mat4 to_texels_1,
                                             UMBRAGE_HIGHP mat4 to_texels_2, UMBRAGE_HIGHP mat4 to_texels_3,
                                             UMBRAGE_HIGHP mat4 planes_0, UMBRAGE_HIGHP mat4 planes_1,
                                             UMBRAGE_HIGHP mat4 planes_2, UMBRAGE_HIGHP mat4 planes_3,
                                             UMBRAGE_HIGHP mat4 rounding, UMBRAGE_HIGHP mat4 slack,
                                             UMBRAGE_HIGHP mat4 fades, UMBRAGE_HIGHP vec4 anchor,
                                             UMBRAGE_HIGHP vec4 ahead, UMBRAGE_HIGHP vec4 ends,
                                             UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec3 world,
                                             UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP float number) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP float own = min(number, ends.w);
    UMBRAGE_HIGHP mat4 to_texels = to_texels_0;
    UMBRAGE_HIGHP mat4 planes = planes_0;
    if (own > 0.5) {
        to_texels = to_texels_1;
        planes = planes_1;
    }
    if (own > 1.5) {
        to_texels = to_texels_2;
        planes = planes_2;
    }
    if (own > 2.5) {
        to_texels = to_texels_3;
        planes = planes_3;
    }
    UMBRAGE_HIGHP mat4 at = umbrage_anchored_place(to_texels, planes, umbrage_cascade_column(rounding, own),
                                                   umbrage_cascade_column(slack, own), way, normal);
    UMBRAGE_HIGHP float x = number <= ends.w ? at[0].x : -65536.0;
    return mat4(vec4(x, at[0].y, at[0].z, own), at[1], at[2], at[3]);
}
)GLSL",
};

inline constexpr const snippet* warped_places_snippets[]{&warped_maps_choice, &warped_maps_place};

}  // namespace glsl
}  // namespace umbrage
