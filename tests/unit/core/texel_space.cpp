// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>

#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/four_tap.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>

#include "../fusing.hpp"
#include "../filter/maps.hpp"

using namespace umbrage;

TEST_CASE("inside_texel_space: below 2^15, NaN outside") {
    for (float inside :
         {0.0f, -0.0f, 1e-45f, -1.0f, 32767.0f, std::nextafter(32768.0f, 0.0f), std::nextafter(-32768.0f, 0.0f)}) {
        CHECK(inside_texel_space(glm::vec2(inside, 1)));
        CHECK(inside_texel_space(glm::vec2(1, inside)));
        CHECK(inside_texel_space(glm::dvec2(inside, inside)));
    }
    for (glm::vec2 outside : coordinates_outside_texel_space()) {
        CHECK_FALSE(inside_texel_space(outside));
        CHECK_FALSE(inside_texel_space(glm::dvec2(outside)));
    }
    static_assert(inside_texel_space(glm::vec2(1, 2)) && !inside_texel_space(glm::vec2(1, 32768)));
}

TEST_CASE("inside_texel_space: outside of it no filter fetches and all are lit") {
    int fetched = 0;
    const auto dark = [&](glm::ivec2) { return ++fetched, -1.0f; };
    for (glm::vec2 c : coordinates_outside_texel_space()) {
        CHECK(hard(dark, c, 0.5f) == 1.0f);
        CHECK(four_tap(dark, c, c, c, c, 0.5f) == 1.0f);
        CHECK(pcf_2x2(dark, c, 0.5f) == 1.0f);
        CHECK(pcf_2x2_dx_sdk(dark, c, 0.5f, 0.0f) == 1.0f);
        for (int radius = 0; radius <= max_box_radius; ++radius) CHECK(box(dark, c, 0.5f, radius) == 1.0f);
    }
    CHECK(fetched == 0);
}

TEST_CASE("fetch_depth: the callable's answer") {
    image<float> map({2, 1});
    map[{0, 0}] = 0.25f, map[{1, 0}] = 0.75f;
    CHECK(fetch_depth(clamped(map), {-5, 9}) == 0.25f);
    CHECK(fetch_depth(bordered(map, 0.5f), {-1, 0}) == 0.5f);
}

TEST_CASE_TEMPLATE("depth_at: the texel's under a point of the map", T, float, double) {
    using vec2 = glm::vec<2, T>;
    image<T> map({4, 2}, T(0.25));
    map[{3, 1}] = T(0.75);
    const vec2 size(4, 2);
    CHECK(depth_at(clamped(map), size, vec2(0.875, 0.75)) == T(0.75));
    CHECK(depth_at(clamped(map), size, vec2(0.875, 0.25)) == T(0.25));
    CHECK(depth_at(clamped(map), size, vec2(0.75, 0.5)) == T(0.75));  // its first corner
    CHECK(depth_at(clamped(map), size, vec2(1.5, 1.5)) == T(0.75));   // outside, the nearest one
}

TEST_CASE("decoded: a packed map filters as the map of its decoded depths") {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> depth(0, 1), coordinate(-2, 10);
    const glm::ivec2 size(9, 7);
    const auto check = [&](auto encoding) {
        constexpr const glsl::snippet* reader = decltype(encoding)::reader;
        constexpr bool ties_differ = may_fuse && reader && reader->exactness == glsl::tier::b;
        image<typename decltype(encoding)::texel> packed(size);
        image<float> plain(size);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                packed[{x, y}] = encoding.encode(depth(random));
                plain[{x, y}] = encoding.decode(packed[{x, y}]);
            }
        int unlike = 0;
        for (int i = 0; i < 500; ++i) {
            const glm::vec2 c(coordinate(random), coordinate(random));
            // a reader of tier B may be fused in one place and not in another: then a tie goes either way
            const float receiver = i % 3 || ties_differ ? depth(random) : plain[{i % size.x, i % size.y}];
            unlike += hard(decoded(packed, encoding), c, receiver) != hard(bordered(plain), c, receiver);
            unlike += pcf_2x2(decoded(packed.view(), encoding), c, receiver) != pcf_2x2(bordered(plain), c, receiver);
            unlike += box(decoded(packed, encoding), c, receiver, 2) != box(bordered(plain), c, receiver, 2);
            const float at_edge = box(clamped(plain), c, receiver, 2);
            unlike += box(decoded(clamped(packed), encoding), c, receiver, 2) != at_edge;
            unlike += box(clamped(decoded(packed, encoding)), c, receiver, 2) != at_edge;
        }
        CHECK(unlike == 0);
    };
    for_each_encoding(check);
    check(rg<11>{.edge = lower_edge<float>});
    for_each_encoding([&](auto encoding) {
        const image<typename decltype(encoding)::texel> dark({1, 1}, encoding.encode(0.25f));
        CHECK(hard(decoded(clamped(dark), encoding), glm::vec2(-1), 0.5f) == 0.0f);
        CHECK(hard(clamped(decoded(dark, encoding)), glm::vec2(-1), 0.5f) == 0.0f);
        CHECK(hard(decoded(dark, encoding), glm::vec2(-1), 0.5f) == 1.0f);
    });
    CHECK(decoded(image<glm::u8vec2>(), rg<11>{})({0, 0}) == 1.0f);  // an empty map is all border
    CHECK_THROWS_AS((void)clamped(decoded(image<glm::u8vec2>(), rg<11>{})), std::invalid_argument);
}

