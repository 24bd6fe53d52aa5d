// SPDX-License-Identifier: MIT
//
// Receivers of the soft table and what rays to a light of 64 points say about them, and the sums of its rows.
#pragma once

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/light/frustum.hpp>
#include <umbrage/shadow/setup.hpp>

#include "light_maps.hpp"
#include "ray_tree.hpp"
#include "receivers.hpp"
#include "scenes.hpp"

namespace proof::picture {

/// Point of a surface under a light that has a size.
struct soft_receiver {
    glm::vec3 position{0}, normal{0};  ///< the normal of length one
    glm::ivec2 pixel{0};
    umbrage::map_place place{};
    float light = 0;          ///< share of the light that rays reach
    bool in_contact = false;  ///< in the shadow of a caster less than 10 texels away, where no ray reaches the light
};

/// Sums over receivers.
struct soft_tally {
    double all = 0, squares = 0, penumbra = 0, penumbra_squares = 0, lit = 0, dark = 0, contact = 0, contact_light = 0;

    void add(const soft_receiver& r, float visibility) {
        const double off = double(visibility) - double(r.light);
        all += 1, squares += off * off;
        if (r.light > 0 && r.light < 1) penumbra += 1, penumbra_squares += off * off;
        if (r.light == 1) lit += 1, dark += visibility < 0.9f;
        if (r.in_contact) contact += 1, contact_light += double(visibility);
    }
    soft_tally& operator+=(const soft_tally& o) {
        all += o.all, squares += o.squares, penumbra += o.penumbra, penumbra_squares += o.penumbra_squares;
        lit += o.lit, dark += o.dark, contact += o.contact, contact_light += o.contact_light;
        return *this;
    }
    [[nodiscard]] double rms_percent() const { return 100 * std::sqrt(squares / all); }
    [[nodiscard]] double penumbra_percent() const { return 100 * std::sqrt(penumbra_squares / penumbra); }
    [[nodiscard]] double dark_percent() const { return 100 * dark / lit; }
    [[nodiscard]] double contact_percent() const { return 100 * contact_light / contact; }
};

/// Sums of rows, in the order in which they came.
class soft_table {
public:
    void add(const std::string& row, const soft_tally& sums) {
        for (auto& [name, all] : rows_)
            if (name == row) {
                all += sums;
                return;
            }
        rows_.emplace_back(row, sums);
    }
    soft_table& operator+=(const soft_table& other) {
        for (const auto& [name, sums] : other.rows_) add(name, sums);
        return *this;
    }
    [[nodiscard]] soft_tally of(std::string_view row) const {
        for (const auto& [name, sums] : rows_)
            if (name == row) return sums;
        return {};
    }
    /// Prints the lit receivers beside creases.
    void print_creases(std::string_view title) const {
        std::printf("\n| creases, %.*s | lit but dark %% |\n|---|--:|\n", int(title.size()), title.data());
        for (const auto& [name, t] : rows_) std::printf("| %s | %.2f |\n", name.c_str(), t.dark_percent());
    }
    void print(std::string_view title) const {
        std::printf(
            "\n| %.*s | RMS %% | in penumbras %% | lit but dark %% | light in contact %% |\n"
            "|---|--:|--:|--:|--:|\n",
            int(title.size()), title.data());
        for (const auto& [name, t] : rows_)
            std::printf("| %s | %.2f | %.1f | %.3f | %.1f |\n", name.c_str(), t.rms_percent(), t.penumbra_percent(),
                        t.dark_percent(), t.contact_percent());
        const soft_tally& t = rows_.front().second;
        std::printf("\n%.0f receivers: %.0f lit, %.0f in penumbras, %.0f in contact.\n", t.all, t.lit, t.penumbra,
                    t.contact);
    }

private:
    std::vector<std::pair<std::string, soft_tally>> rows_{};
};

/// Points of a light across its axis, less its middle: a disc, which a Vogel spiral covers evenly.
/// @param size   radius of a spot light, or the tangent of half the angle under which a directional one is seen
[[nodiscard]] inline std::vector<glm::dvec3> points_of_light(glm::dvec3 axis, double size) {
    constexpr int count = 64;
    const glm::dvec3 x = glm::normalize(glm::cross(axis, glm::dvec3(0.3, 0.2, 0.9))), y = glm::cross(axis, x);
    std::vector<glm::dvec3> all;
    for (int i = 0; i < count; ++i) {
        const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0)), away = size * std::sqrt((i + 0.5) / count);
        all.push_back(away * (std::cos(angle) * x + std::sin(angle) * y));
    }
    return all;
}

/// Receivers that a camera of 480 x 270 pixels sees, that face the light and lie 8 texels or more inside its one map.
/// Their pixels are those of a picture with one pixel for each of them, as rotations repeat.
/// @param size   of the light, as of points_of_light
/// @param step   pixels from one receiver to the next, along each axis
[[nodiscard]] inline std::vector<soft_receiver> soft_receivers(const scene& s, const ray_tree& tree,
                                                               const light_maps& maps, const place_function& place_of,
                                                               double size, int step) {
    constexpr int width = 480, height = 270;
    const umbrage::frustum<double> camera = camera_of(s);
    const glm::dvec3 ahead = glm::normalize(camera.direction), x = glm::normalize(glm::cross(ahead, camera.up)),
                     y = glm::cross(x, ahead);
    const std::vector<glm::dvec3> points = points_of_light(maps.axis(0), size);
    std::vector<soft_receiver> found;
    for (int j = step / 2; j < height; j += step)
        for (int i = step / 2; i < width; i += step) {
            const glm::dvec2 at = glm::dvec2(2 * i + 1, 2 * j + 1) / glm::dvec2(width, height) - 1.0;
            const glm::dvec3 way = ahead + x * (at.x * camera.tan_half_x) + y * (at.y * camera.tan_half_y);
            const ray_hit hit = tree.first(camera.position, way);
            if (hit.distance == never) continue;
            const glm::dvec3 exact = camera.position + hit.distance * way;
            const glm::dvec3 normal = glm::normalize(glm::dvec3(s.mesh.normal(hit.triangle)));
            const glm::dvec3 from = exact + 1e-6 * normal, middle = maps.rays.way(exact);
            if (!(glm::dot(normal, glm::normalize(middle)) > 0.02) || !maps.holds(maps.at(0, exact), 8.0)) continue;
            soft_receiver r{glm::vec3(exact), glm::vec3(normal), glm::ivec2(i, j) / step};
            r.place = place_of(r.position, r.normal);
            const double farthest = maps.rays.is_point ? 1.0 : never;
            int reached = 0;
            for (const glm::dvec3& p : points)
                reached += glm::dot(normal, middle + p) > 0 && !tree.is_blocked(from, middle + p, farthest);
            r.light = float(reached) / float(points.size());
            const double first = tree.first(from, middle, farthest).distance * glm::length(middle);
            r.in_contact = reached == 0 && first < 10 * maps.texel(0, exact);
            found.push_back(r);
        }
    return found;
}

}  // namespace proof::picture
