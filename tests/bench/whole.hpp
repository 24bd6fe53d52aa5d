// SPDX-License-Identifier: MIT
//
// Whole images of shadows: squares over a wavy floor, every setup of a light over them, and the points that a camera
// sees.
#pragma once

#include <cmath>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/shadow/adaptive_maps.hpp>
#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/paraboloid_maps.hpp>
#include <umbrage/shadow/shadow.hpp>
#include <umbrage/shadow/single_map.hpp>
#include <umbrage/shadow/tetrahedron_map.hpp>
#include <umbrage/shadow/warped_maps.hpp>

#include "data.hpp"

namespace bench::whole {

/// Point of the floor, above (x, z).
[[nodiscard]] inline glm::vec3 floor_point(float x, float z) {
    return {x, 0.5f * std::sin(0.7f * x) * std::cos(0.5f * z), z};
}
[[nodiscard]] inline glm::vec3 floor_normal(float x, float z) {
    return {-0.35f * std::cos(0.7f * x) * std::cos(0.5f * z), 1, 0.25f * std::sin(0.7f * x) * std::sin(0.5f * z)};
}

/// The floor, 40 units a side around the origin, and squares in rows over it.
struct scene {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    operator umbrage::mesh_view() const { return {positions, triangles}; }

    scene() {
        for (float z = -20; z < 20; z += 0.125f)
            for (float x = -20; x < 20; x += 0.125f) add(x, z, 0.125f, 0);
        for (float z = -20; z < 19; z += 2)
            for (float x = -20; x < 19; x += 2) add(x, z, 1, 1);
    }
    /// A piece of the floor, moved up.
    void add(float x, float z, float side, float up) {
        const auto first = static_cast<unsigned>(positions.size());
        for (const glm::vec2 at : {glm::vec2(0, 0), glm::vec2(side, 0), glm::vec2(side, side), glm::vec2(0, side)})
            positions.push_back(floor_point(x + at.x, z + at.y) + glm::vec3(0, up, 0));
        triangles.emplace_back(first, first + 1, first + 2);
        triangles.emplace_back(first, first + 2, first + 3);
    }
};

inline constexpr umbrage::clip_space clip = umbrage::cpu_clip_space;
inline constexpr umbrage::frustum<float> camera{
    .position = {0, 3, 21}, .direction = {0, -0.1f, -1}, .tan_half_x = 0.6f, .tan_half_y = 0.6f, .z_near = 1};
inline constexpr umbrage::bounding_box<float> bounds{{-20, -1, -20}, {20, 3, 20}};
inline constexpr glm::ivec2 image_size(512);

/// Points and normals of the floor: rows of a camera's image, or anywhere, with normals of zero and a NaN.
struct receivers {
    umbrage::image<glm::vec3> points{image_size}, normals{image_size};

