// SPDX-License-Identifier: MIT
//
// Lookups in prefiltered shadow maps (VSM, ESM, EVSM, MSM) for shaders and single receivers: four texels, weighted.
//
//     float visibility = umbrage::vsm(umbrage::bordered(moments), coord, depth - bias, 1e-6f);
//
// In a shader, bind the snippet to the map of moments, any float texture. It weights texels in steps of 1/256. If the
// sampler filters, call `umbrage_decode_vsm(texture(map, uv).xy, receiver, 1e-6)`. The weights are then the hardware's.
#pragma once

#include <glm/vec2.hpp>

#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/prefiltered/esm.hpp>
#include <umbrage/filter/prefiltered/evsm.hpp>
#include <umbrage/filter/prefiltered/hausdorff.hpp>
#include <umbrage/filter/prefiltered/msm.hpp>
#include <umbrage/filter/prefiltered/vsm.hpp>

namespace umbrage {

/// Bilinear mean of the four texels around a point.
/// @param fetch     returns a texel, float or vector, from glm::ivec2. Called 4 times, up to one texel outside the map
/// @param coord     in texels, inside texel space: (0.5, 0.5) is the center of the first texel
/// @return          same type as fetch
/// @formula         ((a (256 - s) + b s) (256 - t) + (c (256 - s) + d s) t) / 65536, s and t integers below 256;
///                  for texels below 2^111
/// @exactness       B, n = 19, S at most 9 times the largest magnitude of a texel;  A where texels are multiples of
///                  2^-8 below 1
template <real T, class Fetch>
[[nodiscard]] auto fetch_bilinear(Fetch&& fetch, glm::vec<2, T> coord) {
    const glm::vec<2, T> x = glm::floor(coord * T(256)) - T(128);
    const glm::vec<2, T> texel = glm::floor(x * T(1.0 / 256.0));
    const glm::vec<2, T> hi = glm::clamp(x * T(1.0 / 256.0) - texel, T(0), T(1)) * T(256), lo = T(256) - hi;
    const glm::ivec2 at(texel);
    const auto a = fetch(at), b = fetch(at + glm::ivec2(1, 0));
    const auto c = fetch(at + glm::ivec2(0, 1)), d = fetch(at + glm::ivec2(1, 1));
    const auto low = a * lo.x + b * hi.x, high = c * lo.x + d * hi.x;
    return (low * lo.y + high * hi.y) * T(1.0 / 65536.0);
}

namespace detail {

/// Lookup that all prefiltered maps share. Receivers outside the filter domain are lit. With bordered(map), receivers
/// outside the map are lit too. Texels outside the map are the nearest ones inside, as for the blur.
template <real T, class Fetch, class Decode>
[[nodiscard]] T look_up(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T cleared, const Decode& decode) {
    const comparison is_lit{cleared < T(0.5) ? depth_direction::reversed : depth_direction::forward};
    if (!in_filter_domain(coord, receiver, is_lit)) return T(1);
    if constexpr (requires { fetch.map.size; }) {
        if (!map_covers(glm::vec<2, T>(fetch.map.size), coord)) return T(1);
        return decode(fetch_bilinear(clamped(fetch.map), coord));
    } else return decode(fetch_bilinear(fetch, coord));
}

}  // namespace detail

/// Visibility from a blurred map of encode_vsm's texels.
/// @param fetch          returns a texel, from glm::ivec2: bordered(map), which is lit outside, or clamped(map)
/// @param coord          receiver position, in texels: (0.5, 0.5) is the first center. Outside texel space or NaN: lit
/// @param receiver       receiver depth, with the bias already applied. Beyond the far plane: lit. NaN: in shadow
/// @param min_variance   as for decode_vsm
/// @param cleared        cleared depth: 1, or 0 where depth is reversed
/// @formula              decode_vsm of fetch_bilinear
/// @exactness            C, n = 165: a division. S is decode_vsm's with S of fetch_bilinear for the texels
template <real T, class Fetch>
[[nodiscard]] T vsm(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T min_variance, T cleared = T(1)) {
    return detail::look_up(fetch, coord, receiver, cleared,
                           [&](glm::vec<2, T> m) { return decode_vsm(m, receiver, min_variance, cleared); });
}

/// Visibility as for vsm, from texels of encode_esm.
/// @exactness        B, n = 56, S likewise
template <real T, class Fetch>
[[nodiscard]] T esm(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T exponent, T cleared = T(1)) {
    return detail::look_up(fetch, coord, receiver, cleared,
                           [&](T m) { return decode_esm(m, receiver, exponent, cleared); });
}

/// Visibility as for vsm, from texels of encode_evsm2.
/// @exactness        C, n = 267: a division. S likewise
template <real T, class Fetch>
[[nodiscard]] T evsm2(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T exponent, T deviation, T cleared = T(1)) {
    return detail::look_up(fetch, coord, receiver, cleared,
                           [&](glm::vec<2, T> m) { return decode_evsm2(m, receiver, exponent, deviation, cleared); });
}

/// Visibility as for vsm, from texels of encode_evsm4.
/// @exactness        C, n = 267: a division. S likewise
template <real T, class Fetch>
[[nodiscard]] T evsm4(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<2, T> exponents,
                      glm::vec<2, T> deviations, T cleared = T(1)) {
    return detail::look_up(fetch, coord, receiver, cleared,
                           [&](glm::vec<4, T> m) { return decode_evsm4(m, receiver, exponents, deviations, cleared); });
}

/// Visibility as for vsm, from texels of encode_msm.
/// @exactness        C, within 1/64 as written
template <real T, class Fetch>
[[nodiscard]] T msm(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<2, T> bias, T cleared = T(1)) {
    return detail::look_up(fetch, coord, receiver, cleared,
                           [&](glm::vec<4, T> b) { return decode_msm(b, receiver, bias, cleared); });
}

/// Visibility as for vsm, from texels of to_optimized_moments(encode_msm).
/// @exactness        C, within 1/64 as written
template <real T, class Fetch>
[[nodiscard]] T msm_unorm16(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<2, T> bias, T cleared = T(1)) {
    return detail::look_up(fetch, coord, receiver, cleared, [&](glm::vec<4, T> o) {
        return decode_msm(from_optimized_moments(o), receiver, bias, cleared);
    });
}

/// Visibility as for vsm, from texels of encode_msm and by decode_msm_hausdorff.
/// @exactness        C, within 1/64 as written, as decode_msm_hausdorff
template <real T, class Fetch>
[[nodiscard]] T msm_hausdorff(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<2, T> bias, T cleared = T(1)) {
    return detail::look_up(fetch, coord, receiver, cleared,
                           [&](glm::vec<4, T> b) { return decode_msm_hausdorff(b, receiver, bias, cleared); });
}

namespace glsl {

inline constexpr snippet fetch_bilinear{
    .name = "fetch_bilinear",
    .summary = "bilinear mean of the four texels around a point",
    .exactness = tier::b,
    .operations = 19,
    .needs = list<&fetch_clamped>,
    .source = R"GLSL(
// umbrage_fetch_bilinear: bilinear mean of the four texels around a point, weights in steps of 1/256
//   coord   in texels. (0.5, 0.5) is the center of the first texel
UMBRAGE_HIGHP vec4 umbrage_fetch_bilinear(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord) {
    UMBRAGE_HIGHP vec2 x = floor(coord * 256.0) - 128.0;
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already. The clamp keeps compilers from regrouping sums across it
    UMBRAGE_HIGHP vec2 hi = clamp(x * (1.0 / 256.0) - texel, vec2(0.0, 0.0), vec2(1.0, 1.0)) * 256.0;
    UMBRAGE_HIGHP vec2 lo = 256.0 - hi;  // 1.0 - hi would become an interpolation, which rounds differently
    UMBRAGE_HIGHP vec4 a = umbrage_fetch_clamped(map, size, texel);
    UMBRAGE_HIGHP vec4 b = umbrage_fetch_clamped(map, size, texel + vec2(1.0, 0.0));
    UMBRAGE_HIGHP vec4 c = umbrage_fetch_clamped(map, size, texel + vec2(0.0, 1.0));
    UMBRAGE_HIGHP vec4 d = umbrage_fetch_clamped(map, size, texel + vec2(1.0, 1.0));
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 low = a * lo.x + b * hi.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 high = c * lo.x + d * hi.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
)GLSL",
};

inline constexpr snippet vsm{
    .name = "vsm",
    .summary = "visibility from a blurred variance shadow map (VSM)",
    .exactness = tier::c,
    .operations = 165,
    .needs = list<&in_filter_domain, &map_covers, &fetch_bilinear, &decode_vsm>,
    .source = R"GLSL(
// umbrage_vsm: visibility from a blurred map of encode_vsm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. min_variance: 0.0 or more
UMBRAGE_HIGHP float umbrage_vsm(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float min_variance) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_vsm(vec2(m.x, m.y), receiver, min_variance);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr snippet esm{
    .name = "esm",
    .summary = "visibility from a blurred exponential shadow map (ESM)",
    .exactness = tier::b,
    .operations = 56,
    .needs = list<&in_filter_domain, &map_covers, &fetch_bilinear, &decode_esm>,
    .source = R"GLSL(
// umbrage_esm: visibility from a blurred map of encode_esm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. exponent: same as for the texels
UMBRAGE_HIGHP float umbrage_esm(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float exponent) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_esm(m.x, receiver, exponent);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr snippet evsm2{
    .name = "evsm2",
    .summary = "visibility from a blurred EVSM of two components",
    .exactness = tier::c,
    .operations = 267,
    .needs = list<&in_filter_domain, &map_covers, &fetch_bilinear, &decode_evsm2>,
    .source = R"GLSL(
// umbrage_evsm2: visibility from a blurred map of encode_evsm2's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. exponent, deviation: as for decode_evsm2
UMBRAGE_HIGHP float umbrage_evsm2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                  UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float exponent,
                                  UMBRAGE_HIGHP float deviation) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_evsm2(vec2(m.x, m.y), receiver, exponent, deviation);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr snippet evsm4{
    .name = "evsm4",
    .summary = "visibility from a blurred EVSM of four components",
    .exactness = tier::c,
    .operations = 267,
    .needs = list<&in_filter_domain, &map_covers, &fetch_bilinear, &decode_evsm4>,
    .source = R"GLSL(
// umbrage_evsm4: visibility from a blurred map of encode_evsm4's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. exponents, deviations: as for decode_evsm4
UMBRAGE_HIGHP float umbrage_evsm4(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                  UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 exponents,
                                  UMBRAGE_HIGHP vec2 deviations) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_evsm4(m, receiver, exponents, deviations);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr snippet msm{
    .name = "msm",
    .summary = "visibility from a blurred moment shadow map (MSM)",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .as_written = true,
    .needs = list<&in_filter_domain, &map_covers, &fetch_bilinear, &decode_msm>,
    .source = R"GLSL(
// umbrage_msm: visibility from a blurred map of encode_msm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
UMBRAGE_HIGHP float umbrage_msm(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_msm(m, receiver, bias);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr snippet msm_unorm16{
    .name = "msm_unorm16",
    .summary = "visibility from a blurred MSM of optimized moments",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .as_written = true,
    .needs = list<&in_filter_domain, &map_covers, &fetch_bilinear, &decode_msm, &from_optimized_moments>,
    .source = R"GLSL(
// umbrage_msm_unorm16: visibility from a blurred map of optimized moments, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
UMBRAGE_HIGHP float umbrage_msm_unorm16(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                       UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_msm(umbrage_from_optimized_moments(m), receiver, bias);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr snippet msm_hausdorff{
    .name = "msm_hausdorff",
    .summary = "visibility from a blurred MSM, for depths on [-1, 1]",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .as_written = true,
    .needs = list<&in_filter_domain, &map_covers, &fetch_bilinear, &decode_msm_hausdorff>,
    .source = R"GLSL(
// umbrage_msm_hausdorff: visibility from a blurred map of encode_msm's texels, for depths on [-1, 1]. 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
UMBRAGE_HIGHP float umbrage_msm_hausdorff(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                          UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_msm_hausdorff(m, receiver, bias);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr const snippet* look_up_snippets[]{&fetch_bilinear, &vsm, &esm,         &evsm2,
                                                   &evsm4,          &msm, &msm_unorm16, &msm_hausdorff};

}  // namespace glsl
}  // namespace umbrage
