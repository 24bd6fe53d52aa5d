// SPDX-License-Identifier: MIT
//
// Gain of a second thread. Two processors of a machine may be two halves of one core. The gain of copies and
// multiplications is then the most that anything can gain. Or they may share no cache, and a virtual machine may change
// that from one minute to the next. If a number takes 400 ns to the other thread and back instead of 50, the depth pass
// by two threads takes a fifth to a third longer.
#include <algorithm>
#include <atomic>
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

#include <umbrage/draw/rasterize.hpp>
#include <umbrage/images/encode.hpp>
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

/// A number to the other thread and back, so often.
void send_to_and_fro(int rounds) {
    std::atomic<int> number = 0;
    two_threads(2, [&](int first, int last) {
        for (int side = first; side < last; ++side)
            for (int i = side; i < 2 * rounds; i += 2) {
                while (number != i) {}
                number = i + 1;
            }
    });
}

struct state {
    image<float> depth = bench::make_map(), back{bench::map_size}, back_too = back, one{bench::screen},
                 two{bench::screen};
    image<glm::u8vec2> packed{bench::map_size}, packed_too = packed;
    image<std::uint32_t> words{bench::map_size, 200u}, sums{bench::map_size}, sums_too = sums;
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

    // run(out, threads) writes the same with two threads as alone. What two processors give to two programs that know
    // nothing of each other is what they can give to one: twice on two threads, against two runs at once.
    const auto beside = [s](const std::string& work, double items, auto& out, auto& other, const auto& run) {
        const auto same = [run, &out, &other] {
            run(out, two_threads);
            run(other, umbrage::serial{});
            return std::ranges::equal(out.texels(), other.texels());
        };
        bench::add({.work = work + ", two threads",
                    .peer = "two runs side by side",
                    .at_least = 0.9,
                    .items = 2 * items,
                    .ours =
                        [run, &out, &other] {
                            run(out, two_threads);
                            run(other, two_threads);
                        },
                    .theirs =
                        [run, &out, &other] {
                            two_threads(2, [&](int first, int last) {
                                for (int i = first; i < last; ++i) run(i == 0 ? out : other, umbrage::serial{});
                            });
                        },
                    .agree = same,
                    .measured = bench::clock::wall});
    };
    const auto on_both = [=](const std::string& work, double at_least, int bytes, auto& out, auto& other,
                             const auto& run) {
        beside(work, bench::map_texels, out, other, run);
        bench::add({.work = work + ", two threads",
                    .peer = "memcpy, two threads",
                    .at_least = at_least,
                    .items = bench::map_texels,
                    .ours = [run, &out] { run(out, two_threads); },
                    .theirs = [=] { s->copy(bytes); },
                    .agree = {},
                    .measured = bench::clock::wall});
    };
    const umbrage::rg<11> rg;
    on_both("encode 11 bits", 0.9, 3, s->packed, s->packed_too,
            [=](auto& out, const auto& threads) { umbrage::encode(s->depth, out, rg, threads); });
    on_both("decode 11 bits", 0.9, 3, s->back, s->back_too,
            [=](auto& out, const auto& threads) { umbrage::decode(s->packed, out, rg, threads); });
    on_both("summed-area table of uint32", 0, 4, s->sums, s->sums_too,
            [=](auto& out, const auto& threads) { umbrage::summed_area(s->words.view(), out.view(), threads); });

    constexpr int products = 1000000;
    bench::add({.work = "limit: multiplications, two threads",
                .peer = "one thread",
                .items = products,
                .ours = [] { two_threads(products, multiply); },
                .theirs = [] { multiply(0, products); },
                .agree = {},
                .measured = bench::clock::wall});
    constexpr int rounds = 20000;
    bench::add({.work = "limit: a number to and fro, two threads",
                .peer = "multiplications, one thread",
                .items = rounds,
                .ours = [] { send_to_and_fro(rounds); },
                .theirs = [] { multiply(0, rounds); },
                .agree = {},
                .measured = bench::clock::wall});
    const auto against_one = [&](const std::string& work, double items, const auto& run) {
        beside(work, items, s->one, s->two, run);
        bench::add({.work = work + ", two threads",
                    .peer = "one thread",
                    .items = items,
                    .ours = [=] { run(s->one, two_threads); },
                    .theirs = [=] { run(s->two, umbrage::serial{}); },
                    .agree = {},
                    .measured = bench::clock::wall});
    };
    against_one("PCF 5x5, float map", bench::pixels, [s](image<float>& out, const auto& threads) {
        umbrage::visibility(s->depth, umbrage::depth32f{}, s->receivers, umbrage::filters::box{2}, out, threads,
                            umbrage::outside_map::clamped);
    });
    for (const bench::mesh* mesh : {&s->hills, &s->large})
        against_one(mesh == &s->large ? "depth pass, 100-pixel triangles" : "depth pass, hills",
                    double(mesh->triangles.size()), [s, mesh](image<float>& out, const auto& threads) {
                        threads(out.size().y, [&](int first, int last) {
                            std::fill(out.view().row(first), out.view().row(last - 1) + out.size().x, 1.0f);
                        });
                        umbrage::rasterize_depth(out, *mesh, glm::mat4(1.0f), umbrage::cpu_clip_space,
                                                 umbrage::cull_mode::none, threads);
                    });
});

}  // namespace
