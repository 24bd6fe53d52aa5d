// SPDX-License-Identifier: MIT
//
// Cascades each of which is warped: the parts of a camera's range share out what one warp cannot reach.
//
//     const auto cascades = umbrage::make_warped_cascades<4>(
//         fit, splits, [](const auto& part) { return umbrage::fit_light_space_perspective(part); });
//     draw_depths(cascades[i].light);
//     glm::mat4 to_texels = umbrage::texture_matrix(cascades[i].light, map_size);  // of each, for shaders
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
#include <umbrage/light/warp/warp_fit.hpp>

namespace umbrage {

/// A warped map for each part of the camera's range, around what that has in common with the scene; where that is
/// nothing, around the part.
///
/// @param fit      but for up: warps take the camera's direction
/// @param splits   Count + 1 distances along the camera's axis, ascending, the first 0 or above: see splits.hpp
/// @param warp     (const warp_fit<double>& part) -> warped_light<double>, whose margin is as many texels as fit's
/// @return         the nearest first
/// @throws std::invalid_argument  splits out of order, map_size, margin or overlap out of range, what warp complains
///                                of, and what gives matrices that are not finite
template <std::size_t Count, real T, class Warp>
[[nodiscard]] std::array<warped_light<T>, Count> make_warped_cascades(const cascade_fit<T>& fit,
                                                                      const std::array<T, Count + 1>& splits,
                                                                      Warp&& warp) {
    constexpr auto function = "make_warped_cascades";
    const bounding_box<double> scene{glm::dvec3(fit.scene.low), glm::dvec3(fit.scene.high)};
    const auto parts = detail::camera_parts<Count>(fit, splits, function);
    std::array<warped_light<T>, Count> all;
    for (std::size_t i = 0; i < Count; ++i) {
        const warped_light<double> own = warp(warp_fit<double>{.camera = parts[i],
                                                               .direction = glm::dvec3(fit.direction),
                                                               .receivers = detail::receivers_of(parts[i], scene),
                                                               .casters = scene,
                                                               .margin = detail::margin_share(fit),
                                                               .clip = fit.clip});
        const light_space<T> light{glm::mat<4, 4, T>(own.light.view), glm::mat<4, 4, T>(own.light.projection),
                                   own.light.clip};
        all[i] = {detail::checked(light, function, "camera, splits and scene"), T(own.strength)};
    }
    return all;
}

}  // namespace umbrage
