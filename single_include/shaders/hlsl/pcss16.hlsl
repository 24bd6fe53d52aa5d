// umbrage 0.1.0, pcss16: percentage-closer soft shadows (PCSS), 16 points twice. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_PENUMBRA
#define UMBRAGE_HAS_PENUMBRA
// umbrage_penumbra: radius of a penumbra in 1/16 texel, an integer
//   apart      umbrage_distance_code of the receiver minus that of the blocker
//   softness   (1/16 texel per distance code, min_radius, max_radius), from make_penumbra_params
float umbrage_penumbra(float apart, float3 softness) {
    return min(max(floor(apart * softness.x), softness.y), softness.z);
}
#endif

#ifndef UMBRAGE_HAS_DISC_TAP
#define UMBRAGE_HAS_DISC_TAP
// umbrage_disc_tap: texel that a point of a disc falls on
//   position   floor(256 coord) of the receiver
//   p          point, in 1/16 of the radius
//   rotation   from umbrage_disc_rotation
//   radius     in 1/16 texel, an integer from 0 to 4095
float2 umbrage_disc_tap(float2 position, float2 p, float2 rotation, float radius) {
    float2 at = position * (1.0 / 256.0);
    float2 texel = floor(at);
    float2 within = clamp(at - texel, float2(0.0, 0.0), float2(1.0, 1.0));  // no sum is regrouped across it
    float2 scaled = rotation * (radius * (1.0 / 16384.0));
    float x = scaled.x * p.x + within.x - scaled.y * p.y;
    float y = scaled.y * p.x + within.y + scaled.x * p.y;
    return texel + floor(float2(x, y));
}
#endif

#ifndef UMBRAGE_HAS_CORRECT_QUOTIENT
#define UMBRAGE_HAS_CORRECT_QUOTIENT
// umbrage_correct_quotient: floor(a / b) from a guess q, off by at most one
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
float umbrage_correct_quotient(float q, float a, float b) {
    float more = q + 1.0;
    float known = more * b <= a ? more : q;
    return q * b > a ? q - 1.0 : known;
}
#endif

#ifndef UMBRAGE_HAS_FLOOR_DIVIDE
#define UMBRAGE_HAS_FLOOR_DIVIDE
// umbrage_floor_divide: floor(a / b) of integers; the quotient is at most 2^18
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
float umbrage_floor_divide(float a, float b) {
    return umbrage_correct_quotient(floor(a / b), a, b);
}
#endif

#ifndef UMBRAGE_HAS_DISC_RADIUS
#define UMBRAGE_HAS_DISC_RADIUS
// umbrage_disc_radius: radius of a disc in 1/16 texel, from one in texels
// Returns an integer from 0 to 4095, and 0 for NaN
float umbrage_disc_radius(float radius) {
    float inside = radius > 0.0 ? floor(radius * 16.0) : 0.0;
    return radius >= 255.9375 ? 4095.0 : inside;
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

#ifndef UMBRAGE_HAS_BLOCKER
#define UMBRAGE_HAS_BLOCKER
// umbrage_blocker: (1.0, umbrage_distance_code) of a texel nearer to the light than the receiver, else (0.0, 0.0)
float2 umbrage_blocker(Texture2D<float4> map, float2 size, float2 texel, float receiver) {
    float stored = umbrage_fetch_depth(map, size, texel);
    float code = umbrage_distance_code(stored);
    return umbrage_compare(receiver, stored) > 0.5 ? float2(0.0, 0.0) : float2(1.0, code);
}
#endif

#ifndef UMBRAGE_HAS_BLOCKERS16
#define UMBRAGE_HAS_BLOCKERS16
// umbrage_blockers16: (number of blockers, sum of their distance codes) at 16 points of a disc
//   map, size   shadow map and its size in texels
//   position    floor(256 coord) of the receiver
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in 1/16 texel, an integer from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
float2 umbrage_blockers16(Texture2D<float4> map, float2 size, float2 position, float receiver, float radius,
                          float2 rotation) {
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(8.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-12.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-9.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(14.0, -2.0), rotation, radius), receiver);
    return n;
}
#endif

#ifndef UMBRAGE_HAS_LIT
#define UMBRAGE_HAS_LIT
// umbrage_lit: visibility from one comparison with a texel
float umbrage_lit(Texture2D<float4> map, float2 size, float2 texel, float receiver) {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
#endif

#ifndef UMBRAGE_HAS_DISC16
#define UMBRAGE_HAS_DISC16
// umbrage_disc16: PCF over a rotated disc of 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_disc16(Texture2D<float4> map, float2 size, float2 coord, float receiver, float radius, float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float rho = umbrage_disc_radius(radius);
    float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(5.0, 2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-5.0, 2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 7.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-6.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(8.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, -11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, 5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-12.0, 4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-1.0, 13.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, 11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-9.0, 10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, -4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, -12.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-7.0, -12.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(14.0, -2.0), rotation, rho), receiver);
    return compared ? n * (1.0 / 16.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_PCSS16
#define UMBRAGE_HAS_PCSS16
// umbrage_pcss16: percentage-closer soft shadows (PCSS), 16 points twice. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_pcss16(Texture2D<float4> map, float2 size, float2 coord, float receiver, float3 softness,
                     float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    float radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is that of the search, whose points are all lit
    return umbrage_disc16(map, size, coord, receiver, radius * (1.0 / 16.0), rotation);
}
#endif
