// SPDX-License-Identifier: MIT
//
// The depth pass on the CPU: triangles into a depth image, each sample on a shared edge covered exactly once.
//
//     umbrage::image<float> map({1024, 1024}, umbrage::cleared_depth(clip));
//     umbrage::rasterize_depth(map, {positions, triangles}, world_to_clip, clip);
//
// A camera pass keeps the nearest triangle of each texel and interpolates afterwards:
//
//     umbrage::rasterize(size, mesh, world_to_clip, clip, [&](glm::ivec2 texel, float z, unsigned triangle) {
//         if (z <= depth[texel]) depth[texel] = z, visible[texel] = triangle;
//     });
//     glm::vec3 weights = umbrage::barycentrics(size, mesh, world_to_clip, clip, texel, visible[texel]);
//
// Vertices are snapped to 1/256 texel, edges are evaluated in integers at texel centres, and ties go by the top-left
// rule (top and left as NDC has them, for either texture origin). Depth is a plane whose coefficients are rounded to a
// grid on which every sample is then computed exactly. So no order of triangles or vertices, no tiling, no instruction
// set and no contraction to FMA changes a bit; of clipped triangles the last may move a cut by 1/256 texel.
//
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/clip_space.hpp>
#include <umbrage/image.hpp>
#include <umbrage/image_ops/clip.hpp>
#include <umbrage/scalar.hpp>

namespace umbrage {

/// Triangles that somebody else owns: three indices into the positions each.
struct mesh_view {
    std::span<const glm::vec3> positions;
    std::span<const glm::uvec3> triangles;
};

/// Which faces to leave out. The front goes counter-clockwise in NDC, x to the right and y up.
enum class cull_mode { none, front, back };

/// Depth over a triangle, exact on its grid: z + dx * x + dy * y for texels x, y counted from `first`.
struct depth_plane {
    glm::ivec2 first;        ///< a texel within the triangle's bounds
    double z, dx, dy;        ///< multiples of one power of two, so that no sum of theirs within the bounds is rounded
    double lowest, highest;  ///< of the vertices; samples never leave it

    [[nodiscard]] double operator()(int x, int y) const {
        const double depth = z + dx * (x - first.x) + dy * (y - first.y);
        return depth > lowest ? (depth < highest ? depth : highest) : lowest;
    }
};

/// The plane through three vertices, anchored at the first, which must be the smallest of them.
///
/// @param area   twice the signed area in squares of the vertex grid, not 0
/// @exactness    B: the same bits with and without FMA. With n the bounds' larger side in 1/256 texel and m the sum of
///               the depth's and the two slopes' magnitudes over the bounds, a sample is within 2^-48 n m of the plane
///               through the snapped vertices
[[nodiscard]] inline depth_plane make_depth_plane(const std::array<snapped_vertex, 3>& v, double area,
                                                  glm::ivec2 first) {
    const auto magnitude = [](double a) { return a < 0.0 ? -a : a; };
    const auto largest = [](double a, double b) { return a < b ? b : a; };
    const auto round_down = [](double a) {  // to a power of two
        return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a) & 0x7FF0000000000000u);
    };
    const auto on_grid = [](double a, double unit) {
        return static_cast<double>(static_cast<std::int64_t>(a / unit)) * unit;
    };
    const double x1 = v[1].x - v[0].x, y1 = v[1].y - v[0].y, x2 = v[2].x - v[0].x, y2 = v[2].y - v[0].y;
    const double width = largest(magnitude(x1), largest(magnitude(x2), magnitude(x1 - x2)));
    const double height = largest(magnitude(y1), largest(magnitude(y2), magnitude(y1 - y2)));

    // Depths with so few digits that the products with x1 .. y2 and their differences need no rounding.
    constexpr double tiny = 0x1p-200;
    double unit = largest(tiny, largest(magnitude(v[0].depth), largest(magnitude(v[1].depth), magnitude(v[2].depth))));
    unit = round_down(unit) * round_down(largest(width, height)) * 0x1p-49;
    const double z0 = on_grid(v[0].depth, unit), z1 = on_grid(v[1].depth, unit), z2 = on_grid(v[2].depth, unit);
    const double slope_x = ((z1 - z0) * y2 + (z2 - z0) * -y1) / area;
    const double slope_y = ((z2 - z0) * x1 + (z1 - z0) * -x2) / area;

    // Slopes with so few digits that the same holds for every sample.
    const double reach = magnitude(z0) + magnitude(slope_x) * width + magnitude(slope_y) * height;
    unit = round_down(largest(tiny, reach)) * 0x1p-51;
    const double dx = on_grid(slope_x, unit), dy = on_grid(slope_y, unit);
    constexpr int centre = subtexels / 2;
    return {.first = first,
            .z = on_grid(z0, unit) + dx * (first.x * subtexels + centre - v[0].x) +
                 dy * (first.y * subtexels + centre - v[0].y),
            .dx = dx * subtexels,
            .dy = dy * subtexels,
            .lowest = z0 < z1 ? (z0 < z2 ? z0 : z2) : (z1 < z2 ? z1 : z2),
            .highest = largest(z0, largest(z1, z2))};
}

