// SPDX-License-Identifier: MIT
//
// A floor with a table over it, and lights of every setup above: what the tests of shadows draw.
#pragma once

#include <array>
#include <type_traits>
#include <vector>

#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/point/point_light.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/shadow/adaptive_maps.hpp>
#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/paraboloid_maps.hpp>
#include <umbrage/shadow/shadow.hpp>
#include <umbrage/shadow/tetrahedron_map.hpp>
#include <umbrage/shadow/warped_maps.hpp>

namespace shadow_scene {

using namespace umbrage;

inline const std::vector<glm::vec3> positions{{-20, 0, -20}, {20, 0, -20}, {20, 0, 20}, {-20, 0, 20},
                                              {-1, 2, -1},   {1, 2, -1},   {1, 2, 1},   {-1, 2, 1}};
inline const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
inline const mesh_view mesh{positions, triangles};
inline const bounding_box<float> bounds{{-20, 0, -20}, {20, 2, 20}};
inline constexpr glm::vec3 up(0, 1, 0);

[[nodiscard]] inline light_space<float> spot(clip_space clip) {
    return make_spot_light<float>({.position = {0.5f, 8, 0.25f},
                                   .direction = {0, -1, 0},
                                   .up = {0, 0, 1},
                                   .outer_angle_radians = 1.2f,
                                   .clip = clip});
}
[[nodiscard]] inline light_space<float> fitted(clip_space clip) {
    return fit_directional_light<float>({.direction = {0.1f, -1, 0.1f}, .receivers = bounds, .clip = clip});
}
[[nodiscard]] inline point_light<float> bulb(clip_space clip, int map_size = 256) {
    return {.position = {0.5f, 8, 0.25f}, .map_size = map_size, .border = 8, .clip = clip};
}
[[nodiscard]] inline tetrahedron_light<float> tetrahedron(clip_space clip) {
    return {.position = {0.5f, 8, 0.25f}, .map_size = 512, .border = 8, .clip = clip};
}
[[nodiscard]] inline dual_paraboloid_light<float> paraboloids(clip_space clip) {
    return {.position = {0.5f, 8, 0.25f}, .range = 60, .map_size = 512, .border = 8, .clip = clip};
}
[[nodiscard]] inline cascade_fit<float> range(clip_space clip) {
    return {.camera = {.position = {0, 3, 15}, .direction = {0, 0, -1}, .up = up, .tan_half_x = 1, .tan_half_y = 1},
            .direction = {0.1f, -1, 0.1f},
            .up = {0, 0, 1},
            .scene = bounds,
            .map_size = glm::ivec2(256),
            .margin = 4,
            .overlap = 0.1f,
            .clip = clip};
}
template <std::size_t Count = 3>
[[nodiscard]] std::array<cascade<float>, Count> cascades(clip_space clip) {
    return make_stable_cascades<Count>(range(clip), practical_splits<Count>(0.5f, 60.0f, 0.9f));
}
template <std::size_t Count = 3>
[[nodiscard]] warped_maps warped(clip_space clip) {
    const cascade_fit<float> fit = range(clip);
    const auto parts = make_warped_cascades<Count>(fit, practical_splits<Count>(0.5f, 60.0f, 0.4f),
                                                   [](const auto& part) { return fit_light_space_perspective(part); });
    return warped_maps(parts, fit.camera, fit.overlap);
}
/// Pages of every level, the finer the nearer to the table.
[[nodiscard]] inline adaptive_maps pages(clip_space clip) {
    const auto root = make_page_root<double>({.direction = {0.1, -1, 0.1},
                                              .up = {0, 0, 1},
                                              .side = 20,
                                              .scene = {glm::dvec3(bounds.low), glm::dvec3(bounds.high)},
                                              .clip = clip});
    const glm::mat4 to_root(page_matrix(root));
    std::vector<page_receiver> seen;
    for (float x = -10; x < 11; ++x)
        for (float z = -10; z < 11; ++z) {
            const glm::vec3 p(x, 0, z);
            seen.push_back({glm::vec2(shadow_coordinate(to_root, p)), 40 / (1 + glm::length(p))});
        }
    page_cache cache({.slots = {8, 8}, .deepest_level = 4});
    static_cast<void>(cache.update(seen));
    return {root, cache, {.texels = 64, .gutter = 8}};
}

/// Calls use(light, map_size) for each setup.
template <class Use>
void for_each_light(clip_space clip, const Use& use) {
    use(spot(clip), glm::ivec2(256, 128));
    use(fitted(clip), glm::ivec2(200, 300));
    use(cascades(clip), glm::ivec2(256));
    use(cascades<6>(clip), glm::ivec2(256));
    use(warped(clip), glm::ivec2(256));
    use(pages(clip), glm::ivec2(80));
    use(bulb(clip), glm::ivec2(256));
    use(tetrahedron(clip), glm::ivec2(512));
    use(paraboloids(clip), glm::ivec2(512));
}

/// A filter that knows the size of the light, where it wants to.
template <class Filter>
[[nodiscard]] Filter sized(Filter filter) {
    if constexpr (detail::contact_hardening<Filter>)
        detail::softness_of(filter) = make_penumbra_params(0.3f, 0.0625f, 4.0f);
    return filter;
}

/// Contact hardening has no shadows of dual paraboloids.
template <class Light, class Filter>
inline constexpr bool go_together =
    !(std::is_same_v<Light, dual_paraboloid_light<float>> && detail::contact_hardening<Filter>);

/// Calls use(shadow) for each setup under a filter and an encoding.
template <class Filter, class Encoding, class Use>
void for_each_shadow(clip_space clip, const Filter& filter, const Encoding& encoding, const Use& use) {
    for_each_light(clip, [&]<class Light>(const Light& light, glm::ivec2 map_size) {
        if constexpr (go_together<Light, Filter>) use(shadow(light, map_size, filter, encoding));
    });
}

/// The scene's depths. Shadows of one light have the same, whatever their filter.
template <class Shadow>
[[nodiscard]] image<float> depths_of(const Shadow& s) {
    image<float> depths(s.size(), cleared_depth(s.setup().clip()));
    s.draw(depths, mesh);
    return depths;
}

/// Its map: depths as its encoding has them.
template <class Shadow>
[[nodiscard]] image<typename Shadow::texel> stored(const Shadow& s, const image<float>& depths) {
    image<typename Shadow::texel> map(s.size(), s.cleared());
    s.store(depths, map);
    return map;
}
template <class Shadow>
[[nodiscard]] image<typename Shadow::texel> drawn(const Shadow& s) {
    return stored(s, depths_of(s));
}

}  // namespace shadow_scene
