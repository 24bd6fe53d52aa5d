// umbrage 0.1.0, fetch_bilinear: bilinear mean of the four texels around a point. Exactness: tier B.
// fetch_bilinear, tier B: within 19 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_FETCH_BILINEAR
#define UMBRAGE_HAS_FETCH_BILINEAR
// umbrage_fetch_bilinear: bilinear mean of the four texels around a point, weights in steps of 1/256
//   coord   in texels. (0.5, 0.5) is the center of the first texel
inline float4 umbrage_fetch_bilinear(metal::texture2d<float> map, float2 size, float2 coord) {
    float2 x = metal::floor(coord * 256.0) - 128.0;
    float2 texel = metal::floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already. The clamp keeps compilers from regrouping sums across it
    float2 hi = metal::clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 lo = 256.0 - hi;  // 1.0 - hi would become an interpolation, which rounds differently
    float4 a = umbrage_fetch_clamped(map, size, texel);
    float4 b = umbrage_fetch_clamped(map, size, texel + float2(1.0, 0.0));
    float4 c = umbrage_fetch_clamped(map, size, texel + float2(0.0, 1.0));
    float4 d = umbrage_fetch_clamped(map, size, texel + float2(1.0, 1.0));
    float4 low = a * lo.x + b * hi.x;
    float4 high = c * lo.x + d * hi.x;
    float4 sum = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
#endif
