// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/reduce.hpp>

#include <doctest/doctest.h>

#include <random>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <umbrage/images/blur.hpp>

#include "../../fusing.hpp"

using namespace umbrage;

namespace {

template <int Taps>
int differences(const image<glm::vec4>& map) {
    image<glm::vec4> columns(map.size()), blurred(map.size());
    blur(map, blurred, make_binomial_kernel<Taps>());
    const auto each = [&](const auto& use) {
        for (int y = 0; y < map.size().y; ++y)
            for (int x = 0; x < map.size().x; ++x) use(glm::ivec2(x, y));
    };
    each([&](glm::ivec2 at) { columns[at] = blur_row<Taps>(clamped(map), at, glm::ivec2(0, 1)); });
    int wrong = 0;
    each([&](glm::ivec2 at) {
        const glm::vec4 twice = blur_row<Taps>(clamped(columns), at, glm::ivec2(1, 0));
        // fused, tier B is off by what its terms round by, all of them positive
        wrong += may_fuse ? glm::any(glm::greaterThan(glm::abs(twice - blurred[at]), twice * (2 * Taps * 0x1p-24f)))
                          : twice != blurred[at];
    });
    return wrong;
}

}  // namespace

TEST_CASE("blur_row: two of them are blur's bits, also of powers near the greatest float") {
    std::mt19937 random(2);
    image<glm::vec4> map({21, 13});
    for (glm::vec4& texel : map.texels())
        for (int c = 0; c < 4; ++c) texel[c] = static_cast<float>(random()) * (c == 3 ? 0x1p88f : 0x1p-32f);
    CHECK(differences<3>(map) == 0);
    CHECK(differences<5>(map) == 0);
    CHECK(differences<7>(map) == 0);
}

TEST_CASE("blur_row: five taps both ways are exact over codes of 16 bits") {
    std::mt19937 random(4);
    image<float> map({9, 9}), columns({9, 9});
    image<double> exact({9, 9}), exact_columns({9, 9});
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x) exact[{x, y}] = map[{x, y}] = static_cast<float>(random() % 65536) / 65536.0f;
    int wrong = 0;
    const auto each = [](const auto& use) {
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 9; ++x) use(glm::ivec2(x, y));
    };
    each([&](glm::ivec2 at) {
        columns[at] = blur_row<5>(clamped(map), at, glm::ivec2(0, 1));
        exact_columns[at] = blur_row<5>(clamped(exact), at, glm::ivec2(0, 1));
    });
    each([&](glm::ivec2 at) {
        wrong += double(blur_row<5>(clamped(columns), at, glm::ivec2(1, 0))) !=
                 blur_row<5>(clamped(exact_columns), at, glm::ivec2(1, 0));
    });
    CHECK(wrong == 0);
}

TEST_CASE("halve_texels: mean of four, the last counts twice where there is no other") {
    image<glm::vec2> map({3, 3});
    for (int i = 0; i < 9; ++i) map[{i % 3, i / 3}] = glm::vec2(static_cast<float>(i), 1.0f);
    CHECK(halve_texels(clamped(map), {0, 0}) == glm::vec2(2.0f, 1.0f));
    CHECK(halve_texels(clamped(map), {1, 0}) == glm::vec2(3.5f, 1.0f));
    CHECK(halve_texels(clamped(map), {1, 1}) == glm::vec2(8.0f, 1.0f));
}
