// umbrage 0.1.0, box_mean: mean of four integers over a box, from a SAT in two halves. Exactness: tier C.
// box_mean, tier C: within 19 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `texture2d<float> map`, texels of the kind that the function's comment names, read unfiltered.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

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

#ifndef UMBRAGE_HAS_BOX_MEAN
#define UMBRAGE_HAS_BOX_MEAN
// umbrage_box_mean: mean over a box of four integers below 65536.0
//   map, size    table from make_moment_table and its size
//   first, end   lowest texel of the box, and one past its highest. first < end
inline float4 umbrage_box_mean(metal::texture2d<float> map, float2 size, float2 first, float2 end) {
    float right = size.x * 0.5;
    float4 a = umbrage_texel(map, size, end);
    float4 b = umbrage_texel(map, size, float2(first.x, end.y));
    float4 c = umbrage_texel(map, size, float2(end.x, first.y));
    float4 d = umbrage_texel(map, size, first);
    float4 low = (a - b) - (c - d);
    float4 carry = metal::floor(low * (1.0 / 65536.0));
    a = umbrage_texel(map, size, float2(right + end.x, end.y));
    b = umbrage_texel(map, size, float2(right + first.x, end.y));
    c = umbrage_texel(map, size, float2(right + end.x, first.y));
    d = umbrage_texel(map, size, float2(right + first.x, first.y));
    float4 above = (a - b) - (c - d) + carry;
    float4 high = above - metal::floor(above * (1.0 / 65536.0)) * 65536.0;
    float4 sum = high * 65536.0 + (low - carry * 65536.0);
    float2 sides = end - first;
    return sum / (sides.x * sides.y);
}
#endif
