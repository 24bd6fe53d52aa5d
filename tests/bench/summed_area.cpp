// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <random>

#include <umbrage/images/summed_area.hpp>

#include "bench.hpp"
#include "data.hpp"
#ifdef UMBRAGE_BENCH_OPENCV
#include "peers/opencv.hpp"
#endif

namespace {

using bench::map_size;
using umbrage::image;

struct state {
    image<std::uint32_t> words, sums, byte_sums, their_sums;
    image<std::uint8_t> bytes;
    image<float> floats, float_sums, their_float_sums;
    explicit state(glm::ivec2 size)
        : words(size),
          sums(size),
          byte_sums(size),
          their_sums(size + 1),
          bytes(size),
          floats(size),
          float_sums(size),
          their_float_sums(size + 1) {
        std::mt19937 engine(9);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                bytes[{x, y}] = static_cast<std::uint8_t>(engine() >> 24);
                words[{x, y}] = bytes[{x, y}];
                floats[{x, y}] = bytes[{x, y}];
            }
    }
    template <class Ours, class Theirs, class Close>
    static bool agree(const image<Ours>& ours, const image<Theirs>& theirs, Close close) {
        for (int y = 0; y < ours.size().y; ++y)
            for (int x = 0; x < ours.size().x; ++x)
                if (!close(ours[{x, y}], theirs[{x + 1, y + 1}])) return false;
        return true;
    }
};

const bench::registration rows([] {
    const auto s = std::make_shared<state>(map_size);
    const auto copy = [s] {
        std::memcpy(s->their_sums.texels().data(), s->words.texels().data(), sizeof(std::uint32_t) << 22);
    };
    const auto words = [s] { umbrage::summed_area(s->words.view(), s->sums.view()); };
    const auto floats = [s] { umbrage::summed_area(s->floats.view(), s->float_sums.view()); };
    bench::add({.work = "summed-area table of uint32, 2048 x 2048",
                .peer = "memcpy",
                .at_least = 0.75,
                .items = bench::map_texels,
                .ours = words,
                .theirs = copy,
                .agree = {}});
    bench::add({.work = "summed-area table of floats, 2048 x 2048",
                .peer = "memcpy",
                .items = bench::map_texels,
                .ours = floats,
                .theirs = copy,
                .agree = {}});
#ifdef UMBRAGE_BENCH_OPENCV
    // OpenCV takes no integers wider than bytes: against our words its floats, of the same size.
    const auto their_floats = [s] { peers::opencv::integral(s->floats, s->their_float_sums); };
    const auto near = [](float a, float b) { return std::abs(a - b) <= 1e-3f * b; };
    bench::add({.work = "summed-area table of uint32, 2048 x 2048",
                .peer = "OpenCV integral, float",
                .at_least = 2,
                .items = bench::map_texels,
                .ours = words,
                .theirs = their_floats,
                .agree = [s] {
                    return state::agree(s->sums, s->their_float_sums, [](std::uint32_t a, float b) {
                        return std::abs(static_cast<float>(a) - b) <= 1e-3f * b;  // floats stop counting at 2^24
                    });
                }});
    bench::add({.work = "summed-area table of floats, 2048 x 2048",
                .peer = "OpenCV integral, float",
                .items = bench::map_texels,
                .ours = floats,
                .theirs = their_floats,
                .agree = [s, near] { return state::agree(s->float_sums, s->their_float_sums, near); }});
    const auto add_bytes = [](const char* work, const std::shared_ptr<state>& of) {
        bench::add({.work = work,
                    .peer = "OpenCV integral, bytes",
                    .at_least = 1.3,
                    .items = static_cast<double>(of->bytes.texels().size()),
                    .ours = [of] { umbrage::summed_area(of->bytes.view(), of->byte_sums.view()); },
                    .theirs = [of] { peers::opencv::integral(of->bytes, of->their_sums); },
                    .agree = [of] { return state::agree(of->byte_sums, of->their_sums, std::equal_to<>()); }});
    };
    add_bytes("summed-area table of bytes, 2048 x 2048", s);
    // 31 blocks of 64 texels and three quarters of one.
    add_bytes("summed-area table of bytes, 2032 x 2048", std::make_shared<state>(glm::ivec2(2032, 2048)));
#endif
});

}  // namespace
