// SPDX-License-Identifier: MIT
#include "scene.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <umbrage/draw/instances.hpp>

#include "shapes.hpp"

namespace example {
namespace {

constexpr float floor_half = 4.0f;   ///< the floor reaches from -4 to 4
constexpr float fitted_size = 2.4f;  ///< greatest edge of a mesh that was scaled to fit

void add_sphere(mesh& out, glm::vec3 center, float radius, glm::vec3 color) {
    add_surface(out, {96, 48}, glm::translate(glm::mat4(1), center), color, [&](float u, float v) {
        const glm::vec3 n = on_sphere(u, v);
        return vertex{radius * n, n};
    });
}

void add_torus(mesh& out, const glm::mat4& place, float ring, float tube, glm::vec3 color) {
    add_surface(out, {128, 48}, place, color, [&](float u, float v) {
        const glm::vec3 outwards(on_circle(u), 0);
        const glm::vec2 around = on_circle(v);
        const glm::vec3 n = around.x * outwards + glm::vec3(0, 0, around.y);
        return vertex{ring * outwards + tube * n, n};
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
    add_floor(out.geometry);
    out.floor_triangles = out.geometry.triangles.size();
    append(out.geometry, object, glm::mat4(1));
    find_bounds(out);
    out.target = {0, 0.45f * out.high.y, 0};
    return out;
}

}  // namespace

void append(mesh& to, const mesh& of, const glm::mat4& place) {
    const auto base = static_cast<unsigned>(to.positions.size());
    for (glm::vec3 p : of.positions) to.positions.emplace_back(place * glm::vec4(p, 1));
    const glm::mat3 turn = glm::mat3(place) / glm::length(glm::vec3(place[0]));
    for (glm::vec3 n : of.normals) to.normals.push_back(turn * n);
    to.colors.insert(to.colors.end(), of.colors.begin(), of.colors.end());
    for (glm::uvec3 t : of.triangles) to.triangles.push_back(t + base);
}

void find_bounds(scene& s) {
    const umbrage::bounding_box<float> box = umbrage::bounds_of(view_of(s.geometry));
    s.low = box.low, s.high = box.high;
}

scene solids_scene() {
    mesh m;
    const auto at = [](glm::vec3 p) { return glm::translate(glm::mat4(1), p); };
    constexpr double radian = 0.5 / std::numbers::pi;  // in turns
    add_pillar(m, {1.15f, 0, -0.2f}, 0.25f, 1.35f, {0.75f, 0.72f, 0.66f});
    add_sphere(m, {1.15f, 1.8f, -0.2f}, 0.48f, {0.80f, 0.30f, 0.16f});
    add_box(m, at({-0.05f, 0.5f, -0.75f}) * rotation_about(1, 0.5 * radian), glm::vec3(0.5f), {0.22f, 0.42f, 0.70f});
    add_torus(m, at({-0.75f, 0.63f, 0.85f}) * rotation_about(1, 0.6 * radian) * rotation_about(0, -0.45 * radian), 0.5f,
              0.17f, {0.90f, 0.65f, 0.13f});
    return finish(m);
}

scene plain_scene() {
    scene s;
    s.target = {0, 2, -100}, s.z_near = 0.5f, s.z_far = 1000;
    const glm::vec3 up(0, 1, 0);
    add_surface(s.geometry, {120, 120}, glm::mat4(1), {0.42f, 0.48f, 0.30f}, [&](float u, float v) {
        return vertex{{1200 * u - 600, 0, 1200 * v - 1000}, up};
    });
    s.floor_triangles = s.geometry.triangles.size();
    for (const float away : {12.0f, 30.0f, 70.0f, 160.0f, 400.0f, 900.0f})
        for (const float side : {-1.0f, 1.0f})
            add_pillar(s.geometry, {side * away / 4, 0, -away}, 0.4f, 10, {0.75f, 0.72f, 0.66f});
    find_bounds(s);
    return s;
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
