// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <utility>

#include <umbrage/depth/rg_level.hpp>

using namespace umbrage;

namespace {

static_assert(level_rg<11>(glm::vec2(1, 0)) == 1.0f && level_rg<11>(glm::vec2(0, 1)) == 8.0f);
static_assert(level_rg<16>(glm::vec2(1, 1)) == 257.0f);
static_assert(0.00392156886f == float(1.0 / 255.0));  // the literal of the GLSL twin

/// Number of codes and receivers around them for which the test is not that of decode_rg; reads `ulps` off.
template <int Bits>
int wrong(float edge, int ulps) {
    int count = 0;
    for (std::uint32_t x = 0; x < rg<Bits>::codes; ++x) {
        const glm::u8vec2 texel(x & 0xFF, (x >> 8) << (16 - Bits));
        glm::vec2 c = load_unorm(texel);
        for (int i = 0; i < 2; ++i)
            for (int n = std::abs(ulps); n > 0; --n) c[i] = std::nextafter(c[i], ulps < 0 ? -1.0f : 2.0f);
        const float at = decode_rg<Bits>(texel, edge), step = 1.0f / float(rg<Bits>::codes);
        for (const float depth :
             {at, std::nextafter(at, 2.0f), std::nextafter(at, -1.0f), at + step, at - step, at + step / 2})
            count += (receiver_rg<Bits>(depth, edge) <= level_rg<Bits>(c)) != (depth <= at || depth > 1.0f);
    }
    return count;
}

}  // namespace

TEST_CASE("receiver_rg, level_rg: the test of decode_rg, for every code, at, beside and between codes, in any read") {
    [&]<int... M>(std::integer_sequence<int, M...>) {
        for (const float edge : {lower_edge<float>, center<float>, upper_edge<float>})
            for (const int ulps : {0, -1, 1, 32}) CHECK((wrong<9 + M>(edge, ulps) + ...) == 0);
    }
    (std::make_integer_sequence<int, 8>());
}

TEST_CASE("receiver_rg: depths that no map holds") {
    const float top = level_rg<11>(glm::vec2(1, 224.0f / 255.0f)), infinity = std::numeric_limits<float>::infinity();
    CHECK(receiver_rg<11>(0.0f, 1.0f) <= 0.0f);  // nothing shadows the near plane
    CHECK(receiver_rg<11>(0.5f) == receiver_rg<11>(0.5f, upper_edge<float>));
    CHECK(receiver_rg<11>(-5.0f, 0.0f) <= 0.0f);
    CHECK(receiver_rg<11>(-infinity, 0.0f) <= 0.0f);
    CHECK(receiver_rg<11>(1.0f, 1.0f) <= top);                         // a cleared map shadows nothing up to 1
    CHECK(receiver_rg<11>(std::nextafter(1.0f, 2.0f), 1.0f) <= 0.0f);  // beyond the far plane nothing does
    CHECK(receiver_rg<11>(infinity, 1.0f) <= 0.0f);
    CHECK_FALSE(receiver_rg<11>(std::nanf(""), 1.0f) <= top);
    CHECK(receiver_rg<11>(1e-30f, 1.0f) <= 0.0f);  // 2^11 depth - 1 rounds to -1: still the first code's
}
