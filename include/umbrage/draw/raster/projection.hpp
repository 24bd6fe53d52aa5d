// SPDX-License-Identifier: MIT
//
// Projection of world positions to vertices snapped to the 1/256 texel grid, one at a time or in blocks.
//
//     projection project(world_to_clip, clip, {1024, 1024});
//     snapped_vertex vertex = project.snap(project.homogeneous(position));
//
// Texels are counted from the bottom here (NDC y = -1) for every clip space. The texture origin only mirrors rows when
// texels are written, so both origins give the same picture.
//
#pragma once

#include <compare>
#include <cstdint>
#include <limits>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Steps of the vertex grid per texel.
inline constexpr int subtexels = 256;

/// Largest side of an image in texels, and largest distance of a vertex from texel 0 before it is clipped. Differences
/// of vertices then stay below 2^23 steps, edge functions below 2^47.
inline constexpr int guard_band = 1 << 14;

/// Vertex on the grid. Its order makes results independent of the order in which a mesh lists vertices.
struct snapped_vertex {
    std::int32_t x, y;  ///< in 1/256 texel, within +-guard_band
    double depth;       ///< z/w moved to [0, 1]. Only points beyond the far plane are outside

    friend auto operator<=>(const snapped_vertex&, const snapped_vertex&) = default;
};

/// Checks the size of an image and its clip space.
/// @throws std::invalid_argument  clip unset; a side negative or above guard_band
inline void require_drawable(glm::ivec2 size, clip_space clip, const char* function) {
    require_given(clip, function);
    require(size.x >= 0 && size.y >= 0 && size.x <= guard_band && size.y <= guard_band, function, "size",
            "from 0 to 16384 texels a side", size);
}

/// Placeholder for a vertex outside of some planes. It lies off the grid, and holds the bits of those planes.
[[nodiscard]] inline snapped_vertex outside_vertex(unsigned planes) {
    return {std::numeric_limits<std::int32_t>::lowest(), static_cast<std::int32_t>(planes), 0.0};
}

/// Bits of the planes that a vertex is outside of.
[[nodiscard]] inline unsigned planes_outside(const snapped_vertex& v) {
    return v.x == std::numeric_limits<std::int32_t>::lowest() ? static_cast<unsigned>(v.y) : 0u;
}

/// Projection to homogeneous texels (x/w and y/w in texels, z/w the depth in [0, 1]), and from there to the grid.
/// Products of a float matrix' elements are exact in double, so contraction to FMA changes no bit of it.
class projection {
public:
    static constexpr int planes = 6, z_near = 1;       ///< w > 0, the near plane, four sides of the guard band
    static constexpr unsigned nowhere = 1u << planes;  ///< stands for a position that is not finite

    /// @param world_to_clip  projection * view; its elements must be finite
    /// @throws std::invalid_argument  as require_drawable
    projection(const glm::dmat4& world_to_clip, clip_space clip, glm::ivec2 size, const char* function = "rasterize")
        : matrix_(world_to_clip), clip_(clip), half_size_(glm::dvec2(size) * 0.5) {
        require_drawable(size, clip, function);
    }

    [[nodiscard]] glm::dvec4 homogeneous(glm::vec3 p) const {
        const double x = row(0, p), y = row(1, p), z = row(2, p), w = row(3, p);
        return {(x + w) * half_size_.x, (y + w) * half_size_.y,
                clip_.range == depth_range::minus_one_to_one ? (z + w) * 0.5 : z, w};
    }

    /// Distance of a point from a plane: positive inside, negative outside.
    [[nodiscard]] double distance(int plane, const glm::dvec4& h) const {
        switch (plane) {
            case 0: return h.w - smallest_w;
            case 1: return clip_.direction == depth_direction::forward ? h.z : h.w - h.z;
            case 2: return guard_band * h.w + h.x;
            case 3: return guard_band * h.w - h.x;
            case 4: return guard_band * h.w + h.y;
            default: return guard_band * h.w - h.y;
        }
    }

    /// Bits of the planes that the point is outside of.
    [[nodiscard]] unsigned outside(const glm::dvec4& h) const {
        unsigned bits = 0;
        for (int plane = 0; plane < planes; ++plane) bits |= (distance(plane, h) < 0.0 ? 1u : 0u) << plane;
        return bits;
    }

    /// Intersection of a plane with the line from a point inside to one outside. Callers always use this direction, so
    /// triangles on both sides of an edge cut it at the same point.
    [[nodiscard]] glm::dvec4 cut(int plane, const glm::dvec4& in, const glm::dvec4& out) const {
        const double d = distance(plane, in);
        glm::dvec4 h = in + (out - in) * (d / (d - distance(plane, out)));
        if (!(h.w > smallest_w)) h.w = smallest_w;  // rounding
        switch (plane) {                            // points on the plane are exactly on it
            case 0: h.w = smallest_w; break;
            case 1: h.z = clip_.direction == depth_direction::forward ? 0.0 : h.w; break;
            case 2: h.x = -guard_band * h.w; break;
            case 3: h.x = guard_band * h.w; break;
            case 4: h.y = -guard_band * h.w; break;
            default: h.y = guard_band * h.w; break;
        }
        return h;
    }

