// umbrage 0.1.0, probe_color: debug color of a lookup: its texels, or why it fails. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_PROBE_COLOR
#define UMBRAGE_HAS_PROBE_COLOR
// umbrage_probe_color: debug color of a receiver's position in a map
//   at      x and y in texels, z depth
//   size    size of the map, in texels
//   bias    bias of the receiver, in depth
//   number  index of the map, an integer
//   magenta  not a number
//   black    behind the light, or in no cascade
//   white    outside the map
//   cyan     beyond the far plane
//   blue     in front of the near plane
//   red      bias at its limit of 1.0
//   else     squares of one texel
inline float3 umbrage_probe_color(float3 at, float2 size, float bias, float number) {
    float limit = 18446744073709551616.0;
    // limits differ on purpose: Mesa makes max(x, y) < limit of equal ones, which loses a NaN
    bool usable = metal::abs(at.x) < limit && metal::abs(at.y) * 2.0 < limit * 2.0 && metal::abs(at.z) * 4.0 < limit *
        4.0;
    bool inside = at.x >= 0.0 && at.y >= 0.0 && at.x <= size.x && at.y <= size.y;
    bool forward = umbrage_cleared_depth() > 0.5;
    bool past_far = forward ? at.z > 1.0 : at.z < 0.0;
    bool past_near = forward ? at.z < 0.0 : at.z > 1.0;
    float2 place = metal::clamp(float2(at.x, at.y), float2(0.0, 0.0), float2(65536.0, 65536.0));
    float square = metal::floor(place.x) + metal::floor(place.y);
    float shade = square - 2.0 * metal::floor(square * 0.5) > 0.5 ? 0.75 : 1.0;
    float3 bits = metal::floor(float3(number + 1.0, (number + 1.0) * 0.5, (number + 1.0) * 0.25));
    bits = bits - 2.0 * metal::floor(bits * 0.5);
    float3 color = (bits * 0.5 + 0.375) * shade;
    color = bias < 1.0 ? color : float3(1.0, 0.0, 0.0);
    color = past_near ? float3(0.0, 0.0, 1.0) : color;
    color = past_far ? float3(0.0, 1.0, 1.0) : color;
    color = inside ? color : float3(1.0, 1.0, 1.0);
    color = at.x < 65536.0 ? color : float3(0.0, 0.0, 0.0);
    return usable ? color : float3(1.0, 0.0, 1.0);
}
#endif
