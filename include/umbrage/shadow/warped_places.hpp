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

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

/// Places of a point of the world in up to four warped cascades.
/// @param to_texels           of the anchored_map of each map
/// @param planes              likewise
/// @param rounding            one column per map: rounding of its anchored_map
/// @param slack               likewise
/// @param fades               one column per map: scale and offset for cascade_fade
/// @param anchor              xyz: the one anchor of all maps
/// @param ahead               distance along the camera's axis: dot(ahead.xyz, world - anchor) + ahead.w
/// @param ends                xyz: ends of the first three cascades; w: number of the last one
/// @param world               position of the point
/// @param normal              its normal
/// @return                    both places. The second has a weight of 0 where only the first counts
/// @exactness                 C, n = 121: as anchored_place
[[nodiscard]] UMBRAGE_INLINE inline std::array<map_place, 2> warped_maps_places(
    const std::array<glm::mat4, 4>& to_texels, const std::array<glm::mat4, 4>& planes, const glm::mat4& rounding,
    const glm::mat4& slack, const glm::mat4& fades, const glm::vec4& anchor, const glm::vec4& ahead,
    const glm::vec4& ends, const shadow_terms&, glm::vec3 world, glm::vec3 normal) {
    const glm::vec3 way = world - glm::vec3(anchor);
    const auto in_map = [&](std::size_t i, float weight) {
        const auto column = static_cast<glm::length_t>(i);
        map_place place = anchored_place(to_texels[i], planes[i], rounding[column], slack[column], way, normal);
        place.number = static_cast<int>(i), place.weight = weight;
        return place;
    };
    const float depth = ahead.x * way.x + ahead.y * way.y + ahead.z * way.z + ahead.w;
    const float number = cascade_by_depth(depth, glm::vec3(ends));
    const glm::vec4 own = cascade_column(fades, number);
    const float weight = cascade_fade(depth, own.x, own.y);
    const auto own_map = static_cast<std::size_t>(number);
    std::array<map_place, 2> both{in_map(own_map, 1.0f), map_place{.weight = 0.0f}};
    if (!(weight > 0.0f)) return both;
    both[1] = in_map(own_map < 3 ? own_map + 1 : 3, weight);
    if (!(number < ends.w)) both[1].number = static_cast<int>(ends.w), both[1].at = outside_all_maps;
    return both;
}

namespace glsl {

inline constexpr snippet warped_maps_places{
    .name = "warped_maps_places",
    .summary = "places of a point of the world in up to four warped cascades",
    .exactness = tier::c,
    .operations = 121,
    .needs = list<&anchored_place, &cascade_by_depth, &cascade_column, &cascade_fade>,
    .source = R"GLSL(
// umbrage_warped_maps_places: places of a point of the world in one or two of up to four warped cascades
//   to_texels_0 to planes_3   matrices of umbrage_anchored_place for each map
//   rounding, slack           one column per map: its rounding and slack there
//   fades                     one column per map: scale and offset of the next one's weight
//   anchor                    the one anchor of all maps
//   ahead                     distance along the camera's axis: dot(ahead.xyz, world - anchor) + ahead.w
//   ends                      ends of the first three cascades, number of the last one
//   returns (texels, texels, depth, number), (slope, slope, weight, slack) of both. After the last: outside, lit
UMBRAGE_HIGHP mat4 umbrage_warped_maps_places(UMBRAGE_HIGHP mat4 to_texels_0, UMBRAGE_HIGHP mat4 to_texels_1,
                                              UMBRAGE_HIGHP mat4 to_texels_2, UMBRAGE_HIGHP mat4 to_texels_3,
                                              UMBRAGE_HIGHP mat4 planes_0, UMBRAGE_HIGHP mat4 planes_1,
                                              UMBRAGE_HIGHP mat4 planes_2, UMBRAGE_HIGHP mat4 planes_3,
                                              UMBRAGE_HIGHP mat4 rounding, UMBRAGE_HIGHP mat4 slack,
                                              UMBRAGE_HIGHP mat4 fades, UMBRAGE_HIGHP vec4 anchor,
                                              UMBRAGE_HIGHP vec4 ahead, UMBRAGE_HIGHP vec4 ends,
                                              UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec3 world,
                                              UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = ahead.x * way.x + ahead.y * way.y + ahead.z * way.z + ahead.w;
    UMBRAGE_HIGHP float number = umbrage_cascade_by_depth(depth, vec3(ends.x, ends.y, ends.z));
    UMBRAGE_HIGHP vec4 own = umbrage_cascade_column(fades, number);
    UMBRAGE_HIGHP float weight = umbrage_cascade_fade(depth, own.x, own.y);
    UMBRAGE_HIGHP mat4 to_texels = to_texels_0;
    UMBRAGE_HIGHP mat4 planes = planes_0;
    UMBRAGE_HIGHP mat4 to_next = to_texels_1;
    UMBRAGE_HIGHP mat4 next_planes = planes_1;
    if (number > 0.5) {
        to_texels = to_texels_1;
        planes = planes_1;
        to_next = to_texels_2;
        next_planes = planes_2;
    }
    if (number > 1.5) {
        to_texels = to_texels_2;
        planes = planes_2;
        to_next = to_texels_3;
        next_planes = planes_3;
    }
    if (number > 2.5) {
        to_texels = to_texels_3;
        planes = planes_3;
    }
    UMBRAGE_HIGHP mat4 at = umbrage_anchored_place(to_texels, planes, umbrage_cascade_column(rounding, number),
                                                   umbrage_cascade_column(slack, number), way, normal);
    UMBRAGE_HIGHP mat4 there =
        umbrage_anchored_place(to_next, next_planes, umbrage_cascade_column(rounding, number + 1.0),
                               umbrage_cascade_column(slack, number + 1.0), way, normal);
    UMBRAGE_HIGHP vec3 after = vec3(there[0].x, there[0].y, there[0].z);
    UMBRAGE_HIGHP vec3 next = number >= ends.w ? vec3(-65536.0, -65536.0, 0.0) : after;
    return mat4(vec4(at[0].x, at[0].y, at[0].z, number), at[1], vec4(next, min(number + 1.0, ends.w)),
                vec4(there[1].x, there[1].y, weight, there[1].w));
}
)GLSL",
};

inline constexpr const snippet* warped_places_snippets[]{&warped_maps_places};

}  // namespace glsl
}  // namespace umbrage
