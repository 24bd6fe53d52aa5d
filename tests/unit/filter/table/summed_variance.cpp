// SPDX-License-Identifier: MIT
//
// Boxes of a table against sums over their texels in wide integers, and visibility against the formula in double.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include <umbrage/images/variance_table.hpp>

#include "../../special_values.hpp"
#include "../maps.hpp"

using namespace umbrage;

namespace {

struct box {
    glm::ivec2 first, end;
    std::int64_t count = 0, sum = 0, squares = 0;
};

std::int64_t code_of(float depth, const variance_table& of) {
    const auto x =
        std::min(static_cast<std::int64_t>(double(depth) * std::ldexp(1.0, of.bits)), (std::int64_t(1) << of.bits) - 1);
    return of.direction == depth_direction::forward ? x : (std::int64_t(1) << of.bits) - 1 - x;
}

/// The box around a texel, clipped to the map, texel by texel.
box around(const image<float>& map, const variance_table& of, glm::ivec2 texel, int radius) {
    const glm::ivec2 middle = glm::clamp(texel, glm::ivec2(0), map.size() - 1);
    box b{glm::max(middle - radius, glm::ivec2(0)), glm::min(middle + radius + 1, map.size())};
    for (int y = b.first.y; y < b.end.y; ++y)
        for (int x = b.first.x; x < b.end.x; ++x) {
            const std::int64_t code = code_of(map[{x, y}], of);
            ++b.count, b.sum += code, b.squares += code * code;
        }
    return b;
}

/// Chebyshev's bound in double.
double chebyshev(const box& b, double receiver) {
    const double n = double(b.count), mean = double(b.sum) / n;
    const double variance = double(b.count * b.squares - b.sum * b.sum) / (n * n), d = receiver - 1 - mean;
    return d <= 0 ? 1.0 : variance / (variance + d * d);
}

void check(const variance_table& of, glm::ivec2 size) {
    std::mt19937 random(static_cast<unsigned>(of.bits));
    image<float> map(size);
    for (float& d : map.texels()) d = static_cast<float>(random() % 4097) / 4096.0f;
    for (int y = 0; y < size.y / 2; ++y)  // and some of one depth
        for (int x = 0; x < size.x / 2; ++x) map[{x, y}] = 0.4375f;
    const auto table = make_variance_table(map.view(), of);
    const auto fetch = [&](glm::ivec2 t) { return glm::dvec4(table[t]); };
    const auto codes = static_cast<float>(1 << of.bits);
    int wrong = 0, darker = 0, partly = 0;
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        const float x = static_cast<float>(random() % 65536) / 65536.0f,
                    y = static_cast<float>(random() % 65536) / 65536.0f;
        const glm::vec2 coord = glm::vec2(x, y) * glm::vec2(size + 40) - 20.0f;
        const int radius = static_cast<int>(random() % static_cast<unsigned>(of.radius + 1));
        const box b = around(map, of, glm::ivec2(glm::floor(coord)), radius);
        const auto m = box_moments<double>(fetch, b.first, b.end);
        const auto m32 = box_moments<float>([&](glm::ivec2 t) { return glm::vec4(table[t]); }, b.first, b.end);
        const std::int64_t mean = b.sum / b.count, rest = b.sum % b.count;
        const std::int64_t squared = b.squares - 2 * mean * b.sum + b.count * mean * mean;
        wrong += m != glm::dvec4(double(mean), double(rest), double(squared >> 12), double(squared & 4095));
        wrong += glm::dvec4(m32) != m;

        const bool forward = of.direction == depth_direction::forward;
        const float receiver = static_cast<float>(random() % 8193) / 8192.0f;
        const double t = double(codes) * (forward ? double(receiver) : 1.0 - double(receiver));
        const float seen = summed_variance([&](glm::ivec2 at) { return glm::vec4(table[at]); }, size, coord, receiver,
                                           static_cast<float>(radius), codes, umbrage::comparison{of.direction},
                                           umbrage::outside_map::clamped);
        worst = std::max(worst, std::abs(double(seen) - chebyshev(b, t)));
        int lit = 0;
        for (int v = b.first.y; v < b.end.y; ++v)
            for (int u = b.first.x; u < b.end.x; ++u) lit += t <= double(code_of(map[{u, v}], of) + 1);
        darker += double(seen) < double(lit) / double(b.count) - 0x1p-16;
        partly += seen > 0.0f && seen < 1.0f;
    }
    CAPTURE(of.bits);
    CHECK(wrong == 0);
    CHECK(darker == 0);
    CHECK(worst < 0x1p-16);
    CHECK(partly > 100);
}

}  // namespace

TEST_CASE("box_moments, summed_variance: wide integers, tables wrapped often, and never darker than the lit share") {
    check({.bits = 11, .radius = 16}, {401, 300});  // squares' sums pass 2^32 a hundred times
    check({.bits = 8, .radius = 40, .direction = depth_direction::reversed}, {201, 97});
    check({.bits = 12, .radius = 5}, {64, 65});
    check({.bits = 1, .radius = 3, .direction = depth_direction::reversed}, {7, 1});
}

TEST_CASE("summed_variance: two depths by hand, and what is out of range") {
    image<float> map({3, 1}, 0.25f);
    map[{2, 0}] = 0.75f;
    const auto table = make_variance_table(map.view(), {.bits = 8, .radius = 1});
    const auto fetch = [&](glm::ivec2 t) { return glm::vec4(table[t]); };
    const auto seen = [&](float x, float receiver) {
        return summed_variance(fetch, map.size(), glm::vec2(x, 0.5f), receiver, 1.0f, 256.0f);
    };
    CHECK(box_moments<float>(fetch, {0, 0}, {3, 1}) == glm::vec4(106.0f, 2.0f, 2.0f, 2732.0f));  // 2 42^2 + 86^2
    CHECK(seen(0.5f, 0.25f) == 1.0f);
    CHECK(seen(0.5f, 0.26f) == 0.0f);                          // both texels at 1/4: no variance
    CHECK(std::abs(seen(1.5f, 0.75f) - 2.0f / 6.0f) < 0.01f);  // a third sees it, two do not
    CHECK(seen(-300.0f, 0.25f) == 1.0f);                       // the nearest box
    for (const float beyond : {1.01f, inf32}) CHECK(seen(1.5f, beyond) == 1.0f);
    CHECK(seen(1.5f, nan32) == 0.0f);
    CHECK(seen(1.5f, -inf32) == 1.0f);
    for (const glm::vec2 outside : coordinates_outside_texel_space())
        CHECK(summed_variance(fetch, map.size(), outside, 0.9f, 1.0f, 256.0f) == 1.0f);
    const auto of = [&](auto radius) {
        using T = decltype(radius);
        const auto texels = [&](glm::ivec2 t) { return glm::vec<4, T>(table[t]); };
        return summed_variance(texels, map.size(), glm::vec<2, T>(1.5, 0.5), T(0.75), radius, T(256));
    };
    for (const float none : {-0.5f, -1.0f, -1e30f, -inf32, nan32, -nan32}) CHECK(of(none) == of(0.0f));
    for (const float all : {32767.0f, 1e30f, inf32}) CHECK(of(all) == of(3.0f));
    CHECK(of(1e300) == of(3.0));
}
