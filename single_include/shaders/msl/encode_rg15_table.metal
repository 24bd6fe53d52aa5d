// umbrage 0.1.0, encode_rg15_table: depth to two 8-bit channels through a lookup texture. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `texture2d<float> map`, texels of the kind that the function's comment names, read unfiltered.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_FROM_UNORM
#define UMBRAGE_HAS_FROM_UNORM
// umbrage_from_unorm: channel 0..255 of a value from an 8-bit texture, even if the division by 255 is inexact
inline float umbrage_from_unorm(float c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float2 umbrage_from_unorm(float2 c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float3 umbrage_from_unorm(float3 c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float4 umbrage_from_unorm(float4 c) {
    return metal::floor(c * 255.0 + 0.5);
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_SATURATE
#define UMBRAGE_HAS_SATURATE
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
inline float umbrage_saturate(float v) {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
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

#ifndef UMBRAGE_HAS_FETCH_CLAMPED
#define UMBRAGE_HAS_FETCH_CLAMPED
// umbrage_fetch_clamped: texel of a map, or the nearest one inside for coordinates outside
inline float4 umbrage_fetch_clamped(metal::texture2d<float> map, float2 size, float2 texel) {
    return umbrage_texel(map, size, metal::clamp(texel, float2(0.0, 0.0), size - 1.0));
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG15_TABLE
#define UMBRAGE_HAS_ENCODE_RG15_TABLE
// umbrage_encode_rg15_table: two channels of a 15-bit depth code through a lookup table, integers 0..255
//   table   2048 x 16 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg15_table(metal::texture2d<float> table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    float row = metal::floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 16.0), texel));
    return float2(k.x, k.y);
}
#endif
