// SPDX-License-Identifier: MIT
//
// The depth pass against llvmpipe's, and a shadow mask, from the mesh on, against Embree's rays.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <umbrage/draw/rasterize.hpp>
#include <umbrage/images/visibility.hpp>

#include "bench.hpp"
#include "data.hpp"
#include "peers/depth_pass.hpp"
#include "scenes.hpp"

namespace {

using bench::mesh;

#ifdef UMBRAGE_BENCH_LLVMPIPE_DEPTH
/// @param triangles   with OpenGL's depths
void add_pass(const std::string& work, double at_least, const mesh& triangles, const glm::mat4& world_to_clip) {
    struct state {
        mesh triangles;
        glm::mat4 matrix;
        umbrage::image<float> depth{bench::screen};
        peers::llvmpipe_pass pipe{bench::screen, triangles.positions, triangles.triangles, matrix};
    };
    const auto s = std::make_shared<state>(triangles, world_to_clip);
    bench::add({.work = work,
                .peer = "llvmpipe, one thread",
                .at_least = at_least,
                .items = double(triangles.triangles.size()),
                .ours =
                    [s] {
                        std::ranges::fill(s->depth.texels(), 1.0f);
                        umbrage::rasterize_depth(s->depth, s->triangles, s->matrix, umbrage::opengl_clip_space);
                    },
                .theirs = [s] { s->pipe.clear_and_draw(); },
                .agree = [s] {  // but for samples on edges that the two snap differently, and what that moves a slope
                    const auto theirs = s->pipe.read();
                    const auto ours = s->depth.texels();
                    std::size_t differ = 0;
                    for (std::size_t i = 0; i < ours.size(); ++i) differ += std::abs(ours[i] - theirs[i]) > 1e-5f;
                    return differ * 200 < ours.size();
                }});
}
#endif

#ifdef UMBRAGE_BENCH_EMBREE
struct mask_state : bench::lit_hills {
    umbrage::image<float> map{bench::map_size}, ours{bench::screen};
    std::vector<float> theirs = std::vector<float>(points.size());
    peers::embree_scene embree;
    mask_state() : lit_hills(724) {}
};
#endif

const bench::registration rows([] {
#ifdef UMBRAGE_BENCH_LLVMPIPE_DEPTH
    const glm::mat4 to_opengl = bench::to_opengl_depth();
    add_pass("depth pass, 10-pixel triangles", 3.5, bench::scattered(200000, 10.0f), to_opengl);
    add_pass("depth pass, 100-pixel triangles", 3.3, bench::scattered(10000, 100.0f), to_opengl);
    add_pass("depth pass, hills of 2 million triangles", 3.3, bench::hills(1000), glm::mat4(1.0f));
#endif
#ifdef UMBRAGE_BENCH_EMBREE
    const auto s = std::make_shared<mask_state>();
    bench::add({.work = "shadow mask 1920 x 1080, a million triangles",
                .peer = "Embree, build and rays",
                .at_least = 4.5,
                .items = bench::pixels,
                .ours =
                    [s] {
                        s->draw(s->map);
                        umbrage::visibility(s->map.view(), umbrage::depth32f{}, s->receivers.view(),
                                            umbrage::filters::pcf_2x2{}, s->ours.view(), umbrage::serial{},
                                            umbrage::outside_map::clamped);
                    },
                .theirs =
                    [s] {
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
});

}  // namespace
