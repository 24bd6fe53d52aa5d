// SPDX-License-Identifier: MIT
#include "scene.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

namespace example {
namespace {

constexpr float floor_half = 4.0f;   ///< the floor reaches from -4 to 4
constexpr float fitted_size = 2.4f;  ///< greatest edge of a mesh that was scaled to fit
constexpr float tau = 2.0f * std::numbers::pi_v<float>;

struct vertex {
    glm::vec3 position, normal;
};

/// The surface (u, v) -> vertex over the unit square, in columns x rows cells.
template <class Surface>
void add_surface(mesh& out, glm::uvec2 cells, const glm::mat4& place, glm::vec3 colour, Surface surface) {
    const auto base = static_cast<unsigned>(out.positions.size());
    for (unsigned j = 0; j <= cells.y; ++j)
        for (unsigned i = 0; i <= cells.x; ++i) {
            const vertex p = surface(float(i) / float(cells.x), float(j) / float(cells.y));
            out.positions.push_back(place * glm::vec4(p.position, 1));
            out.normals.push_back(glm::normalize(glm::mat3(place) * p.normal));  // `place` only moves and rotates
            out.colours.push_back(colour);
        }
    for (unsigned j = 0; j < cells.y; ++j)
        for (unsigned i = 0; i < cells.x; ++i) {
            const unsigned a = base + j * (cells.x + 1) + i, b = a + cells.x + 1;
            out.triangles.emplace_back(a, a + 1, b + 1);
            out.triangles.emplace_back(a, b + 1, b);
        }
}

void add_sphere(mesh& out, glm::vec3 centre, float radius, glm::vec3 colour) {
    add_surface(out, {96, 48}, glm::translate(glm::mat4(1), centre), colour, [&](float u, float v) {
        const float a = u * tau, b = v * tau / 2;
        const glm::vec3 n(std::sin(b) * std::sin(a), -std::cos(b), std::sin(b) * std::cos(a));
        return vertex{radius * n, n};
    });
}

void add_torus(mesh& out, const glm::mat4& place, float ring, float tube, glm::vec3 colour) {
    add_surface(out, {128, 48}, place, colour, [&](float u, float v) {
        const float a = u * tau, b = v * tau;
        const glm::vec3 outwards(std::cos(a), std::sin(a), 0);
        const glm::vec3 n = std::cos(b) * outwards + glm::vec3(0, 0, std::sin(b));
        return vertex{ring * outwards + tube * n, n};
    });
}

/// An upright cylinder and its lid.
void add_pillar(mesh& out, glm::vec3 foot, float radius, float height, glm::vec3 colour) {
    const glm::mat4 place = glm::translate(glm::mat4(1), foot);
    const auto around = [](float u) { return glm::vec3(std::sin(u * tau), 0, std::cos(u * tau)); };
    add_surface(out, {96, 1}, place, colour, [&](float u, float v) {
        return vertex{radius * around(u) + glm::vec3(0, v * height, 0), around(u)};
    });
    add_surface(out, {96, 1}, place, colour, [&](float u, float v) {
        return vertex{(1 - v) * radius * around(u) + glm::vec3(0, height, 0), {0, 1, 0}};
    });
}

void add_box(mesh& out, const glm::mat4& place, glm::vec3 half, glm::vec3 colour) {
    for (int axis = 0; axis < 3; ++axis)
        for (float side : {-1.0f, 1.0f})
            add_surface(out, {1, 1}, place, colour, [&](float u, float v) {
                glm::vec3 n(0), p(0);
                n[axis] = side;
                p[axis] = side * half[axis];
                p[(axis + 1) % 3] = side * (2 * u - 1) * half[(axis + 1) % 3];
                p[(axis + 2) % 3] = (2 * v - 1) * half[(axis + 2) % 3];
                return vertex{p, n};
            });
}

void add_floor(mesh& out) {
    add_surface(out, {1, 1}, glm::mat4(1), glm::vec3(1), [](float u, float v) {
        return vertex{{(2 * u - 1) * floor_half, 0, (1 - 2 * v) * floor_half}, {0, 1, 0}};
    });
}

/// Floor first, then the object, and the box around both.
scene finish(const mesh& object) {
    scene out;
    mesh& all = out.geometry;
    add_floor(all);
    out.floor_triangles = all.triangles.size();
    const auto base = static_cast<unsigned>(all.positions.size());
    all.positions.insert(all.positions.end(), object.positions.begin(), object.positions.end());
    all.normals.insert(all.normals.end(), object.normals.begin(), object.normals.end());
    all.colours.insert(all.colours.end(), object.colours.begin(), object.colours.end());
    for (glm::uvec3 t : object.triangles) all.triangles.push_back(t + base);

    out.low = out.high = all.positions.front();
    for (glm::vec3 p : all.positions) {
        out.low = glm::min(out.low, p);
        out.high = glm::max(out.high, p);
    }
    out.target = {0, 0.45f * out.high.y, 0};
    return out;
}

}  // namespace

scene default_scene() {
    mesh m;
    const auto at = [](glm::vec3 p) { return glm::translate(glm::mat4(1), p); };
    add_pillar(m, {1.15f, 0, -0.2f}, 0.25f, 1.35f, {0.75f, 0.72f, 0.66f});
    add_sphere(m, {1.15f, 1.8f, -0.2f}, 0.48f, {0.80f, 0.30f, 0.16f});
    add_box(m, glm::rotate(at({-0.05f, 0.5f, -0.75f}), 0.5f, {0, 1, 0}), glm::vec3(0.5f), {0.22f, 0.42f, 0.70f});
    add_torus(m, glm::rotate(glm::rotate(at({-0.75f, 0.63f, 0.85f}), 0.6f, {0, 1, 0}), -0.45f, {1, 0, 0}), 0.5f, 0.17f,
              {0.90f, 0.65f, 0.13f});
    return finish(m);
}

scene on_floor(mesh object, up_axis up) {
    if (up == up_axis::z)
        for (auto* vectors : {&object.positions, &object.normals})
            for (glm::vec3& v : *vectors) v = {v.x, v.z, -v.y};

    // In double: units and offsets can be anything that float holds. Only vertices in use count.
    const auto& p = object.positions;
    glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
    for (glm::uvec3 t : object.triangles)
        for (int i = 0; i < 3; ++i) {
            low = glm::min(low, glm::dvec3(p[t[i]]));
            high = glm::max(high, glm::dvec3(p[t[i]]));
        }
    const glm::dvec3 extent = high - low, foot(0.5 * (low.x + high.x), low.y, 0.5 * (low.z + high.z));
    const double scale = fitted_size / std::max({extent.x, extent.y, extent.z});
    for (glm::vec3& v : object.positions) {
        v = glm::vec3((glm::dvec3(v) - foot) * scale);
        if (!(glm::length(v) < 100.0f)) v = glm::vec3(0);  // belongs to no triangle that is left
    }
    return finish(object);
}

}  // namespace example
