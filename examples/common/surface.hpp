// SPDX-License-Identifier: MIT
//
// Surface of a triangle, as the camera sees it.
//
//     if (seen[texel] != example::nothing) example::surface s = example::surface_at(scene, camera, seen, texel);
//
// Neighbors in a row mostly see the same triangle. Their common values are then computed once:
//
//     example::for_each_run(seen, y, [&](int first, int last, std::uint32_t triangle) {
//         const example::seen_triangle on(scene, camera, seen.size(), triangle);
//         for (int x = first; x < last; ++x) use(on.position({x, y}));
//     });
//
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/draw/barycentrics.hpp>

#include "camera.hpp"
#include "scene.hpp"

namespace example {

/// A point that the camera sees. Both normals point to the camera's side of the triangle.
struct surface {
    glm::vec3 position;
    glm::vec3 face_normal;  ///< normal of the flat triangle that the shadow map holds
    glm::vec3 normal;       ///< interpolated, for shading
    glm::vec3 color;
};

/// Color of the floor's tiles at a point of it, without a branch or a call.
[[nodiscard]] inline glm::vec3 floor_color(glm::vec3 position) {
    const float x = position.x * 2.0f, z = position.z * 2.0f;
    const auto floor = [](float v) {
        return static_cast<int>(v) - (v < static_cast<float>(static_cast<int>(v)) ? 1 : 0);
    };
    const float across = x - static_cast<float>(floor(x)), along = z - static_cast<float>(floor(z));
    const bool joint = (across < 0.02f) | (along < 0.02f) | (1 - across < 0.02f) | (1 - along < 0.02f);
    const bool dark = ((floor(x) + floor(z)) & 1) != 0;
    return glm::vec3(joint ? 0.30f : dark ? 0.52f : 0.64f);
}

/// Texels of a row that are computed together, so that compilers can use vectors: a fixed number, without branches.
inline constexpr int lanes = 8;

/// As many vectors.
struct vectors {
    float x[lanes], y[lanes], z[lanes];

    [[nodiscard]] glm::vec3 operator[](int i) const { return {x[i], y[i], z[i]}; }
    void set(int i, glm::vec3 v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
};

class seen_triangle {
public:
    /// @param size  size of the camera's image
    seen_triangle(const scene& s, const camera& c, glm::ivec2 size, std::uint32_t triangle)
        : weights_(size, view_of(s.geometry), c.world_to_clip, picture_clip, triangle),
          camera_(c.position),
          floor_(triangle < s.floor_triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const unsigned vertex = s.geometry.triangles[triangle][static_cast<int>(i)];
            positions_[i] = s.geometry.positions[vertex];
            normals_[i] = s.geometry.normals[vertex];
            colors_[i] = s.geometry.colors[vertex];
        }
        face_normal_ = unit(glm::cross(positions_[1] - positions_[0], positions_[2] - positions_[0]), {0, 1, 0});
    }

    [[nodiscard]] glm::vec3 weights(glm::ivec2 texel) const { return weights_(texel); }
    [[nodiscard]] glm::vec3 position(glm::vec3 weights) const { return blend(positions_, weights); }
    [[nodiscard]] glm::vec3 face_normal(glm::vec3 position) const { return towards(face_normal_, camera_ - position); }
    [[nodiscard]] glm::vec3 normal(glm::vec3 weights, glm::vec3 face_normal) const {
        return towards(unit(blend(normals_, weights), face_normal), face_normal);
    }
    [[nodiscard]] glm::vec3 color(glm::vec3 weights, glm::vec3 position) const {
        return floor_ ? floor_color(position) : blend(colors_, weights);
    }

    /// Positions on the triangle that the next texels see, which may lie beyond its last one.
    void locate(glm::ivec2 first, vectors& weights, vectors& positions) const {
        for (int i = 0; i < lanes; ++i) weights.set(i, weights_({first.x + i, first.y}));
        for (int i = 0; i < lanes; ++i) positions.set(i, position(weights[i]));
    }

    /// Their colors.
    void paint(const vectors& weights, const vectors& positions, vectors& colors) const {
        if (floor_)
            for (int i = 0; i < lanes; ++i) colors.set(i, floor_color(positions[i]));
        else
            for (int i = 0; i < lanes; ++i) colors.set(i, blend(colors_, weights[i]));
    }

    [[nodiscard]] surface at(glm::ivec2 texel) const {
        const glm::vec3 w = weights(texel), p = position(w), face = face_normal(p);
        return {p, face, normal(w, face), color(w, p)};
    }

private:
    using vertices = std::array<glm::vec3, 3>;
    static glm::vec3 blend(const vertices& of, glm::vec3 w) { return w.x * of[0] + w.y * of[1] + w.z * of[2]; }
    static glm::vec3 towards(glm::vec3 v, glm::vec3 side) { return (glm::dot(v, side) < 0 ? -1.0f : 1.0f) * v; }
    static glm::vec3 unit(glm::vec3 v, glm::vec3 otherwise) {
        const float length = glm::length(v);
        const bool has_one = length > 0 && length < std::numeric_limits<float>::infinity();
        return (has_one ? v : otherwise) / (has_one ? length : 1.0f);
    }

    umbrage::triangle_weights weights_;
    vertices positions_, normals_, colors_;
    glm::vec3 face_normal_, camera_;
    bool floor_;
};

[[nodiscard]] inline surface surface_at(const scene& s, const camera& c, const umbrage::image<std::uint32_t>& seen,
                                        glm::ivec2 texel) {
    return seen_triangle(s, c, seen.size(), seen[texel]).at(texel);
}

/// Calls use(first, last, triangle) for the runs of texels in row y that see the same triangle.
template <class Use>
void for_each_run(const umbrage::image<std::uint32_t>& seen, int y, Use&& use) {
    const std::uint32_t* const row = seen.view().row(y);
    for (int first = 0, last = 0; first < seen.size().x; first = last) {
        while (last < seen.size().x && row[last] == row[first]) ++last;
        if (row[first] != nothing) use(first, last, row[first]);
    }
}

}  // namespace example
