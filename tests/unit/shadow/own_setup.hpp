// SPDX-License-Identifier: MIT
//
// A setup of a user's own: a lamp that shines up and down, with a map of each.
#pragma once

#include <array>
#include <vector>

#include <umbrage/light/spot_light.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/setup.hpp>

namespace own {

namespace glsl = umbrage::glsl;

inline constexpr glsl::snippet up_and_down_places{.name = "up_and_down_places",
                                                  .summary = "place of a point below or above a lamp",
                                                  .exactness = glsl::tier::c,
                                                  .operations = 30,
                                                  .needs = glsl::list<&glsl::anchored_place>,
                                                  .source = R"GLSL(
// umbrage_up_and_down_places: place of a point of the world in the map below the lamp, or in that above it
UMBRAGE_HIGHP mat4 umbrage_up_and_down_places(UMBRAGE_HIGHP mat4 down, UMBRAGE_HIGHP mat4 down_planes,
                                              UMBRAGE_HIGHP mat4 up, UMBRAGE_HIGHP mat4 up_planes,
                                              UMBRAGE_HIGHP vec4 anchor, UMBRAGE_HIGHP vec4 rounding,
                                              UMBRAGE_HIGHP mat4 slack, UMBRAGE_HIGHP vec4 terms,
                                              UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP mat4 below = umbrage_anchored_place(down, down_planes, rounding, slack[0], way, normal);
    UMBRAGE_HIGHP mat4 above = umbrage_anchored_place(up, up_planes, rounding, slack[1], way, normal);
    bool is_above = way.y > 0.0;
    UMBRAGE_HIGHP vec4 at = is_above ? above[0] : below[0];
    UMBRAGE_HIGHP vec4 slope = is_above ? above[1] : below[1];
    return mat4(vec4(at.x, at.y, at.z, is_above ? 1.0 : 0.0), slope, below[2], below[3]);
}
)GLSL"};

struct up_and_down {
    glm::dvec3 position;
    umbrage::clip_space of;

    struct uniforms {
        glm::mat4 down, down_planes, up, up_planes;
        glm::vec4 anchor, rounding;
        glm::mat4 slack;
    };
    static constexpr umbrage::uniform_field fields[]{{"down"},          {"down_planes"},     {"up"},   {"up_planes"},
                                                     {"anchor", false}, {"rounding", false}, {"slack"}};
    static constexpr umbrage::map_grid grid{2, 1};
    static constexpr umbrage::outside_map outside = umbrage::outside_map::bordered;

    [[nodiscard]] umbrage::clip_space clip() const { return of; }
    [[nodiscard]] std::vector<umbrage::light_space<double>> lights() const {
        std::vector<umbrage::light_space<double>> both;
        for (const double y : {-1.0, 1.0})
            both.push_back(umbrage::make_spot_light<double>({.position = position,
                                                             .direction = {0, y, 0},
                                                             .up = {0, 0, 1},
                                                             .outer_angle_radians = 1.2,
                                                             .clip = of}));
        return both;
    }
    [[nodiscard]] uniforms make_uniforms(glm::ivec2 map_size, glm::dvec3 origin) const {
        const auto both = lights();
        const umbrage::anchored_map down = umbrage::make_anchored_map(both[0], map_size, origin),
                                    up = umbrage::make_anchored_map(both[1], map_size, origin);
        return {down.to_texels,
                down.planes,
                up.to_texels,
                up.planes,
                down.anchor,
                down.rounding,
                glm::mat4(down.slack, up.slack, glm::vec4(0), glm::vec4(0))};
    }
    [[nodiscard]] static std::array<umbrage::map_place, 1> places(const uniforms& u, const umbrage::shadow_terms&,
                                                                  glm::vec3 world, glm::vec3 normal) {
        const glm::vec3 way = world - glm::vec3(u.anchor);
        const bool is_above = way.y > 0.0f;
        auto place = umbrage::anchored_place(is_above ? u.up : u.down, is_above ? u.up_planes : u.down_planes,
                                             u.rounding, u.slack[is_above], way, normal);
        place.number = is_above;
        return {place};
    }
    static constexpr const glsl::snippet* placing = &up_and_down_places;
};

}  // namespace own
