// SPDX-License-Identifier: MIT
//
// Curves for plots.gp: the cost of the same work over map size, kernel size, triangle count and threads.
//
//     bench_series bench-series.tsv    # then: gnuplot -e "data='bench-series.tsv'; folder='plots'" style.gp plots.gp
//
// A line is `plot, work, by, x, y`, separated by tabs, the lines of a curve together. A peer that is not here has none.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>

#include <umbrage/draw/rasterize.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/images/summed_area.hpp>
#include <umbrage/images/visibility.hpp>

#include "../forced_form.hpp"
#include "curves.hpp"
#include "data.hpp"
#include "peers/depth_pass.hpp"
#include "peers/glm.hpp"
#include "scenes.hpp"
#include "schedulers.hpp"
#ifdef UMBRAGE_BENCH_OPENCV
#include "peers/opencv.hpp"
#endif

namespace {

using bench::measurements;
using umbrage::image;

template <class T>
std::vector<T> copy_of(const image<T>& from) {
    return {from.texels().begin(), from.texels().end()};
}

template <class A, class B>
double mean_difference(const A& a, const B& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(double(a[i]) - double(b[i]));
    return sum / double(a.size());
}

/// A peer, or null where it does not start.
template <class Peer, class... Arguments>
std::unique_ptr<Peer> start(const Arguments&... arguments) try {
    return std::make_unique<Peer>(arguments...);
} catch (const std::exception& error) {
    std::fprintf(stderr, "bench_series: a peer is left out: %s\n", error.what());
    return nullptr;
}

/// The benchmarks' map with another number of texels.
image<float> map_of(int side) {
    const image<float> map = bench::make_map();
    image<float> out({side, side});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) out[{x, y}] = map[{x * map.size().x / side, y * map.size().y / side}];
    return out;
}

const umbrage::rg<11> rg11{.edge = umbrage::lower_edge<float>};
const umbrage::depth32f f32;

void encoding_over_map_size(measurements& m, int side) {
    const double texels = double(side) * side;
    const auto add = [&](const char* work, const char* by, const auto& run, const std::function<bool()>& agree = {}) {
        m.add({"map_size_encode", work, by, {}}, side, texels, run, false, agree);
    };
    const image<float> depth = map_of(side);
    image<float> back(depth.size());
    image<glm::u8vec2> packed(depth.size());
    const auto glm_depth = copy_of(depth);
    auto glm_back = glm_depth;
    auto glm_packed = copy_of(packed);
    add("encode 11 bits", "umbrage", [&] { umbrage::encode(depth, packed, rg11); });
    add(
        "encode 11 bits", "GLM code", [&] { peers::glm_code::encode(glm_depth, glm_packed); },
        [&] { return std::ranges::equal(packed.texels(), glm_packed); });
    add("decode 11 bits", "umbrage", [&] { umbrage::decode(packed, back, umbrage::rg<11>{}); });
    add(
        "decode 11 bits", "GLM code", [&] { peers::glm_code::decode(glm_packed, glm_back); },
        [&] { return std::ranges::equal(back.texels(), glm_back); });
    // as many bytes read and written as by either: 6 a texel
    add("the same traffic", "memcpy",
        [&] { std::memcpy(glm_back.data(), depth.texels().data(), std::size_t(texels) * 3); });
    m.measure();
}

void visibility_over_map_size(measurements& m, int side) {
    const auto add = [&](const char* work, const char* by, const auto& run, const std::function<bool()>& agree = {}) {
        m.add({"map_size_visibility", work, by, {}}, side, bench::pixels, run, false, agree);
    };
    const image<float> map = map_of(side);
    image<glm::u8vec2> packed(map.size());
    umbrage::encode(map, packed, rg11);
    image<glm::vec3> receivers = bench::make_receivers(bench::order::coherent);
    for (glm::vec3& r : receivers.texels()) {
        r.x *= float(side) / float(bench::map_size.x);
        r.y *= float(side) / float(bench::map_size.y);
    }
    image<float> ours(bench::screen), other(bench::screen);
    const peers::glm_code::float_map glm_map{copy_of(map), map.size()};
    const auto glm_receivers = copy_of(receivers);
    auto theirs = copy_of(ours);
    const umbrage::filters::pcf_2x2 filter;
    add("PCF 2x2, float map", "umbrage", [&] {
        umbrage::visibility(map, f32, receivers, filter, ours, umbrage::serial{}, umbrage::outside_map::clamped);
    });
    add(
        "PCF 2x2, float map", "GLM code", [&] { peers::glm_code::pcf_2x2(glm_map, glm_receivers, theirs); },
        [&] { return mean_difference(ours.texels(), theirs) < 1e-3; });  // weights in 1/256 here, in floats there
    add(
        "PCF 2x2, 11-bit map", "umbrage",
        [&] {
            umbrage::visibility(packed, rg11, receivers, filter, other, umbrage::serial{},
                                umbrage::outside_map::clamped);
        },
        [&] { return std::ranges::equal(ours.texels(), other.texels()); });
    m.measure();
}