/// One triangle on the grid, row by row.
///
/// @param v     vertices within the guard band, the smallest first
/// @param size  of the image in texels
/// @param row   (int y, int x_first, int x_last, const depth_plane&): texels x_first <= x < x_last of row y are
///              covered; y counts from the bottom
/// @formula     covered: for each edge, E >= 0, or E > 0 where the edge is neither a top nor a left one
/// @exactness   A: 64-bit integers
template <class Row>
void rasterize_snapped(std::array<snapped_vertex, 3> v, glm::ivec2 size, cull_mode cull, Row&& row) {
    const auto area_of = [&] {
        return std::int64_t(v[1].x - v[0].x) * (v[2].y - v[0].y) - std::int64_t(v[2].x - v[0].x) * (v[1].y - v[0].y);
    };
    const std::int64_t area = area_of();
    if (area == 0 || cull == (area > 0 ? cull_mode::front : cull_mode::back)) return;
    if (area < 0) std::swap(v[1], v[2]);

    // texels whose centres are within the bounds
    constexpr int centre = subtexels / 2;
    const auto first_from = [](int low) { return low <= centre ? 0 : (low - centre + subtexels - 1) / subtexels; };
    const auto last_to = [](int high, int count) {
        return high < centre ? -1 : std::min((high - centre) / subtexels, count - 1);
    };
    const glm::ivec2 first{first_from(std::min({v[0].x, v[1].x, v[2].x})),
                           first_from(std::min({v[0].y, v[1].y, v[2].y}))};
    const glm::ivec2 last{last_to(std::max({v[0].x, v[1].x, v[2].x}), size.x),
                          last_to(std::max({v[0].y, v[1].y, v[2].y}), size.y)};
    if (first.x > last.x || first.y > last.y) return;

    struct edge {
        std::int64_t value, step_x, step_y;  // at the first texel of the row; per texel
    };
    std::array<edge, 3> edges;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& a = v[i];
        const auto& b = v[i < 2 ? i + 1 : 0];
        const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
        const bool top_left = dy < 0 || (dy == 0 && dx < 0);
        const int to_x = first.x * subtexels + centre - a.x, to_y = first.y * subtexels + centre - a.y;
        edges[i] = {dx * to_y - dy * to_x - (top_left ? 0 : 1), -dy * subtexels, dx * subtexels};
    }

    const auto plane = make_depth_plane(v, static_cast<double>(area_of()), first);
    for (int y = first.y; y <= last.y; ++y) {
        std::int64_t low = 0, high = last.x - first.x;  // steps from first.x for which no edge is negative
        for (auto& e : edges) {
            if (e.step_x > 0 && e.value < 0) low = std::max(low, (-e.value + e.step_x - 1) / e.step_x);
            if (e.step_x < 0) high = e.value < 0 ? -1 : std::min(high, e.value / -e.step_x);
            if (e.step_x == 0 && e.value < 0) high = -1;
            e.value += e.step_y;
        }
        if (low <= high) row(y, first.x + int(low), first.x + int(high) + 1, plane);
    }
}

