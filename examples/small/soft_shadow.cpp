// SPDX-License-Identifier: MIT
//
// A fence against a low sun: its shadow is sharp at the boards' feet and softer towards their tops (PCSS).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "picture.hpp"

int main() {
    // Boards in the plane z = 0, as (left, bottom, right, top), and the floor that they stand on.
    std::vector<glm::vec4> boards{{-2.6f, 0.35f, 2.6f, 0.45f}, {-2.6f, 0.95f, 2.6f, 1.05f}};
    for (float x = -2.5f; x < 2.6f; x += 0.5f) boards.emplace_back(x - 0.1f, 0.0f, x + 0.1f, 1.4f);
    std::vector<glm::vec3> vertices{{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}};
    std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};
    for (const glm::vec4 b : boards) {
        const auto k = unsigned(vertices.size());
        vertices.insert(vertices.end(), {{b.x, b.y, 0}, {b.z, b.y, 0}, {b.z, b.w, 0}, {b.x, b.w, 0}});
        triangles.insert(triangles.end(), {{k, k + 1, k + 2}, {k, k + 2, k + 3}});
    }

    // The light is as wide as 1 unit at a distance of 10; its penumbras are that wide in texels.
    const auto light = umbrage::make_directional_light({.direction = {0.15f, -0.5f, 1},
                                                        .target = {0, 0, 1},
                                                        .offset = 30,
                                                        .map_size = {1024, 1024},
                                                        .texels_per_unit = 128,
                                                        .clip = umbrage::cpu_clip_space});
    const glm::ivec2 map_size(1024, 1024), size(2048, 2048);
    const umbrage::filters::pcss filter{.points = 32, .softness = umbrage::make_penumbra_params(0.05f, 1.0f, 24.0f)};
    const umbrage::shadow sun(light, map_size, filter);
    umbrage::image<float> map(sun.size(), sun.cleared());
    sun.draw(map, {vertices, triangles});

    const glm::vec3 eye(0, 3, 6.2f);
    const int samples = 4;  // along a pixel's side, as the filter has 16 rotations
    const auto ray = [](int x, int y) {
        const float u = (float(x) + 0.5f) / 1024 - 1, v = 1 - (float(y) + 0.5f) / 1024;
        return glm::vec3(u * 0.5f, v * 0.45f - 0.48f, v * -0.2f - 1);
    };
    umbrage::image<glm::vec3> points(size), normals(size, glm::vec3(0, 1, 0));
    for (glm::ivec2 p{0, 0}; p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x) {
            const glm::vec3 way = ray(p.x, p.y);
            points[p] = eye - way * (eye.y / way.y);  // on the floor
        }
    umbrage::image<float> visibility(size), picture(size / samples);
    sun.visibility(map, points, normals, visibility);

    int dark = 0;
    glm::vec2 floor_at(0), soft_at(0);  // at the boards' feet, and two units farther
    for (glm::ivec2 p{0, 0}; p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x) {
            const glm::vec3 way = ray(p.x, p.y), at = eye - way * (eye.z / way.z);
            const bool board = std::ranges::any_of(
                boards, [at](glm::vec4 b) { return at.x > b.x && at.x < b.z && at.y > b.y && at.y < b.w; });
            const float z = eye.z - way.z * (eye.y / way.y);
            for (const int i : {0, 1})
                if (std::abs(z - (i ? 2.0f : 0.15f)) < 0.1f)
                    ++floor_at[i], soft_at[i] += visibility[p] > 0.1f && visibility[p] < 0.9f;
            dark += visibility[p] < 0.5f;
            picture[p / samples] += (board ? 0.015f : 0.06f + 0.6f * visibility[p]) / (samples * samples);
        }
    write_picture("soft_shadow.png", picture);
    const glm::vec2 soft = 100.0f * soft_at / floor_at;
    std::printf(
        "soft_shadow.png: %d of %d points are in shadow; penumbra covers %.0f %% of the floor at the boards' "
        "feet, %.0f %% two units farther\n",
        dark, size.x * size.y, soft.x, soft.y);
    return soft.y > 3 * soft.x ? 0 : 1;
}
