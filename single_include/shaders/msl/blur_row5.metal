// umbrage 0.1.0, blur_row5: binomial mean of texels in a row, for blurs. Exactness: tier B.
// blur_row5, tier B: within 12 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_FETCH_CLAMPED
#define UMBRAGE_HAS_FETCH_CLAMPED
// umbrage_fetch_clamped: texel of a map, or the nearest one inside for coordinates outside
inline float4 umbrage_fetch_clamped(metal::texture2d<float> map, float2 size, float2 texel) {
    return umbrage_texel(map, size, metal::clamp(texel, float2(0.0, 0.0), size - 1.0));
}
#endif

#ifndef UMBRAGE_HAS_BLUR_ROW5
#define UMBRAGE_HAS_BLUR_ROW5
// umbrage_blur_row5: mean of 5 texels in a row, with the weights of a row of Pascal's triangle
//   map, size   map that is read, and its size in texels
//   texel       index of the texel, integers. (0, 0) is the first
//   along       (1.0, 0.0) or (0.0, 1.0)
inline float4 umbrage_blur_row5(metal::texture2d<float> map, float2 size, float2 texel, float2 along) {
    float4 sum = umbrage_fetch_clamped(map, size, texel) * (6.0 / 16.0);
    float4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    float4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (4.0 / 16.0);
    float4 before2 = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    float4 after2 = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (1.0 / 16.0);
    return sum;
}
#endif
