// umbrage 0.1.0, castano5_shadow: PCF kernel 1 3 4 3 1. Exactness: tier B.
// castano5_shadow, tier B: within 80 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `Texture2D<float> map, SamplerComparisonState map_sampler`, a depth texture. Its sampler passes receiver <=
//   depth, clamps to the edge and filters nearest.
// Render target of the map: depth attachment, one sample. Clear to 1.0.
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

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE_SHADOW
#define UMBRAGE_HAS_BEYOND_FAR_PLANE_SHADOW
// umbrage_beyond_far_plane_shadow: true if a receiver is beyond the far plane
precise bool umbrage_beyond_far_plane_shadow(float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN_SHADOW
#define UMBRAGE_HAS_IN_FILTER_DOMAIN_SHADOW
// umbrage_in_filter_domain_shadow: true if a filter compares; lit outside texel space and beyond the far plane
precise bool umbrage_in_filter_domain_shadow(float2 coord, float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane_shadow(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif

#ifndef UMBRAGE_HAS_LIT_TEXEL_SHADOW
#define UMBRAGE_HAS_LIT_TEXEL_SHADOW
// umbrage_lit_texel_shadow: the sampler's comparison with a texel inside the map. NaN is in shadow
float umbrage_lit_texel_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 texel,
                               float receiver) {
    float lit = map.SampleCmpLevelZero(map_sampler, (texel + 0.5) / size, receiver);
    return (receiver > 0.0 ? lit : 0.0) + (receiver <= 0.0 ? lit : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_COMPARE_SHADOW
#define UMBRAGE_HAS_COMPARE_SHADOW
// umbrage_compare_shadow: 1.0 when the receiver is no farther than the stored depth
float umbrage_compare_shadow(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_LIT_SHADOW
#define UMBRAGE_HAS_LIT_SHADOW
// umbrage_lit_shadow: visibility of one comparison with a texel, with the far plane when outside the map
float umbrage_lit_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 texel,
                         float receiver) {
    float2 inside = clamp(texel, float2(0.0, 0.0), size - 1.0);
    float lit = umbrage_lit_texel_shadow(map, map_sampler, size, inside, receiver);
    float outside = umbrage_compare_shadow(receiver, 1.0);
    return inside.x == texel.x && inside.y == texel.y ? lit : outside;
}
#endif

#ifndef UMBRAGE_HAS_LIT_2X2_SHADOW
#define UMBRAGE_HAS_LIT_2X2_SHADOW
// umbrage_lit_2x2_shadow: visibility from the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
float4 umbrage_lit_2x2_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 texel,
                              float receiver) {
    float a = umbrage_lit_shadow(map, map_sampler, size, texel, receiver);
    float b = umbrage_lit_shadow(map, map_sampler, size, texel + float2(1.0, 0.0), receiver);
    float c = umbrage_lit_shadow(map, map_sampler, size, texel + float2(0.0, 1.0), receiver);
    float d = umbrage_lit_shadow(map, map_sampler, size, texel + float2(1.0, 1.0), receiver);
    return float4(a, b, c, d);
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_SUM5_SHADOW
#define UMBRAGE_HAS_WINDOW_SUM5_SHADOW
// umbrage_window_sum5_shadow: weighted count of the lit texels under a kernel that slides over the map, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   steps       per texel, a power of two up to 256
//   k0 .. k2    weights from the edge to the middle one. The others mirror them
// Steps times the sum of all weights must be an integer up to 4096. Its square is the count when all is lit
float umbrage_window_sum5_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                                 float receiver, float steps, float k0, float k1, float k2) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = floor(x * (1.0 / 256.0));
    float2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k2 + k1 + k0);
    float2 w0 = floor(r * k0);
    float2 w1 = floor(r * k1 + s * k0);
    float2 w3 = floor(r * k1 + s * k2);
    float2 w4 = floor(r * k0 + s * k1);
    float2 w5 = floor(s * k0);
    float2 w2 = max(whole - (w0 + w1 + w3 + w4 + w5), float2(0.0, 0.0));
    float2 first = texel - 2.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(2.0, 0.0), receiver);
    float4 c = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(4.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(4.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(4.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    return compared ? n : whole * whole;
}
#endif

#ifndef UMBRAGE_HAS_CASTANO5_SHADOW
#define UMBRAGE_HAS_CASTANO5_SHADOW
// umbrage_castano5_shadow: PCF under 5 x 5 weights, 1 3 4 3 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_castano5_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                              float receiver) {
    float n = umbrage_window_sum5_shadow(map, map_sampler, size, coord, receiver, 256.0, 1.0, 3.0, 4.0);
    return n < 9437184.0 ? n * (1.0 / 65536.0) * 0.00694444450 : 1.0;
}
#endif
