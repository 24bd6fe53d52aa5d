// SPDX-License-Identifier: MIT
//
// Bakes the light of an overcast sky: 64 lights, each with a map of its own, over a whole image of receivers on all
// threads.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <thread>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "picture.hpp"

namespace {

/// A stepped pyramid among pillars, of 32 x 32 cells a unit wide.
float height(int x, int z) {
    const int ring = std::max(std::abs(2 * x - 31), std::abs(2 * z - 31)) / 2;
    if (ring < 10) return 1.5f * float(5 - ring / 2);
    return ring > 11 && x % 4 == 1 && z % 4 == 1 ? 6.0f : 0.0f;
}

}  // namespace

int main() {
    std::vector<glm::vec3> vertices{{0, 0, 0}, {32, 0, 0}, {32, 0, 32}, {0, 0, 32}};
    std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};
    for (int z = 0; z < 32; ++z)
        for (int x = 0; x < 32; ++x) {
            if (height(x, z) == 0) continue;
            const auto k = unsigned(vertices.size());
            for (int i = 0; i < 8; ++i)  // a box: its top and four walls
                vertices.emplace_back(x + i % 2, i < 4 ? 0.0f : height(x, z), z + i / 2 % 2);
            for (const glm::uvec4 q : {glm::uvec4(4, 5, 7, 6), {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}})
                triangles.insert(triangles.end(), {{k + q.x, k + q.y, k + q.z}, {k + q.x, k + q.z, k + q.w}});
        }

    // The receivers, as a texture over the scene has them: 16 x 16 texels a cell.
    const glm::ivec2 size(512, 512), map_size(512, 512);
    umbrage::image<glm::vec3> points(size), normals(size, {0, 1, 0});
    for (glm::ivec2 p{0, 0}; p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x)
            points[p] = {(float(p.x) + 0.5f) / 16, height(p.x / 16, p.y / 16), (float(p.y) + 0.5f) / 16};

    // The library starts no threads: its functions give this their number of rows and the work on some of them.
    const int count = std::max(2, int(std::thread::hardware_concurrency()));
    const auto on_all_threads = [count](int rows, const auto& work) {
        std::vector<std::jthread> threads;  // joined at the end
        for (int i = 0; i < count; ++i)
            threads.emplace_back([&work, rows, i, count] { work(rows * i / count, rows * (i + 1) / count); });
    };

    constexpr int lights = 64;
    umbrage::image<float> visibility(size), alone(size), baked(size);
    bool same = true;
    for (int i = 0; i < lights; ++i) {  // denser overhead, as a floor gets more light from there
        const float angle = 2.39996f * float(i), out = std::sqrt((float(i) + 0.5f) / float(lights));
        const auto light = umbrage::fit_directional_light<float>(
            {.direction = {out * std::cos(angle), -std::sqrt(1 - out * out), out * std::sin(angle)},
             .receivers = umbrage::bounding_box<float>{{0, 0, 0}, {32, 7.5f, 32}},
             .clip = umbrage::cpu_clip_space});
        const umbrage::shadow shadow(light, map_size, umbrage::filters::tent<3>);
        umbrage::image<float> map(shadow.size(), shadow.cleared());
        shadow.draw(map, {vertices, triangles}, on_all_threads);
        shadow.visibility(map, points, normals, visibility, on_all_threads);
        if (i == 0) shadow.visibility(map, points, normals, alone);
        same = same && (i > 0 || std::ranges::equal(alone.texels(), visibility.texels()));
        for (glm::ivec2 p{0, 0}; p.y < size.y; ++p.y)
            for (p.x = 0; p.x < size.x; ++p.x) baked[p] += visibility[p] / float(lights);
    }
    write_picture("bake.png", baked);
    const auto dark = std::ranges::count_if(baked.texels(), [](float v) { return v < 0.5f; });
    std::printf("bake.png: %d of %d points see less than half of the sky, by %d lights on %d threads\n", int(dark),
                size.x * size.y, lights, count);
    return same && baked[size / 2] > 0.999f ? 0 : 1;  // the same bits as on one thread; the pyramid's top sees all
}
