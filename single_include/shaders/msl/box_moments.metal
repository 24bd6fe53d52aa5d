// umbrage 0.1.0, box_moments: mean and squared distances over a box, from a SAT. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `texture2d<float> map`, texels of the kind that the function's comment names, read unfiltered.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

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
