// SPDX-License-Identifier: MIT
//
// Shadows of every kind of light, for what is tried on all of them.
#pragma once

#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/filter/prefiltered/prefilters.hpp>
#include <umbrage/light/adaptive/pages.hpp>
#include <umbrage/light/adaptive/root.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/cascades/warped.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/shadow/adaptive_maps.hpp>
#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/depth_pass.hpp>
#include <umbrage/shadow/in_shader.hpp>
#include <umbrage/shadow/paraboloid_maps.hpp>
#include <umbrage/shadow/tetrahedron_map.hpp>
#include <umbrage/shadow/warped_maps.hpp>

namespace package {

inline constexpr int shadow_size = 256, shadow_border = 8;

/// Calls use(name, light) for each kind.
template <class Use>
void for_each_light(const umbrage::clip_space& clip, const Use& use) {
    const glm::vec3 position(2, 6, 3), direction(-2, -6, -3);
    const umbrage::bounding_box<float> scene{{-20, -1, -20}, {20, 5, 20}};
    const umbrage::frustum<float> camera{.position = {0, 2, 8},
                                         .direction = {0, -0.25f, -1},
                                         .tan_half_x = 0.8f,
                                         .tan_half_y = 0.5f,
                                         .z_near = 0.5f,
                                         .z_far = 60};
    const umbrage::cascade_fit<float> fit{
        .camera = camera, .direction = direction, .scene = scene, .map_size = glm::ivec2(shadow_size), .clip = clip};
    use("spot_light", umbrage::make_spot_light<float>(
                          {.position = position, .direction = direction, .z_near = 1, .z_far = 20, .clip = clip}));
    use("directional_light",
        umbrage::fit_directional_light<float>({.direction = direction, .receivers = scene, .clip = clip}));
    use("cascades", umbrage::make_stable_cascades<4>(fit, umbrage::practical_splits<4>(0.5f, 60.0f, 0.9f)));
    use("cascades_8", umbrage::make_stable_cascades<6>(fit, umbrage::practical_splits<6>(0.5f, 60.0f, 0.9f)));
    use("warped_cascades",
        umbrage::warped_maps(umbrage::make_warped_cascades<3>(
                                 fit, umbrage::practical_splits<3>(0.5f, 60.0f, 0.9f),
                                 [](const auto& part) { return umbrage::fit_light_space_perspective(part); }),
                             camera));
    use("adaptive_pages",
        umbrage::adaptive_maps(
            umbrage::make_page_root<float>({.direction = direction, .side = 60, .scene = scene, .clip = clip}),
            umbrage::page_cache({.slots = {8, 8}, .deepest_level = 4}), {.texels = 128, .gutter = 64}));
    use("point_light", umbrage::point_light<float>{.position = position,
                                                   .z_near = 0.1f,
                                                   .z_far = 30,
                                                   .map_size = shadow_size,
                                                   .border = shadow_border,
                                                   .clip = clip});
    use("tetrahedron_light", umbrage::tetrahedron_light<float>{.position = position,
                                                               .z_near = 0.1f,
                                                               .z_far = 30,
                                                               .map_size = shadow_size,
                                                               .border = shadow_border,
                                                               .clip = clip});
    use("dual_paraboloid_light",
        umbrage::dual_paraboloid_light<float>{
            .position = position, .range = 30, .map_size = shadow_size, .border = shadow_border, .clip = clip});
}

template <class Light>
inline constexpr bool bends = false;
template <>
inline constexpr bool bends<umbrage::dual_paraboloid_light<float>> = true;

/// Calls use(filter) for each that a shadow of the light takes.
template <class Light, class Use>
void for_each_shadow_filter(const Light&, const Use& use) {
    const auto taken = [&](auto filter) {
        using type = decltype(filter);
        if constexpr (umbrage::detail::contact_hardening<type>)
            filter.softness = umbrage::make_penumbra_params(0.25f, 1.0f, 6.0f);
        if constexpr (umbrage::shadow_filter<type> && !(bends<Light> && umbrage::detail::contact_hardening<type>))
            use(filter);
    };
    umbrage::filters::all::for_each(taken);
    umbrage::filters::soft::for_each(taken);
    umbrage::prefilters::all::for_each(taken);
}

}  // namespace package
