// umbrage 0.1.0, disc_hardware8: disc PCF, 8 fetches from a linear comparison sampler. Exactness: tier C.
// disc_hardware8, tier C: within 1/128 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `Texture2D<float4> map`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   depth      depth of a texel's value, in place of .x: for packed depths
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   compare    one comparison, in place of receiver <= stored
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
precise bool umbrage_inside_texel_space(float2 coord) {
    // two different limits: of one limit Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) * 2.0 < 65536.0;
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

#ifndef UMBRAGE_HAS_WITHIN_FAR_PLANE
#define UMBRAGE_HAS_WITHIN_FAR_PLANE
// umbrage_within_far_plane: true if a receiver is a number and not beyond the far plane
precise bool umbrage_within_far_plane(float receiver) {
    return receiver <= 1.0;
}
#endif

#ifndef UMBRAGE_HAS_COMPARE
#define UMBRAGE_HAS_COMPARE
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
float umbrage_compare(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
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

#ifndef UMBRAGE_HAS_FETCH_DEPTH
#define UMBRAGE_HAS_FETCH_DEPTH
// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
float umbrage_fetch_depth(Texture2D<float4> map, float2 size, float2 texel) {
    float2 inside = clamp(texel, float2(0.0, 0.0), size - 1.0);
    float4 value = umbrage_texel(map, size, inside);
    float depth = value.x;
    return inside.x == texel.x && inside.y == texel.y ? depth : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_LIT
#define UMBRAGE_HAS_LIT
// umbrage_lit: visibility from one comparison with a texel
float umbrage_lit(Texture2D<float4> map, float2 size, float2 texel, float receiver) {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
#endif

#ifndef UMBRAGE_HAS_LIT_2X2
#define UMBRAGE_HAS_LIT_2X2
// umbrage_lit_2x2: visibility from the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
float4 umbrage_lit_2x2(Texture2D<float4> map, float2 size, float2 texel, float receiver) {
    float a = umbrage_lit(map, size, texel, receiver);
    float b = umbrage_lit(map, size, texel + float2(1.0, 0.0), receiver);
    float c = umbrage_lit(map, size, texel + float2(0.0, 1.0), receiver);
    float d = umbrage_lit(map, size, texel + float2(1.0, 1.0), receiver);
    return float4(a, b, c, d);
}
#endif

#ifndef UMBRAGE_HAS_PCF_2X2
#define UMBRAGE_HAS_PCF_2X2
// umbrage_pcf_2x2: bilinear 2x2 PCF. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_pcf_2x2(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    float2 hi = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0));
    float2 lo = 1.0 - hi;
    float4 lit = umbrage_lit_2x2(map, size, texel, receiver);
    float visibility = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_LIT_FILTERED
#define UMBRAGE_HAS_LIT_FILTERED
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
// The sampler of this map cannot weight comparisons, so the shader does
//   coord   in texels, no NaN. Outside texel space it is clamped
float umbrage_lit_filtered(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    return umbrage_pcf_2x2(map, size, clamp(coord, float2(-32767.0, -32767.0), float2(32767.0, 32767.0)), receiver);
}
#endif

#ifndef UMBRAGE_HAS_LIT_AT
#define UMBRAGE_HAS_LIT_AT
// umbrage_lit_at: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
float umbrage_lit_at(Texture2D<float4> map, float2 size, float2 uv, float receiver) {
    return umbrage_lit_filtered(map, size, uv * size, receiver);
}
#endif

#ifndef UMBRAGE_HAS_DISC_HARDWARE8
#define UMBRAGE_HAS_DISC_HARDWARE8
// umbrage_disc_hardware8: PCF over 8 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_disc_hardware8(Texture2D<float4> map, float2 size, float2 coord, float receiver, float radius,
                             float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float n = 0.0;
    n += umbrage_lit_at(map, size, center + x * 3.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 13.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 7.0, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 8.0) : 0.0;
    return compared ? visibility : 1.0;
}
#endif
