// SPDX-License-Identifier: MIT
//
// Scenes of the picture table, each from a seed: boxes with eaves, a thin fence, hills, a room with a lamp, and
// rings among boxes turned in all directions. They stand at the origin or far from it.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "../ray_mesh.hpp"

namespace proof::picture {

/// A mesh, and where its lights and its camera are, world units.
struct scene {
    std::string_view name;
    ray_mesh mesh{};
    glm::dvec3 at{0};  ///< where the scene stands; the other positions count from here
    glm::dvec3 eye{0, 3, 14}, look_at{0, 1, 0};
    glm::dvec3 spot{4, 13, 5}, spot_target{0};
    glm::dvec3 lamp{0, 5, 0};  ///< point light
    glm::dvec3 sun{-0.7, -1.6, -0.5};
    double spot_angle = 0.75;  ///< outer angle, radians
    bool has_sun = true;
    double reach = 25;       ///< range of the spot light and of the point light
    std::size_t smooth = 0;  ///< triangles, from the first on, that share the normals of their vertices
};

/// Normals of vertices that smooth triangles share, weighted by area; zero for other vertices.
[[nodiscard]] inline std::vector<glm::dvec3> shared_normals(const scene& s) {
    std::vector<glm::dvec3> normals(s.mesh.positions.size(), glm::dvec3(0));
    for (std::size_t k = 0; k < s.smooth; ++k)
        for (int i = 0; i < 3; ++i) normals[s.mesh.triangles[k][i]] += glm::dvec3(s.mesh.normal(k));
    for (glm::dvec3& n : normals)
        if (n != glm::dvec3(0)) n = glm::normalize(n);
    return normals;
}

/// Normal at a point of a smooth triangle, as rasterizers interpolate it.
[[nodiscard]] inline glm::dvec3 interpolated_normal(const scene& s, const std::vector<glm::dvec3>& shared,
                                                    std::size_t triangle, glm::dvec3 p) {
    const auto [a, b, c] = s.mesh.corners(triangle);
    const glm::uvec3 t = s.mesh.triangles[triangle];
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double u = glm::dot(glm::cross(c - b, p - b), n), v = glm::dot(glm::cross(a - c, p - c), n),
                 w = glm::dot(glm::cross(b - a, p - a), n);
    return glm::normalize(u * shared[t.x] + v * shared[t.y] + w * shared[t.z]);
}

/// Adds solids to a scene, and numbers that are the same with every standard library.
class scene_builder {
public:
    scene_builder(std::string_view name, std::uint32_t seed, glm::dvec3 at) : random_(seed) {
        made.name = name, made.at = at;
    }

    scene made;

