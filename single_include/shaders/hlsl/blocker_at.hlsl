// umbrage 0.1.0, blocker_at: count and depth of one possible blocker. Exactness: tier C.
// blocker_at, tier C: within 4 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_COMPARE
#define UMBRAGE_HAS_COMPARE
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
float umbrage_compare(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_BLOCKER_AT
#define UMBRAGE_HAS_BLOCKER_AT
// umbrage_blocker_at: (1.0, depth) of the texel at a point if it is nearer to the light, else (0.0, 0.0)
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
float2 umbrage_blocker_at(Texture2D<float4> map, float2 size, float2 uv, float receiver) {
    float stored = umbrage_depth_at(map, size, uv);
    return umbrage_compare(receiver, stored) > 0.5 ? float2(0.0, 0.0) : float2(1.0, stored);
}
#endif
