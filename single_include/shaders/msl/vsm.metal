// umbrage 0.1.0, vsm: visibility from a blurred variance shadow map (VSM). Exactness: tier C.
// vsm, tier C: within 165 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `texture2d<float> map`, texels of the kind that the function's comment names, read unfiltered.
// Render target of vsm: RG32F, not sRGB, no blending, one sample. Clear to umbrage_encode_vsm of the far plane's
//   depth.
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

#ifndef UMBRAGE_HAS_CHEBYSHEV
#define UMBRAGE_HAS_CHEBYSHEV
// umbrage_chebyshev: upper bound on the fraction of depths at the receiver's depth or farther. 0.0 for NaN
//   m              mean of the depths, mean of their squares
//   receiver       receiver depth, on the same scale
//   min_variance   0.0 or more
inline float umbrage_chebyshev(float2 m, float receiver, float min_variance) {
    float difference = m.y - m.x * m.x;
    float variance = difference > min_variance ? difference : min_variance;
    float distance = receiver - m.x;
    float sum = variance + distance * distance;
    float p = variance / sum;
    return receiver <= m.x ? 1.0 : (p > 0.0 ? metal::min(p, 1.0) : 0.0);  // a GPU's v / v may be more than 1.0
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

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TO_FORWARD_DEPTH
#define UMBRAGE_HAS_TO_FORWARD_DEPTH
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
inline float umbrage_to_forward_depth(float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_VSM
#define UMBRAGE_HAS_DECODE_VSM
// umbrage_decode_vsm: visibility of a receiver from a variance shadow map, at least its lit fraction. 1.0 = lit
//   m              mean of texels
//   receiver       receiver depth, bias applied
//   min_variance   0.0 or more
inline float umbrage_decode_vsm(float2 m, float receiver, float min_variance) {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}
#endif

#ifndef UMBRAGE_HAS_VSM
#define UMBRAGE_HAS_VSM
// umbrage_vsm: visibility from a blurred map of encode_vsm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. min_variance: 0.0 or more
inline float umbrage_vsm(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float min_variance) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_vsm(float2(m.x, m.y), receiver, min_variance);
    return compared ? lit : 1.0;
}
#endif
