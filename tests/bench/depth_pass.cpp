// SPDX-License-Identifier: MIT
//
// The depth pass against llvmpipe's, and a shadow mask, from the mesh on, against Embree's rays.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <umbrage/images/rasterize.hpp>
#include <umbrage/images/visibility.hpp>

#include "bench.hpp"
#include "data.hpp"
#include "peers/depth_pass.hpp"
#include "scenes.hpp"

namespace {

using bench::mesh;
using bench::scattered;

#ifdef UMBRAGE_BENCH_LLVMPIPE_DEPTH
void add_pass(int count, float side, double at_least, const std::string& work) {
    struct state {
        mesh triangles;
        umbrage::image<float> depth{bench::screen};
        glm::mat4 matrix = bench::to_opengl_depth();
        peers::llvmpipe_pass pipe;

        state(int n, float s)
            : triangles(scattered(n, s)), pipe(bench::screen, triangles.positions, triangles.triangles, matrix) {}
    };
    const auto s = std::make_shared<state>(count, side);
    bench::add({.work = work,
                .peer = "llvmpipe, one thread",
                .at_least = at_least,
                .items = double(count),
                .ours =
                    [s] {
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
struct mask_state : bench::lit_hills {
    umbrage::image<float> map{bench::map_size}, ours{bench::screen};
    std::vector<float> theirs = std::vector<float>(points.size());
    peers::embree_scene embree;
    mask_state() : lit_hills(724) {}
};
#endif

const bench::registration rows([] {
#ifdef UMBRAGE_BENCH_LLVMPIPE_DEPTH
    add_pass(200000, 10.0f, 4.0, "depth pass, 10-pixel triangles");
    add_pass(10000, 100.0f, 3.0, "depth pass, 100-pixel triangles");
#endif
#ifdef UMBRAGE_BENCH_EMBREE
    const auto s = std::make_shared<mask_state>();
    bench::add({.work = "shadow mask 1920 x 1080, a million triangles",
                .peer = "Embree, build and rays",
                .at_least = 3,
                .items = bench::pixels,
                .ours =
                    [s] {
                        s->draw(s->map);
                        umbrage::visibility(s->map.view(), umbrage::depth32f{}, s->receivers.view(),
                                            umbrage::filters::pcf_2x2{}, s->ours.view());
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
