// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>

#include <glm/vec2.hpp>

#include <umbrage/images/blur.hpp>

#include "bench.hpp"
#include "data.hpp"
#ifdef UMBRAGE_BENCH_OPENCV
#include "peers/opencv.hpp"
#endif

namespace {

constexpr glm::ivec2 size{1024, 1024};
constexpr double texels = 1024.0 * 1024.0;
constexpr float sigma = 1.5f;

struct state {
    umbrage::image<glm::vec2> moments{size}, ours{size}, theirs{size};
    umbrage::blur_kernel kernel = umbrage::make_gaussian_kernel(7, sigma);
    state() {
        const umbrage::image<float> map = bench::make_map();
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const float d = map[{x, y}];
                moments[{x, y}] = {d, d * d};
            }
    }
    [[nodiscard]] bool close() const {
        return std::ranges::equal(ours.texels(), theirs.texels(), [](glm::vec2 a, glm::vec2 b) {
            return std::abs(a.x - b.x) < 1e-6f && std::abs(a.y - b.y) < 1e-6f;
        });
    }
};

const bench::registration rows([] {
    const auto s = std::make_shared<state>();
    const std::string work = "Gaussian 7 taps, two floats, 1024 x 1024";
    const auto ours = [s] { umbrage::blur(s->moments.view(), s->ours.view(), s->kernel); };
    bench::add(
        {.work = work,
         .peer = "memcpy",
         .items = texels,
         .ours = ours,
         .theirs = [s] { std::memcpy(s->theirs.texels().data(), s->moments.texels().data(), sizeof(glm::vec2) << 20); },
         .agree = {}});
#ifdef UMBRAGE_BENCH_OPENCV
    const auto close = [s] { return s->close(); };
    bench::add({.work = work,
                .peer = "OpenCV GaussianBlur",
                .at_least = 1.3,
                .items = texels,
                .ours = ours,
                .theirs = [s] { peers::opencv::gaussian_7(s->moments, s->theirs, double(sigma)); },
                .agree = close});
    const auto& w = s->kernel.weights;
    const std::array<float, 7> taps{w[3], w[2], w[1], w[0], w[1], w[2], w[3]};
    bench::add({.work = work,
                .peer = "OpenCV sepFilter2D",
                .at_least = 1.3,
                .items = texels,
                .ours = ours,
                .theirs = [s, taps] { peers::opencv::separable_7(s->moments, s->theirs, taps); },
                .agree = close});
#endif
});

}  // namespace
