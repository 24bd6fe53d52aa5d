// umbrage 0.1.0, evsm4: visibility from a blurred EVSM of four components. Exactness: tier C.
// evsm4, tier C: within 267 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `Texture2D<float4> map`, texels of the kind that the function's comment names, read unfiltered.
// Render target of evsm4: RGBA32F, not sRGB, no blending, one sample. Clear to umbrage_encode_evsm4 of the far
//   plane's depth.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
precise bool umbrage_inside_texel_space(float2 coord) {
    // two different limits: of one limit Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) * 2.0 < 65536.0;
}
#endif

#ifndef UMBRAGE_HAS_CHEBYSHEV
#define UMBRAGE_HAS_CHEBYSHEV
// umbrage_chebyshev: upper bound on the fraction of depths at the receiver's depth or farther. 0.0 for NaN
//   m              mean of the depths, mean of their squares
//   receiver       receiver depth, on the same scale
//   min_variance   0.0 or more
float umbrage_chebyshev(float2 m, float receiver, float min_variance) {
    precise float difference = m.y - m.x * m.x;
    float variance = difference > min_variance ? difference : min_variance;
    precise float distance = receiver - m.x;
    precise float sum = variance + distance * distance;
    float p = variance / sum;
    return receiver <= m.x ? 1.0 : (p > 0.0 ? min(p, 1.0) : 0.0);  // a GPU's v / v may be more than 1.0
}
#endif

#ifndef UMBRAGE_HAS_POWER_OF_TWO
#define UMBRAGE_HAS_POWER_OF_TWO
// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
float umbrage_power_of_two(float n) {
    uint exponent = uint(n + 127.0);
    return asfloat(exponent << 23);
}
#endif

#ifndef UMBRAGE_HAS_EXP2_POLYNOMIAL
#define UMBRAGE_HAS_EXP2_POLYNOMIAL
// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of itself
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
float umbrage_exp2_polynomial(float y) {
    float x = y > -64.0 ? min(y, 63.0) : -64.0;
    float n = floor(x);
    float f = x - n;
    precise float p = 0.00187931862 * f + 0.00899099465;
    p = p * f + 0.0558186769;
    p = p * f + 0.240159273;
    p = p * f + 0.693151712;
    p = p * f + 1.0;
    return p * umbrage_power_of_two(n);
}
#endif

#ifndef UMBRAGE_HAS_EXPONENTIAL_WARP
#define UMBRAGE_HAS_EXPONENTIAL_WARP
// umbrage_exponential_warp: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
float umbrage_exponential_warp(float depth, float exponent) {
    precise float y = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
#endif

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
precise bool umbrage_beyond_far_plane(float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN
#define UMBRAGE_HAS_IN_FILTER_DOMAIN
// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
precise bool umbrage_in_filter_domain(float2 coord, float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif

#ifndef UMBRAGE_HAS_MAP_COVERS
#define UMBRAGE_HAS_MAP_COVERS
// umbrage_map_covers: true if a receiver lies in a prefiltered map or a table; elsewhere it is lit
precise bool umbrage_map_covers(float2 size, float2 coord) {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
#endif

#ifndef UMBRAGE_HAS_TEXEL
#define UMBRAGE_HAS_TEXEL
// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
float4 umbrage_texel(Texture2D<float4> map, float2 size, float2 texel) {
    return map.Load(int3(int2(texel), 0));
}
#endif

#ifndef UMBRAGE_HAS_FETCH_CLAMPED
#define UMBRAGE_HAS_FETCH_CLAMPED
// umbrage_fetch_clamped: texel of a map, or the nearest one inside for coordinates outside
float4 umbrage_fetch_clamped(Texture2D<float4> map, float2 size, float2 texel) {
    return umbrage_texel(map, size, clamp(texel, float2(0.0, 0.0), size - 1.0));
}
#endif

#ifndef UMBRAGE_HAS_FETCH_BILINEAR
#define UMBRAGE_HAS_FETCH_BILINEAR
// umbrage_fetch_bilinear: bilinear mean of the four texels around a point, weights in steps of 1/256
//   coord   in texels. (0.5, 0.5) is the center of the first texel
float4 umbrage_fetch_bilinear(Texture2D<float4> map, float2 size, float2 coord) {
    float2 x = floor(coord * 256.0) - 128.0;
    float2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already. The clamp keeps compilers from regrouping sums across it
    float2 hi = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 lo = 256.0 - hi;  // 1.0 - hi would become an interpolation, which rounds differently
    float4 a = umbrage_fetch_clamped(map, size, texel);
    float4 b = umbrage_fetch_clamped(map, size, texel + float2(1.0, 0.0));
    float4 c = umbrage_fetch_clamped(map, size, texel + float2(0.0, 1.0));
    float4 d = umbrage_fetch_clamped(map, size, texel + float2(1.0, 1.0));
    precise float4 low = a * lo.x + b * hi.x;
    precise float4 high = c * lo.x + d * hi.x;
    precise float4 sum = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TO_FORWARD_DEPTH
#define UMBRAGE_HAS_TO_FORWARD_DEPTH
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
float umbrage_to_forward_depth(float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
#endif

#ifndef UMBRAGE_HAS_SATURATE
#define UMBRAGE_HAS_SATURATE
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
float umbrage_saturate(float v) {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
#endif

#ifndef UMBRAGE_HAS_DECODE_EVSM4
#define UMBRAGE_HAS_DECODE_EVSM4
// umbrage_decode_evsm4: visibility of a receiver from a mean of texels, at least its lit fraction. 1.0 = lit
//   m            mean of texels
//   receiver     receiver depth in [0, 1], bias applied
//   exponents    same as for the texels
//   deviations   minimum standard deviations, relative to the receiver's powers
float umbrage_decode_evsm4(float4 m, float receiver, float2 exponents, float2 deviations) {
    float d = umbrage_to_forward_depth(umbrage_saturate(receiver));
    float w = umbrage_exponential_warp(d, exponents.x);
    float n = -umbrage_exponential_warp(d, -exponents.y);
    precise float2 least = deviations * float2(w, n);
    precise float2 least_variance = least * least;
    float a = umbrage_chebyshev(float2(m.x, m.y), w, least_variance.x);
    float b = umbrage_chebyshev(float2(m.z, m.w), n, least_variance.y);
    float lit = a < b ? a : b;
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_EVSM4
#define UMBRAGE_HAS_EVSM4
// umbrage_evsm4: visibility from a blurred map of encode_evsm4's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. exponents, deviations: as for decode_evsm4
float umbrage_evsm4(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 exponents,
                    float2 deviations) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_evsm4(m, receiver, exponents, deviations);
    return compared ? lit : 1.0;
}
#endif
