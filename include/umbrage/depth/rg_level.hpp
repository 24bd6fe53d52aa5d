// SPDX-License-Identifier: MIT
//
// The shadow test on maps of encode_rg without decoding them: one multiply-add a texel. The receiver is brought to the
// scale of the channels' sum once, halfway between two codes, so that no rounding of a texel's read can tip the test.
//
//     bool lit = umbrage::receiver_rg<11>(depth, umbrage::upper_edge<float>) <= umbrage::level_rg<11>(sampled);
//
// In a shader the filter is bound to
//
//     {.depth = "umbrage_level_rg11(value.xy)", .channels = 2, .needs = {glsl::level_rg<11>}}
//
// and takes umbrage_receiver_rg11(depth, 1.0) for the receiver; its visibility is that of decode_rg, to the bit.
#pragma once

#include <cmath>
#include <string>

#include <glm/vec2.hpp>

#include <umbrage/core/compare.hpp>
#include <umbrage/depth/rg.hpp>

namespace umbrage {

/// @param c       the two channels of encode_rg<Bits> as sampled, k / 255
/// @return        x / 255, x the code; with Bits = 11, eight times decode_ps14
/// @formula       r + 2^(Bits - 8) g
/// @exactness     B, n = 4: one rounded addition, of an exact product
template <int Bits, real T>
[[nodiscard]] constexpr T level_rg(glm::vec<2, T> c) {
    static_assert(Bits >= 9 && Bits <= 16);
    return c.x + c.y * T(1 << (Bits - 8));
}

/// @param depth   of the receiver, biased; beyond the far plane: -1, which every texel lights; NaN is in shadow, for no
///                comparison with it holds
/// @param edge    the one decode_rg would be given
/// @return        receiver_rg(depth, edge) <= level_rg(c) exactly when depth <= decode_rg(c, edge), for texels c within
///                2^-18 of k / 255. For less_equal_scaled only, not for reversed Z.
/// @formula       depth > 1 ? -1 : (ceil(depth 2^Bits - edge) - 1/2) / 255
/// @exactness     B, n = 2: products and sums round once each; the test that it is made for is exact
template <int Bits, real T>
[[nodiscard]] T receiver_rg(T depth, T edge) {
    static_assert(Bits >= 9 && Bits <= 16);
    if (less_equal::beyond_far_plane(depth)) return T(-1);
    return (std::ceil(depth * T(1 << Bits) - edge) - T(0.5)) * T(1.0 / 255.0);
}

namespace glsl {

template <int Bits>
inline constexpr detail::short_name level_rg_name("level_rg$b", {{'b', Bits}});
template <int Bits>
[[nodiscard]] std::string level_rg_text() {
    return detail::filled(R"GLSL(
// umbrage_level_rg$b: two channels of a $b-bit code, as sampled, to the scale of umbrage_receiver_rg$b, on which 1.0 is
//   not the far plane
UMBRAGE_HIGHP float umbrage_level_rg$b(UMBRAGE_HIGHP vec2 c) {
    return c.x + c.y * $g.0;  // an exact product: fused or not, it rounds once
}
)GLSL",
                          {{'b', Bits}, {'g', 1 << (Bits - 8)}});
}
template <int Bits>
inline constexpr snippet level_rg{.name = level_rg_name<Bits>.view(),
                                  .summary = "two channels to a level to compare with",
                                  .exactness = tier::b,
                                  .operations = 4,
                                  .scaled = true,
                                  .source = level_rg_text<Bits>};

template <int Bits>
inline constexpr detail::short_name receiver_rg_name("receiver_rg$b", {{'b', Bits}});
template <int Bits>
[[nodiscard]] std::string receiver_rg_text() {
    return detail::filled(R"GLSL(
// umbrage_receiver_rg$b: receiver on the scale of umbrage_level_rg$b: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg$b(texel, edge), or beyond the far plane
UMBRAGE_HIGHP float umbrage_receiver_rg$b(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float edge) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float level = (ceil(depth * $n.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
)GLSL",
                          {{'b', Bits}, {'n', 1 << Bits}});
}
template <int Bits>
inline constexpr snippet receiver_rg{.name = receiver_rg_name<Bits>.view(),
                                     .summary = "receiver to a level, for maps that are not decoded",
                                     .exactness = tier::b,
                                     .operations = 2,
                                     .source = receiver_rg_text<Bits>};

/// Of the members named: texts are filled in where they are asked for.
template <int... Bits>
inline constexpr const snippet* rg_level_snippets[]{&level_rg<Bits>..., &receiver_rg<Bits>...};

}  // namespace glsl
}  // namespace umbrage
