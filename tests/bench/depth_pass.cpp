// SPDX-License-Identifier: MIT
//
// The depth pass against llvmpipe's, and a shadow mask, from the mesh on, against Embree's rays.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <umbrage/image_ops/rasterize.hpp>
#include <umbrage/image_ops/visibility.hpp>

#include "bench.hpp"
#include "data.hpp"
#include "peers/depth_pass.hpp"

namespace {

struct mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    operator umbrage::mesh_view() const { return {positions, triangles}; }
};

/// Triangles of half a square with that side, anywhere on the screen, from back to front so that all of them are drawn.
mesh scattered(int count, float side) {
    std::mt19937 engine(7);
    const auto random = [&] { return static_cast<float>(engine() >> 8) * 0x1p-24f; };
    mesh m;
    for (int i = 0; i < count; ++i) {
        const float x = random() * (1920.0f - side), y = random() * (1080.0f - side);
        const float z = 0.9f - 0.8f * static_cast<float>(i) / static_cast<float>(count);
        for (const auto& corner : {glm::vec2(x, y), glm::vec2(x + side, y), glm::vec2(x, y + side)})
            m.positions.emplace_back(corner.x / 960.0f - 1.0f, corner.y / 540.0f - 1.0f, z);
        m.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return m;
}

/// Hills over [-1, 1] x [-1, 1] of 2 n n triangles.
mesh hills(int n) {
    mesh m;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) {
            const glm::vec2 p(2.0f * static_cast<float>(x) / static_cast<float>(n) - 1.0f,
                              2.0f * static_cast<float>(y) / static_cast<float>(n) - 1.0f);
            m.positions.emplace_back(p.x, p.y, 0.1f * std::sin(12.0f * p.x) * std::cos(9.0f * p.y));
        }
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const auto i = static_cast<unsigned>(y * (n + 1) + x), above = i + static_cast<unsigned>(n) + 1;
            m.triangles.emplace_back(i, i + 1, above);
            m.triangles.emplace_back(i + 1, above + 1, above);
        }
    return m;
}

#ifdef UMBRAGE_BENCH_LLVMPIPE_DEPTH
void add_pass(int count, float side, double at_least, const std::string& work) {
    struct state {
        mesh triangles;
        umbrage::image<float> depth{bench::screen};
        glm::mat4 matrix{1.0f};
        peers::llvmpipe_pass pipe;

        static glm::mat4 opengl() {
            glm::mat4 m(1.0f);
            m[2][2] = 2.0f, m[3][2] = -1.0f;
            return m;
        }
        state(int n, float s)
            : triangles(scattered(n, s)), matrix(opengl()), pipe(bench::screen, triangles.positions, triangles.triangles, matrix) {}
    };
    const auto s = std::make_shared<state>(count, side);
    bench::add({.work = work, .peer = "llvmpipe, one thread", .at_least = at_least, .items = double(count),
                .ours = [s] {
                    std::ranges::fill(s->depth.texels(), 1.0f);
                    umbrage::rasterize_depth(s->depth, s->triangles, s->matrix, umbrage::opengl_clip_space);
                },
                .theirs = [s] { s->pipe.clear_and_draw(); },
                .agree = [s] {  // but for samples on edges that the two snap differently
                    const auto theirs = s->pipe.read();
                    const auto ours = s->depth.texels();
                    std::size_t differ = 0;
                    for (std::size_t i = 0; i < ours.size(); ++i) differ += std::abs(ours[i] - theirs[i]) > 1e-6f;
                    return differ * 200 < ours.size();
                }});
}
#endif

#ifdef UMBRAGE_BENCH_EMBREE
struct mask_state {
    mesh scene = hills(724);
    glm::vec3 to_light = glm::vec3(0.8f, 0.3f, 0.5f) / std::sqrt(0.98f);
    glm::mat4 world_to_light{0.0f};
    umbrage::image<float> map{bench::map_size};
    umbrage::image<glm::vec3> receivers{bench::screen};
    umbrage::image<float> ours{bench::screen};
    std::vector<glm::vec3> points = std::vector<glm::vec3>(receivers.texels().size());
    std::vector<float> theirs = std::vector<float>(points.size());
    peers::embree_scene embree;

