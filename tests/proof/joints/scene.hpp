// SPDX-License-Identifier: MIT
//
// Scenes of a draw: convex surfaces as they are meant, their triangles in floats as programs have them, and what lights
// and cameras need to know of them. All positions are relative to the origin that the shadow is told.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/draw/mesh.hpp>
#include <umbrage/light/bounds.hpp>

#include "choices.hpp"
#include "dice.hpp"

namespace joints {

/// A flat convex surface. Its corners are exact; the mesh has them rounded, and so its triangles are hardly flat.
struct surface {
    std::vector<glm::dvec3> corners;
    glm::dvec3 normal;
    std::optional<glm::mat3> model{};  ///< of an instance, which its normal may be transformed with
};

/// A receiver: a point of a triangle as a program has it, and the normal of its surface.
struct receiver {
    std::size_t own;
    glm::vec3 point, normal;
};

class scene {
public:
    explicit scene(const choices& c) : choices_(c), dice_(c.seed ^ 0x5CE4E5CE4Eu) {
        const double size = 10 * c.scale;
        turn_ = c.rotated ? dice_.rotation() : glm::dmat3(1);
        const glm::dvec3 at = dice_.direction() * (size * c.away);
        if (c.with_origin) origin = at, base_ = dice_.direction() * (size * dice_.real(0, 3));
        else base_ = at;
        if (c.scene == scene_kind::room) make_room();
        else make_outdoors();
        // A paraboloid's mesh keeps edges that are as near to the light as range / 4096, and their shadows; far from
        // the origin floats do not resolve the card. The near plane of a warped lamp is not at its z_near.
        const bool is_flat = z_near * c.scale < 0x1p-16 * glm::length(placed(lamp));
        const bool has_near_plane =
            !c.is_sun() && c.setup != setup_kind::paraboloids && c.setup != setup_kind::warped_lamp;
        if (has_near_plane && !is_flat && dice_.one_in(2)) add_shade();
    }

    glm::dvec3 origin{0};
    std::vector<surface> surfaces;
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    std::vector<glm::mat4> instances;  ///< of a cube with sides of 2

