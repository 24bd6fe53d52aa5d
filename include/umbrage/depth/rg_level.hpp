// SPDX-License-Identifier: MIT
//
// Shadow test on maps of `encode_rg` without decoding them: one multiply-add per texel.
//
//     bool lit = umbrage::receiver_rg<11>(depth) <= umbrage::level_rg<11>(sampled);
//
// The receiver is converted once, to the scale of the channels' sum. It lies halfway between two codes there, so the
// rounding of a texel's read cannot change the result. In a shader, bind the filter to
//
//     {.depth = "umbrage_level_rg11(value.xy)", .channels = 2, .needs = {glsl::level_rg<11>}}
//
// and pass `umbrage_receiver_rg11(depth, 1.0)` as the receiver. The visibility has the same bits as with `decode_rg`.
#pragma once

#include <cmath>
#include <string>

#include <glm/vec2.hpp>

#include <umbrage/core/compare.hpp>
#include <umbrage/depth/rg.hpp>

namespace umbrage {

/// Level of a texel, on the scale of receiver_rg.
/// @param c       the two channels of encode_rg<Bits> as sampled, k / 255
/// @return        x / 255, x the code. With Bits = 11, eight times decode_ps14
/// @formula       r + 2^(Bits - 8) g
/// @exactness     B, n = 4: one rounded addition, of an exact product
template <int Bits, real T>
[[nodiscard]] constexpr T level_rg(glm::vec<2, T> c) {
    static_assert(Bits >= 9 && Bits <= 16);
    return c.x + c.y * T(1 << (Bits - 8));
}

/// Receiver depth on the scale of level_rg, for less_equal_scaled only, not for reversed depth.
/// @param depth   receiver depth in [0, 1], with the bias already applied
/// @param edge    same as for decode_rg
/// @return        a level. receiver_rg(depth, edge) <= level_rg(c) exactly when depth <= decode_rg(c, edge), for texels
///                c within 2^-18 (4e-6) of k / 255
/// @edge          beyond the far plane: -1, so that every texel lights it. NaN: in shadow, as no comparison with it is
///                true
/// @formula       depth > 1 ? -1 : (ceil(depth 2^Bits - edge) - 1/2) / 255
/// @exactness     B, n = 2: products and sums round once each. The test for which it is made is exact
template <int Bits, real T>
[[nodiscard]] T receiver_rg(T depth, T edge = upper_edge<T>) {
    static_assert(Bits >= 9 && Bits <= 16);
    if (less_equal::beyond_far_plane(depth)) return T(-1);
    return (std::ceil(depth * T(1 << Bits) - edge) - T(0.5)) * T(1.0 / 255.0);
}

namespace glsl {

/// Name of the snippet of level_rg<Bits>.
template <int Bits>
inline constexpr detail::short_name level_rg_name("level_rg$b", {{'b', Bits}});
/// GLSL text of level_rg<Bits>.
template <int Bits>
[[nodiscard]] std::string level_rg_text() {
    return detail::filled(R"GLSL(
// umbrage_level_rg$b: level of a texel from two channels of a $b-bit code, on the scale of umbrage_receiver_rg$b
//   1.0 is not the far plane on this scale
UMBRAGE_HIGHP float umbrage_level_rg$b(UMBRAGE_HIGHP vec2 c) {
    return c.x + c.y * $g.0;  // an exact product: fused or not, it rounds once
}
)GLSL",
                          {{'b', Bits}, {'g', 1 << (Bits - 8)}});
}
template <int Bits>
inline constexpr snippet level_rg{.name = level_rg_name<Bits>.view(),
                                  .summary = "two channels to a level, for maps that are not decoded",
                                  .exactness = tier::b,
                                  .operations = 4,
                                  .scaled = true,
                                  .source = level_rg_text<Bits>};

/// Name of the snippet of receiver_rg<Bits>.
template <int Bits>
inline constexpr detail::short_name receiver_rg_name("receiver_rg$b", {{'b', Bits}});
/// GLSL text of receiver_rg<Bits>.
template <int Bits>
[[nodiscard]] std::string receiver_rg_text() {
    return detail::filled(R"GLSL(
// umbrage_receiver_rg$b: receiver depth on the scale of umbrage_level_rg$b. It is <= a texel's level exactly when
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

/// Snippets of the given members. Their texts are only filled in on use.
template <int... Bits>
inline constexpr const snippet* rg_level_snippets[]{&level_rg<Bits>..., &receiver_rg<Bits>...};

}  // namespace glsl
}  // namespace umbrage
