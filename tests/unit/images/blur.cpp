// SPDX-License-Identifier: MIT
//
// The oracle is the documented sum, one texel after the other.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include <umbrage/images/blur.hpp>

#include "../fusing.hpp"
#include "isas.hpp"
#include "last_piece_first.hpp"

namespace {

using umbrage::blur_kernel;
using umbrage::image;
using umbrage::image_view;

/// Along x or along y.
template <class T>
image<T> plain(const image<T>& from, const blur_kernel& kernel, glm::ivec2 step) {
    image<T> to(from.size());
    const auto fetch = umbrage::clamped(from);
    for (int y = 0; y < from.size().y; ++y)
        for (int x = 0; x < from.size().x; ++x) {
            const glm::ivec2 t(x, y);
            T sum = kernel.weights[0] * from[t];
            for (int i = 1; i < static_cast<int>(kernel.weights.size()); ++i)
                sum = sum + kernel.weights[static_cast<std::size_t>(i)] * (fetch(t - i * step) + fetch(t + i * step));
            to[t] = sum;
        }
    return to;
}

/// The same bits; where sums may be fused, within what their terms round by: they are below 1, as is their sum.
template <class T>
bool agree(const T* got, const T* wanted, int count, const blur_kernel& kernel) {
    const auto size = static_cast<std::size_t>(count) * sizeof(T);
    if (!may_fuse) return std::memcmp(got, wanted, size) == 0;
    std::vector<float> a(size / sizeof(float)), b(a.size());
    std::memcpy(a.data(), got, size), std::memcpy(b.data(), wanted, size);
    const float bound = 2 * static_cast<float>(2 * kernel.weights.size()) * 0x1p-24f;  // two passes
    bool all = true;
    for (std::size_t i = 0; i < a.size(); ++i) all = all && std::abs(a[i] - b[i]) <= bound;
    return all;
}

template <class T>
void check() {
    constexpr int channels = static_cast<int>(sizeof(T) / sizeof(float));
    std::mt19937 engine(11);
    for (const glm::ivec2 size :
         {glm::ivec2(1, 1), glm::ivec2(2, 9), glm::ivec2(31, 1), glm::ivec2(64, 5), glm::ivec2(67, 23)}) {
        image<T> from(size);
        for (T& texel : from.texels()) {
            float values[channels];
            for (float& v : values) v = static_cast<float>(engine() >> 8) * 0x1p-24f;
            std::memcpy(&texel, values, sizeof texel);
        }
        for (const blur_kernel& kernel :
             {umbrage::make_binomial_kernel<1>(), umbrage::make_binomial_kernel<3>(),
              umbrage::make_gaussian_kernel(5, 0.8f), umbrage::make_gaussian_kernel(7, 1.5f),
              umbrage::make_binomial_kernel<9>(), umbrage::make_gaussian_kernel(21, 4.0f)}) {
            CAPTURE(channels);
            CAPTURE(size.x);
            CAPTURE(kernel.weights.size());
            const image<T> wanted = plain(plain(from, kernel, {0, 1}), kernel, {1, 0});
            for_each_isa([&] {
                for (int pieces : {1, 3, size.y}) {
                    std::vector<T> memory(static_cast<std::size_t>((size.x + 3) * size.y),
                                          T(7));  // rows with a gap behind
                    const image_view<T> to(memory.data(), size, (size.x + 3) * static_cast<std::ptrdiff_t>(sizeof(T)));
                    umbrage::blur(from.view(), to, kernel, last_piece_first{pieces});
                    int wrong = 0;
                    for (int y = 0; y < size.y; ++y) {
                        wrong += !agree(to.row(y), wanted.view().row(y), size.x, kernel);
                        for (int x = size.x; x < size.x + 3; ++x)
                            wrong += memory[static_cast<std::size_t>(y * (size.x + 3) + x)] != T(7);
                    }
                    CHECK(wrong == 0);
                }
            });
        }
    }
}

}  // namespace

TEST_CASE("blur: every path gives the bits of the written order, tier B") {
    check<float>();
    check<glm::vec2>();
    check<glm::vec3>();
    check<glm::vec4>();
}

TEST_CASE("blur: constant images stay, a point becomes the kernel") {
    const blur_kernel kernel = umbrage::make_binomial_kernel<5>();
    image<float> from({70, 9}, 0.625f), to({70, 9});
    umbrage::blur(from.view(), to.view(), kernel);
    CHECK(std::ranges::all_of(to.texels(), [](float v) { return v == 0.625f; }));
    from = image<float>({70, 9}, 0.0f);
    from[{40, 4}] = 256.0f;
    umbrage::blur(from.view(), to.view(), kernel);
    CHECK(to[{40, 4}] == 36.0f);
    CHECK(to[{41, 4}] == 24.0f);
    CHECK(to[{38, 2}] == 1.0f);
    CHECK(to[{43, 4}] == 0.0f);
}

