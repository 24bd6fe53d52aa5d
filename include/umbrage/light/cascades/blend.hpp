// SPDX-License-Identifier: MIT
//
// Transition between cascades without a visible seam: two lookups blended, or one cascade chosen per pixel (dithering).
//
//     float weight = umbrage::cascade_fade(view_depth, scale.w, offset.w);        // of the next cascade
//     visibility = umbrage::blend_cascades(visibility, visibility_of_next, weight);
//     number = umbrage::dithered_cascade(number, weight, umbrage::dither_threshold(pixel));  // or this, one lookup
//
// Weights are multiples of 1/256. Visibilities of `pcf_2x2` are multiples of 2^-16. So their blend does not round.
// Also called: cascade blending, cross-fade (cascade_fade, blend_cascades); dithered transition, ordered dithering
// (dithered_cascade).
#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/core/texel_space.hpp>

namespace umbrage {

/// Weight rounded down to steps of 1/256.
/// @param v       any number
/// @edge          1 or above: 1. 0 or below, or NaN: 0
/// @exactness     A
template <real T>
[[nodiscard]] constexpr T cascade_weight(T v) {
    if (is_nan(v) || !(v > T(0))) return T(0);
    return v < T(1) ? T(static_cast<int>(v * T(256))) * T(1.0 / 256.0) : T(1);
}

/// Weight of the next cascade, which grows towards the end of a cascade.
/// @param depth           distance along the camera's axis, world units
/// @param scale           scale of the weight: the w of the cascade's scale
/// @param offset          offset of the weight: the w of the cascade's offset
/// @return                0 to 1 in steps of 1/256
/// @edge                  NaN: 0
/// @formula               depth scale + offset
/// @exactness             B, n = 3: a product and a sum
template <real T>
[[nodiscard]] constexpr T cascade_fade(T depth, T scale, T offset) {
    return cascade_weight(depth * scale + offset);
}

/// Weight of the next cascade, which grows towards the border of a cascade's map. For selection by projection.
/// @param coordinate   position in the map, in texels
/// @param size         size of the map, in texels
/// @param reach        filter radius in texels: the distance from the border where the weight is 1
/// @param per_texel    weight per texel: 1 / width of the band along the border
/// @return             0 to 1 in steps of 1/256
/// @edge               NaN: 0
/// @formula            1 - (distance from the border - reach) per_texel, for the nearest border
/// @exactness          B, n = 8: S = (|coordinate| + size + reach) per_texel + 1
template <real T>
[[nodiscard]] T cascade_border_fade(glm::vec<2, T> coordinate, glm::vec<2, T> size, T reach, T per_texel) {
    const glm::vec<2, T> half = size * T(0.5);
    const auto weight = [&](T c, T h) {
        const T beyond = glm::abs(c - h) - (h - reach);
        return cascade_weight(beyond * per_texel + T(1));
    };
    return (glm::max)(weight(coordinate.x, half.x), weight(coordinate.y, half.y));
}

/// Blend of two cascades' visibilities.
/// @param nearer    visibility in the pixel's cascade
/// @param farther   visibility in the next cascade
/// @param weight    weight of the farther cascade, 0 to 1
/// @formula         nearer + (farther - nearer) weight, from weight 1 on farther alone
/// @exactness       B, n = 3; nothing rounds where visibilities are multiples of 2^-16 and weights of 1/256
template <real T>
[[nodiscard]] constexpr T blend_cascades(T nearer, T farther, T weight) {
    return weight < T(1) ? nearer + (farther - nearer) * weight : farther;
}

/// Dither threshold of a pixel. Each of 16 values occurs once in every 4x4 pixels, as evenly spread as possible.
/// @param pixel     pixel index, or position in pixels
/// @return          1/32, 3/32 to 31/32
/// @edge            NaN, or a magnitude of 2^15 or more: 1/32
/// @formula         (m + 1/2) / 16, m's bits from the highest: x0 xor y0, y0, x1 xor y1, y1, of x and y modulo 4
/// @exactness       A
/// @cite            Bayer: An optimum method for two-level rendition of continuous-tone pictures, ICC 1973
template <real T>
[[nodiscard]] T dither_threshold(glm::vec<2, T> pixel) {
    if (!inside_texel_space(pixel)) return T(1.0 / 32.0);
    const glm::vec<2, T> whole = glm::floor(pixel);
    const glm::vec<2, T> high = glm::floor(whole * T(0.5)), above = glm::floor(whole * T(0.25));
    const glm::vec<2, T> b0 = whole - high * T(2), b1 = high - above * T(2);
    const T m = glm::abs(b0.x - b0.y) * T(8) + b0.y * T(4) + glm::abs(b1.x - b1.y) * T(2) + b1.y;
    return (m + T(0.5)) * T(1.0 / 16.0);
}

/// Cascade that a pixel uses for its one lookup.
/// @param number      index of the cascade
/// @param weight      weight of the next cascade, in steps of 1/256
/// @param threshold   result of dither_threshold
/// @return            number, or number + 1 if weight is above threshold. After the last cascade that index has no
///                    cascade, and the receiver is lit
/// @exactness         A
template <real T>
[[nodiscard]] constexpr T dithered_cascade(T number, T weight, T threshold) {
    return number + (weight > threshold ? T(1) : T(0));
}

namespace glsl {

inline constexpr snippet cascade_weight{
    .name = "cascade_weight",
    .summary = "weight in steps of 1/256",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
UMBRAGE_HIGHP float umbrage_cascade_weight(UMBRAGE_HIGHP float v) {
    return v > 0.0 ? min(floor(v * 256.0), 256.0) * (1.0 / 256.0) : 0.0;
}
)GLSL",
};

inline constexpr snippet cascade_fade{
    .name = "cascade_fade",
    .summary = "weight of the next cascade, by view depth",
    .exactness = tier::b,
    .operations = 3,
    .needs = list<&cascade_weight>,
    .source = R"GLSL(
// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis: depth * scale + offset
UMBRAGE_HIGHP float umbrage_cascade_fade(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float scale,
                                         UMBRAGE_HIGHP float offset) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float v = depth * scale + offset;
    return umbrage_cascade_weight(v);
}
)GLSL",
};

