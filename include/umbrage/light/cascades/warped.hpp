// SPDX-License-Identifier: MIT
//
// Cascades with warped maps: each slice of the camera's range has its own warp, as one warp cannot serve them all.
//
//     const auto cascades = umbrage::make_warped_cascades<4>(
//         fit, splits, [](const auto& part) { return umbrage::fit_light_space_perspective(part); });
//     for (const auto& c : cascades) draw_depths(c.light);                               // one depth pass each
//     const auto uniforms = umbrage::make_cascade_uniforms(cascades, fit.map_size, 0.1f);  // for shaders
//
// In a shader with four cascades, which need one vec3 of ends:
//
//     uniform mat4 to_texels[4];  uniform vec3 ends;  uniform vec2 fades[4];
//     float number = umbrage_cascade_by_depth(view_depth, ends);
//     vec3 at = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels[int(number)], world));
//     float weight = umbrage_cascade_fade(view_depth, fades[int(number)].x, fades[int(number)].y);  // of the next
//
// Select the cascade with `cascade_by_depth`. `cascade_by_projection` needs one rotation, but here each map has its
// own. See also: cascades.hpp without warps, warp/warp_fit.hpp.
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

/// One slice of the camera's range, and its warped map.
template <real T>
struct warped_cascade {
    light_space<T> light;        ///< light for the depth pass
    T strength = T(0);           ///< strength of the warp, as in warped_light
    T begin = T(0), end = T(0);  ///< slice along the camera's axis, world units
};

/// Warped maps, one per slice of the camera's range. Each covers the part of the scene that its slice sees. If the
/// slice sees nothing or one point, the map covers the whole slice.
///
/// @param fit      camera, light and scene. Its up is not used: warps take the camera's direction
/// @param splits   Count + 1 distances along the camera's axis, increasing, the first >= 0: see splits.hpp
/// @param warp     (const warp_fit<T>& part) -> warped_light<T>; the part has fit's margin in texels
/// @return         cascades from near to far
/// @throws std::invalid_argument  splits out of order; map_size, margin or overlap out of range; clip or scene unset;
///                                errors of warp; matrices that would not be finite
template <std::size_t Count, real T, class Warp>
[[nodiscard]] std::array<warped_cascade<T>, Count> make_warped_cascades(const cascade_fit<T>& fit,
                                                                        const std::array<T, Count + 1>& splits,
                                                                        Warp&& warp) {
    constexpr auto function = "make_warped_cascades";
    const bounding_box<double> scene{glm::dvec3(fit.scene.low), glm::dvec3(fit.scene.high)};
    const auto parts = detail::camera_parts<Count>(fit, splits, function);
    std::array<warped_cascade<T>, Count> all;
    for (std::size_t i = 0; i < Count; ++i) {
        frustum<T> camera = fit.camera;
        camera.z_near = T(parts[i].z_near), camera.z_far = T(parts[i].z_far);
        // in T, so that the warp leaves the depth that rounding to T moves receivers by
        const warped_light<T> own = warp(warp_fit<T>{.camera = camera,
                                                     .direction = fit.direction,
                                                     .receivers = detail::receivers_of(parts[i], scene),
                                                     .casters = fit.scene,
                                                     .margin = T(detail::margin_share(fit)),
                                                     .clip = fit.clip});
        all[i] = {detail::checked(own.light, function, "camera, splits and scene"), own.strength, splits[i],
                  splits[i + 1]};
    }
    return all;
}

/// Uniforms of a shader with warped cascades.
template <real T, std::size_t Count>
struct warped_cascade_uniforms {
    std::array<glm::mat<4, 4, T>, Count> to_texels;  ///< world to each map's texels, for shadow_coordinate
    /// Ends of all cascades but the last, in groups of three. The rest is filled up with the highest float. The sum of
    /// cascade_by_depth over all groups is the cascade.
    std::array<glm::vec<3, T>, detail::ends_groups<Count>> ends;
    std::array<glm::vec<2, T>, Count> fades;  ///< scale and offset for cascade_fade
};

/// Uniforms of warped cascades.
/// @param cascades   from make_warped_cascades
/// @param map_size   size of each map, texels
/// @param fade       fraction of each cascade over which it fades into the next one, 0 to 1. The last one fades to lit.
///                   cascade_fit::overlap must be at least as large
/// @throws std::invalid_argument  map_size below 1; fade out of range, or too small for finite uniforms
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

/// Uniforms of warped cascades in double, for points relative to an origin: see texture_matrix. In their depth passes
/// use relative_to.
/// @throws std::invalid_argument  map_size below 1; fade out of range; values that would not be finite in float
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
