// umbrage 0.1.0, window_hardware5_shadow: 5x5 kernel, 9 fetches from a linear comparison sampler. Exactness: tier C.
// window_hardware5_shadow, tier C: within 1/128 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `Texture2D<float> map, SamplerComparisonState map_sampler`, a depth texture. Its sampler passes receiver <=
//   depth, clamps to the edge and filters linearly.
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

#ifndef UMBRAGE_HAS_WITHIN_FAR_PLANE_SHADOW
#define UMBRAGE_HAS_WITHIN_FAR_PLANE_SHADOW
// umbrage_within_far_plane_shadow: true if a receiver is a number and not beyond the far plane
precise bool umbrage_within_far_plane_shadow(float receiver) {
    return receiver <= 1.0;
}
#endif

#ifndef UMBRAGE_HAS_COMPARE_SHADOW
#define UMBRAGE_HAS_COMPARE_SHADOW
// umbrage_compare_shadow: 1.0 when the receiver is no farther than the stored depth
float umbrage_compare_shadow(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_LIT_AT_SHADOW
#define UMBRAGE_HAS_LIT_AT_SHADOW
// umbrage_lit_at_shadow: 2x2 comparisons around a point, weighted by the sampler, with the far plane outside the map
//   uv         over the map, (0.0, 0.0) to (1.0, 1.0)
//   receiver   no NaN
float umbrage_lit_at_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 uv,
                            float receiver) {
    float lit = map.SampleCmpLevelZero(map_sampler, uv, receiver);
    float outside = umbrage_compare_shadow(receiver, 1.0);
    float2 inside = clamp((0.5 - abs(uv - 0.5)) * size + 0.5, float2(0.0, 0.0), float2(1.0, 1.0));
    return outside + inside.x * inside.y * (lit - outside);
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_HARDWARE5_SHADOW
#define UMBRAGE_HAS_WINDOW_HARDWARE5_SHADOW
// umbrage_window_hardware5_shadow: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k2    weights from the edge to the middle one. The others mirror them
float umbrage_window_hardware5_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size,
                                      float2 coord, float receiver, float k0, float k1, float k2) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k2 + k1 + k0;
    float2 b0 = k1 + s * (k0 - k1);
    float2 w0 = k0 + k1 - s * k1;
    float2 p0 = (texel - 1.5 + b0 / w0) / size;
    float2 b1 = k1 + s * (k2 - k1);
    float2 w1 = float2(k2 + k1, k2 + k1);
    float2 p1 = (texel + 0.5 + b1 / w1) / size;
    float2 b2 = s * k0;
    float2 w2 = k0 + s * k1;
    float2 p2 = (texel + 2.5 + b2 / w2) / size;
    float n = 0.0;
    float row = 0.0;
    row += w0.x * umbrage_lit_at_shadow(map, map_sampler, size, float2(p0.x, p0.y), receiver);
    row += w1.x * umbrage_lit_at_shadow(map, map_sampler, size, float2(p1.x, p0.y), receiver);
    row += w2.x * umbrage_lit_at_shadow(map, map_sampler, size, float2(p2.x, p0.y), receiver);
    n += w0.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at_shadow(map, map_sampler, size, float2(p0.x, p1.y), receiver);
    row += w1.x * umbrage_lit_at_shadow(map, map_sampler, size, float2(p1.x, p1.y), receiver);
    row += w2.x * umbrage_lit_at_shadow(map, map_sampler, size, float2(p2.x, p1.y), receiver);
    n += w1.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at_shadow(map, map_sampler, size, float2(p0.x, p2.y), receiver);
    row += w1.x * umbrage_lit_at_shadow(map, map_sampler, size, float2(p1.x, p2.y), receiver);
    row += w2.x * umbrage_lit_at_shadow(map, map_sampler, size, float2(p2.x, p2.y), receiver);
    n += w2.y * row;
    float share = clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane_shadow(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
#endif