void summed_area_over_map_size(measurements& m, int side) {
    const double texels = double(side) * side;
    const auto add = [&](const char* by, const auto& run, const std::function<bool()>& agree = {}) {
        m.add({"map_size_summed_area", by == std::string("memcpy") ? "the same traffic" : "table", by, {}}, side,
              texels, run, false, agree);
    };
    image<std::uint32_t> words({side, side}), sums(words.size());
    for (std::uint32_t i = 0; auto& word : words.texels()) word = (i++ * 2654435761u) >> 24;
    add("umbrage", [&] { umbrage::summed_area(words.view(), sums.view()); });
#ifdef UMBRAGE_BENCH_OPENCV
    // OpenCV takes no integers wider than bytes: its floats, of the same size.
    image<float> floats(words.size()), their_sums(words.size() + 1);
    std::ranges::copy(words.texels(), floats.texels().begin());
    add(
        "OpenCV, float", [&] { peers::opencv::integral(floats, their_sums); },
        [&] {
            const int at = std::min(side, 256);  // as far as floats count without rounding
            return float(sums[{at - 1, at - 1}]) == their_sums[{at, at}];
        });
#endif
    image<std::uint32_t> copy(words.size());
    add("memcpy", [&] { std::memcpy(copy.texels().data(), words.texels().data(), words.texels().size_bytes()); });
    m.measure();
}

void box_over_kernel_size(measurements& m) {
    const image<float> map = bench::make_map();
    const image<glm::vec3> receivers = bench::make_receivers(bench::order::coherent);
    const peers::glm_code::float_map glm_map{copy_of(map), map.size()};
    const auto glm_receivers = copy_of(receivers);
    image<float> ours(bench::screen), other(bench::screen);
    auto theirs = copy_of(ours);
    const auto add = [&](const char* work, const char* by, int radius, const auto& run,
                         const std::function<bool()>& agree = {}) {
        m.add({"kernel_size", work, by, {}}, 2 * radius + 1, bench::pixels, run, false, agree);
    };
    for (int radius = 0; radius <= 8; ++radius) {
        add("every texel", "umbrage", radius, [&, radius] {
            umbrage::visibility(map, f32, receivers, forced::every_texel{umbrage::filters::box{radius}}, ours,
                                umbrage::serial{}, umbrage::outside_map::clamped);
        });
        add(
            "every texel", "GLM code", radius,
            [&, radius] { peers::glm_code::pcf_box(radius, glm_map, glm_receivers, theirs); },
            [&] { return mean_difference(ours.texels(), theirs) < 1e-7; });
        add(
            "hierarchical, bounds included", "umbrage", radius,
            [&, radius] {
                umbrage::visibility(map, f32, receivers, forced::by_bounds{umbrage::filters::box{radius}}, other,
                                    umbrage::serial{}, umbrage::outside_map::clamped);
            },
            [&] { return std::ranges::equal(ours.texels(), other.texels()); });
    }
    m.measure();
}

