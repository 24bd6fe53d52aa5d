// umbrage 0.1.0, blockers8: blocker search over a disc's points. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_DISC_TAP
#define UMBRAGE_HAS_DISC_TAP
// umbrage_disc_tap: texel that a point of a disc falls on
//   position   floor(256 coord) of the receiver
//   p          point, in 1/16 of the radius
//   rotation   from umbrage_disc_rotation
//   radius     in 1/16 texel, an integer from 0 to 4095
inline float2 umbrage_disc_tap(float2 position, float2 p, float2 rotation, float radius) {
    float2 at = position * (1.0 / 256.0);
    float2 texel = metal::floor(at);
    float2 within = metal::clamp(at - texel, float2(0.0, 0.0), float2(1.0, 1.0));  // no sum is regrouped across it
    float2 scaled = rotation * (radius * (1.0 / 16384.0));
    float x = scaled.x * p.x + within.x - scaled.y * p.y;
    float y = scaled.y * p.x + within.y + scaled.x * p.y;
    return texel + metal::floor(float2(x, y));
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

#ifndef UMBRAGE_HAS_COMPARE
#define UMBRAGE_HAS_COMPARE
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
inline float umbrage_compare(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DISTANCE_CODE
#define UMBRAGE_HAS_DISTANCE_CODE
// umbrage_distance_code: distance of a depth from the near plane, an integer from 0.0 to 65535.0
// Returns 0.0 at the near plane, also where depth is reversed
inline float umbrage_distance_code(float depth) {
    float v = depth * 65536.0;
    float forward = v < 65535.0 ? metal::floor(metal::max(v, 0.0)) : 65535.0;
    float reversed = v > 0.0 ? metal::floor(metal::min(v, 65535.0)) : 0.0;
    return umbrage_cleared_depth() > 0.5 ? forward : 65535.0 - reversed;
}
#endif

#ifndef UMBRAGE_HAS_BLOCKER
#define UMBRAGE_HAS_BLOCKER
// umbrage_blocker: (1.0, umbrage_distance_code) of a texel nearer to the light than the receiver, else (0.0, 0.0)
inline float2 umbrage_blocker(metal::texture2d<float> map, float2 size, float2 texel, float receiver) {
    float stored = umbrage_fetch_depth(map, size, texel);
    float code = umbrage_distance_code(stored);
    return umbrage_compare(receiver, stored) > 0.5 ? float2(0.0, 0.0) : float2(1.0, code);
}
#endif

#ifndef UMBRAGE_HAS_BLOCKERS8
#define UMBRAGE_HAS_BLOCKERS8
// umbrage_blockers8: (number of blockers, sum of their distance codes) at 8 points of a disc
//   map, size   shadow map and its size in texels
//   position    floor(256 coord) of the receiver
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in 1/16 texel, an integer from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
inline float2 umbrage_blockers8(metal::texture2d<float> map, float2 size, float2 position, float receiver, float radius,
                                float2 rotation) {
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(3.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-4.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-12.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, -7.0), rotation, radius), receiver);
    return n;
}
#endif
