// SPDX-License-Identifier: MIT
//
// Shadows of every setup, with their own bias, over random scenes that rays are traced through. A sample in the tests,
// more in `make prove`.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <umbrage/filter/pcf/windows.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/shadow/adaptive_maps.hpp>
#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/warped_maps.hpp>

#include "few_triangles.hpp"
#include "light_kinds.hpp"
#include "traced_shadow.hpp"

namespace proof {

/// A ground and few triangles, a camera, a sun and a spot, and triangles around a bulb, all from one number.
class shadowed_scene : few_triangles {
public:
    explicit shadowed_scene(std::uint64_t n) : few_triangles(static_cast<std::uint32_t>(n)) {
        clip_.range = n & 1 ? umbrage::depth_range::minus_one_to_one : umbrage::depth_range::zero_to_one;
        clip_.direction = n & 2 ? umbrage::depth_direction::reversed : umbrage::depth_direction::forward;
        clip_.origin = n & 4 ? umbrage::texture_origin::top : umbrage::texture_origin::bottom;
        clip_.subpixel_bits = 8;  // as draw has
        clip_.hand = n & 8 ? umbrage::handedness::left : umbrage::handedness::right;
        const glm::vec3 eye = around(real(2, 6));
        camera_ = {.position = eye,
                   .direction = vector(-1, 1) - eye,
                   .tan_half_x = 0.5f,
                   .tan_half_y = 0.4f,
                   .z_near = 0.5f,
                   .z_far = 7};
        sun_ = -around(1);
        spot_ = around(real(6, 9)), bulb_ = vector(-2, 2);
        ground = {positions_, triangles_};
        const surroundings all(random_);
        surrounding = {all.positions, all.triangles};
        for (glm::vec3& p : surrounding.positions) p += bulb_;
    }

    ray_mesh ground, surrounding;

    /// Calls use(name, light, map_size, ray_light, mesh) for each setup.
    template <class Use>
    void for_each_setup(const Use& use) {
        using namespace umbrage;
        const ray_light sun{false, -glm::dvec3(sun_)}, spot{true, spot_}, bulb{true, bulb_};
        const glm::ivec2 size(256);
        use("spot",
            make_spot_light<float>(
                {.position = spot_, .direction = -spot_, .z_near = 0.5f, .z_far = 30, .clip = clip_}),
            size, spot, ground);
        use("directional, fitted", fit_directional_light<float>({.direction = sun_, .receivers = box_, .clip = clip_}),
            size, sun, ground);
        use("directional, warped",
            fit_light_space_perspective(warp_fit<float>{.camera = camera_,
                                                        .direction = sun_,
                                                        .receivers = intersection(camera_, box_),
                                                        .casters = box_,
                                                        .margin = 0.02f,
                                                        .clip = clip_})
                .light,
            size, sun, ground);
        const cascade_fit<float> fit{.camera = camera_,
                                     .direction = sun_,
                                     .scene = box_,
                                     .map_size = size,
                                     .margin = 4,
                                     .overlap = 0.1f,
                                     .clip = clip_};
        const auto splits = practical_splits<3>(camera_.z_near, camera_.z_far, 0.6f);
        use("stable cascades", make_stable_cascades<3>(fit, splits), size, sun, ground);
        use("tight cascades", make_tight_cascades<3>(fit, splits), size, sun, ground);
        const auto warped =
            make_warped_cascades<3>(fit, splits, [](const auto& part) { return fit_light_space_perspective(part); });
        use("warped cascades", warped_maps(warped, camera_, fit.overlap), size, sun, ground);
        use("pages", pages(), glm::ivec2(72), sun, ground);
        use("cube", point_light<float>{.position = bulb_, .z_near = 0.05f, .z_far = 30, .map_size = 256, .clip = clip_},
            size, bulb, surrounding);
        use("tetrahedron",
            tetrahedron_light<float>{.position = bulb_, .z_near = 0.05f, .z_far = 30, .map_size = 512, .clip = clip_},
            glm::ivec2(512), bulb, surrounding);
        use("paraboloids", dual_paraboloid_light<float>{.position = bulb_, .range = 25, .map_size = 256, .clip = clip_},
            size, bulb, surrounding);
    }

