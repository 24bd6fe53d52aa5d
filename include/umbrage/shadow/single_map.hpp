// SPDX-License-Identifier: MIT
//
// Shadow with one map, of a spot light or of a directional light, whose map may be fitted or warped.
//
//     umbrage::shadow lamp(umbrage::make_spot_light({...}), {1024, 1024}, umbrage::filters::tent<3>);
//
#pragma once

#include <array>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/penumbra_shape.hpp>
#include <umbrage/shadow/place_blocks.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

/// Place of a point of the world in a light's one map.
/// @param to_texels                             make_anchored_map of the light
/// @param planes                                likewise
/// @param anchor                                likewise
/// @param rounding                              likewise
/// @param slack                                 likewise
/// @param world                                 position of the point
/// @param normal                                its normal
/// @return                                      its place, with weight 1
/// @exactness                                   C, n = 121: as anchored_place
[[nodiscard]] UMBRAGE_INLINE inline std::array<map_place, 1> single_map_places(
    const glm::mat4& to_texels, const glm::mat4& planes, const glm::vec4& anchor, const glm::vec4& rounding,
    const glm::vec4& slack, const shadow_terms&, glm::vec3 world, glm::vec3 normal) {
    return {anchored_place(to_texels, planes, rounding, slack, world - glm::vec3(anchor), normal)};
}

/// single_map_places under parallel rays, where w is 1, with the same result.
/// @param to_texels                             make_anchored_map of a light with parallel rays
/// @param planes                                likewise
/// @param anchor                                likewise
/// @param slack                                 likewise
/// @param world                                 position of the point
/// @param normal                                its normal
/// @return                                      its place, with weight 1
/// @formula     place = to_texels way + (0, 0, a); slack = t steep + p |z| + q, as anchored_place
/// @exactness   C, n = 121: as anchored_place
[[nodiscard]] UMBRAGE_INLINE inline std::array<map_place, 1> parallel_map_places(
    const glm::mat4& to_texels, const glm::mat4& planes, const glm::vec4& anchor, const glm::vec4&,
    const glm::vec4& slack, const shadow_terms&, glm::vec3 world, glm::vec3 normal) {
    const glm::vec4 c = shadow_coordinate(to_texels, world - glm::vec3(anchor));
    const glm::vec4 q = planes[0] * normal.x + planes[1] * normal.y + planes[2] * normal.z;
    const glm::vec2 slope = cascade_slope(glm::vec3(q), glm::vec4(1));
    const float steep = glm::abs(slope.x) + glm::abs(slope.y), off = glm::abs(c.z) * slack.y + slack.z;
    return {map_place{.at = {c.x, c.y, c.z + slack.w}, .slope = slope, .slack = slack.x * steep + off}};
}

namespace glsl {

inline constexpr snippet single_map_places{
    .name = "single_map_places",
    .summary = "place of a point of the world in a light's one map",
    .exactness = tier::c,
    .operations = 121,
    .needs = list<&anchored_place>,
    .source = R"GLSL(
// umbrage_single_map_places: place of a point of the world in a light's one map
//   to_texels, planes, rounding, slack   of umbrage_anchored_place, which has what it returns
//   anchor                               position that is subtracted from world
UMBRAGE_HIGHP mat4 umbrage_single_map_places(UMBRAGE_HIGHP mat4 to_texels, UMBRAGE_HIGHP mat4 planes,
                                             UMBRAGE_HIGHP vec4 anchor, UMBRAGE_HIGHP vec4 rounding,
                                             UMBRAGE_HIGHP vec4 slack, UMBRAGE_HIGHP vec4 terms,
                                             UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    return umbrage_anchored_place(to_texels, planes, rounding, slack, way, normal);
}
)GLSL",
};

