// SPDX-License-Identifier: MIT
//
// The rasterizer's steps: vertices to their grid, coverage by its definition in integers, depths into an image.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <umbrage/core/compare.hpp>
#include <umbrage/draw/rasterize.hpp>

#include "images.hpp"

namespace hostile {

struct raster_suite : image_suite {
    /// Positions to the grid of vertices, inside and outside of the planes.
    void snapping() const {
        const auto positions = images<glm::vec3>(sizes, [](source& s, std::size_t) {
            glm::vec3 p;
            for (int k = 0; k < 3; ++k)
                p[k] = s.one_in(8) ? s.any() : float(int(s.below(1 << 20)) - (1 << 19)) * 0x1p-18f;
            return p;
        });
        source from{what, flush};
        glm::mat4 matrix;
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = float(int(from.below(1 << 24)) - (1 << 23)) * 0x1p-23f;
        matrix[3][3] = 1.5f;
        const auto project_for = [&](int s) {
            const auto range = s % 2 ? depth_range::minus_one_to_one : depth_range::zero_to_one;
            const auto direction = s < 3 ? depth_direction::forward : depth_direction::reversed;
            return detail::projection(matrix, {.range = range, .direction = direction}, {1000 + s, 600 - s});
        };
        const auto words = [](const detail::snapped_vertex& v) {
            const auto depth = umbrage::detail::bit_cast<std::uint64_t>(v.depth);
            return glm::uvec4(std::uint32_t(v.x), std::uint32_t(v.y), std::uint32_t(depth), std::uint32_t(depth >> 32));
        };
        run<glm::uvec4>(
            "snap",
            [&](int s, glm::ivec2 t) {
                const detail::projection project = project_for(s);
                const glm::dvec4 h = project.homogeneous(positions[std::size_t(s)][t]);
                const unsigned planes = project.outside(h);
                return words(planes ? detail::outside_vertex(planes) : project.snap(h));
            },
            [&](int s, image_view<glm::uvec4> out, pieces) {
                const auto all = positions[std::size_t(s)].texels();
                for (std::size_t first = 0; first < all.size(); first += detail::block) {
                    glm::vec3 some[detail::block]{};
                    detail::snapped_vertex vertices[detail::block];
                    const std::size_t count = std::min(all.size() - first, std::size_t(detail::block));
                    std::copy_n(all.begin() + std::ptrdiff_t(first), count, some);
                    project_for(s).snap(some, vertices);
                    for (std::size_t i = 0; i < count; ++i) {
                        const int texel = int(first + i);
                        out[{texel % out.size.x, texel / out.size.x}] = words(vertices[i]);
                    }
                }
            },
            agree::in_a_mode);
    }

    /// Triangles whose corners are on the grid of vertices, over the image and its surroundings.
    void coverage() const {
        source from{what, flush};
        std::vector<glm::vec3> positions;
        std::vector<glm::uvec3> triangles;
        const auto coordinate = [&] { return float(int(from.below(1024)) - 512) / 256.0f; };
        for (unsigned i = 0; i < 40; ++i) {
            for (int corner = 0; corner < 3; ++corner) {
                const float x = coordinate();
                positions.emplace_back(x, coordinate(), 0.5f);
            }
            triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
        }
        const auto covered = [&](glm::ivec2 size) {
            image<std::uint32_t> ids(size);
            rasterize(size, {positions, triangles}, glm::mat4(1.0f), cpu_clip_space,
                      [&](glm::ivec2 t, float, unsigned id) { ids[t] += 1u + id * id; });
            return ids;
        };
        // by the definition: on the inner side of each edge, or on a top or a left edge, all in integers
        const auto inside = [&](glm::ivec2 size, glm::ivec2 t, unsigned id) {
            std::array<glm::ivec2, 3> v;
            for (int k = 0; k < 3; ++k) {
                const glm::vec3 p = positions[triangles[id][k]];
                const glm::ivec2 steps(int(p.x * 256.0f), int(p.y * 256.0f));
                // (p / 256 + 1) / 2 * size * 256, halves upwards
                for (int c = 0; c < 2; ++c) v[std::size_t(k)][c] = ((steps[c] + 256) * size[c] + 1) >> 1;
            }
            const auto cross = [](glm::ivec2 a, glm::ivec2 b) {
                return std::int64_t(a.x) * b.y - std::int64_t(a.y) * b.x;
            };
            const std::int64_t area = cross(v[1] - v[0], v[2] - v[0]);
            if (area == 0) return false;
            if (area < 0) std::swap(v[1], v[2]);
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::ivec2 a = v[k], edge = v[(k + 1) % 3] - a;
                const std::int64_t side = cross(edge, t * 256 + 128 - a);
                if (side < 0 || (side == 0 && !(edge.y < 0 || (edge.y == 0 && edge.x < 0)))) return false;
            }
            return true;
        };
        run<std::uint32_t>(
            "rasterize_coverage",
            [&](int s, glm::ivec2 t) {
                std::uint32_t ids = 0;
                for (unsigned id = 0; id < triangles.size(); ++id)
                    if (inside(sizes[s], t, id)) ids += 1u + id * id;
                return ids;
            },
            [&](int s, image_view<std::uint32_t> out, pieces) {
                const auto ids = covered(sizes[s]);
                copy(ids, out);
            });
    }

    /// Triangles in perspective, none of them clipped, into an image that already holds any bits.
    void depth_pass() const {
        source from{what, flush};
        std::vector<glm::vec3> positions;
        std::vector<glm::uvec3> triangles;
        const auto within = [&](int low, int high) { return low + int(from.below(unsigned(high - low + 1))); };
        for (unsigned i = 0; i < 200; ++i) {
            const int x = within(-110, 110), y = within(-110, 110);
            for (int corner = 0; corner < 3; ++corner) {
                glm::vec3 p;
                p.x = float(x + within(-20, 20)) / 64.0f;
                p.y = float(y + within(-20, 20)) / 64.0f;
                p.z = float(within(90, 150)) / 64.0f;
                positions.push_back(p);
            }
            triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
        }
        glm::mat4 matrix(0.0f);
        matrix[0][0] = matrix[1][1] = matrix[2][3] = 1.0f;
        const glm::vec4 depth_row = glm::vec4(123.0f, -77.0f, 1999.0f, 1000.0f) / 4096.0f;
        for (int i = 0; i < 4; ++i) matrix[i][2] = depth_row[i];
        const auto before = images<float>(sizes, [](source& s, std::size_t) { return s.one_in(2) ? 1.0f : s.any(); });
        std::vector<image<float>> expected = before;
        detail::isa_in_use = isa::base;
        for (auto& depth : expected)
            rasterize(depth.size(), {positions, triangles}, matrix, cpu_clip_space,
                      [&](glm::ivec2 t, float z, unsigned) {
                          if (less_equal{}(z, depth[t])) depth[t] = z;
                      });
        run<float>(
            "rasterize_depth", [&](int s, glm::ivec2 t) { return expected[std::size_t(s)][t]; },
            [&](int s, image_view<float> out, pieces parallel) {
                copy(before[std::size_t(s)], out);
                rasterize_depth(out, {positions, triangles}, matrix, cpu_clip_space, cull_mode::none, parallel);
            },
            agree::in_a_mode);
    }
};

}  // namespace hostile