/// All triangles of a mesh, row by row; what rasterize and rasterize_depth share.
///
/// @param row   (int y, int x_first, int x_last, const depth_plane&, unsigned triangle), y counting from the bottom
/// @throws std::invalid_argument  an index is out of range; a side of the image is above guard_band
template <class Row>
void rasterize_rows(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip,
                    cull_mode cull, Row&& row) {
    for (const auto& t : mesh.triangles)
        if (t.x >= mesh.positions.size() || t.y >= mesh.positions.size() || t.z >= mesh.positions.size())
            throw std::invalid_argument("umbrage::rasterize: a triangle's index is out of range");
    const projection project(world_to_clip, clip, size);
    if (size.x == 0 || size.y == 0 || mesh.triangles.empty() || !is_finite(world_to_clip)) return;

    constexpr unsigned nowhere = 1u << projection::planes;
    struct vertex {
        snapped_vertex snapped;
        unsigned outside;
    };
    std::vector<vertex> vertices;
    vertices.reserve(mesh.positions.size());
    for (const auto& p : mesh.positions) {
        const auto h = is_finite(p) ? project.homogeneous(p) : glm::dvec4(0.0);
        const unsigned outside = is_finite(p) ? project.outside(h) : nowhere;
        vertices.push_back({outside ? snapped_vertex{0, 0, 0.0} : project.snap(h), outside});
    }

    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        const vertex &a = vertices[t.x], &b = vertices[t.y], &c = vertices[t.z];
        const unsigned crossed = a.outside | b.outside | c.outside;
        if ((a.outside & b.outside & c.outside) || (crossed & nowhere)) continue;
        const auto emit = [&](const snapped_vertex& p, const snapped_vertex& q, const snapped_vertex& r) {
            rasterize_snapped({p, q, r}, size, cull, [&](int y, int x_first, int x_last, const depth_plane& plane) {
                row(y, x_first, x_last, plane, static_cast<unsigned>(i));
            });
        };
        if (crossed) {
            const auto at = [&](unsigned index) { return project.homogeneous(mesh.positions[index]); };
            const auto polygon = clip_triangle(project, at(t.x), at(t.y), at(t.z), crossed);
            for (std::size_t k = 1; int(k) + 1 < polygon.count; ++k)
                emit(polygon.vertices[0], polygon.vertices[k], polygon.vertices[k + 1]);
        } else if (a.snapped < b.snapped && a.snapped < c.snapped) {
            emit(a.snapped, b.snapped, c.snapped);
        } else if (b.snapped < c.snapped) {
            emit(b.snapped, c.snapped, a.snapped);
        } else {
            emit(c.snapped, a.snapped, b.snapped);
        }
    }
}

