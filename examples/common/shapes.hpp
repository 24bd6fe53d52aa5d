// SPDX-License-Identifier: MIT
//
// Shapes from which scenes are built.
//
//     example::add_surface(mesh, {96, 48}, place, color, [](float u, float v) { return example::vertex{...}; });
//
#pragma once

#include <initializer_list>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "circle.hpp"
#include "scene.hpp"

namespace example {

/// A direction by columns u and rows v of a sphere, from below.
[[nodiscard]] inline glm::vec3 on_sphere(float u, float v) {
    const glm::vec2 around = on_circle(u), up = on_circle(0.5 * double(v));
    return {up.y * around.y, -up.x, up.y * around.x};
}

struct vertex {
    glm::vec3 position, normal;
};

/// The surface (u, v) -> vertex over the unit square, in columns x rows cells.
template <class Surface>
void add_surface(mesh& out, glm::uvec2 cells, const glm::mat4& place, glm::vec3 color, Surface surface) {
    const auto base = static_cast<unsigned>(out.positions.size());
    for (unsigned j = 0; j <= cells.y; ++j)
        for (unsigned i = 0; i <= cells.x; ++i) {
            const vertex p = surface(float(i) / float(cells.x), float(j) / float(cells.y));
            out.positions.push_back(place * glm::vec4(p.position, 1));
            out.normals.push_back(glm::normalize(glm::mat3(place) * p.normal));  // `place` only moves and rotates
            out.colors.push_back(color);
        }
    for (unsigned j = 0; j < cells.y; ++j)
        for (unsigned i = 0; i < cells.x; ++i) {
            const unsigned a = base + j * (cells.x + 1) + i, b = a + cells.x + 1;
            out.triangles.emplace_back(a, a + 1, b + 1);
            out.triangles.emplace_back(a, b + 1, b);
        }
}

/// An upright cylinder and its lid.
inline void add_pillar(mesh& out, glm::vec3 foot, float radius, float height, glm::vec3 color) {
    const glm::mat4 place = glm::translate(glm::mat4(1), foot);
    const auto around = [](float u) {
        const glm::vec2 at = on_circle(u);
        return glm::vec3(at.y, 0, at.x);
    };
    add_surface(out, {96, 1}, place, color, [&](float u, float v) {
        return vertex{radius * around(u) + glm::vec3(0, v * height, 0), around(u)};
    });
    add_surface(out, {96, 1}, place, color, [&](float u, float v) {
        return vertex{(1 - v) * radius * around(u) + glm::vec3(0, height, 0), {0, 1, 0}};
    });
}

inline void add_box(mesh& out, const glm::mat4& place, glm::vec3 half, glm::vec3 color) {
    for (int axis = 0; axis < 3; ++axis)
        for (float side : {-1.0f, 1.0f})
            add_surface(out, {1, 1}, place, color, [&](float u, float v) {
                glm::vec3 n(0), p(0);
                n[axis] = side;
                p[axis] = side * half[axis];
                p[(axis + 1) % 3] = side * (2 * u - 1) * half[(axis + 1) % 3];
                p[(axis + 2) % 3] = (2 * v - 1) * half[(axis + 2) % 3];
                return vertex{p, n};
            });
}

}  // namespace example