    mask_state() {
        const glm::vec3 right = glm::vec3(-0.3f, 0.8f, 0.0f) / std::sqrt(0.73f);
        const glm::vec3 up(to_light.y * right.z - to_light.z * right.y, to_light.z * right.x - to_light.x * right.z,
                           to_light.x * right.y - to_light.y * right.x);
        for (int i = 0; i < 3; ++i) {
            world_to_light[i][0] = right[i] / 1.5f, world_to_light[i][1] = up[i] / 1.5f;
            world_to_light[i][2] = -to_light[i] / 4.0f;
        }
        world_to_light[3] = {0.0f, 0.0f, 0.5f, 1.0f};

        glm::mat4 from_above(1.0f);
        from_above[2][2] = -1.0f, from_above[3][2] = 0.5f;  // depth 1/2 - height
        umbrage::rasterize(bench::screen, scene, from_above, {}, [&](glm::ivec2 texel, float z, unsigned) {
            const glm::vec3 p((static_cast<float>(texel.x) + 0.5f) / 960.0f - 1.0f,
                              (static_cast<float>(texel.y) + 0.5f) / 540.0f - 1.0f, 0.5f - z);
            const glm::vec4 c = world_to_light * glm::vec4(p, 1.0f);
            receivers[texel] = {(c.x + 1.0f) * 1024.0f, (c.y + 1.0f) * 1024.0f, c.z - 0.004f};
            points[std::size_t(texel.y) * 1920 + std::size_t(texel.x)] = p + to_light * 0.016f;
        });
    }
    void draw() {
        std::ranges::fill(map.texels(), 1.0f);
        umbrage::rasterize_depth(map, scene, world_to_light, {});
    }
};
#endif

const bench::registration rows([] {
#ifdef UMBRAGE_BENCH_LLVMPIPE_DEPTH
    add_pass(200000, 10.0f, 4.0, "depth pass, 10-pixel triangles");
    add_pass(10000, 100.0f, 3.0, "depth pass, 100-pixel triangles");
#endif
#ifdef UMBRAGE_BENCH_EMBREE
    const auto s = std::make_shared<mask_state>();
    bench::add({.work = "shadow mask 1920 x 1080, a million triangles", .peer = "Embree, build and rays", .at_least = 3,
                .items = bench::pixels,
                .ours = [s] {
                    s->draw();
                    umbrage::visibility(s->map.view(), umbrage::depth32f{}, s->receivers.view(),
                                        umbrage::filters::pcf_2x2{}, s->ours.view());
                },
                .theirs = [s] {
                    s->embree.build(s->scene.positions, s->scene.triangles);
                    s->embree.visibility(s->points, s->to_light, s->theirs);
                },
                .agree = [s] {  // but for borders of shadows and grazing light, which the map has in texels
                    const auto ours = s->ours.texels();
                    std::size_t differ = 0, shadowed = 0;
                    for (std::size_t i = 0; i < ours.size(); ++i) {
                        differ += std::abs(ours[i] - s->theirs[i]) > 0.5f;
                        shadowed += s->theirs[i] == 0.0f;
                    }
                    return differ * 100 < ours.size() && shadowed * 10 > ours.size() && shadowed * 10 < 9 * ours.size();
                }});
#endif
    // both cores
    struct threads_state {
        mesh scene = hills(724), large = scattered(10000, 100.0f);
        umbrage::image<float> one{bench::screen, 1.0f}, two{bench::screen, 1.0f};
    };
    const auto t = std::make_shared<threads_state>();
    const auto halves = [](int count, auto&& piece) {
        std::jthread other([&] { piece(0, count / 2); });
        piece(count / 2, count);
    };
    const auto same = [t] { return std::ranges::equal(t->one.texels(), t->two.texels()); };
    for (const bool large : {false, true})
        bench::add({.work = large ? "depth pass, 100-pixel triangles, two threads" : "depth pass, hills, two threads",
                    .peer = "one thread", .at_least = 1.75,
                    .items = double((large ? t->large : t->scene).triangles.size()),
                    .ours = [=] {
                        std::ranges::fill(t->two.texels(), 1.0f);
                        umbrage::rasterize_depth(t->two, large ? t->large : t->scene, glm::mat4(1.0f), {},
                                                 umbrage::cull_mode::none, halves);
                    },
                    .theirs = [=] {
                        std::ranges::fill(t->one.texels(), 1.0f);
                        umbrage::rasterize_depth(t->one, large ? t->large : t->scene, glm::mat4(1.0f), {});
                    },
                    .agree = same, .measured = bench::clock::wall});
});

}  // namespace
