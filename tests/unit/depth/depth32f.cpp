// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <limits>

#include <umbrage/depth/depth32f.hpp>

using namespace umbrage;

TEST_CASE("depth32f: clamps as the other encodings do, and gives back what it holds") {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK(depth32f{}.encode(1.5f) == 1.0f);
    CHECK(depth32f{}.encode(-1.0f) == 0.0f);
    CHECK(depth32f{}.encode(nan) == 1.0f);
    CHECK(depth32f{depth_direction::reversed}.encode(nan) == 0.0f);
    CHECK(depth32f{}.decode(0.3f) == 0.3f);
    CHECK(depth32f{}.decode(-2.0f) == -2.0f);  // a map of floats may hold anything
}
