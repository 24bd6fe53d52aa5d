// umbrage 0.1.0, castano5: PCF kernel 1 3 4 3 1. Exactness: tier B.
// castano5, tier B: within 80 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `texture2d<float> map`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered. For a comparison
//   sampler: castano5_shadow.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   depth      depth of a texel's value, in place of .x: for packed depths
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   compare    one comparison, in place of receiver <= stored
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

#ifndef UMBRAGE_HAS_COMPARE
#define UMBRAGE_HAS_COMPARE
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
inline float umbrage_compare(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
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

#ifndef UMBRAGE_HAS_FETCH_DEPTH
#define UMBRAGE_HAS_FETCH_DEPTH
// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
inline float umbrage_fetch_depth(metal::texture2d<float> map, float2 size, float2 texel) {
    float2 inside = metal::clamp(texel, float2(0.0, 0.0), size - 1.0);
    float4 value = umbrage_texel(map, size, inside);
    float depth = value.x;
    return inside.x == texel.x && inside.y == texel.y ? depth : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_LIT
#define UMBRAGE_HAS_LIT
// umbrage_lit: visibility from one comparison with a texel
inline float umbrage_lit(metal::texture2d<float> map, float2 size, float2 texel, float receiver) {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
#endif

#ifndef UMBRAGE_HAS_LIT_2X2
#define UMBRAGE_HAS_LIT_2X2
// umbrage_lit_2x2: visibility from the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
inline float4 umbrage_lit_2x2(metal::texture2d<float> map, float2 size, float2 texel, float receiver) {
    float a = umbrage_lit(map, size, texel, receiver);
    float b = umbrage_lit(map, size, texel + float2(1.0, 0.0), receiver);
    float c = umbrage_lit(map, size, texel + float2(0.0, 1.0), receiver);
    float d = umbrage_lit(map, size, texel + float2(1.0, 1.0), receiver);
    return float4(a, b, c, d);
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_SUM5
#define UMBRAGE_HAS_WINDOW_SUM5
// umbrage_window_sum5: weighted count of the lit texels under a kernel that slides over the map, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   steps       per texel, a power of two up to 256
//   k0 .. k2    weights from the edge to the middle one. The others mirror them
// Steps times the sum of all weights must be an integer up to 4096. Its square is the count when all is lit
inline float umbrage_window_sum5(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float steps,
                                 float k0, float k1, float k2) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? metal::floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = metal::floor(x * (1.0 / 256.0));
    float2 s = metal::floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k2 + k1 + k0);
    float2 w0 = metal::floor(r * k0);
    float2 w1 = metal::floor(r * k1 + s * k0);
    float2 w3 = metal::floor(r * k1 + s * k2);
    float2 w4 = metal::floor(r * k0 + s * k1);
    float2 w5 = metal::floor(s * k0);
    float2 w2 = metal::max(whole - (w0 + w1 + w3 + w4 + w5), float2(0.0, 0.0));
    float2 first = texel - 2.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2(map, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2(map, size, first + float2(2.0, 0.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, first + float2(4.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    return compared ? n : whole * whole;
}
#endif

#ifndef UMBRAGE_HAS_CASTANO5
#define UMBRAGE_HAS_CASTANO5
// umbrage_castano5: PCF under 5 x 5 weights, 1 3 4 3 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
inline float umbrage_castano5(metal::texture2d<float> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 3.0, 4.0);
    return n < 9437184.0 ? n * (1.0 / 65536.0) * 0.00694444450 : 1.0;
}
#endif