void over_triangles(measurements& m, int n) {
    const bench::lit_hills hills(n);
    const auto add = [&](const char* work, const char* by, const auto& run, const std::function<bool()>& agree = {}) {
        m.add({"triangles", work, by, {}}, double(hills.scene.triangles.size()), 1e6, run, false, agree);
    };
    image<float> map(bench::map_size), mask(bench::screen);
    add("depth pass 2048 x 2048", "umbrage", [&] { hills.draw(map); });
#ifdef UMBRAGE_BENCH_LLVMPIPE_DEPTH
    const auto pipe = start<peers::llvmpipe_pass>(bench::map_size, hills.scene.positions, hills.scene.triangles,
                                                  bench::to_opengl_depth() * hills.world_to_light);
    if (pipe)
        add(
            "depth pass 2048 x 2048", "llvmpipe", [&] { pipe->clear_and_draw(); },
            [&] {
                // but for samples on edges that the two snap differently
                const auto theirs = pipe->read();
                std::size_t differ = 0;
                for (std::size_t i = 0; i < theirs.size(); ++i) differ += std::abs(map.texels()[i] - theirs[i]) > 1e-4f;
                return differ * 100 < theirs.size();
            });
#endif
    add("shadow mask 1920 x 1080", "umbrage", [&] {
        hills.draw(map);
        umbrage::visibility(map, f32, hills.receivers, umbrage::filters::pcf_2x2{}, mask, umbrage::serial{},
                            umbrage::outside_map::clamped);
    });
#ifdef UMBRAGE_BENCH_EMBREE
    std::vector<float> theirs(mask.texels().size());
    const auto embree = start<peers::embree_scene>();
    if (embree)
        add(
            "shadow mask 1920 x 1080", "Embree, build and rays",
            [&] {
                embree->build(hills.scene.positions, hills.scene.triangles);
                embree->visibility(hills.points, hills.to_light, theirs);
            },
            [&] {
                return mean_difference(mask.texels(), theirs) < 0.02;
            });  // borders of shadows, which a map has in texels
#endif
    m.measure();
}

void over_threads(measurements& m) {
    const image<float> depth = bench::make_map();
    image<glm::u8vec2> packed(depth.size());
    const image<glm::vec3> receivers = bench::make_receivers(bench::order::coherent);
    image<float> ours(bench::screen), map(bench::map_size), copy(bench::map_size);
    const bench::lit_hills hills(724);
    const int all = std::max(2, int(std::thread::hardware_concurrency()));
    for (int threads = 1; threads <= all; ++threads) {
        if (threads > 8 && all % threads != 0) continue;
        const std_threads parallel{threads};
        const auto add = [&](const char* work, const char* by, const auto& run) {
            m.add({"threads", work, by, {}}, threads, 1, run, true);
        };
        add("encode 11 bits", "umbrage", [&, parallel] { umbrage::encode(depth, packed, rg11, parallel); });
        add("PCF 2x2", "umbrage", [&, parallel] {
            umbrage::visibility(depth, f32, receivers, umbrage::filters::pcf_2x2{}, ours, parallel,
                                umbrage::outside_map::clamped);
        });
        add("box 5x5", "umbrage", [&, parallel] {
            umbrage::visibility(depth, f32, receivers, umbrage::filters::box{2}, ours, parallel,
                                umbrage::outside_map::clamped);
        });
        add("depth pass", "umbrage", [&, parallel] {
            std::ranges::fill(map.texels(), 1.0f);
            umbrage::rasterize_depth(map, hills.scene, hills.world_to_light, umbrage::cpu_clip_space,
                                     umbrage::cull_mode::none, parallel);
        });
        add("a copy", "memcpy", [&, parallel] {
            parallel(bench::map_size.y, [&](int first, int last) {
                std::memcpy(copy.view().row(first), depth.view().row(first),
                            std::size_t(last - first) * sizeof(float) * 2048);
            });
        });
    }
    m.measure();
    m.make_relative("threads");
}

}  // namespace

int main(int argc, char** argv) try {
    std::vector<char*> arguments(argv, argv + argc);
    std::string interleave = "--benchmark_enable_random_interleaving=true";
    arguments.push_back(interleave.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());

    measurements m;
    for (int side = 256; side <= 8192; side *= 2) {
        encoding_over_map_size(m, side);
        visibility_over_map_size(m, side);
        summed_area_over_map_size(m, side);
    }
    box_over_kernel_size(m);
    for (const int n : {22, 50, 100, 224, 400, 724, 1000}) over_triangles(m, n);
    over_threads(m);
    return m.write(count > 1 ? arguments[1] : "bench-series.tsv") ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "bench_series: %s\n", error.what());
    return 1;
}
