// SPDX-License-Identifier: MIT
#include <array>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/draw/dual_paraboloid_pass.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/draw/tetrahedron_pass.hpp>
#include <umbrage/light/point/dual_paraboloid.hpp>
#include <umbrage/light/point/tetrahedron_light.hpp>

#include "../mesh.hpp"
#include "functions.hpp"

namespace {

using namespace umbrage;

using tests::mesh;

/// Grid whose triangles follow each other: threads draw it under locks.
mesh grid() {
    constexpr unsigned side = 72;
    mesh m;
    for (unsigned y = 0; y < side; ++y)
        for (unsigned x = 0; x < side; ++x) {
            m.positions.emplace_back(float(x) / 36 - 1, float(y) / 36 - 1, 0.5f + 0.1f * float((x * y) % 3));
            const unsigned i = y * side + x;
            if (x + 1 < side && y + 1 < side)
                m.triangles.insert(m.triangles.end(), {{i, i + 1, i + side}, {i + 1, i + side + 1, i + side}});
        }
    return m;
}

/// Triangles of any size anywhere: threads draw them in bands.
mesh soup(float low = -1) {
    numbers random;
    mesh m;
    for (unsigned i = 0; i < 600; i += 3) {
        for (int corner = 0; corner < 3; ++corner)
            m.positions.emplace_back(random(low, 1), random(low, 1), random(low, 1));
        m.triangles.emplace_back(i, i + 1, i + 2);
    }
    return m;
}

blob drawn(const mesh& m, const hook& parallel) {
    image<float> depth({96, 300}, 1.0f);
    rasterize_depth(depth, m.view(), glm::mat4(1), cpu_clip_space, cull_mode::none, parallel);
    return blob_of(depth);
}

blob instances(const hook& parallel) {
    const mesh m = soup();
    std::vector<glm::mat4> places(5, glm::mat4(0.5f));
    for (std::size_t i = 0; i < places.size(); ++i) places[i][3] = {float(i) / 4 - 0.5f, 0, 0, 1};
    image<float> depth({96, 200}, 1.0f);
    rasterize_depth(depth, m.view(), places, glm::mat4(1), cpu_clip_space, cull_mode::none, parallel);
    return blob_of(depth);
}

blob paraboloid(const hook& parallel) {
    const mesh m = soup(-0.9f);
    const auto light = make_dual_paraboloid_light<float>({.range = 3, .map_size = 160, .clip = cpu_clip_space});
    image<float> depth({160, 160}, 1.0f);
    rasterize_dual_paraboloid(depth, m.view(), light, 0, parallel);
    return blob_of(depth);
}

blob tetrahedron(const hook& parallel) {
    const mesh m = soup();
    const auto faces = make_tetrahedron_light(
        tetrahedron_light<float>{.z_near = 0.1f, .z_far = 3, .map_size = 160, .clip = cpu_clip_space});
    image<float> depth({160, 160}, 1.0f);
    rasterize_tetrahedron(depth, m.view(), faces, cull_mode::none, parallel);
    return blob_of(depth);
}

}  // namespace

std::vector<function> depth_passes() {
    return {{"rasterize_depth, triangles that follow each other", [](const hook& h) { return drawn(grid(), h); }},
            {"rasterize_depth, triangles anywhere", [](const hook& h) { return drawn(soup(), h); }},
            {"rasterize_depth, instances", instances},
            {"rasterize_dual_paraboloid", paraboloid},
            {"rasterize_tetrahedron", tetrahedron}};
}