TEST_CASE("make_binomial_kernel: Pascal's triangle") {
    CHECK(umbrage::make_binomial_kernel<1>().weights == std::vector<float>{1.0f});
    CHECK(umbrage::make_binomial_kernel<7>().weights ==
          std::vector<float>{20.0f / 64.0f, 15.0f / 64.0f, 6.0f / 64.0f, 1.0f / 64.0f});
    const auto wide = umbrage::make_binomial_kernel<25>().weights;
    CHECK(wide[0] == 2704156.0f / 16777216.0f);
    CHECK(wide[12] == 1.0f / 16777216.0f);
}

TEST_CASE("make_gaussian_kernel: the bell's shape, a sum of 1") {
    for (int taps : {1, 3, 7, 31}) {
        const auto w = umbrage::make_gaussian_kernel(taps, 2.0f).weights;
        REQUIRE(w.size() == static_cast<std::size_t>(taps / 2 + 1));
        double sum = w[0];
        for (std::size_t i = 1; i < w.size(); ++i) sum += 2.0 * double(w[i]);
        CHECK(sum == doctest::Approx(1.0).epsilon(1e-6));
        for (std::size_t i = 1; i < w.size(); ++i)
            CHECK(double(w[i] / w[0]) ==
                  doctest::Approx(std::pow(std::numbers::e, -double(i * i) / 8.0)).epsilon(1e-6));
    }
    const auto flat = umbrage::make_gaussian_kernel(5, std::numeric_limits<float>::infinity()).weights;
    CHECK(flat == std::vector<float>(3, 0.2f));
    const auto sharp = umbrage::make_gaussian_kernel(5, std::numeric_limits<float>::denorm_min()).weights;
    CHECK(sharp == std::vector<float>{1.0f, 0.0f, 0.0f});
}

TEST_CASE("blur, make_gaussian_kernel: bad input") {
    image<float> small({2, 2}), large({2, 3}), none;
    const blur_kernel kernel = umbrage::make_binomial_kernel<3>();
    CHECK_THROWS_AS(umbrage::blur(small.view(), large.view(), kernel), std::invalid_argument);
    CHECK_THROWS_AS(umbrage::blur(small.view(), small.view(), kernel), std::invalid_argument);
    CHECK_THROWS_AS(umbrage::blur(small.view(), image<float>({2, 2}).view(), blur_kernel{}), std::invalid_argument);
    umbrage::blur(none.view(), none.view(), kernel);
    CHECK_THROWS_AS((void)umbrage::make_gaussian_kernel(4, 1.0f), std::invalid_argument);
    CHECK_THROWS_AS((void)umbrage::make_gaussian_kernel(-1, 1.0f), std::invalid_argument);
    CHECK_THROWS_AS((void)umbrage::make_gaussian_kernel(3, 0.0f), std::invalid_argument);
    CHECK_THROWS_AS((void)umbrage::make_gaussian_kernel(3, std::nanf("")), std::invalid_argument);
}

TEST_CASE("blur: views of one image, refused where they have a texel in common") {
    const blur_kernel kernel = umbrage::make_binomial_kernel<3>();
    image<float> memory({12, 10});
    for (std::size_t i = 0; i < memory.texels().size(); ++i) memory.texels()[i] = static_cast<float>(i * i % 31);
    const auto part = [&](glm::ivec2 first, glm::ivec2 extent, bool flipped) {
        const auto view = memory.view().region(first, extent);
        return flipped ? image_view<float>(view.row(extent.y - 1), extent, -view.stride) : view;
    };
    int refused = 0, taken = 0, wrong = 0;
    for (const glm::ivec2 extent : {glm::ivec2(4, 3), {5, 1}, {1, 5}, {12, 5}})
        for (int at = 0; at < 12 * 10 * 4; ++at) {
            const glm::ivec2 a(3 % (13 - extent.x), 4), b(at % 12, at / 12 % 10), apart = glm::abs(a - b);
            if (a.y + extent.y > 10 || b.x + extent.x > 12 || b.y + extent.y > 10) continue;
            const auto from = part(a, extent, at / 120 % 2 == 1), to = part(b, extent, at / 240 == 1);
            const bool common = apart.x < extent.x && apart.y < extent.y;
            const image<float> before = memory;
            image<float> alone(extent);
            umbrage::blur(from, alone.view(), kernel);
            if (common) {
                CHECK_THROWS_AS(umbrage::blur(from, to, kernel), std::invalid_argument);
                ++refused;
            } else {
                umbrage::blur(from, to, kernel);
                ++taken;
                for (int y = 0; y < extent.y; ++y)
                    wrong += std::memcmp(to.row(y), alone.view().row(y), sizeof(float) * std::size_t(extent.x)) != 0;
            }
            memory = before;
        }
    CHECK(refused > 100);
    CHECK(taken > 300);
    CHECK(wrong == 0);
    const image_view<float> wide(memory.view().row(0), {12, 2}, 48 * 4), odd(memory.view().row(1), {12, 2}, 48);
    umbrage::blur(wide, odd, kernel);  // rows 0 and 4, rows 1 and 2
    const image_view<float> next(memory.view().row(3), {12, 2}, 48);
    CHECK_THROWS_AS(umbrage::blur(wide, next, kernel), std::invalid_argument);
    CHECK_THROWS_AS(umbrage::blur(next, wide, kernel), std::invalid_argument);
}
