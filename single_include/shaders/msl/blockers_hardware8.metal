// umbrage 0.1.0, blockers_hardware8: blocker search, 8 points of a nearest-texel sampler. Exactness: tier C.
// blockers_hardware8, tier C: within 24 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
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

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
inline bool umbrage_inside_texel_space(float2 coord) {
    // two different limits: of one limit Mesa makes max(x, y) < limit, which loses a NaN
    return metal::abs(coord.x) < 32768.0 && metal::abs(coord.y) * 2.0 < 65536.0;
}
#endif

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
inline bool umbrage_beyond_far_plane(float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN
#define UMBRAGE_HAS_IN_FILTER_DOMAIN
// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
inline bool umbrage_in_filter_domain(float2 coord, float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
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

#ifndef UMBRAGE_HAS_DEPTH_AT
#define UMBRAGE_HAS_DEPTH_AT
// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the neighbor's
//   uv  point on the map, (0.0, 0.0) to (1.0, 1.0), no NaN
inline float umbrage_depth_at(metal::texture2d<float> map, float2 size, float2 uv) {
    return umbrage_fetch_depth(map, size, metal::floor(uv * size));
}
#endif

#ifndef UMBRAGE_HAS_COMPARE
#define UMBRAGE_HAS_COMPARE
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
inline float umbrage_compare(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_BLOCKER_AT
#define UMBRAGE_HAS_BLOCKER_AT
// umbrage_blocker_at: (1.0, depth) of the texel at a point if it is nearer to the light, else (0.0, 0.0)
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
inline float2 umbrage_blocker_at(metal::texture2d<float> map, float2 size, float2 uv, float receiver) {
    float stored = umbrage_depth_at(map, size, uv);
    return umbrage_compare(receiver, stored) > 0.5 ? float2(0.0, 0.0) : float2(1.0, stored);
}
#endif

#ifndef UMBRAGE_HAS_BLOCKERS_HARDWARE8
#define UMBRAGE_HAS_BLOCKERS_HARDWARE8
// umbrage_blockers_hardware8: (number of blockers, sum of their depths) at 8 points of a disc
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
inline float2 umbrage_blockers_hardware8(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                         float radius, float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? metal::min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 3.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 - y * 7.0, receiver);
    return compared ? n : float2(0.0, 0.0);
}
#endif
