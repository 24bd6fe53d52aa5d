// SPDX-License-Identifier: MIT
//
// Receivers of a picture and what rays say about them: the light that reaches each, and a disc of 3 texels around it.
#pragma once

#include <cmath>
#include <functional>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/light/frustum.hpp>
#include <umbrage/shadow/setup.hpp>

#include "light_maps.hpp"
#include "ray_tree.hpp"
#include "scenes.hpp"

namespace proof::picture {

/// Point of a surface as a pixel sees it, and its place in a map.
struct receiver {
    glm::vec3 position{0}, normal{0};  ///< as a renderer has them, the normal of length one
    glm::vec3 smooth_normal{0};        ///< interpolated one; zero on flat surfaces
    glm::vec3 screen_normal{0};        ///< cross product of the position's derivatives on the screen, of any length
    glm::ivec2 pixel{0};
    glm::dvec3 exact{0}, to_light{0};          ///< position, and direction to the light of length one
    double cosine = 0;                         ///< between the normal and the light
    umbrage::map_place place{};                ///< in the map that holds it
    umbrage::map_place smooth_place{};         ///< with the slope of the interpolated normal
    double texel = 0;                          ///< edge of a texel of that map across the light, world units
    bool is_lit = false;                       ///< a ray reaches the light
    bool disc_lit = false, disc_dark = false;  ///< all rays of the disc reach it, or none does
    bool in_contact = false;                   ///< in the shadow of a caster less than 10 texels away
};

/// Sums over receivers.
struct tally {
    double all = 0, lit = 0, acne = 0, dark = 0, leak = 0, contact = 0, lost = 0, squares = 0;

    void add(const receiver& r, float visibility) {
        const double off = double(visibility) - (r.is_lit ? 1.0 : 0.0);
        all += 1, squares += off * off;
        if (r.disc_lit) lit += 1, acne += visibility < 0.9f;
        if (r.disc_dark) dark += 1, leak += visibility > 0.1f;
        if (r.in_contact) contact += 1, lost += visibility > 0.5f;
    }
    tally& operator+=(const tally& o) {
        all += o.all, lit += o.lit, acne += o.acne, dark += o.dark, leak += o.leak;
        contact += o.contact, lost += o.lost, squares += o.squares;
        return *this;
    }
    [[nodiscard]] double acne_percent() const { return 100 * acne / lit; }
    [[nodiscard]] double leak_percent() const { return 100 * leak / dark; }
    [[nodiscard]] double lost_percent() const { return 100 * lost / contact; }
    [[nodiscard]] double rms_percent() const { return 100 * std::sqrt(squares / all); }
};

[[nodiscard]] inline umbrage::frustum<double> camera_of(const scene& s) {
    return {.position = s.eye + s.at, .direction = s.look_at - s.eye, .tan_half_x = 0.8, .tan_half_y = 0.45};
}

/// Rays of one scene to one light, from a disc around a receiver on its plane.
class ray_judge {
public:
    ray_judge(const ray_tree& tree, const light_maps& maps, std::initializer_list<double> radii)
        : tree_(&tree), maps_(&maps) {
        disc_.emplace_back(0.0);
        for (const double radius : radii)
            for (int i = 0; i < 8; ++i) {
                const double angle = 0.25 * std::numbers::pi * i;
                disc_.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
            }
    }