TEST_CASE("decoded, bordered: in either order, texels outside are the far plane, whichever way depth runs") {
    for_each_encoding([&]<class Encoding>(Encoding encoding) {
        for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
            encoding = {.direction = direction};
            image<typename Encoding::texel> map({3, 2}, encoding.encode(0.25f));
            map[{1, 1}] = encoding.encode(0.75f);
            CAPTURE(Encoding::name);
            for (int y = -2; y < 4; ++y)
                for (int x = -2; x < 5; ++x) {
                    const glm::ivec2 texel(x, y);
                    const float wanted =
                        inside_map(map.size(), texel) ? encoding.decode(map[texel]) : cleared_depth(direction);
                    CHECK(bordered(decoded(map, encoding))(texel) == wanted);
                    CHECK(decoded(map, encoding)(texel) == wanted);
                    CHECK(decoded(map.view(), encoding)(texel) == wanted);
                    CHECK(decoded(bordered(map, encoding.cleared()), encoding)(texel) == wanted);
                    if constexpr (!std::is_floating_point_v<typename Encoding::texel>)
                        CHECK(decoded(bordered(map), encoding)(texel) == wanted);
                }
        }
    });
}

TEST_CASE_TEMPLATE("map_covers: from the first texel's edge to the last one's", T, float, double) {
    using vec = glm::vec<2, T>;
    const vec size(3, 2);
    CHECK(map_covers(size, vec(0, 0)));
    CHECK(map_covers(size, vec(2.75, 1.75)));
    for (const vec outside : {vec(3, 1), vec(1, 2), vec(-0.125, 1), vec(1, -0.125), vec(400, 1)}) {
        CHECK_FALSE(map_covers(size, outside));
        CHECK(map_covers(size, outside, outside_map::clamped));
    }
}

TEST_CASE("decoded: with the upper edge no surface shadows itself, with the lower edge it does") {
    const auto fractions = [](auto encoding, int step) {
        int dark = 0, tried = 0;
        for (int k = 0; k <= 1 << 24; k += step, ++tried) {
            const float depth = static_cast<float>(k) / static_cast<float>(1 << 24);
            const float stored = encoding.decode(encoding.encode(depth));
            const auto everywhere = [=](glm::ivec2) { return stored; };
            const glm::vec2 c(3.3f, 4.7f);
            dark += hard(everywhere, c, depth) != 1 || pcf_2x2(everywhere, c, depth) != 1;
        }
        CHECK(tried > 10000);
        return dark;
    };
    for_each_encoding([&](const auto& encoding) {
        if (encoding.error().below == 0.0) CHECK(fractions(encoding, 251) == 0);
    });
    CHECK(fractions(rg<11>{.edge = lower_edge<float>}, 251) > 60000);
    CHECK(fractions(rg<11>{.edge = center<float>}, 251) > 30000);
}

TEST_CASE("decoded: reversed, it is the lower edge that keeps a surface from shadowing itself") {
    int dark_lower = 0, dark_upper = 0;
    for (int k = 0; k <= 1 << 24; k += 251) {
        const float depth = static_cast<float>(k) / static_cast<float>(1 << 24);
        const auto stored = [&](float edge) {
            return [=](glm::ivec2) { return rg<11>{.edge = edge}.decode(rg<11>{}.encode(depth)); };
        };
        dark_lower += hard(stored(lower_edge<float>), glm::vec2(1), depth, greater_equal{}) != 1;
        dark_upper += hard(stored(upper_edge<float>), glm::vec2(1), depth, greater_equal{}) != 1;
    }
    CHECK(dark_lower == 0);
    CHECK(dark_upper > 60000);
}

TEST_CASE("greater_equal: reversed maps filter as forward maps, bit for bit") {
    std::mt19937 random(2);
    const glm::ivec2 size(8, 6);
    const image<float> map = random_map(random, size);
    image<float> reversed(size);
    for (std::size_t i = 0; i < map.texels().size(); ++i) reversed.texels()[i] = 1.0f - map.texels()[i];
    const auto f = clamped(map), r = clamped(reversed);
    const greater_equal ge;
    std::uniform_real_distribution<float> coordinate(-3, 11);
    std::uniform_int_distribution<int> step(-1, 33);
    int partly = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::vec2 c(coordinate(random), coordinate(random)), d(coordinate(random), coordinate(random));
        const float z = static_cast<float>(step(random)) / 32.0f;
        const float pcf = pcf_2x2(f, c, z);
        CHECK_FALSE(pcf != pcf_2x2(r, c, 1 - z, ge));
        CHECK_FALSE(hard(f, c, z) != hard(r, c, 1 - z, ge));
        CHECK_FALSE(four_tap(f, c, d, c + d, c - d, z) != four_tap(r, c, d, c + d, c - d, 1 - z, ge));
        CHECK_FALSE(box(f, c, z, i % 10 - 1) != box(r, c, 1 - z, i % 10 - 1, ge));
        partly += pcf > 0 && pcf < 1;
    }
    CHECK(partly > 1000);
}
