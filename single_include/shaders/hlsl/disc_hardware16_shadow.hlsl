// umbrage 0.1.0, disc_hardware16_shadow: disc PCF, 16 fetches from a linear comparison sampler. Exactness: tier C.
// disc_hardware16_shadow, tier C: within 1/128 of C++.
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

#ifndef UMBRAGE_HAS_DISC_HARDWARE16_SHADOW
#define UMBRAGE_HAS_DISC_HARDWARE16_SHADOW
// umbrage_disc_hardware16_shadow: PCF over 16 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_disc_hardware16_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size,
                                     float2 coord, float receiver, float radius, float2 rotation) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float n = 0.0;
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 14.0 - y * 2.0, receiver);
    float visibility = umbrage_within_far_plane_shadow(receiver) ? n * (1.0 / 16.0) : 0.0;
    return compared ? visibility : 1.0;
}
#endif
