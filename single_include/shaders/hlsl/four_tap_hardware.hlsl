// umbrage 0.1.0, four_tap_hardware: mean of four taps from a nearest-texel sampler. Exactness: tier C.
// four_tap_hardware, tier C: within 39 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
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

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
precise bool umbrage_beyond_far_plane(float receiver) {
    return receiver > 1.0;
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

#ifndef UMBRAGE_HAS_DEPTH_AT
#define UMBRAGE_HAS_DEPTH_AT
// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the neighbor's
//   uv  point on the map, (0.0, 0.0) to (1.0, 1.0), no NaN
float umbrage_depth_at(Texture2D<float4> map, float2 size, float2 uv) {
    return umbrage_fetch_depth(map, size, floor(uv * size));
}
#endif

#ifndef UMBRAGE_HAS_FOUR_TAP_HARDWARE
#define UMBRAGE_HAS_FOUR_TAP_HARDWARE
// umbrage_four_tap_hardware: mean of the shadow test at four taps of a nearest-texel sampler
// Returns visibility, 1.0 = lit
//   map, size    shadow map and its size in texels
//   a, b, c, d   taps from (0.0, 0.0) to (1.0, 1.0) over the map
//                All are lit where the mean of |x| + |y| is 2^15 texels or more
//   receiver     receiver depth in [0, 1], bias applied
float umbrage_four_tap_hardware(Texture2D<float4> map, float2 size, float2 a, float2 b, float2 c, float2 d,
                                float receiver) {
    float2 sum = (abs(a) + abs(b) + abs(c) + abs(d)) * size;
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x + sum.y < 131072.0;
    float count = umbrage_compare(receiver, umbrage_depth_at(map, size, a)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, b)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, c)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, d));
    return compared ? count * 0.25 : 1.0;
}
#endif