    /// A point of a triangle that the setup is to hold.
    struct receiver {
        std::size_t own;
        glm::vec3 point;
    };
    [[nodiscard]] receiver receiver_of(std::string_view setup, const ray_mesh& mesh) {
        for (;;) {
            const auto own = std::uniform_int_distribution<std::size_t>(0, mesh.triangles.size() - 1)(random_);
            const auto [a, b, c] = mesh.corners(own);
            double u = real(0, 1), v = real(0, 1);
            if (u + v > 1) u = 1 - u, v = 1 - v;
            const glm::vec3 p(a + u * (b - a) + v * (c - a));
            if (is_held(setup, p)) return {own, p};
        }
    }
    /// A point and a normal, some way off the light, for a plane that the setup holds.
    [[nodiscard]] std::pair<glm::vec3, glm::vec3> plane_of(std::string_view setup, const ray_light& light) {
        for (;;) {
            const glm::vec3 p = light.is_point && setup != "spot" ? bulb_ + glm::normalize(vector(-1, 1)) * real(2, 5)
                                                                  : vector(-1, 1) + glm::vec3(0, 1.5f, 0);
            const glm::vec3 normal = glm::normalize(vector(-1, 1)), way(glm::normalize(light.way(p)));
            const float cosine = std::abs(glm::dot(normal, way));
            if (is_held(setup, p) && cosine > 0.35f && cosine < 0.9f) return {p, normal};
        }
    }
    [[nodiscard]] std::mt19937& random() { return random_; }

private:
    [[nodiscard]] bool is_held(std::string_view setup, glm::vec3 p) const {
        if (setup == "spot") return glm::dot(glm::normalize(p - spot_), glm::normalize(-spot_)) > 0.88f;
        if (!setup.ends_with("cascades") && !setup.ends_with("warped")) return true;
        const umbrage::polyhedron seen(camera_);
        return std::ranges::all_of(seen.faces(),
                                   [p](const auto& face) { return glm::dot(face.plane, glm::dvec4(p, 1)) > 1e-4; });
    }
    [[nodiscard]] umbrage::adaptive_maps pages() {
        using namespace umbrage;
        const auto root = make_page_root<double>({.direction = glm::dvec3(sun_),
                                                  .side = 20,
                                                  .scene = {glm::dvec3(box_.low), glm::dvec3(box_.high)},
                                                  .clip = clip_});
        const glm::mat4 to_root(page_matrix(root));
        std::vector<page_receiver> seen;
        for (int i = 0; i < 2000; ++i) {
            const glm::vec3 p = point_of(std::size_t(i) % triangles_.size()), way = p - camera_.position;
            seen.push_back({glm::vec2(shadow_coordinate(to_root, p)), 100 / glm::dot(way, way)});
        }
        page_cache cache({.slots = {8, 8}, .deepest_level = 4});
        static_cast<void>(cache.update(seen));
        return {root, cache, {.texels = 64, .gutter = 4}};
    }

    umbrage::clip_space clip_;
    umbrage::frustum<float> camera_;
    glm::vec3 sun_{0}, spot_{0}, bulb_{0};
};

/// Calls use(setup, filter, shadow, light, mesh) for each setup under three filters.
template <class Use>
void for_each_traced(shadowed_scene& scene, const Use& use) {
    scene.for_each_setup(
        [&](std::string_view name, const auto& light, glm::ivec2 size, const ray_light& from, const ray_mesh& mesh) {
            const auto under = [&](std::string_view filter_name, const auto& filter) {
                use(name, filter_name, any_shadow(umbrage::shadow(light, size, filter)), from, mesh);
            };
            under("hard", umbrage::filters::hard{});
            under("pcf_2x2", umbrage::filters::pcf_2x2{});
            under("tent<3>", umbrage::filters::tent<3>);
        });
}

/// The least share of the stated distance over which a caster's shadow is really lost. Of 4096 receivers none lies in
/// the very corner of its texel, which is 1/30 of a hard filter's reach; beside the reach the bias covers what a
/// rasterizer and floats lose. Paraboloids are curved: their bias covers every direction's slope, and tessellation.
[[nodiscard]] constexpr double least_share(std::string_view setup) { return setup == "paraboloids" ? 0.6 : 0.93; }

/// A scene's receivers.
[[nodiscard]] inline traced trace_receivers(shadowed_scene& scene, std::string_view setup, const any_shadow& s,
                                            const ray_light& light, const ray_mesh& mesh, int receivers) {
    traced found;
    s.draw(mesh.view());
    for (int i = 0; i < receivers; ++i) {
        const auto [own, p] = scene.receiver_of(setup, mesh);
        trace(s, light, mesh, own, p, found);
    }
    return found;
}

}  // namespace proof