    /// Nearest point of the grid, halves upwards. The point must be inside all planes: clamps only catch cut()'s
    /// rounding.
    [[nodiscard]] snapped_vertex snap(const glm::dvec4& h) const {
        constexpr double limit = double(guard_band) * subtexels;
        const auto grid = [&](double v) {
            const double steps = v / h.w * subtexels + 0.5;
            const double inside = steps > -limit ? (steps < limit ? steps : limit) : -limit;
            const auto whole = static_cast<std::int32_t>(inside);
            return whole - (inside < whole ? 1 : 0);
        };
        const double depth = h.z / h.w;
        if (clip_.direction == depth_direction::forward) return {grid(h.x), grid(h.y), depth > 0.0 ? depth : 0.0};
        return {grid(h.x), grid(h.y), depth < 1.0 ? depth : 1.0};
    }

    /// Snaps 64 positions at once, as homogeneous() and snap() do. Positions outside of planes, or not finite, become
    /// `outside_vertex`.
    /// @exactness  the bits of one by one
    template <class = on_use>
    void snap(const glm::vec3 (&positions)[block], snapped_vertex* vertices) const {
        using bits = std::int64_t;
        constexpr bits minus_zero = std::numeric_limits<bits>::lowest();
        const bool forward = clip_.direction == depth_direction::forward;
        const double z_share = clip_.range == depth_range::minus_one_to_one ? 0.5 : 1.0, w_share = 1.0 - z_share;
        const double near_z = forward ? 1.0 : -1.0, near_w = forward ? 0.0 : 1.0;
        const bits lowest = forward ? 0 : minus_zero;
        const bits highest = forward ? detail::highest<bits> : bit_cast<bits>(1.0);
        on_best_isa_without_fma([&](auto) UMBRAGE_INLINE {
            alignas(64) float x[block], y[block], z[block];
            alignas(64) double column[block], row[block], depth[block];
            alignas(64) bits outside[block];
            alignas(64) std::int32_t finite[block];  // masks
            for (int i = 0; i < block; ++i) x[i] = positions[i].x, y[i] = positions[i].y, z[i] = positions[i].z;
            for (int i = 0; i < block; ++i) {
                finite[i] = finite_mask(x[i]) & finite_mask(y[i]) & finite_mask(z[i]);
                x[i] = masked(x[i], finite[i]), y[i] = masked(y[i], finite[i]), z[i] = masked(z[i], finite[i]);
            }
            const glm::dmat4 m = matrix_;
            const glm::dvec2 half_size = half_size_;
            for (int i = 0; i < block; ++i) {
                const auto clip_row = [&](glm::length_t r) UMBRAGE_INLINE {
                    return m[0][r] * double(x[i]) + m[1][r] * double(y[i]) + m[2][r] * double(z[i]) + m[3][r];
                };
                const double w = clip_row(3), band = guard_band * w;
                const double hx = (clip_row(0) + w) * half_size.x, hy = (clip_row(1) + w) * half_size.y;
                const double hz = z_share * clip_row(2) + w_share * w;
                const auto bit = [](double distance, int plane) UMBRAGE_INLINE {
                    const bits d = bit_cast<bits>(distance);
                    return bits((d < 0) & (d != minus_zero)) << plane;
                };
                outside[i] = bit(w - smallest_w, 0) | bit(near_z * hz + near_w * w, 1) | bit(band + hx, 2) |
                             bit(band - hx, 3) | bit(band + hy, 4) | bit(band - hy, 5) |
                             (~bits(finite[i]) & bits(nowhere));
                const bits inside = -bits(outside[i] == 0);
                column[i] = bit_cast<double>(bit_cast<bits>(hx / w * subtexels + 0.5) & inside);
                row[i] = bit_cast<double>(bit_cast<bits>(hy / w * subtexels + 0.5) & inside);
                bits d = bit_cast<bits>(hz / w);
                d = d < lowest ? lowest : d;
                d = d > highest ? highest : d;
                depth[i] = bit_cast<double>(d & inside);
            }
            alignas(64) std::int32_t columns[block], rows[block];
            const auto floors = [](const double* from, std::int32_t* to) UMBRAGE_INLINE {
                for (int i = 0; i < block; ++i) {
                    const auto whole = static_cast<std::int32_t>(from[i]);
                    to[i] = whole - std::int32_t(from[i] < whole);
                }
            };
            floors(column, columns);
            floors(row, rows);
            for (int i = 0; i < block; ++i) vertices[i] = {columns[i], rows[i], depth[i]};
            for (int i = 0; i < block; ++i)
                if (outside[i]) vertices[i] = outside_vertex(static_cast<unsigned>(outside[i]));
        });
    }

private:
    static constexpr double smallest_w = 0x1p-126;

    [[nodiscard]] double row(glm::length_t r, glm::vec3 p) const {
        return matrix_[0][r] * double(p.x) + matrix_[1][r] * double(p.y) + matrix_[2][r] * double(p.z) + matrix_[3][r];
    }

    glm::dmat4 matrix_;
    clip_space clip_;
    glm::dvec2 half_size_;
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
