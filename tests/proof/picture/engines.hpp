// SPDX-License-Identifier: MIT
//
// Rows of the picture table: what engines compute by default, as formulas, over maps of the table's own lights.
//
// Sources, read for their formulas:
//   three.js r187          src/renderers/shaders/ShaderChunk/shadowmap_pars_fragment.glsl.js, WebGLShadowMap.js
//   Godot 4, 2025          servers/rendering/renderer_rd: shaders/scene_forward_lights_inc.glsl, shaders/
//                          forward_clustered/scene_forward_clustered.glsl, storage_rd/light_storage.cpp
//   Unity URP 17           Runtime/ShadowUtils.cs, ShaderLibrary/Shadows.hlsl
//   TheRealMJP/Shadows     ShadowMapping/Mesh.hlsl, with its plane bias enabled
// Each looks a receiver up in the map that holds it here; positions and planes are exact, where engines have floats.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/bias/light_units.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/filter/pcf/windows.hpp>

#include "discs.hpp"
#include "light_maps.hpp"
#include "receivers.hpp"
#include "rows.hpp"
#include "scenes.hpp"

namespace proof::picture {

/// Mean of bilinear comparisons at the points of a rotated Vogel disk.
[[nodiscard]] inline float vogel_look(const light_maps& maps, const drawn_maps& drawn, const receiver& r, map_point at,
                                      int points, double radius) {
    float sum = 0;
    for (const glm::dvec2& p : vogel_points(points, radius, noise_rotation(r.pixel))) {
        const glm::vec3 tap(at + glm::dvec3(p, 0));
        sum += look(maps, drawn, umbrage::filters::pcf_2x2{}, r.place.number, tap);
    }
    return sum / float(points);
}

/// three.js: faces that turn away from the light cast shadows, bias and normalBias are 0, PCFShadowMap.
[[nodiscard]] inline row threejs(const light_maps& maps, const scene& s) {
    const auto drawn = std::make_shared<const umbrage::image<float>>(
        maps.draw([&](int) -> const ray_mesh& { return s.mesh; }, umbrage::cull_mode::front));
    return {"three.js r187", [&maps, drawn](const receiver& r) {
                return vogel_look(maps, drawn, r, maps.at(r.place.number, r.exact), 5, 1.0);
            }};
}

/// Radius of Godot's filter, texels: shadow_blur times that of soft shadows of low quality. It scales shadow_bias too,
/// but for point lights.
constexpr double godot_blur = 2.0;

/// Position in a map where Godot 4 looks a receiver up, by its lights' default shadow_bias and shadow_normal_bias.
[[nodiscard]] inline map_point godot_point(const light_maps& maps, const receiver& r) {
    const glm::dvec3 n(r.normal), sideways = n - r.to_light * r.cosine;
    const int map = r.place.number;
    if (maps.kind == light_kind::sun) {  // across the light by 2 texels, and along it by 0.1 % of its depths times blur
        const double range = 1 / maps.units(map).y;
        return maps.at(map, r.exact + 2 * r.texel * sideways + 0.001 * godot_blur * range * r.to_light);
    }
    const double distance = glm::length(maps.rays.way(r.exact));
    const double tilt = 10.0 / maps.size().x * (1 - std::abs(r.cosine));  // shares of the distance
    if (maps.kind == light_kind::spot) {  // 0.03 % of clip space over w, with a near plane at 0.025
        const glm::dvec3 p = r.exact + n * (distance * tilt);
        const double w = maps.w(map, p), world = 0.0003 * godot_blur / 0.025 * w;
        return maps.at(map, p) - glm::dvec3(0, 0, umbrage::world_to_depth(world, maps.units(map), w));
    }
    return maps.at(map, maps.rays.from + glm::normalize(n * tilt - r.to_light) * (distance - 0.1));
}

/// Godot 4: soft shadows of low quality, as wide in all cascades.
[[nodiscard]] inline row godot(const light_maps& maps, const drawn_maps& drawn) {
    return {"Godot 4", [&maps, drawn](const receiver& r) {
                return vogel_look(maps, drawn, r, godot_point(maps, r), 4, godot_blur);
            }};
}

/// Unity's universal render pipeline: depth bias 1 and normal bias 1 in its texels, both times the kernel's radius of
/// 2.5 texels, on casters; point lights have no normal bias. The rasterizer adds 2.5 texels of a triangle's slope.
/// Texels are those of the far plane, of half its width under spot lights and point lights. Its tent of 5 x 5, soft
/// shadows of medium quality, is castano<5> within 0.03 of a weight.
[[nodiscard]] inline row unity_urp(const light_maps& maps, const scene& s) {
    const std::vector<glm::dvec3> shared = shared_normals(s);
    const auto casters = [&](int map) {
        const double across = (maps.kind == light_kind::sun ? 2 : maps.range) / maps.light(map).projection[0][0];
        const double bias = 2.5 * across / maps.size().x, normal_bias = maps.kind == light_kind::point ? 0 : bias;
        ray_mesh moved;
        for (std::size_t k = 0; k < s.mesh.triangles.size(); ++k) {
            const auto corners = s.mesh.corners(k);
            for (int i = 0; i < 3; ++i) {
                const glm::dvec3 p = corners[std::size_t(i)], to_light = glm::normalize(maps.rays.way(p));
                const glm::dvec3 n =
                    glm::normalize(k < s.smooth ? shared[s.mesh.triangles[k][i]] : glm::dvec3(s.mesh.normal(k)));
                const double tilt = 1 - glm::clamp(glm::dot(to_light, n), 0.0, 1.0);
                moved.positions.emplace_back(p - bias * to_light - normal_bias * tilt * n);
            }
            const auto first = static_cast<unsigned>(3 * k);
            moved.triangles.emplace_back(first, first + 1, first + 2);
        }
        return maps.with_slope_bias(map, moved, 2.5);
    };
    const auto drawn = std::make_shared<const umbrage::image<float>>(maps.draw(casters, umbrage::cull_mode::back));
    return {"Unity URP 17", [&maps, drawn](const receiver& r) {
                return look(maps, drawn, umbrage::filters::castano<5>, r.place.number,
                            glm::vec3(maps.at(r.place.number, r.exact)));
            }};
}

/// The receiver's plane at every tap, with a bias of a texel of its slope but 0.01 at most.
[[nodiscard]] inline std::vector<row> mjp(const light_maps& maps, const drawn_maps& drawn) {
    const auto look_along = [&maps, drawn](const receiver& r, const auto& filter, glm::vec2 slope) {
        const float bias = std::min(std::abs(r.place.slope.x) + std::abs(r.place.slope.y), 0.01f);
        const glm::vec2 coord(r.place.at);
        const auto fetch = umbrage::bordered(maps.map_of(*drawn, r.place.number));
        const auto less_plane = [&](glm::ivec2 texel) {
            return fetch(texel) - glm::dot(slope, glm::vec2(texel) + 0.5f - coord);
        };
        return filter(less_plane, coord, r.place.at.z - bias);
    };
    return {{"TheRealMJP's plane, 2x2",
             [=](const receiver& r) { return look_along(r, umbrage::filters::pcf_2x2{}, glm::vec2(0)); }},
            {"TheRealMJP's plane, 3x3",
             [=](const receiver& r) { return look_along(r, umbrage::filters::tent<3>, r.place.slope); }}};
}

}  // namespace proof::picture
