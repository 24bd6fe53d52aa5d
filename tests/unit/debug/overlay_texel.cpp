// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <umbrage/debug/overlay_texel.hpp>

using namespace umbrage;

namespace {

template <class T>
T shown(std::int64_t pixel, std::int64_t size, std::int64_t map_size, int ulp = 0) {
    T ratio = T(map_size) / T(size);
    for (int i = 0; i != ulp; i += ulp > 0 ? 1 : -1)
        ratio = std::nextafter(ratio, ulp > 0 ? std::numeric_limits<T>::max() : T(0));
    return overlay_texel(T(pixel) + T(0.5), T(size), T(map_size), ratio);
}

}  // namespace

TEST_CASE_TEMPLATE("overlay_texel: by hand", T, float, double) {
    CHECK(shown<T>(0, 4, 2) == 0);
    CHECK(shown<T>(1, 4, 2) == 0);
    CHECK(shown<T>(2, 4, 2) == 1);
    CHECK(shown<T>(3, 4, 2) == 1);
    CHECK(shown<T>(0, 1, 2) == 1);  // the center lies on an edge: the texel that begins there
    CHECK(shown<T>(1, 3, 12) == 6);
    CHECK(shown<T>(2047, 2048, 4096) == 4095);
    CHECK(shown<T>(63, 64, 65536) == 65024);
    CHECK(shown<T>(4, 4, 2) == -1);
    CHECK(shown<T>(-1, 4, 2) == -1);
    for (T outside : {std::numeric_limits<T>::infinity(), std::numeric_limits<T>::quiet_NaN(), T(1e30)})
        for (T sign : {T(1), T(-1)}) CHECK(overlay_texel(sign * outside, T(4), T(2), T(0.5)) == -1);
}

TEST_CASE_TEMPLATE("overlay_texel: every pixel of small overlays, found by walking over the texels", T, float, double) {
    int wrong = 0;
    for (int size = 1; size <= 48; ++size)
        for (int map_size = 1; map_size <= 96; ++map_size)
            for (int pixel = 0, texel = 0; pixel < size; ++pixel) {
                while (2 * size * (texel + 1) <= (2 * pixel + 1) * map_size) ++texel;
                for (int ulp : {-16, 0, 16}) wrong += shown<T>(pixel, size, map_size, ulp) != T(texel);
            }
    CHECK(wrong == 0);
}

TEST_CASE_TEMPLATE("overlay_texel: up to the largest sides, with quotients that are off", T, float, double) {
    constexpr bool is_float = sizeof(T) == sizeof(float);
    constexpr std::int64_t area = std::int64_t{1} << (is_float ? 23 : 52);
    std::mt19937_64 random(3);
    const auto up_to = [&](std::int64_t most) { return std::uniform_int_distribution<std::int64_t>(1, most)(random); };
    int wrong = 0;
    for (int i = 0; i < 400000; ++i) {
        const std::int64_t map_size = up_to(std::int64_t{1} << up_to(is_float ? 16 : 31));
        const std::int64_t most = std::min(area / map_size, std::int64_t{1} << 31), size = i % 4 ? up_to(most) : most;
        const std::int64_t pixel = i % 8 ? up_to(size) - 1 : size - 1;
        const auto center = static_cast<std::uint64_t>(2 * pixel + 1) * static_cast<std::uint64_t>(map_size);
        const int ulp = static_cast<int>(up_to(33)) - 17;
        wrong += shown<T>(pixel, size, map_size, ulp) != T(center / static_cast<std::uint64_t>(2 * size));
    }
    CHECK(wrong == 0);
}