inline constexpr snippet parallel_map_places{
    .name = "parallel_map_places",
    .summary = "place of a point of the world in the one map of a light with parallel rays",
    .exactness = tier::c,
    .operations = 121,
    .needs = list<&cascade_slope>,
    .source = R"GLSL(
// umbrage_parallel_map_places: umbrage_single_map_places under parallel rays, where w is 1
UMBRAGE_HIGHP mat4 umbrage_parallel_map_places(UMBRAGE_HIGHP mat4 to_texels, UMBRAGE_HIGHP mat4 planes,
                                               UMBRAGE_HIGHP vec4 anchor, UMBRAGE_HIGHP vec4 rounding,
                                               UMBRAGE_HIGHP vec4 slack, UMBRAGE_HIGHP vec4 terms,
                                               UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec4 none = vec4(0.0, 0.0, 0.0, 0.0);
    UMBRAGE_HIGHP vec4 one = vec4(1.0, 1.0, 1.0, 1.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 c = to_texels[3] + to_texels[0] * way.x + to_texels[1] * way.y + to_texels[2] * way.z;
    UMBRAGE_HIGHP vec4 q = planes[0] * normal.x + planes[1] * normal.y + planes[2] * normal.z;
    UMBRAGE_HIGHP vec2 slope = umbrage_cascade_slope(vec3(q.x, q.y, q.z), one);
    UMBRAGE_HIGHP float steep = abs(slope.x) + abs(slope.y);
    UMBRAGE_HIGHP float off = abs(c.z) * slack.y + slack.z;
    return mat4(vec4(c.x, c.y, c.z + slack.w, 0.0), vec4(slope, 1.0, slack.x * steep + off), none, none);
}
)GLSL",
};

inline constexpr const snippet* single_map_snippets[]{&single_map_places, &parallel_map_places};

}  // namespace glsl

/// Setup of one map.
struct single_map {
    light_space<double> light;
    const glsl::snippet* placing;  ///< that of parallel rays costs less
    bool warped;                   ///< true where the shape of penumbras changes, or is sheared

    /// @throws std::invalid_argument  clip unset; light.parallel true, but a projection with perspective
    template <real T>
    explicit single_map(const light_space<T>& space)
        : light(detail::in_double(space)),
          placing(light.parallel ? &glsl::parallel_map_places : &glsl::single_map_places) {
        detail::require_given(light.clip, "shadow", "light.clip");
        const glm::ivec2 one_texel(1);
        warped = detail::warp_of(texture_matrix(light, one_texel), one_texel) != glm::vec4(0, 0, 0, 1);
        const glm::dmat4 rows = glm::transpose(light.projection * light.view);
        detail::require(!light.parallel || rows[3] == glm::dvec4(0, 0, 0, 1), "shadow", "light.parallel",
                        "false for a projection with perspective", light.parallel);
    }

    using uniforms = anchored_map;
    static constexpr uniform_field fields[]{
        {"to_texels"}, {"planes"}, {"anchor", false}, {"rounding", false}, {"slack", false}};
    static constexpr map_grid grid{1, 1};
    static constexpr outside_map outside = outside_map::bordered;

    [[nodiscard]] clip_space clip() const { return light.clip; }
    [[nodiscard]] bool is_warped() const { return warped; }
    [[nodiscard]] std::vector<light_space<double>> lights() const { return {light}; }
    [[nodiscard]] uniforms make_uniforms(glm::ivec2 map_size, glm::dvec3 origin) const {
        return make_anchored_map(light, map_size, origin);
    }

    [[nodiscard]] UMBRAGE_INLINE static std::array<map_place, 1> places(const uniforms& u, const shadow_terms& terms,
                                                                        glm::vec3 world, glm::vec3 normal) {
        return single_map_places(u.to_texels, u.planes, u.anchor, u.rounding, u.slack, terms, world, normal);
    }
    template <bool Forward>
    UMBRAGE_INLINE static void place_block(const uniforms& u, const shadow_terms& terms, const glm::vec3* points,
                                           const glm::vec3* normals, const detail::place_row& to) {
        detail::place_anchored_block<Forward>(u, terms, points, normals, to);
    }
};

/// A light's one map may be warped.
template <>
inline constexpr bool has_warps<single_map> = true;

/// Setup of a light with one map.
template <real T>
struct setup_for<light_space<T>> {
    using type = single_map;
};

}  // namespace umbrage
