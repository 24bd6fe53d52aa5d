// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>

#include <umbrage/depth/depth32f.hpp>
#include <umbrage/depth/encoding.hpp>
#include <umbrage/depth/rg.hpp>

namespace {

/// A user's own: all that functions over images ask for.
struct halves {
    using texel = std::uint8_t;
    [[nodiscard]] texel encode(float depth) const { return depth < 0.5f ? 0 : 1; }
    [[nodiscard]] float decode(texel t) const { return t == 0 ? 0.5f : 1.0f; }
};

struct without_texel {
    [[nodiscard]] int encode(float) const { return 0; }
    [[nodiscard]] float decode(int) const { return 0.0f; }
};

struct returns_another : halves {
    [[nodiscard]] int encode(float) const { return 0; }
};

}  // namespace

TEST_CASE("encoding: texel, encode and decode make one; what it tells of itself makes it known") {
    static_assert(umbrage::encoding<halves> && !umbrage::known_encoding<halves>);
    static_assert(umbrage::known_encoding<umbrage::rg<11>> && umbrage::known_encoding<umbrage::depth32f>);
    static_assert(!umbrage::encoding<without_texel> && !umbrage::encoding<returns_another> && !umbrage::encoding<int>);
    static_assert(umbrage::has_edge<umbrage::rg<11>> && !umbrage::has_edge<umbrage::depth32f>);
    static_assert(umbrage::detail::is_encoding<halves>());
}

TEST_CASE("safe_edge: the far side of a code's interval") {
    using enum umbrage::depth_direction;
    CHECK(umbrage::detail::safe_edge(forward) == 1.0f);
    CHECK(umbrage::detail::safe_edge(reversed) == 0.0f);
}
