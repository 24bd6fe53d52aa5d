// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/four_tap_hardware.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <string>

#include <umbrage/shader/glsl.hpp>

#include "../maps.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("four_tap_hardware: four_tap at the taps' texels", T, float, double) {
    using vec2 = glm::vec<2, T>;
    std::mt19937 random(6);
    const glm::ivec2 size(8, 4);  // powers of two: shares of them are exact
    const image<float> map = random_map(random, size);
    std::uniform_int_distribution<int> sixteenths(-48, 176);
    int partly = 0;
    for (int i = 0; i < 5000; ++i) {
        vec2 tap[4], uv[4];
        for (int k = 0; k < 4; ++k) {
            tap[k] = vec2(sixteenths(random), sixteenths(random)) / T(16);
            uv[k] = tap[k] / vec2(size);
        }
        const T receiver = T(i % 9) / T(8);
        const auto both = [&](auto is_lit) {
            const T got = four_tap_hardware(clamped(map), vec2(size), uv[0], uv[1], uv[2], uv[3], receiver, is_lit);
            CHECK(got == four_tap(clamped(map), tap[0], tap[1], tap[2], tap[3], receiver, is_lit));
            partly += got > 0 && got < 1;
        };
        both(less_equal{});
        both(greater_equal{});
    }
    CHECK(partly > 1000);
}

TEST_CASE("four_tap_hardware: lit far outside texel space, beyond the far plane, at NaN; a NaN receiver is in shadow") {
    const auto dark = [](glm::ivec2) { return 0.0f; };
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const glm::vec2 size(1024, 512), in(0.5f);
    const auto with = [&](glm::vec2 tap, float receiver) {
        const float first = four_tap_hardware(dark, size, tap, in, in, in, receiver);
        CHECK(four_tap_hardware(dark, size, in, in, in, tap, receiver) == first);
        return first;
    };
    for (const float bad : {nan, -nan, infinity, -infinity, 128.0f, -256.0f, 3e38f}) {
        CHECK(with({bad, 0.5f}, 0.5f) == 1.0f);
        CHECK(with({0.5f, bad + bad}, 0.5f) == 1.0f);
    }
    CHECK(with({120.0f, -1.0f}, 0.5f) == 0.0f);
    CHECK(with(in, 0.5f) == 0.0f);
    CHECK(with(in, 1.5f) == 1.0f);
    CHECK(with(in, nan) == 0.0f);
}

TEST_CASE("four_tap_hardware: the sampler reads where a map has one to itself") {
    using namespace umbrage::glsl;
    const auto text = [](const binding& map) { return glsl::text({bind(glsl::four_tap_hardware, "sun", map)}); };
    CHECK(text({.gather = true}).find("textureLod(map, uv, 0.0)") != std::string::npos);
    CHECK(text({}).find("umbrage_fetch_depth_sun(map, ") != std::string::npos);
}