    [[nodiscard]] umbrage::mesh_view mesh() const { return {positions, triangles}; }
    [[nodiscard]] static umbrage::mesh_view cube() {
        static const std::vector<glm::vec3> corners{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                                    {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
        static const std::vector<glm::uvec3> faces{{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
        return {corners, faces};
    }

    /// A position of the scene's own units, relative to the origin.
    [[nodiscard]] glm::dvec3 placed(glm::dvec3 own) const { return base_ + turned(own * choices_.scale); }
    [[nodiscard]] glm::dvec3 turned(glm::dvec3 way) const { return turn_ * way; }

    glm::dvec3 lamp{0}, aim{0}, sun{0}, eye{0}, look{0};  ///< in the scene's own units
    double z_near = 0.1;                                  ///< of the lamp
    double angle = 0.5;                                   ///< from its axis to the edge of its cone, radians

    /// Box around all casters that stand on the ground, or around these and what hangs above, in the world.
    [[nodiscard]] umbrage::bounding_box<double> box(bool with_all = true) const {
        umbrage::bounding_box<double> b{glm::dvec3(1e300), glm::dvec3(-1e300)};
        const auto add = [&](glm::dvec3 p) {
            b.low = glm::min(b.low, p + origin), b.high = glm::max(b.high, p + origin);
        };
        for (std::size_t k = with_all ? 0 : apart_; k < surfaces.size(); ++k)
            for (const glm::dvec3& p : surfaces[k].corners) add(p);
        return b;
    }
    /// Box of the receivers, in the world: the scene but for what is apart.
    [[nodiscard]] umbrage::bounding_box<double> near_box() const { return box_around({-5, -0.5, -5}, {5, 4, 5}); }
    /// Box of those that lie before a lamp outdoors, along its axis.
    [[nodiscard]] umbrage::bounding_box<double> low_box() const {
        return box_around({-1.5, -0.5, -1.5}, {1.5, 1, 1.5});
    }

    /// The camera that maps are fitted to, in the world.
    template <class T>
    [[nodiscard]] umbrage::frustum<T> camera() const {
        return {.position = glm::vec<3, T>(placed(eye) + origin),
                .direction = glm::vec<3, T>(turned(look)),
                .tan_half_x = T(0.5),
                .tan_half_y = T(0.4),
                .z_near = T(0.5 * choices_.scale),
                .z_far = T(9 * choices_.scale)};
    }

    [[nodiscard]] receiver draw_receiver() {
        const auto k = std::size_t(dice_.whole(0, int(surfaces.size()) - 1));
        const surface& s = surfaces[k];
        const auto fan = std::size_t(dice_.whole(1, int(s.corners.size()) - 2));
        const auto given = [&](std::size_t i) { return s.model ? s.corners[i] : glm::dvec3(glm::vec3(s.corners[i])); };
        double u = dice_.real(0, 1), v = dice_.real(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        if (k == ground_ && choices_.scene == scene_kind::huge_ground) return ground_receiver(k);
        const glm::dvec3 a = given(0), b = given(fan), c = given(fan + 1);
        return {k, glm::vec3(a + u * (b - a) + v * (c - a)), glm::vec3(s.normal * dice_.real(0.5, 2))};
    }

private:
    /// Box in the world around a box of the scene.
    [[nodiscard]] umbrage::bounding_box<double> box_around(glm::dvec3 low, glm::dvec3 high) const {
        umbrage::bounding_box<double> b{glm::dvec3(1e300), glm::dvec3(-1e300)};
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 p =
                placed({(i & 1 ? high : low).x, (i & 2 ? high : low).y, (i & 4 ? high : low).z}) + origin;
            b.low = glm::min(b.low, p), b.high = glm::max(b.high, p);
        }
        return b;
    }
    void add(std::vector<glm::dvec3> own, bool as_given = false) {
        surface s;
        const auto first = static_cast<unsigned>(positions.size());
        for (const glm::dvec3& p : own) {
            glm::dvec3 at = placed(p);
            positions.emplace_back(at);
            if (as_given) at = glm::dvec3(positions.back());
            s.corners.push_back(at);
        }
        s.normal = glm::normalize(glm::cross(s.corners[1] - s.corners[0], s.corners[2] - s.corners[0]));
        for (unsigned i = 2; i < own.size(); ++i) triangles.emplace_back(first, first + i - 1, first + i);
        surfaces.push_back(std::move(s));
    }
    /// Corners of a face of a box, seen from outside counter-clockwise.
    [[nodiscard]] static std::array<glm::dvec3, 4> face_of(int face) {
        const int axis = face / 2;
        const double side = face % 2 ? 1 : -1;
        std::array<glm::dvec3, 4> all;
        for (int i = 0; i < 4; ++i) {
            const double a = i == 0 || i == 3 ? -1 : 1, b = i < 2 ? -1 : 1;
            glm::dvec3& p = all[std::size_t(i)];
            p[axis] = side, p[(axis + 1) % 3] = side * a, p[(axis + 2) % 3] = b;
        }
        return all;
    }
    void add_box(glm::dvec3 middle, const glm::dmat3& axes) {
        if (!choices_.mirrored || dice_.one_in(2)) {
            for (int face = 0; face < 6; ++face) {
                std::vector<glm::dvec3> own;
                for (const glm::dvec3& corner : face_of(face)) own.push_back(middle + axes * corner);
                add(own);
            }
            return;
        }
        glm::dmat3 model = turn_ * axes * choices_.scale;
        model[dice_.whole(0, 2)] *= dice_.one_in(3) ? 1.0 : -1.0;
        glm::mat4 rounded{glm::mat3(model)};
        rounded[3] = glm::vec4(glm::vec3(placed(middle)), 1);
        instances.push_back(rounded);
        const glm::dmat4 exact(rounded);
        for (int face = 0; face < 6; ++face) {
            surface s;
            for (const glm::dvec3& corner : face_of(face)) s.corners.emplace_back(exact * glm::dvec4(corner, 1));
            s.normal = glm::normalize(glm::cross(s.corners[1] - s.corners[0], s.corners[2] - s.corners[0]));
            s.model = glm::mat3(rounded);
            surfaces.push_back(std::move(s));
        }
    }
    /// A box: a block, a board or a pole.
    void add_some_box(glm::dvec3 low, glm::dvec3 high) {
        for (int tries = 0; tries < 100; ++tries) {
            const glm::dvec3 middle = dice_.between(low, high);
            glm::dvec3 half(dice_.real(0.2, 1), dice_.real(0.2, 1), dice_.real(0.2, 1));
            if (!dice_.one_in(3)) half[dice_.whole(0, 2)] = dice_.spread(0.002, 0.1);
            const glm::dmat3 turn = dice_.rotation();
            const glm::dvec3 of_lamp = glm::transpose(turn) * (lamp - middle);
            if (glm::length(glm::max(glm::abs(of_lamp) - half, glm::dvec3(0))) < 0.4) continue;
            return add_box(middle, {turn[0] * half.x, turn[1] * half.y, turn[2] * half.z});
        }
    }
    void add_card(glm::dvec3 middle, double size) {
        const glm::dmat3 turn = dice_.rotation();
        const glm::dvec3 x = turn[0] * size, y = turn[1] * (size * dice_.real(0.3, 1));
        add({middle - x - y, middle + x - y, middle + x + y, middle - x + y});
    }
    void make_room() {
        const glm::dvec3 half = dice_.between({2, 1.5, 2}, {4.5, 3, 4.5});
        lamp = dice_.between(-0.8 * half, 0.8 * half);
        if (dice_.one_in(3))  // in a corner
            for (int i = 0; i < 3; ++i)
                if (!dice_.one_in(3)) lamp[i] = (dice_.one_in(2) ? 1 : -1) * (half[i] - dice_.spread(0.02, 0.4));
        aim = dice_.between(-0.7 * half, 0.7 * half) - lamp;
        if (choices_.facing) aim = {0, 0, 0}, aim[dice_.whole(0, 2)] = dice_.one_in(2) ? 1 : -1;
        z_near = dice_.one_in(8) ? dice_.spread(1e-5, 1e-3) : dice_.spread(0.005, 0.1);
        angle = dice_.one_in(8) ? dice_.real(1.3, 1.5) : dice_.real(0.3, 1.3);
        for (int face = 0; face < 6; ++face) {
            std::vector<glm::dvec3> own;
            for (const glm::dvec3& corner : face_of(face)) own.push_back(corner * half);
            add(own);
        }
        for (int i = dice_.whole(0, 4); i > 0; --i) add_some_box(-0.8 * half, 0.8 * half);
    }
    void make_outdoors() {
        sun = dice_.upwards(0.15);
        lamp = dice_.upwards(choices_.setup == setup_kind::warped_lamp ? 0.6 : 0.3) * dice_.real(6, 9);
        z_near = dice_.one_in(8) ? dice_.spread(1e-5, 1e-3) : dice_.real(0.02, 0.5);
        angle = dice_.real(0.2, 0.6);
        if (choices_.is_point()) lamp = dice_.between({-2, 1, -2}, {2, 3, 2});
        aim = dice_.between({-2, 0, -2}, {2, 1, 2}) - lamp;
        if (choices_.facing) sun = {0, 1, 0}, aim = {0, -1, 0};
        const glm::dvec3 away = dice_.upwards(0.15) * dice_.real(2, 7);
        eye = away, look = dice_.between(glm::dvec3(-1), glm::dvec3(1)) - away;
        // apart: a card above that the receivers' box does not hold, and one beside them
        add_card(sun * dice_.real(6, 20) + dice_.between(glm::dvec3(-2), glm::dvec3(2)), dice_.real(1, 3));
        add_card({dice_.real(8, 20), 1, 0}, 1);
        apart_ = surfaces.size();
        ground_ = surfaces.size();
        if (choices_.scene == scene_kind::huge_ground) {
            const double far = dice_.spread(100, 1e5);  // one triangle, which is what its floats say
            add({{-far, 0, -far}, {0, 0, 2 * far}, {far, 0, -far}}, true);
        } else add({{-5, 0, -5}, {-5, 0, 5}, {5, 0, 5}, {5, 0, -5}});
        for (int i = dice_.whole(2, 5); i > 0; --i) add_some_box({-2.5, 0.2, -2.5}, {2.5, 2.5, 2.5});
        for (int i = dice_.whole(0, 2); i > 0; --i) add_card(dice_.between({-2, 1.2, -2}, {2, 3, 2}), 1);
    }
    /// A card nearer to the lamp than its near plane, which no shadow holds.
    void add_shade() {
        const glm::dvec3 way = choices_.is_point() ? dice_.direction() : glm::normalize(aim);
        const glm::dvec3 x = glm::normalize(glm::cross(way, dice_.direction())), y = glm::cross(way, x);
        const glm::dvec3 middle = lamp + way * (0.5 * z_near);
        const double size = 0.2 * z_near;
        add({middle - (x + y) * size, middle + (x - y) * size, middle + (x + y) * size, middle - (x - y) * size});
    }
    [[nodiscard]] receiver ground_receiver(std::size_t k) {
        const surface& s = surfaces[k];
        const glm::dvec3 near = placed(dice_.between({-4, 0, -4}, {4, 0, 4}));
        const glm::dvec3 on_it = near - s.normal * glm::dot(s.normal, near - s.corners[0]);
        return {k, glm::vec3(on_it), glm::vec3(s.normal)};
    }

    choices choices_;
    dice dice_;
    glm::dmat3 turn_{1};
    glm::dvec3 base_{0};
    std::size_t apart_ = 0, ground_ = ~std::size_t(0);
};

}  // namespace joints
