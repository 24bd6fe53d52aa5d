// SPDX-License-Identifier: MIT
//
// Shadow with one map, of a spot light or of a directional light, whose map may be fitted or warped.
//
//     umbrage::shadow lamp(umbrage::make_spot_light({...}), {1024, 1024}, umbrage::filters::tent<3>);
//
#pragma once

#include <array>
#include <vector>

#include <umbrage/core/config.hpp>
#include <umbrage/shadow/anchored_map.hpp>
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

inline constexpr const snippet* single_map_snippets[]{&single_map_places};

}  // namespace glsl

/// Setup of one map.
struct single_map {
    light_space<double> light;

    template <real T>
    explicit single_map(const light_space<T>& space) : light(detail::in_double(space)) {}

    using uniforms = anchored_map;
    static constexpr uniform_field fields[]{
        {"to_texels"}, {"planes"}, {"anchor", false}, {"rounding", false}, {"slack", false}};
    static constexpr map_grid grid{1, 1};
    static constexpr outside_map outside = outside_map::bordered;

    [[nodiscard]] clip_space clip() const { return light.clip; }
    [[nodiscard]] std::vector<light_space<double>> lights() const { return {light}; }
    [[nodiscard]] uniforms make_uniforms(glm::ivec2 map_size, glm::dvec3 origin) const {
        return make_anchored_map(light, map_size, origin);
    }

    [[nodiscard]] UMBRAGE_INLINE static std::array<map_place, 1> places(const uniforms& u, const shadow_terms& terms,
                                                                        glm::vec3 world, glm::vec3 normal) {
        return single_map_places(u.to_texels, u.planes, u.anchor, u.rounding, u.slack, terms, world, normal);
    }
    static constexpr const glsl::snippet* placing = &glsl::single_map_places;
};

/// Setup of a light with one map.
template <real T>
struct setup_for<light_space<T>> {
    using type = single_map;
};

}  // namespace umbrage
