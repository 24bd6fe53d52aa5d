// SPDX-License-Identifier: MIT
//
// Barycentric weights of texels on a triangle, to interpolate attributes after a camera pass.
//
//     glm::vec3 weights = umbrage::barycentrics(size, mesh, world_to_clip, clip, texel, triangle);
//
// For many texels of one triangle, this computes their common values only once:
//
//     const umbrage::triangle_weights weights(size, mesh, world_to_clip, clip, triangle);
//     for (int x = first; x < last; ++x) use(weights({x, y}));
//
#pragma once

#include <array>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/draw/mesh.hpp>
#include <umbrage/draw/raster/projection.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage {

/// Perspective-correct weights of a triangle's vertices at texel centers.
class triangle_weights {
public:
    /// @param size            size of the image, in texels
    /// @param mesh            triangles, world units
    /// @param world_to_clip   projection * view
    /// @param clip            clip space that the matrix leads to
    /// @param triangle        index into mesh.triangles; its vertices may be behind the camera
    /// @throws std::invalid_argument  clip unset; triangle or an index of its out of range; a side of the image above
    ///                                16384
    triangle_weights(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip,
                     unsigned triangle)
        : triangle_weights("triangle_weights", size, mesh, world_to_clip, clip, triangle) {}

    /// Weights at the center of a texel.
    /// @return      weights that are not negative and sum to 1
    /// @edge        texel that snapping moved out of the triangle: the weights of the nearest edge. Triangle seen
    ///              edge-on or not finite: (1, 0, 0)
    /// @formula     b_i ~ (x_j - X w_j)(y_k - Y w_k) - (y_j - Y w_j)(x_k - X w_k), homogeneous texels; no division by w
    /// @cite        Olano, Greer: Triangle Scan Conversion using 2D Homogeneous Coordinates, Graphics Hardware 1997
    [[nodiscard]] UMBRAGE_INLINE glm::vec3 operator()(glm::ivec2 texel) const {
        const double x = texel.x + 0.5, y = top_ + down_ * (texel.y + 0.5);
        const glm::dvec4 &p = vertices_[0], &q = vertices_[1], &r = vertices_[2];
        const double px = p.x - x * p.w, qx = q.x - x * q.w,
                     rx = r.x - x * r.w;  // from the center to each vertex, times w
        const double py = p.y - y * p.w, qy = q.y - y * q.w, ry = r.y - y * r.w;
        const double a = qx * ry - qy * rx, b = rx * py - ry * px, c = px * qy - py * qx, sum = a + b + c;
        const double side = sum < 0.0 ? -1.0 : 1.0;
        const auto inside = [&](double weight) UMBRAGE_INLINE { return side * weight > 0.0 ? side * weight : 0.0; };
        const double total = inside(a) + inside(b) + inside(c);
        const double over = total > 0.0 ? total : 1.0, first = total > 0.0 ? inside(a) : 1.0;
        return {static_cast<float>(first / over), static_cast<float>(inside(b) / over),
                static_cast<float>(inside(c) / over)};
    }

private:
    triangle_weights(const char* function, glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip,
                     clip_space clip, unsigned triangle)
        : top_(clip.origin == texture_origin::top ? size.y : 0),
          down_(clip.origin == texture_origin::top ? -1.0 : 1.0) {
        const detail::projection project(glm::dmat4(world_to_clip), clip, size, function);
        detail::require(triangle < mesh.triangles.size(), function, "triangle", "an index of mesh.triangles", triangle);
        const glm::uvec3 t = mesh.triangles[triangle];
        detail::require((glm::max)((glm::max)(t.x, t.y), t.z) < mesh.positions.size(), function, "mesh.triangles",
                        "indices of positions", t);
        for (glm::length_t i = 0; i < 3; ++i)
            vertices_[static_cast<std::size_t>(i)] = project.homogeneous(mesh.positions[t[i]]);
        bool finite = true;
        for (const glm::dvec4& v : vertices_) finite = finite && is_finite(v.x) && is_finite(v.y) && is_finite(v.w);
        if (!finite) vertices_ = {};
    }
    friend glm::vec3 barycentrics(glm::ivec2, const mesh_view&, const glm::mat4&, clip_space, glm::ivec2, unsigned);

    double top_, down_;
    std::array<glm::dvec4, 3> vertices_;
};

/// Weights of triangle_weights for a single texel.
/// @throws std::invalid_argument  as triangle_weights
[[nodiscard]] inline glm::vec3 barycentrics(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip,
                                            clip_space clip, glm::ivec2 texel, unsigned triangle) {
    return triangle_weights("barycentrics", size, mesh, world_to_clip, clip, triangle)(texel);
}

}  // namespace umbrage
UMBRAGE_END_STRICT_MATH
