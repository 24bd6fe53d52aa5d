// umbrage 0.1.0, quadratic_b_spline: PCF kernel of the quadratic B-spline, 3x3 texels. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_QUADRATIC_B_SPLINE
#define UMBRAGE_HAS_QUADRATIC_B_SPLINE
// umbrage_quadratic_b_spline: PCF over 3 x 3 texels, weighted by the quadratic B-spline. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_quadratic_b_spline(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative. clamp and max keep compilers from regrouping sums across them
    float2 s = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 r = 256.0 - s;
    float2 w0 = floor(r * r * (1.0 / 32.0));
    float2 w2 = floor(s * s * (1.0 / 32.0));
    float2 w1 = max(4096.0 - w0 - w2, float2(0.0, 0.0));
    float4 a = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    float4 b = umbrage_lit_2x2(map, size, texel + float2(1.0, -1.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, texel + float2(-1.0, 1.0), receiver);
    float4 d = umbrage_lit_2x2(map, size, texel + float2(1.0, 1.0), receiver);
    float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
}
#endif
