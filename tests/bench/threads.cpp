// SPDX-License-Identifier: MIT
//
// What a second thread gives. Two processors of a machine may be two halves of one core: what copies and
// multiplications gain here is what anything can gain.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include <benchmark/benchmark.h>

#include <umbrage/images/encode.hpp>
#include <umbrage/images/rasterize.hpp>
#include <umbrage/images/summed_area.hpp>
#include <umbrage/images/visibility.hpp>

#include "bench.hpp"
#include "data.hpp"
#include "scenes.hpp"
#include "schedulers.hpp"

namespace {

using umbrage::image;

const std_threads two_threads{2};

/// Multiplications that wait for none before them.
void multiply(int first, int last) {
    float products[32];
    std::fill(std::begin(products), std::end(products), 1.0f);
    for (int i = first; i < last; ++i) {
        for (float& product : products) product *= 1.0000001f;
        benchmark::ClobberMemory();
    }
    benchmark::DoNotOptimize(products);
}

struct state {
    image<float> depth = bench::make_map(), back{bench::map_size}, one{bench::screen}, two{bench::screen};
    image<glm::u8vec2> packed{bench::map_size};
    image<std::uint32_t> words{bench::map_size, 200u}, sums{bench::map_size};
    image<glm::vec3> receivers = bench::make_receivers(bench::order::coherent);
    std::vector<char> from = std::vector<char>(std::size_t(bench::map_texels) * 4, 1), to = from;
    bench::mesh hills = bench::hills(724), large = bench::scattered(10000, 100.0f);

    /// Each thread copies half of so many bytes a texel.
    void copy(int bytes) {
        const std::size_t half = std::size_t(bench::map_texels) * std::size_t(bytes) / 2;
        two_threads(2, [&](int first, int last) {
            const std::size_t start = half * std::size_t(first);
            std::memcpy(to.data() + start, from.data() + start, half * std::size_t(last - first));
        });
    }
};

const bench::registration rows([] {
    const auto s = std::make_shared<state>();

    // run(out, threads) writes the same with two threads as alone.
    const auto on_both = [s](const std::string& work, double at_least, int bytes, auto& out, const auto& run) {
        const auto same_alone = [run, &out] {
            auto alone = std::remove_cvref_t<decltype(out)>(out.size());
            run(alone, umbrage::serial{});
            return std::ranges::equal(out.texels(), alone.texels());
        };
        bench::add({.work = work + ", two threads",
                    .peer = "memcpy, two threads",
                    .at_least = at_least,
                    .items = bench::map_texels,
                    .ours = [run, &out] { run(out, two_threads); },
                    .theirs = [=] { s->copy(bytes); },
                    .agree = same_alone,
                    .measured = bench::clock::wall});
    };
    const umbrage::rg<11> rg;
    on_both("encode 11 bits", 0.9, 3, s->packed,
            [=](auto& out, const auto& threads) { umbrage::encode(s->depth, out, rg, threads); });
    on_both("decode 11 bits", 0.9, 3, s->back,
            [=](auto& out, const auto& threads) { umbrage::decode(s->packed, out, rg, threads); });
    on_both("summed-area table of uint32", 0, 4, s->sums,
            [=](auto& out, const auto& threads) { umbrage::summed_area(s->words.view(), out.view(), threads); });

    const auto against_one = [](const std::string& work, double at_least, double items, const auto& two,
                                const auto& one, const auto& agree) {
        bench::add({.work = work + ", two threads",
                    .peer = "one thread",
                    .at_least = at_least,
                    .items = items,
                    .ours = two,
                    .theirs = one,
                    .agree = agree,
                    .measured = bench::clock::wall});
    };
    constexpr int products = 1000000;
    against_one(
        "limit: multiplications", 0, products, [=] { two_threads(products, multiply); }, [] { multiply(0, products); },
        std::function<bool()>());
    const auto same = [s] { return std::ranges::equal(s->one.texels(), s->two.texels()); };
    const auto filtered = [=](image<float>& out, const auto& threads) {
        return [=, &out] {
            umbrage::visibility(s->depth, umbrage::depth32f{}, s->receivers, umbrage::filters::box{2}, out, threads);
        };
    };
    against_one("PCF 5x5, float map", 1.75, bench::pixels, filtered(s->two, two_threads),
                filtered(s->one, umbrage::serial{}), same);
    const auto drawn = [=](const bench::mesh& mesh, image<float>& out, const auto& threads) {
        return [=, &mesh, &out] {
            std::ranges::fill(out.texels(), 1.0f);
            umbrage::rasterize_depth(out, mesh, glm::mat4(1.0f), {}, umbrage::cull_mode::none, threads);
        };
    };
    for (const bool large : {false, true}) {
        const bench::mesh& mesh = large ? s->large : s->hills;
        against_one(large ? "depth pass, 100-pixel triangles" : "depth pass, hills", 1.75,
                    double(mesh.triangles.size()), drawn(mesh, s->two, two_threads),
                    drawn(mesh, s->one, umbrage::serial{}), same);
    }
});

}  // namespace
