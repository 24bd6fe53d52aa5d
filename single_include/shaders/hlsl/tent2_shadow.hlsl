// umbrage 0.1.0, tent2_shadow: PCF kernel 1 1. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_TENT2_SHADOW
#define UMBRAGE_HAS_TENT2_SHADOW
// umbrage_tent2_shadow: PCF over 3 x 3 texels, weights 1 1. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_tent2_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                           float receiver) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    float2 x = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative. clamp and max keep compilers from regrouping sums across them
    float2 s = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 r = 256.0 - s;
    float2 w0 = r * 8.0;
    float2 w2 = s * 8.0;
    float2 w1 = max(4096.0 - w0 - w2, float2(0.0, 0.0));
    float4 a = umbrage_lit_2x2_shadow(map, map_sampler, size, texel - 1.0, receiver);
    float4 b = umbrage_lit_2x2_shadow(map, map_sampler, size, texel + float2(1.0, -1.0), receiver);
    float4 c = umbrage_lit_2x2_shadow(map, map_sampler, size, texel + float2(-1.0, 1.0), receiver);
    float4 d = umbrage_lit_2x2_shadow(map, map_sampler, size, texel + float2(1.0, 1.0), receiver);
    float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
}
#endif
