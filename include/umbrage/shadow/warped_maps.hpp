// SPDX-License-Identifier: MIT
//
// Warped cascades of a directional light (LiSPSM, TSM, PSM), up to four, with one map per cascade. The distance along
// the camera's axis chooses a receiver's map. Near that map's end the next one blends in.
//
//     const auto cascades = umbrage::make_warped_cascades<4>(
//         fit, splits, [](const auto& part) { return umbrage::fit_light_space_perspective(part); });
//     umbrage::shadow sun(umbrage::warped_maps(cascades, fit.camera, fit.overlap), fit.map_size, filter);
//
// Each map has its own matrix, as each warp differs. A map holds only the casters of its own part of the view. So a
// point never takes the map of another part, unlike in cascaded_maps.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include <umbrage/bias/slope.hpp>
#include <umbrage/core/check.hpp>
#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/cascades/warped.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/set_up.hpp>

namespace umbrage {

/// Setup of warped cascades.
struct warped_maps {
    std::vector<warped_cascade<double>> cascades;
    glm::dvec3 position, axis;  ///< position of the camera, and its forward axis of length 1
    double fade;                ///< fraction of each cascade that blends into the next, 0 to 1

    /// @param all      cascades from near to far
    /// @param camera   camera that the cascades were made for. Distances are along its axis
    /// @param share    fraction of each cascade over which the next one takes over, 0 to 1: cascade_fit::overlap or
    ///                 less. The last cascade fades to light
    /// @throws std::invalid_argument  a camera direction of zero or not finite; a share out of range
    template <real T, std::size_t Count>
    warped_maps(const std::array<warped_cascade<T>, Count>& all, const frustum<T>& camera, T share = T(0))
        : position(camera.position), axis(glm::normalize(glm::dvec3(camera.direction))), fade(double(share)) {
        static_assert(Count >= 1 && Count <= 4, "a shadow takes one to four warped cascades");
        detail::require(detail::all_finite(axis), "warped_maps", "camera.direction", "finite and not zero",
                        camera.direction);
        detail::require(share >= T(0) && share <= T(1), "warped_maps", "share", "from 0 to 1", share);
        for (const warped_cascade<T>& c : all)
            cascades.push_back({detail::in_double(c.light), double(c.strength), double(c.begin), double(c.end)});
    }

    struct uniforms {
        glm::mat4 to_texels[4];  ///< texture_matrix of each map
        glm::mat4 planes[4];     ///< plane_matrix of each
        glm::mat4 fades;         ///< one column per map: scale and offset for cascade_fade
        glm::vec4 ahead;         ///< distance along the camera's axis: dot(ahead.xyz, world) + ahead.w
        glm::vec4 ends;          ///< xyz: ends of the first three cascades; w: number of the last one
    };
    static constexpr uniform_field fields[]{{"to_texels_0"}, {"to_texels_1"},  {"to_texels_2"}, {"to_texels_3"},
                                            {"planes_0"},    {"planes_1"},     {"planes_2"},    {"planes_3"},
                                            {"fades"},       {"ahead", false}, {"ends", false}};
    static constexpr map_grid grid{2, 2};
    static constexpr outside_map outside = outside_map::bordered;
    static constexpr glsl::map_choice tiles{true, glsl::cascade_tile.name, "vec2(terms.x, terms.y)"};

    /// @throws std::invalid_argument  no cascade, or more than there are maps
    [[nodiscard]] clip_space clip() const {
        require_cascades();
        return cascades.front().light.clip;
    }
    [[nodiscard]] std::vector<light_space<double>> lights() const {
        std::vector<light_space<double>> all;
        for (const warped_cascade<double>& c : cascades) all.push_back(c.light);
        return all;
    }
    /// @throws std::invalid_argument  as clip()
    [[nodiscard]] uniforms make_uniforms(glm::ivec2 map_size, glm::dvec3 origin) const {
        require_cascades();
        uniforms u{};
        u.ends = glm::vec4(glm::vec3(detail::highest<float>), float(cascades.size() - 1));
        u.ahead = glm::vec4(glm::dvec4(axis, glm::dot(axis, origin - position)));
        for (std::size_t i = 0; i < 4; ++i) {
            const warped_cascade<double>& c = cascades[i < cascades.size() ? i : cascades.size() - 1];
            const auto column = static_cast<glm::length_t>(i);
            const glm::dmat4 to_texels = texture_matrix(detail::relative_to(origin, c.light), map_size);
            u.to_texels[i] = glm::mat4(to_texels), u.planes[i] = glm::mat4(plane_matrix(to_texels));
            u.fades[column] = glm::vec4(glm::dvec4(detail::fade_of(c.begin, c.end, fade), 0.0, 0.0));
            if (i + 1 < cascades.size()) u.ends[column] = float(c.end);
        }
        return u;
    }

