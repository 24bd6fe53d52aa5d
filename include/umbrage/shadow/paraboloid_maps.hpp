// SPDX-License-Identifier: MIT
//
// Dual paraboloid shadow maps of a point light: two maps, each with a paraboloid's image of half of all directions.
// They need two passes where a cube map needs six, and a mesh of short edges. They store distances, not depths.
//
//     const umbrage::dual_paraboloid_light<float> bulb{.position = p, .range = 30, .border = 3, .clip = clip};
//     umbrage::shadow lamp(bulb, {512, 512}, umbrage::filters::tent<3>);
//
#pragma once

#include <string>
#include <vector>

#include <umbrage/bias/distance_slope.hpp>
#include <umbrage/core/check.hpp>
#include <umbrage/depth/conversions.hpp>
#include <umbrage/images/dual_paraboloid_pass.hpp>
#include <umbrage/images/tessellate.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/point/dual_paraboloid.hpp>
#include <umbrage/shadow/set_up.hpp>

namespace umbrage {

/// Setup of two paraboloid maps.
struct paraboloid_maps {
    dual_paraboloid_light<double> light;

    template <real T>
    explicit paraboloid_maps(const dual_paraboloid_light<T>& l)
        : light{glm::dvec3(l.position), double(l.range), l.map_size, l.border, l.clip} {
        static_cast<void>(make_dual_paraboloid_light(light));  // checks the light
    }

    struct uniforms {
        glm::vec4 position;  ///< position of the light; w: depth per world unit, 1 / range, or reversed -1 / range
        glm::vec4 halves;    ///< x: map_size - 2 border; y: border; z: 2 / (range x); w: depth at the light
    };
    static constexpr uniform_field fields[]{{"position", false}, {"halves", false}};
    static constexpr map_grid grid{2, 1};
    static constexpr outside_map outside = outside_map::clamped;
    static constexpr glsl::map_choice tiles{true, glsl::cascade_tile.name, "vec2(terms.x, terms.y)"};
    static constexpr bent_lines bends{tessellation_reach<float>, 1.0f / 4096.0f};
    static constexpr glsl::vertex_place vertex{
        ", UMBRAGE_HIGHP vec3 position, UMBRAGE_HIGHP float number",
        "    UMBRAGE_HIGHP vec4 p = umbrage_dual_paraboloid_position(world - position, number);\n"
        "    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 place =\n"
        "        to_clip[3] * p.w + to_clip[0] * p.x + to_clip[1] * p.y + to_clip[2] * p.z;\n"
        "    return place;\n",
        &glsl::dual_paraboloid_position};

    [[nodiscard]] clip_space clip() const { return light.clip; }
    [[nodiscard]] std::vector<light_space<double>> lights() const { return {2, make_dual_paraboloid_light(light)}; }
    template <class ParallelFor>
    void draw(image_view<float> depths, const mesh_view& mesh, ParallelFor&& parallel) const {
        const light_space<double> space = make_dual_paraboloid_light(light);
        const light_space<float> single{glm::mat4(space.view), glm::mat4(space.projection), space.clip};
        const auto cut = tessellate(mesh, {.position = glm::vec3(light.position),
                                           .angle = float(paraboloid_edge_angle(light.map_size, light.border)),
                                           .range = float(light.range),
                                           .depth_error = bends.error});
        const glm::ivec2 size(light.map_size);
        for (const int map : {0, 1})
            rasterize_dual_paraboloid(depths.region({map * size.x, 0}, size), cut.view(), single, map, parallel);
    }
    /// @throws std::invalid_argument  a map_size other than the light's
    [[nodiscard]] uniforms make_uniforms(glm::ivec2 map_size, glm::dvec3 origin) const {
        detail::require_size(map_size, glm::ivec2(light.map_size), "shadow", "map_size", "the paraboloid light's");
        const double inner = light.map_size - 2 * light.border;
        const bool forward = light.clip.direction == depth_direction::forward;
        return {glm::vec4(glm::dvec4(light.position - origin, (forward ? 1.0 : -1.0) / light.range)),
                glm::vec4(glm::dvec4(inner, light.border, 2.0 / (light.range * inner), forward ? 0.0 : 1.0))};
    }

    template <class Look>
    [[nodiscard]] static float visibility(const uniforms& u, const shadow_terms&, glm::vec3 world, glm::vec3 normal,
                                          const Look& look) {
        const glm::vec3 way = world - glm::vec3(u.position), found = dual_paraboloid_coordinate(way);
        const glm::vec2 at = glm::vec2(found) * u.halves.x + u.halves.y;
        const float depth = distance_depth(way, u.position.w) + u.halves.w;
        return look(map_place{int(found.z), glm::vec3(at, depth), dual_paraboloid_slope(way, normal, u.halves.z)});
    }
    [[nodiscard]] static std::string text(const glsl::map_choice& choice) {
        return R"GLSL(
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(position.x, position.y, position.z);
    UMBRAGE_HIGHP vec3 found = umbrage_dual_paraboloid_coordinate(way);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 at = vec2(found.x, found.y) * halves.x + halves.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = umbrage_distance_depth(way, position.w) + halves.w;
    UMBRAGE_HIGHP vec2 slope = umbrage_dual_paraboloid_slope(way, normal, halves.z);
)GLSL" + choice.first("found.z") +
               "    return umbrage_look(map, terms, filter_terms, vec3(at.x, at.y, depth), slope);\n";
    }
    static constexpr const auto& needs = glsl::list<&glsl::dual_paraboloid_coordinate, &glsl::distance_depth,
                                                    &glsl::dual_paraboloid_slope, &glsl::cascade_tile>;
};

/// Setup of a light with paraboloid maps.
template <real T>
struct set_up_for<dual_paraboloid_light<T>> {
    using type = paraboloid_maps;
};

}  // namespace umbrage