    explicit receivers(order o) {
        std::mt19937 engine(7);
        std::uniform_real_distribution<float> anywhere(-22, 22);
        for (glm::ivec2 p(0); p.y < image_size.y; ++p.y)
            for (p.x = 0; p.x < image_size.x; ++p.x) {
                const glm::vec2 part = (glm::vec2(p) + 0.5f) / glm::vec2(image_size);
                const float ahead = 1.0f / (0.025f + 0.475f * part.y);  // 40 .. 2
                glm::vec2 at((part.x - 0.5f) * 1.2f * ahead, camera.position.z - ahead);
                if (o == order::random) at.x = anywhere(engine), at.y = anywhere(engine);
                points[p] = floor_point(at.x, at.y);
                normals[p] = floor_normal(at.x, at.y);
                if (o == order::random && engine() % 64 == 0) normals[p] = glm::vec3(0);
            }
        if (o == order::random) points[{0, 0}].x = std::numeric_limits<float>::quiet_NaN();
    }
};

/// Pages of every level, by the distance from the camera.
[[nodiscard]] inline umbrage::adaptive_maps pages() {
    const auto root = umbrage::make_page_root<double>({.direction = {-1, -4, -2},
                                                       .side = 48,
                                                       .scene = {glm::dvec3(bounds.low), glm::dvec3(bounds.high)},
                                                       .clip = clip});
    const glm::mat4 to_root(umbrage::page_matrix(root));
    std::vector<umbrage::page_receiver> seen;
    for (float z = -20; z < 21; ++z)
        for (float x = -20; x < 21; ++x) {
            const glm::vec3 p = floor_point(x, z);
            const glm::vec2 at(umbrage::shadow_coordinate(to_root, p));
            seen.push_back({at, 512.0f / glm::length(p - camera.position)});
        }
    umbrage::page_cache cache({.slots = {8, 8}, .deepest_level = 4});
    static_cast<void>(cache.update(seen));
    return {root, cache, {.texels = 128, .gutter = 8}};
}

inline constexpr auto directional_name = "directional light";
[[nodiscard]] inline umbrage::light_space<float> directional_light() {
    return umbrage::fit_directional_light<float>({.direction = {-1, -4, -2}, .receivers = bounds, .clip = clip});
}

/// Calls use(name, light, map_size) for every setup.
template <class Use>
void for_each_setup(const Use& use) {
    constexpr glm::ivec2 size(1024);
    constexpr glm::vec3 bulb(0.5f, 8, 0.25f);
    const umbrage::cascade_fit<float> fit{.camera = camera,
                                          .direction = {-1, -4, -2},
                                          .scene = bounds,
                                          .map_size = size,
                                          .margin = 8,
                                          .overlap = 0.1f,
                                          .clip = clip};
    use(directional_name, directional_light(), size);
    use("spot light",
        umbrage::make_spot_light<float>({.position = {1, 25, 2},
                                         .direction = {0, -1, 0},
                                         .up = {0, 0, 1},
                                         .outer_angle_radians = 0.7f,
                                         .z_near = 5,
                                         .z_far = 40,
                                         .clip = clip}),
        size);
    use("three cascades", umbrage::make_stable_cascades<3>(fit, umbrage::practical_splits<3>(1.0f, 45.0f, 0.8f)), size);
    const auto fit_part = [](const auto& part) { return umbrage::fit_light_space_perspective(part); };
    use("three warped cascades",
        umbrage::warped_maps(
            umbrage::make_warped_cascades<3>(fit, umbrage::practical_splits<3>(1.0f, 45.0f, 0.4f), fit_part), camera,
            fit.overlap),
        size);
    use("pages", pages(), glm::ivec2(144));
    use("cube", umbrage::point_light<float>{.position = bulb, .map_size = size.x, .border = 8, .clip = clip}, size);
    use("tetrahedron",
        umbrage::tetrahedron_light<float>{.position = bulb, .map_size = size.x, .border = 8, .clip = clip}, size);
    use("paraboloids",
        umbrage::dual_paraboloid_light<float>{
            .position = bulb, .range = 60, .map_size = size.x, .border = 8, .clip = clip},
        size);
}

/// Calls use(name, filter) for every filter that goes with a light's setup: paraboloids bend planes.
template <class Light, class Use>
void for_each_filter(const Use& use) {
    use("tent<3>", umbrage::filters::tent<3>);
    use("castano<5>", umbrage::filters::castano<5>);
    use("disc 16", umbrage::filters::disc{.points = 16});
    if constexpr (!std::is_same_v<Light, umbrage::dual_paraboloid_light<float>>)
        use("pcss 16", umbrage::filters::pcss{.softness = umbrage::make_penumbra_params(0.1f, 1.0f, 6.0f)});
}

/// Depths of all maps. They are those of every filter.
template <class Shadow>
[[nodiscard]] umbrage::image<float> drawn(const Shadow& s) {
    static const scene all;
    umbrage::image<float> map(s.size(), s.cleared());
    s.draw(map, all);
    return map;
}

/// True if every receiver alone has the image's bits.
template <class Shadow>
[[nodiscard]] bool same_alone(const Shadow& s, const umbrage::image<float>& map, const receivers& of,
                              const umbrage::image<float>& out) {
    for (glm::ivec2 p(0); p.y < image_size.y; ++p.y)
        for (p.x = 0; p.x < image_size.x; ++p.x)
            if (out[p] != s(map, of.points[p], of.normals[p], p)) return false;
    return true;
}

}  // namespace bench::whole