    template <class Look>
    [[nodiscard]] static float visibility(const uniforms& u, const shadow_terms&, glm::vec3 world, glm::vec3 normal,
                                          const Look& look) {
        const auto in_map = [&](float number) {
            const auto i = static_cast<std::size_t>(number);
            return look(map_place{int(number), project_coordinate(shadow_coordinate(u.to_texels[i], world)),
                                  receiver_slope(u.planes[i], normal, world)});
        };
        const float depth = u.ahead.x * world.x + u.ahead.y * world.y + u.ahead.z * world.z + u.ahead.w;
        const float number = cascade_by_depth(depth, glm::vec3(u.ends));
        const glm::vec4 own = cascade_column(u.fades, number);
        const float nearer = in_map(number), weight = cascade_fade(depth, own.x, own.y);
        if (!(weight > 0.0f)) return nearer;
        return blend_cascades(nearer, number < u.ends.w ? in_map(number + 1.0f) : 1.0f, weight);
    }
    [[nodiscard]] static std::string text(const glsl::map_choice& choice) {
        std::string in_map;
        for (const char i : {'1', '2', '3'})
            in_map = in_map + "    if (number > " + char(i - 1) + ".5) {\n        to_texels = to_texels_" + i +
                     ";\n        planes = planes_" + i + ";\n    }\n";
        const std::string look =
            "umbrage_look(map, terms, filter_terms, umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, "
            "world)), umbrage_receiver_slope(planes, normal, world));\n";
        return R"GLSL(
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = ahead.x * world.x + ahead.y * world.y + ahead.z * world.z + ahead.w;
    UMBRAGE_HIGHP float number = umbrage_cascade_by_depth(depth, vec3(ends.x, ends.y, ends.z));
    UMBRAGE_HIGHP vec4 own = umbrage_cascade_column(fades, number);
    UMBRAGE_HIGHP float weight = umbrage_cascade_fade(depth, own.x, own.y);
    UMBRAGE_HIGHP mat4 to_texels = to_texels_0;
    UMBRAGE_HIGHP mat4 planes = planes_0;
)GLSL" + in_map +
               choice.first("number") + "    UMBRAGE_HIGHP float nearer = " + look +
               R"GLSL(    bool last = number >= ends.w;
    number = min(number + 1.0, ends.w);
)GLSL" + in_map +
               choice.again("number") +
               R"GLSL(    UMBRAGE_HIGHP float farther = 1.0;
    if (weight > 0.0 && !last) {
        farther = )GLSL" +
               look + R"GLSL(    }
    return weight > 0.0 ? umbrage_blend_cascades(nearer, farther, weight) : nearer;
)GLSL";
    }
    static constexpr const auto& needs =
        glsl::list<&glsl::shadow_coordinate, &glsl::project_coordinate, &glsl::receiver_slope, &glsl::cascade_by_depth,
                   &glsl::cascade_column, &glsl::cascade_fade, &glsl::blend_cascades, &glsl::cascade_tile>;

private:
    void require_cascades() const {
        detail::require(!cascades.empty() && cascades.size() <= 4, "shadow", "light.cascades.size()", "from 1 to 4",
                        cascades.size(), "A setup that was moved from has none.");
    }
};

/// Refuses an array of warped cascades, which lacks its camera.
template <real T, std::size_t Count>
struct set_up_for<std::array<warped_cascade<T>, Count>> {
    static_assert(
        Count == 0,
        "warped cascades are chosen along the camera's axis: take warped_maps(cascades, camera) as the light");
};

}  // namespace umbrage
