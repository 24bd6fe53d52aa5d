// SPDX-License-Identifier: MIT
//
// A near plane that clamps: what lies before it is drawn with its depth, and what lies behind it as ever, to the bit.
#include <umbrage/draw/rasterize.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "../../light/clip_spaces.hpp"
#include "scene.hpp"

using namespace raster_scene;

namespace {

image<float> clamped_render(glm::ivec2 size, const mesh_view& m, const glm::mat4& matrix,
                            clip_space clip = cpu_clip_space) {
    image<float> depth(size, cleared_depth(clip));
    rasterize_depth(depth, m, matrix, clip, cull_mode::none, serial{}, near_plane::clamps);
    return depth;
}

/// 0 to 1 from near to far into a convention's z/w.
glm::mat4 in_convention(clip_space clip, const glm::mat4& zero_to_one) {
    glm::mat4 out = zero_to_one;
    for (glm::length_t c = 0; c < 4; ++c) {
        float z = zero_to_one[c][2];
        const float w = zero_to_one[c][3];
        if (clip.direction == depth_direction::reversed) z = w - z;
        out[c][2] = clip.range == depth_range::zero_to_one ? z : 2.0f * z - w;
    }
    return out;
}

/// Texels between a sample and the line through a triangle's nearest edge, seen without a near plane.
double from_edges(glm::ivec2 size, const mesh& m, const glm::mat4& matrix, glm::ivec2 texel) {
    double nearest = 1e9;
    for (glm::length_t k = 0; k < 3; ++k) {
        const auto at = [&](glm::length_t i) {
            const glm::dvec4 h = glm::dmat4(matrix) * glm::dvec4(m.positions[m.triangles[0][i % 3]], 1);
            return glm::dvec3((h.x + h.w) * size.x / 2, (h.y + h.w) * size.y / 2, h.w);
        };
        const glm::dvec3 line = glm::cross(at(k), at(k + 1));
        const glm::dvec3 p(texel.x + 0.5, texel.y + 0.5, 1);
        nearest = std::min(nearest, std::abs(glm::dot(line, p)) / glm::length(glm::dvec2(line)));
    }
    return nearest;
}

}  // namespace

TEST_CASE("near_plane::clamps: a slope that begins before the near plane, by hand, in every convention") {
    mesh slope;  // depth -1 on the left, 1 on the right
    slope.positions = {{-1, -1, -1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, -1}};
    slope.triangles = {{0, 1, 2}, {0, 2, 3}};
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const glm::mat4 matrix = in_convention(clip, glm::mat4(1.0f));
        const auto clips = render({64, 8}, slope, matrix, clip), clamps = clamped_render({64, 8}, slope, matrix, clip);
        const bool forward = clip.direction == depth_direction::forward;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 64; ++x) {
                const float share = (static_cast<float>(x) + 0.5f) / 32.0f - 1.0f;
                const float expected = forward ? std::max(share, 0.0f) : std::min(1.0f - share, 1.0f);
                CHECK(std::abs(clamps[{x, y}] - expected) < 1e-6f);
                if (x < 32) CHECK(clips[{x, y}] == cleared_depth(clip));
                else CHECK(clips[{x, y}] == clamps[{x, y}]);
            }
    }
}

TEST_CASE("near_plane::clamps: of any triangle the part behind the plane keeps its bits, the rest is at the plane") {
    generator random;
    const glm::ivec2 size(48, 40);
    int flat = 0, kept = 0, astray = 0, unlike = 0;
    for (int round = 0; round < 400; ++round) {
        mesh m;
        for (int k = 0; k < 3; ++k)
            m.positions.emplace_back(random.real(-2, 2), random.real(-2, 2), random.real(-0.7f, 0.05f));
        m.triangles = {{0, 1, 2}};
        const clip_space clip = all_clip_spaces()[std::size_t(round % 16)];
        const glm::mat4 plain = raster_scene::perspective(), matrix = in_convention(clip, plain);
        const float near_depth = 1.0f - cleared_depth(clip);
        // the plane at 1/4 moved to 1/1000 clips next to nothing: what the triangle covers
        glm::mat4 close = plain;
        close[2][2] = -8.0f / 7.999f, close[3][2] = -0.008f / 7.999f;
        const auto whole = render(size, m, in_convention(clip, close), clip);
        const auto clips = render(size, m, matrix, clip), clamps = clamped_render(size, m, matrix, clip);
        image<int> count(size);
        rasterize(
            size, m, matrix, clip, [&](glm::ivec2 t, float, unsigned) { ++count[t]; }, cull_mode::none,
            near_plane::clamps);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec2 texel(x, y);
                const bool is_covered = clamps[texel] != cleared_depth(clip);
                if (clips[texel] != cleared_depth(clip)) unlike += clamps[texel] != clips[texel], ++kept;
                else if (is_covered) unlike += clamps[texel] != near_depth, ++flat;
                unlike += count[texel] != (is_covered ? 1 : 0);
                const glm::ivec2 up(x, clip.origin == texture_origin::top ? size.y - 1 - y : y);
                if (is_covered != (whole[texel] != cleared_depth(clip)))
                    astray += from_edges(size, m, plain, up) > 1.0 / 64;
            }
    }
    CHECK(unlike == 0);
    CHECK(astray == 0);
    CHECK(flat > 10000);
    CHECK(kept > 10000);
}

TEST_CASE("near_plane::clamps: triangles that share edges through the plane cover each sample once") {
    generator random;
    const glm::ivec2 size(64, 48);
    for (int round = 0; round < 60; ++round) {
        mesh m;  // a fan around a corner in sight, each of its corners before the plane or behind it
        m.positions = {{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)}};
        for (auto [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            m.positions.emplace_back(float(x) * 3, float(y) * 3, random.real(-1, 1));
        m.triangles = {{0, 1, 2}, {2, 0, 3}, {4, 3, 0}, {0, 4, 1}};
        image<int> count(size);
        rasterize(
            size, m, glm::mat4(1.0f), cpu_clip_space, [&](glm::ivec2 t, float, unsigned) { ++count[t]; },
            cull_mode::none, near_plane::clamps);
        CHECK(std::all_of(count.texels().begin(), count.texels().end(), [](int n) { return n == 1; }));
    }
}

TEST_CASE(
    "near_plane::clamps: triangles in bands and in any order give the same bits, as does a plane that cuts none") {
    generator random;
    const glm::ivec2 size(96, 130);
    mesh m = soup(random, 4000);
    const auto plain = clamped_render(size, m, raster_scene::perspective());
    CHECK_FALSE(same_bits(plain, render(size, m, raster_scene::perspective())));
    const auto backwards = [](int count, const auto& work) {
        for (int i = count; i-- > 0;) work(i, i + 1);
    };
    std::reverse(m.triangles.begin(), m.triangles.end());
    image<float> banded(size, 1.0f);
    rasterize_depth(banded, m, raster_scene::perspective(), cpu_clip_space, cull_mode::none, backwards,
                    near_plane::clamps);
    CHECK(same_bits(plain, banded));

    for (glm::vec3& p : m.positions) p.z = std::min(p.z, -0.25f);
    CHECK(
        same_bits(clamped_render(size, m, raster_scene::perspective()), render(size, m, raster_scene::perspective())));
}
