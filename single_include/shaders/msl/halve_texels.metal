// umbrage 0.1.0, halve_texels: mean of 2x2 texels, for mip chains. Exactness: tier B.
// halve_texels, tier B: within 8 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_HALVE_TEXELS
#define UMBRAGE_HAS_HALVE_TEXELS
// umbrage_halve_texels: mean of the 2x2 texels behind one texel of the next mip level
//   map, size   map that is read, and its size in texels
//   texel       index in the next level, integers
inline float4 umbrage_halve_texels(metal::texture2d<float> map, float2 size, float2 texel) {
    float2 at = texel * 2.0;
    float4 a = umbrage_fetch_clamped(map, size, at);
    float4 b = umbrage_fetch_clamped(map, size, at + float2(1.0, 0.0));
    float4 c = umbrage_fetch_clamped(map, size, at + float2(0.0, 1.0));
    float4 d = umbrage_fetch_clamped(map, size, at + float2(1.0, 1.0));
    float4 sum = (a + b) + (c + d);
    return sum * 0.25;
}
#endif
