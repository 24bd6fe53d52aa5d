// umbrage 0.1.0, blocker: count and distance code of one possible blocker. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_COMPARE
#define UMBRAGE_HAS_COMPARE
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
float umbrage_compare(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DISTANCE_CODE
#define UMBRAGE_HAS_DISTANCE_CODE
// umbrage_distance_code: distance of a depth from the near plane, an integer from 0.0 to 65535.0
// Returns 0.0 at the near plane, also where depth is reversed
float umbrage_distance_code(float depth) {
    float v = depth * 65536.0;
    float forward = v < 65535.0 ? floor(max(v, 0.0)) : 65535.0;
    float reversed = v > 0.0 ? floor(min(v, 65535.0)) : 0.0;
    return umbrage_cleared_depth() > 0.5 ? forward : 65535.0 - reversed;
}
#endif

#ifndef UMBRAGE_HAS_BLOCKER
#define UMBRAGE_HAS_BLOCKER
// umbrage_blocker: (1.0, umbrage_distance_code) of a texel nearer to the light than the receiver, else (0.0, 0.0)
float2 umbrage_blocker(Texture2D<float4> map, float2 size, float2 texel, float receiver) {
    float stored = umbrage_fetch_depth(map, size, texel);
    float code = umbrage_distance_code(stored);
    return umbrage_compare(receiver, stored) > 0.5 ? float2(0.0, 0.0) : float2(1.0, code);
}
#endif