    void judge(receiver& r) const {
        const glm::dvec3 normal(r.normal);
        const map_point at = maps_->at(r.place.number, r.exact);
        int lit = 0, dark = 0;
        for (const glm::dvec2& d : disc_) {
            const auto p = maps_->on_plane(r.place.number, glm::dvec2(at) + d, r.exact, normal);
            if (!p) return;  // neither all lit nor all dark
            const glm::dvec3 from = *p + 1e-6 * normal, way = maps_->rays.way(from);
            const double farthest = maps_->rays.is_point ? 1.0 : never;
            bool blocked = false;
            if (&d == disc_.data()) {
                const double first = tree_->first(from, way, farthest).distance;
                blocked = first < farthest;
                r.is_lit = !blocked, r.in_contact = blocked && first * glm::length(way) < 10 * r.texel;
            } else blocked = tree_->is_blocked(from, way, farthest);
            ++(blocked ? dark : lit);
            if (lit > 0 && dark > 0) return;
        }
        r.disc_lit = dark == 0, r.disc_dark = lit == 0;
    }

private:
    const ray_tree* tree_;
    const light_maps* maps_;
    std::vector<glm::dvec2> disc_{};
};

/// Cross product of a position's derivatives on the screen, as fragment shaders have them: differences of positions in
/// float between the pixel and its neighbors, on the plane of the pixel's own triangle.
/// @param to_right   change of the camera's ray from a pixel to the next
[[nodiscard]] inline glm::vec3 cross_of_derivatives(const receiver& r, glm::dvec3 eye, glm::dvec3 way,
                                                    glm::dvec3 to_right, glm::dvec3 to_up) {
    const glm::dvec3 normal(r.normal);
    const auto on_plane = [&](glm::dvec3 ray) {
        return glm::vec3(eye + ray * (glm::dot(normal, r.exact - eye) / glm::dot(normal, ray)));
    };
    return glm::cross(on_plane(way + to_right) - r.position, on_plane(way + to_up) - r.position);
}

/// Where a shadow looks a receiver up.
using place_function = std::function<umbrage::map_place(glm::vec3 position, glm::vec3 normal)>;

/// Receivers that a camera of 480 x 270 pixels sees, that face the light and lie 8 texels or more inside their map.
/// @param step    pixels from one receiver to the next, along each axis
/// @param radii   texels from the receiver, at which eight rays each tell what is lit and dark around it
[[nodiscard]] inline std::vector<receiver> visible_receivers(const scene& s, const ray_tree& tree,
                                                             const light_maps& maps, const place_function& place_of,
                                                             int step,
                                                             std::initializer_list<double> radii = {1.5, 3.2}) {
    constexpr int width = 480, height = 270;
    const umbrage::frustum<double> camera = camera_of(s);
    const glm::dvec3 ahead = glm::normalize(camera.direction), x = glm::normalize(glm::cross(ahead, camera.up)),
                     y = glm::cross(x, ahead);
    const ray_judge rays(tree, maps, radii);
    const std::vector<glm::dvec3> shared = shared_normals(s);
    std::vector<receiver> found;
    for (int j = step / 2; j < height; j += step)
        for (int i = step / 2; i < width; i += step) {
            const glm::dvec2 at = glm::dvec2(2 * i + 1, 2 * j + 1) / glm::dvec2(width, height) - 1.0;
            const glm::dvec3 way = ahead + x * (at.x * camera.tan_half_x) + y * (at.y * camera.tan_half_y);
            const ray_hit hit = tree.first(camera.position, way);
            if (hit.distance == never) continue;
            receiver r{.pixel = {i, j}, .exact = camera.position + hit.distance * way};
            r.position = glm::vec3(r.exact), r.normal = glm::normalize(s.mesh.normal(hit.triangle));
            if (hit.triangle < s.smooth)
                r.smooth_normal = glm::vec3(interpolated_normal(s, shared, hit.triangle, r.exact));
            r.screen_normal = cross_of_derivatives(r, camera.position, way, x * (2 * camera.tan_half_x / width),
                                                   y * (2 * camera.tan_half_y / height));
            r.to_light = glm::normalize(maps.rays.way(r.exact));
            r.cosine = glm::dot(glm::dvec3(r.normal), r.to_light);
            if (!(r.cosine > 0.02)) continue;
            r.place = place_of(r.position, r.normal);
            r.smooth_place = place_of(r.position, r.smooth_normal);
            if (!maps.holds(maps.at(r.place.number, r.exact), 8.0)) continue;
            r.texel = maps.texel(r.place.number, r.exact);
            rays.judge(r);
            found.push_back(r);
        }
    return found;
}

}  // namespace proof::picture