inline constexpr snippet cascade_border_fade{
    .name = "cascade_border_fade",
    .summary = "weight of the next cascade, by distance from the border",
    .exactness = tier::b,
    .operations = 8,
    .needs = list<&cascade_weight>,
    .source = R"GLSL(
// umbrage_cascade_border_fade: weight of the next cascade, 1.0 up to reach texels from the border of a map
//   coordinate  position in the map, in texels
//   size        size of the map, in texels
//   per_texel   weight per texel: 1.0 / width of the band along the border
UMBRAGE_HIGHP float umbrage_cascade_border_fade(UMBRAGE_HIGHP vec2 coordinate, UMBRAGE_HIGHP vec2 size,
                                                UMBRAGE_HIGHP float reach, UMBRAGE_HIGHP float per_texel) {
    UMBRAGE_HIGHP vec2 half_size = size * 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 beyond = abs(coordinate - half_size) - (half_size - reach);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 v = beyond * per_texel + 1.0;
    UMBRAGE_HIGHP float x = umbrage_cascade_weight(v.x);
    UMBRAGE_HIGHP float y = umbrage_cascade_weight(v.y);
    return x > y ? x : y;
}
)GLSL",
};

inline constexpr snippet blend_cascades{
    .name = "blend_cascades",
    .summary = "blend of two cascades' visibilities",
    .exactness = tier::b,
    .operations = 3,
    .source = R"GLSL(
// umbrage_blend_cascades: blend of the visibilities of a cascade and of the next one, by the next one's weight
UMBRAGE_HIGHP float umbrage_blend_cascades(UMBRAGE_HIGHP float nearer, UMBRAGE_HIGHP float farther,
                                           UMBRAGE_HIGHP float weight) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float sum = nearer + (farther - nearer) * weight;
    return weight < 1.0 ? sum : farther;
}
)GLSL",
};

inline constexpr snippet dither_threshold{
    .name = "dither_threshold",
    .summary = "one of 16 dither thresholds for a pixel",
    .exactness = tier::a,
    .needs = list<&inside_texel_space>,
    .source = R"GLSL(
// umbrage_dither_threshold: dither threshold of a position in pixels: 1/32 to 31/32, each once in 4x4 pixels
UMBRAGE_HIGHP float umbrage_dither_threshold(UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec2 whole = umbrage_inside_texel_space(pixel) ? floor(pixel) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 high = floor(whole * 0.5);
    UMBRAGE_HIGHP vec2 above = floor(whole * 0.25);
    UMBRAGE_HIGHP vec2 b0 = whole - high * 2.0;
    UMBRAGE_HIGHP vec2 b1 = high - above * 2.0;
    UMBRAGE_HIGHP float m = abs(b0.x - b0.y) * 8.0 + b0.y * 4.0 + abs(b1.x - b1.y) * 2.0 + b1.y;
    return (m + 0.5) * (1.0 / 16.0);
}
)GLSL",
};

inline constexpr snippet dithered_cascade{
    .name = "dithered_cascade",
    .summary = "cascade of a pixel, or the next one, by its weight",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_dithered_cascade: index of a cascade, or of the next one if its weight is above the pixel's threshold
UMBRAGE_HIGHP float umbrage_dithered_cascade(UMBRAGE_HIGHP float number, UMBRAGE_HIGHP float weight,
                                             UMBRAGE_HIGHP float threshold) {
    return number + (weight > threshold ? 1.0 : 0.0);
}
)GLSL",
};

inline constexpr const snippet* blend_snippets[]{&cascade_weight, &cascade_fade,     &cascade_border_fade,
                                                 &blend_cascades, &dither_threshold, &dithered_cascade};

}  // namespace glsl
}  // namespace umbrage
