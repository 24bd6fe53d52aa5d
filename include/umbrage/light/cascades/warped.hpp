// SPDX-License-Identifier: MIT
//
// Cascades each of which is warped: the parts of a camera's range share out what one warp cannot reach.
//
//     const auto cascades = umbrage::make_warped_cascades<4>(
//         fit, splits, [](const auto& part) { return umbrage::fit_light_space_perspective(part); });
//     for (const auto& c : cascades) draw_depths(c.light);                               // a depth pass each
//     const auto uniforms = umbrage::make_cascade_uniforms(cascades, fit.map_size, 0.1f);  // for shaders
//
// In a shader with four of them, which have one vec3 of ends:
//
//     uniform mat4 to_texels[4];  uniform vec3 ends;  uniform vec2 fades[4];
//     float number = umbrage_cascade_by_depth(view_depth, ends);
//     vec3 at = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels[int(number)], world));
//     float weight = umbrage_cascade_fade(view_depth, fades[int(number)].x, fades[int(number)].y);  // of the next
//
// A pixel takes the cascade that cascade_by_depth names: their maps are turned and bent each in its own way, so that
// there is no common rotation for cascade_by_projection.
#pragma once

#include <array>
#include <cstddef>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/light/bounds.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/warp_fit.hpp>

namespace umbrage {

/// One part of the camera's range and its warped map.
template <real T>
struct warped_cascade {
    light_space<T> light;        ///< for the depth pass
    T strength = T(0);           ///< as warped_light has it
    T begin = T(0), end = T(0);  ///< distances along the camera's axis
};

/// A warped map for each part of the camera's range, around what that has in common with the scene; where that is
/// nothing, around the part.
///
/// @param fit      but for up: warps take the camera's direction
/// @param splits   Count + 1 distances along the camera's axis, ascending, the first 0 or above: see splits.hpp
/// @param warp     (const warp_fit<double>& part) -> warped_light<double>, whose margin is as many texels as fit's
/// @return         the nearest first, each from its split to the next
/// @throws std::invalid_argument  splits out of order, map_size, margin or overlap out of range, what warp complains
///                                of, and what gives matrices that are not finite
template <std::size_t Count, real T, class Warp>
[[nodiscard]] std::array<warped_cascade<T>, Count> make_warped_cascades(const cascade_fit<T>& fit,
                                                                        const std::array<T, Count + 1>& splits,
                                                                        Warp&& warp) {
    constexpr auto function = "make_warped_cascades";
    const bounding_box<double> scene{glm::dvec3(fit.scene.low), glm::dvec3(fit.scene.high)};
    const auto parts = detail::camera_parts<Count>(fit, splits, function);
    std::array<warped_cascade<T>, Count> all;
    for (std::size_t i = 0; i < Count; ++i) {
        const warped_light<double> own = warp(warp_fit<double>{.camera = parts[i],
                                                               .direction = glm::dvec3(fit.direction),
                                                               .receivers = detail::receivers_of(parts[i], scene),
                                                               .casters = scene,
                                                               .margin = detail::margin_share(fit),
                                                               .clip = fit.clip});
        const light_space<T> light{glm::mat<4, 4, T>(own.light.view), glm::mat<4, 4, T>(own.light.projection),
                                   own.light.clip};
        all[i] = {detail::checked(light, function, "camera, splits and scene"), T(own.strength), splits[i],
                  splits[i + 1]};
    }
    return all;
}

/// What a shader of warped cascades takes.
template <real T, std::size_t Count>
struct warped_cascade_uniforms {
    std::array<glm::mat<4, 4, T>, Count> to_texels;  ///< world to each map, for shadow_coordinate
    /// Of the cascades but the last, three at a time, filled up with the highest float: the sum of cascade_by_depth
    /// over all of them is a cascade's number.
    std::array<glm::vec<3, T>, detail::ends_groups<Count>> ends;
    std::array<glm::vec<2, T>, Count> fades;  ///< scale and offset of cascade_fade
};

/// @param map_size   of each cascade, texels
/// @param fade       share of each cascade over which the next one takes over, 0 .. 1; after the last, full light.
///                   cascade_fit::overlap must be as much
/// @throws std::invalid_argument  map_size below 1, fade out of range
template <real T, std::size_t Count>
[[nodiscard]] warped_cascade_uniforms<T, Count> make_cascade_uniforms(
    const std::array<warped_cascade<T>, Count>& cascades, glm::ivec2 map_size, T fade) {
    constexpr auto function = "make_cascade_uniforms";
    static_assert(Count >= 1);
    detail::require(map_size.x >= 1 && map_size.y >= 1, function, "map_size", "above 0", map_size);
    detail::require_fade(fade);
    warped_cascade_uniforms<T, Count> u;
    u.ends = detail::ends_of<T>(cascades);
    for (std::size_t i = 0; i < Count; ++i) {
        const warped_cascade<T>& c = cascades[i];
        u.to_texels[i] = texture_matrix(c.light, map_size);
        u.fades[i] = detail::fade_of(c.begin, c.end, fade);
    }
    return u;
}

/// Warped cascades of double for points relative to an origin: see texture_matrix. Their depth passes take relative_to.
/// @throws std::invalid_argument  map_size below 1, fade out of range, what is not finite in float
template <std::size_t Count>
[[nodiscard]] warped_cascade_uniforms<float, Count> make_cascade_uniforms(
    const std::array<warped_cascade<double>, Count>& cascades, glm::ivec2 map_size, float fade, glm::dvec3 origin) {
    std::array<warped_cascade<float>, Count> all;
    for (std::size_t i = 0; i < Count; ++i) {
        const warped_cascade<double>& c = cascades[i];
        all[i] = {relative_to(c.light, origin), float(c.strength), float(c.begin), float(c.end)};
    }
    auto u = make_cascade_uniforms(all, map_size, fade);
    for (std::size_t i = 0; i < Count; ++i) u.to_texels[i] = texture_matrix(cascades[i].light, map_size, origin);
    return u;
}

}  // namespace umbrage
