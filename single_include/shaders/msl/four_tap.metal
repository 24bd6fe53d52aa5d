// umbrage 0.1.0, four_tap: mean of four taps, each with its own coordinates. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `texture2d<float> map`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
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

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
inline bool umbrage_beyond_far_plane(float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_FOUR_TAP
#define UMBRAGE_HAS_FOUR_TAP
// umbrage_four_tap: mean of the shadow test at four taps. Returns visibility, 1.0 = lit
//   map, size    shadow map and its size in texels
//   a, b, c, d   taps in texels. All are lit where their mean magnitude is 2^15 or more along an axis
//   receiver     receiver depth in [0, 1], bias applied
inline float umbrage_four_tap(metal::texture2d<float> map, float2 size, float2 a, float2 b, float2 c, float2 d,
                              float receiver) {
    float2 a_texel = metal::floor(a);
    float2 b_texel = metal::floor(b);
    float2 c_texel = metal::floor(c);
    float2 d_texel = metal::floor(d);
    float2 sum = metal::abs(a_texel) + metal::abs(b_texel) + metal::abs(c_texel) + metal::abs(d_texel);
    // two different limits on purpose: Mesa turns a single one into max(x, y) < limit, which loses a NaN
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x < 131072.0 && sum.y * 2.0 < 262144.0;
    float count = umbrage_lit(map, size, a_texel, receiver) + umbrage_lit(map, size, b_texel, receiver) +
        umbrage_lit(map, size, c_texel, receiver) + umbrage_lit(map, size, d_texel, receiver);
    return compared ? count * 0.25 : 1.0;
}
#endif