    /// In braces numbers come in their order with every compiler, as function arguments they do not.
    /// Number between two. Take them one by one or in braces: compilers differ in the order of function arguments.
    [[nodiscard]] double real(double low, double high) { return low + (high - low) * 0x1p-32 * double(random_()); }
    [[nodiscard]] glm::dmat3 upright_rotation() {
        const double angle = real(0, 2 * std::numbers::pi), c = std::cos(angle), s = std::sin(angle);
        return {{c, 0, s}, {0, 1, 0}, {-s, 0, c}};
    }
    [[nodiscard]] glm::dmat3 rotation() {
        const double angle = real(0, 2 * std::numbers::pi), c = std::cos(angle), s = std::sin(angle);
        const glm::dmat3 first = upright_rotation(), last = upright_rotation();
        return last * glm::dmat3({1, 0, 0}, {0, c, s}, {0, -s, c}) * first;
    }
    /// Place on the ground in a ring around the lamp.
    [[nodiscard]] glm::dvec3 around_lamp(double nearest, double farthest, double height = 0) {
        const double angle = real(0, 2 * std::numbers::pi), away = real(nearest, farthest);
        return {away * std::cos(angle), height, away * std::sin(angle)};
    }
    unsigned vertex(glm::dvec3 p) {
        made.mesh.positions.emplace_back(p + made.at);
        return static_cast<unsigned>(made.mesh.positions.size() - 1);
    }
    /// Box between two corners, rotated and then moved.
    void box(glm::dvec3 low, glm::dvec3 high, glm::dvec3 to = glm::dvec3(0), const glm::dmat3& turn = glm::dmat3(1)) {
        const auto first = static_cast<unsigned>(made.mesh.positions.size());
        for (int i = 0; i < 8; ++i)
            vertex(to + turn * glm::dvec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z));
        static constexpr unsigned faces[6][4]{{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                                              {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
        for (const auto& f : faces) {
            made.mesh.triangles.emplace_back(first + f[0], first + f[1], first + f[2]);
            made.mesh.triangles.emplace_back(first + f[0], first + f[2], first + f[3]);
        }
    }
    /// Ring around the y axis, rotated and then moved: smooth, of 32 by 16 quads.
    void ring(double radius, double thickness, glm::dvec3 to, const glm::dmat3& turn) {
        constexpr unsigned around = 32, across = 16;
        const auto first = static_cast<unsigned>(made.mesh.positions.size());
        for (unsigned i = 0; i < around; ++i)
            for (unsigned j = 0; j < across; ++j) {
                const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / across;
                const double out = radius + thickness * std::cos(b);
                vertex(to + turn * glm::dvec3(out * std::cos(a), thickness * std::sin(b), out * std::sin(a)));
            }
        for (unsigned i = 0; i < around; ++i)
            for (unsigned j = 0; j < across; ++j) {
                const auto at = [&](unsigned u, unsigned v) { return first + u % around * across + v % across; };
                made.mesh.triangles.emplace_back(at(i, j), at(i, j + 1), at(i + 1, j + 1));
                made.mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i + 1, j));
            }
    }
    void ground() { box({-30, -1, -30}, {30, 0, 30}); }

private:
    std::mt19937 random_;
};

/// Houses, half of them with a roof of 25 cm that overhangs by 30 cm.
[[nodiscard]] inline scene boxes_with_eaves(std::uint32_t seed, glm::dvec3 at) {
    scene_builder all("boxes with eaves", seed, at);
    all.ground();
    for (int i = 0; i < 40; ++i) {
        const double w = all.real(0.2, 1.7), h = all.real(0.5, 4), d = all.real(0.2, 1.7);
        const glm::dmat3 turn = all.upright_rotation();
        const glm::dvec3 to = all.around_lamp(3, 11);
        all.box({-w, 0, -d}, {w, h, d}, to, turn);
        if (i % 2 == 0) all.box({-w - 0.3, h, -d - 0.3}, {w + 0.3, h + 0.25, d + 0.3}, to, turn);
    }
    all.made.lamp = {0, 3, 0};
    return all.made;
}

/// Pales of 8 by 3 cm in four rows, with rails, among a few posts.
[[nodiscard]] inline scene thin_fence(std::uint32_t seed, glm::dvec3 at) {
    scene_builder all("thin fence", seed, at);
    all.ground();
    for (int row = 0; row < 4; ++row) {
        const glm::dvec3 to(0, 0, 3.0 - 2.5 * row);
        const glm::dmat3 turn = all.upright_rotation();
        for (int i = -20; i <= 20; ++i) {
            const double x = 0.2 * i, h = all.real(0.8, 1.0);
            all.box({x - 0.04, 0, -0.015}, {x + 0.04, h, 0.015}, to, turn);
        }
        for (const double y : {0.3, 0.7}) all.box({-4.1, y, 0.015}, {4.1, y + 0.06, 0.045}, to, turn);
    }
    for (int i = 0; i < 12; ++i) all.box({-0.06, 0, -0.06}, {0.06, 2, 0.06}, all.around_lamp(0.5, 9));
    all.made.eye = {0, 1.8, 6.5}, all.made.look_at = {0, 0.2, 0};
    all.made.spot = {2, 6, 2}, all.made.lamp = {0.5, 3, 1}, all.made.reach = 15;
    return all.made;
}

/// Hills of a few waves, of triangles of 31 cm, with rocks that lie in them.
[[nodiscard]] inline scene hills(std::uint32_t seed, glm::dvec3 at) {
    scene_builder all("hills", seed, at);
    constexpr unsigned side = 129;
    struct wave {
        double x, z, phase, height;
    };
    std::vector<wave> waves;
    for (int i = 0; i < 10; ++i) {
        const double length = all.real(2, 10), way = all.real(0, 2 * std::numbers::pi);
        const double k = 2 * std::numbers::pi / length;
        waves.push_back({k * std::cos(way), k * std::sin(way), all.real(0, 2 * std::numbers::pi), 0.04 * length});
    }
    const auto height = [&](double x, double z) {
        double y = 0;
        for (const wave& w : waves) y += w.height * std::sin(w.x * x + w.z * z + w.phase);
        return y;
    };
    for (unsigned j = 0; j < side; ++j)
        for (unsigned i = 0; i < side; ++i) {
            const double x = 40.0 * i / (side - 1) - 20, z = 40.0 * j / (side - 1) - 20;
            const unsigned v = all.vertex({x, height(x, z), z});
            if (i == 0 || j == 0) continue;
            all.made.mesh.triangles.emplace_back(v, v - side, v - side - 1);
            all.made.mesh.triangles.emplace_back(v, v - side - 1, v - 1);
        }
    all.made.smooth = all.made.mesh.triangles.size();
    for (int i = 0; i < 40; ++i) {
        const double x = all.real(-9, 9), z = all.real(-9, 9);
        const glm::dvec3 half{all.real(0.1, 0.5), all.real(0.1, 0.5), all.real(0.1, 0.5)};
        all.box(-half, half, {x, height(x, z), z}, all.rotation());
    }
    all.made.eye = {0, 5, 12}, all.made.look_at = {0, 0, 0};
    all.made.sun = {-1, -0.7, -0.6}, all.made.spot = {8, 7, 5}, all.made.lamp = {0.5, 6, 1};
    return all.made;
}

/// A table, chairs, shelves and a cabinet between walls, under a lamp.
[[nodiscard]] inline scene room(std::uint32_t seed, glm::dvec3 at) {
    scene_builder all("room", seed, at);
    all.box({-4.3, -0.3, -3.3}, {4.3, 0, 3.3}), all.box({-4.3, 2.8, -3.3}, {4.3, 3.1, 3.3});
    all.box({-4.3, -0.3, -3.3}, {-4, 3.1, 3.3}), all.box({4, -0.3, -3.3}, {4.3, 3.1, 3.3});
    all.box({-4.3, -0.3, -3.3}, {4.3, 3.1, -3}), all.box({-4.3, -0.3, 3}, {4.3, 3.1, 3.3});
    const auto table = [&](glm::dvec3 to, glm::dvec3 half, double height, const glm::dmat3& turn) {
        all.box({-half.x, height - 0.04, -half.z}, {half.x, height, half.z}, to, turn);
        for (int i = 0; i < 4; ++i) {
            const double x = (i & 1 ? 1 : -1) * (half.x - 0.05), z = (i & 2 ? 1 : -1) * (half.z - 0.05);
            all.box({x - 0.03, 0, z - 0.03}, {x + 0.03, height - 0.03, z + 0.03}, to, turn);
        }
    };
    table({0.3, 0, 0.2}, {0.9, 0, 0.5}, 0.75, all.upright_rotation());
    for (int i = 0; i < 5; ++i) {  // chairs, with a back
        const glm::dvec3 to{all.real(-3, 3), 0, all.real(-2, 2)};
        const glm::dmat3 turn = all.upright_rotation();
        table(to, {0.22, 0, 0.22}, 0.45, turn);
        all.box({-0.22, 0.44, 0.19}, {0.22, 0.95, 0.22}, to, turn);
    }
    for (int i = 0; i < 5; ++i) all.box({-3.5, 0.4 + 0.4 * i, -3.1}, {-1.5, 0.43 + 0.4 * i, -2.7});
    for (int i = 0; i < 24; ++i) {  // books
        const double x = all.real(-3.4, -1.7), y = 0.43 + 0.4 * (i % 4), w = all.real(0.02, 0.08);
        all.box({x, y, -3.05}, {x + w, y + all.real(0.2, 0.3), -2.8});
    }
    all.box({2, 0, -3.1}, {3.4, 1.1, -2.5});
    all.made.eye = {3.6, 1.9, 2.7}, all.made.look_at = {-0.8, 0.6, -0.8};
    all.made.spot = {-2.5, 2.7, 2.2}, all.made.spot_target = {0.5, 0, -0.6}, all.made.lamp = {0.6, 2.3, -0.3};
    all.made.reach = 10, all.made.has_sun = false;
    return all.made;
}

/// Rings that lie and stand on the ground, and boxes turned in all directions, in each other and in the ground.
[[nodiscard]] inline scene rings_and_boxes(std::uint32_t seed, glm::dvec3 at) {
    scene_builder all("rings and turned boxes", seed, at);
    for (int i = 0; i < 40; ++i) {
        const double radius = all.real(0.2, 1), thickness = radius * all.real(0.15, 0.5);
        const bool lies = i % 2 == 0;
        const glm::dmat3 stands({1, 0, 0}, {0, 0, 1}, {0, -1, 0});
        const glm::dvec3 to = all.around_lamp(2, 8, lies ? thickness : radius + thickness);
        all.ring(radius, thickness, to, all.upright_rotation() * (lies ? glm::dmat3(1) : stands));
    }
    all.made.smooth = all.made.mesh.triangles.size();
    all.ground();
    for (int i = 0; i < 30; ++i) {
        const glm::dvec3 half{all.real(0.1, 0.8), all.real(0.1, 0.8), all.real(0.05, 0.8)};
        const glm::dvec3 to = all.around_lamp(2, 8, all.real(0, 1.5));
        all.box(-half, half, to, all.rotation());
    }
    all.made.eye = {1, 4, 12};
    return all.made;
}

}  // namespace proof::picture
