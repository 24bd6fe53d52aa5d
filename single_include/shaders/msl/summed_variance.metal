// umbrage 0.1.0, summed_variance: variance shadow over a box of any size, from a SAT. Exactness: tier C.
// summed_variance, tier C: within 1/65536 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `texture2d<float> map`, texels of the kind that the function's comment names, read unfiltered.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
inline bool umbrage_inside_texel_space(float2 coord) {
    // two different limits: of one limit Mesa makes max(x, y) < limit, which loses a NaN
    return metal::abs(coord.x) < 32768.0 && metal::abs(coord.y) * 2.0 < 65536.0;
}
#endif

#ifndef UMBRAGE_HAS_CORRECT_QUOTIENT
#define UMBRAGE_HAS_CORRECT_QUOTIENT
// umbrage_correct_quotient: floor(a / b) from a guess q, off by at most one
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
inline float umbrage_correct_quotient(float q, float a, float b) {
    float more = q + 1.0;
    float known = more * b <= a ? more : q;
    return q * b > a ? q - 1.0 : known;
}
#endif

#ifndef UMBRAGE_HAS_FLOOR_DIVIDE
#define UMBRAGE_HAS_FLOOR_DIVIDE
// umbrage_floor_divide: floor(a / b) of integers; the quotient is at most 2^18
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
inline float umbrage_floor_divide(float a, float b) {
    return umbrage_correct_quotient(metal::floor(a / b), a, b);
}
#endif

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
inline bool umbrage_beyond_far_plane(float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN
#define UMBRAGE_HAS_IN_FILTER_DOMAIN
// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
inline bool umbrage_in_filter_domain(float2 coord, float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif

#ifndef UMBRAGE_HAS_MAP_COVERS
#define UMBRAGE_HAS_MAP_COVERS
// umbrage_map_covers: true if a receiver lies in a prefiltered map or a table; elsewhere it is lit
inline bool umbrage_map_covers(float2 size, float2 coord) {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TEXEL
#define UMBRAGE_HAS_TEXEL
// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
inline float4 umbrage_texel(metal::texture2d<float> map, float2 size, float2 texel) {
    return map.read(uint2(texel));
}
#endif

#ifndef UMBRAGE_HAS_BOX_MOMENTS
#define UMBRAGE_HAS_BOX_MOMENTS
// umbrage_box_moments: (mean, rest, high, low) of the quantized depths in a box of n texels, integers
//   The sum of the depths is n mean + rest. The sum of their squared distances from mean is 4096 high + low
//   map, size    table from make_variance_table and its size
//   first, end   lowest texel of the box, and one past its highest. first < end
inline float4 umbrage_box_moments(metal::texture2d<float> map, float2 size, float2 first, float2 end) {
    float4 a = umbrage_texel(map, size, end);
    float4 b = umbrage_texel(map, size, float2(first.x, end.y));
    float4 c = umbrage_texel(map, size, float2(end.x, first.y));
    float4 d = umbrage_texel(map, size, first);
    float4 part = (a - b) - (c - d);
    float2 low = float2(part.x, part.z);
    float2 carry = metal::floor(low * (1.0 / 65536.0));
    float2 above = float2(part.y, part.w) + carry;
    // nothing below is negative. The maxima keep compilers from regrouping sums across them
    low = metal::max(low - carry * 65536.0, float2(0.0, 0.0));
    above = metal::max(above - metal::floor(above * (1.0 / 65536.0)) * 65536.0, float2(0.0, 0.0));
    float sum = above.x * 65536.0 + low.x;
    float2 sides = metal::max(end - first, float2(1.0, 1.0));
    float n = sides.x * sides.y;
    float mean = umbrage_floor_divide(sum, n);
    float rest = metal::max(sum - mean * n, 0.0);
    float2 digits = float2(sum + rest, low.y);
    float2 high = metal::floor(digits * (1.0 / 4096.0));
    digits = metal::max(digits - high * 4096.0, float2(0.0, 0.0));
    float below = digits.y - mean * digits.x;
    float borrow = metal::floor(below * (1.0 / 4096.0));
    float wide = above.y * 16.0 + high.y - mean * high.x + borrow;
    wide = wide - metal::floor(wide * (1.0 / 1048576.0)) * 1048576.0;
    return float4(mean, rest, wide, below - borrow * 4096.0);
}
#endif

#ifndef UMBRAGE_HAS_SUMMED_VARIANCE
#define UMBRAGE_HAS_SUMMED_VARIANCE
// umbrage_summed_variance: variance shadow from a summed-area table. Returns visibility, 1.0 = lit
//   map, size   table from make_variance_table and its size: the shadow map's plus one
//   coord       receiver in texels of the shadow map. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      an integer. The box has 2 radius + 1 texels per side
//   codes       2^bits of the table
inline float umbrage_summed_variance(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                     float radius, float codes) {
    float2 last = size - 1.0;
    bool compared = umbrage_map_covers(last, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float2 texel = compared ? metal::clamp(metal::floor(coord), float2(0.0, 0.0), last - 1.0) : float2(0.0, 0.0);
    float2 first = metal::max(texel - radius, float2(0.0, 0.0));
    float2 end = metal::min(texel + radius + 1.0, last);
    float4 m = umbrage_box_moments(map, size, first, end);
    float2 sides = end - first;
    float n = sides.x * sides.y;
    float share = m.y / n;
    float variance = (m.z * 4096.0 + (m.w - m.y)) / n + share * (1.0 - share);
    float scaled = receiver * codes;
    float t = umbrage_cleared_depth() > 0.5 ? scaled : codes - scaled;
    float d = (t - 1.0 - m.x) - share;
    float behind = d > 0.0 ? variance / (variance + d * d) : 0.0;
    return compared ? (d <= 0.0 ? 1.0 : behind) : 1.0;
}
#endif
