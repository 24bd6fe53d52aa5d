// SPDX-License-Identifier: MIT
//
// Warped cascades of a directional light (LiSPSM, TSM, PSM), up to four, with one map per cascade. The distance along
// the camera's axis chooses a receiver's map. The next map blends in near that map's end.
//
//     const auto cascades = umbrage::make_warped_cascades<4>(
//         fit, splits, [](const auto& part) { return umbrage::fit_light_space_perspective(part); });
//     umbrage::shadow sun(umbrage::warped_maps(cascades, fit.camera, fit.overlap), fit.map_size, filter);
//
// Each map has its own matrix, as each warp differs. A map holds only the casters of its own part of the view. So a
// point never takes the map of another part, unlike in `cascaded_maps`.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/geometric.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/light/cascades/warped.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/setup.hpp>
#include <umbrage/shadow/warped_places.hpp>

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
        std::array<glm::mat4, 4> to_texels, planes;  ///< those of each map's anchored_map
        glm::mat4 rounding, slack;                   ///< one column per map: its rounding and slack
        glm::mat4 fades;                             ///< one column per map: scale and offset for cascade_fade
        glm::vec4 anchor;                            ///< xyz: position of the camera, the anchor of all maps
        glm::vec4 ahead;  ///< distance along the camera's axis: dot(ahead.xyz, world - anchor) + ahead.w
        glm::vec4 ends;   ///< xyz: ends of the first three cascades; w: number of the last one
    };
    static constexpr uniform_field fields[]{{"to_texels_0"},  {"to_texels_1"}, {"to_texels_2"}, {"to_texels_3"},
                                            {"planes_0"},     {"planes_1"},    {"planes_2"},    {"planes_3"},
                                            {"rounding"},     {"slack"},       {"fades"},       {"anchor", false},
                                            {"ahead", false}, {"ends", false}};
    static constexpr map_grid grid{2, 2};
    static constexpr outside_map outside = outside_map::bordered;

    /// @throws std::invalid_argument  no cascade, or more than there are maps
    [[nodiscard]] clip_space clip() const {
        require_cascades();
        return cascades.front().light.clip;
    }
    [[nodiscard]] static bool is_warped() { return true; }
    /// Anchor of receivers and of vertices: what is near the camera needs the most digits.
    [[nodiscard]] glm::dvec3 anchor() const { return position; }
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
        const glm::dvec3 own_anchor = detail::in_binary32(anchor() - origin);
        u.anchor = glm::vec4(glm::vec3(own_anchor), 0.0f);
        u.ahead = glm::vec4(glm::dvec4(axis, glm::dot(axis, own_anchor + origin - position)));
        for (std::size_t i = 0; i < 4; ++i) {
            const warped_cascade<double>& c = cascades[i < cascades.size() ? i : cascades.size() - 1];
            const auto column = static_cast<glm::length_t>(i);
            const glm::dmat4 here = texture_matrix(detail::relative_to(origin, c.light), map_size);
            const anchored_map map = detail::anchored_at(own_anchor, here, map_size, c.light.clip);
            u.to_texels[i] = map.to_texels, u.planes[i] = map.planes;
            u.rounding[column] = map.rounding, u.slack[column] = map.slack;
            u.fades[column] = glm::vec4(glm::dvec4(detail::fade_of(c.begin, c.end, fade), 0.0, 0.0));
            if (i + 1 < cascades.size()) u.ends[column] = float(c.end);
        }
        return u;
    }

    [[nodiscard]] UMBRAGE_INLINE static std::array<map_place, 2> places(const uniforms& u, const shadow_terms&,
                                                                        glm::vec3 world, glm::vec3 normal) {
        const glm::vec2 choice = warped_maps_choice(u.fades, u.anchor, u.ahead, u.ends, world);
        return chosen_places(choice, [&](float number) UMBRAGE_INLINE {
            return warped_maps_place(u.to_texels, u.planes, u.rounding, u.slack, u.anchor, u.ends, world, normal,
                                     number);
        });
    }
    static constexpr choice_function choosing{&glsl::warped_maps_choice, "fades, anchor, ahead, ends, "};
    static constexpr const glsl::snippet* placing = &glsl::warped_maps_place;

private:
    void require_cascades() const {
        detail::require(!cascades.empty() && cascades.size() <= 4, "shadow", "light.cascades.size()", "from 1 to 4",
                        cascades.size(), "A setup that was moved from has none.");
    }
};

/// All of its maps are warped.
template <>
inline constexpr bool has_warps<warped_maps> = true;

/// Refuses an array of warped cascades, which lacks its camera.
template <real T, std::size_t Count>
struct setup_for<std::array<warped_cascade<T>, Count>> {
    static_assert(
        Count == 0,
        "warped cascades are chosen along the camera's axis: take warped_maps(cascades, camera) as the light");
};

}  // namespace umbrage