/// Renders triangles into a depth image that holds the cleared depth or an earlier pass.
///
/// @param depth          greatest side 16384; row 0 is where clip.origin says; empty: nothing happens
/// @param mesh           triangles with a NaN or infinite position are left out, as all are if the matrix has one;
///                       those of no area on the 1/256 texel grid cover nothing
/// @param world_to_clip  projection * view
/// @param clip           reversed: greater depths win
/// @param cull           which faces to leave out
/// @throws std::invalid_argument  an index is out of range; a side of the image is above 16384
/// @formula     the nearer of what is there and the plane's depth, ties to the newcomer (the same bits); nothing beyond
///              the far plane; never -0
/// @exactness   coverage A from the snapped vertices on; depth B, see depth_plane
inline void rasterize_depth(image_view<float> depth, const mesh_view& mesh, const glm::mat4& world_to_clip,
                            clip_space clip, cull_mode cull = cull_mode::none) {
    const bool flipped = clip.origin == texture_origin::top, forward = clip.direction == depth_direction::forward;
    rasterize_rows(depth.size, mesh, world_to_clip, clip, cull,
                   [&](int y, int x_first, int x_last, const depth_plane& plane, unsigned) {
        float* texels = depth.row(flipped ? depth.size.y - 1 - y : y);
        for (int x = x_first; x < x_last; ++x) {
            const double z = plane(x, y);
            if (!(z >= 0.0 && z <= 1.0)) continue;
            const float stored = z > 0.0 ? static_cast<float>(z) : 0.0f;
            if (forward ? stored <= texels[x] : stored >= texels[x]) texels[x] = stored;
        }
    });
}

/// The general form: one call for each covered sample between the near and the far plane, triangle by triangle.
///
/// @param size    of the image in texels, each at most 16384
/// @param sample  (glm::ivec2 texel, float depth, unsigned triangle); does the depth test. Where depths tie, a callee
///                that wants results free of the triangles' order compares the triangles too
/// The rest as for rasterize_depth.
template <class Sample>
void rasterize(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip, Sample&& sample,
               cull_mode cull = cull_mode::none) {
    const bool flipped = clip.origin == texture_origin::top;
    rasterize_rows(size, mesh, world_to_clip, clip, cull,
                   [&](int y, int x_first, int x_last, const depth_plane& plane, unsigned triangle) {
        for (int x = x_first; x < x_last; ++x)
            if (const double z = plane(x, y); z >= 0.0 && z <= 1.0)
                sample(glm::ivec2(x, flipped ? size.y - 1 - y : y), z > 0.0 ? static_cast<float>(z) : 0.0f, triangle);
    });
}

/// Perspective-correct weights of a triangle's vertices at the centre of a texel.
///
/// @param triangle  index into mesh.triangles; its vertices may be behind the camera
/// @return      weights that are not negative and sum to 1: a texel that snapping moved out of the triangle gets the
///              weights of the nearest edge; (1, 0, 0) for a triangle seen edge-on or not finite
/// @formula     b_i ~ (x_j - X w_j)(y_k - Y w_k) - (y_j - Y w_j)(x_k - X w_k), homogeneous texels; no division by w
/// @cite        Olano, Greer: Triangle Scan Conversion using 2D Homogeneous Coordinates, Graphics Hardware 1997
[[nodiscard]] inline glm::vec3 barycentrics(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip,
                                            clip_space clip, glm::ivec2 texel, unsigned triangle) {
    assert(triangle < mesh.triangles.size());
    const projection project(world_to_clip, clip, size);
    const double centre_x = texel.x + 0.5;
    const double centre_y = clip.origin == texture_origin::top ? size.y - texel.y - 0.5 : texel.y + 0.5;
    std::array<glm::dvec2, 3> from;  // the centre to each vertex, times w
    for (int i = 0; i < 3; ++i) {
        const auto h = project.homogeneous(mesh.positions[mesh.triangles[triangle][i]]);
        from[std::size_t(i)] = {h.x - centre_x * h.w, h.y - centre_y * h.w};
    }
    const auto cross = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
    std::array<double, 3> weights{cross(from[1], from[2]), cross(from[2], from[0]), cross(from[0], from[1])};
    const double signed_sum = weights[0] + weights[1] + weights[2];
    double sum = 0.0;
    for (auto& w : weights) {
        if (signed_sum < 0.0) w = -w;
        sum += w = w > 0.0 ? w : 0.0;
    }
    if (!is_finite(signed_sum) || sum == 0.0) return {1.0f, 0.0f, 0.0f};
    return {weights[0] / sum, weights[1] / sum, weights[2] / sum};
}

}  // namespace umbrage
