// umbrage 0.1.0, probe_color: debug color of a lookup: its texels, or why it fails. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

#ifndef UMBRAGE_HIGHP
#ifdef GL_ES
#define UMBRAGE_HIGHP highp
#else
#define UMBRAGE_HIGHP
#endif
#endif
#ifndef UMBRAGE_PRECISE
#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)
#define UMBRAGE_PRECISE precise
#else
#define UMBRAGE_PRECISE
#endif
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
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
//   black    behind the light
//   white    outside the map, or all cascades
//   cyan     beyond the far plane
//   blue     in front of the near plane
//   red      bias at its limit of 1.0
//   else     squares of one texel, gray or in the map's color: all is well
UMBRAGE_HIGHP vec3 umbrage_probe_color(UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP float bias,
                                       UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP float limit = 18446744073709551616.0;
    // limits differ on purpose: Mesa makes max(x, y) < limit of equal ones, which loses a NaN
    bool usable = abs(at.x) < limit && abs(at.y) * 2.0 < limit * 2.0 && abs(at.z) * 4.0 < limit * 4.0;
    bool inside = at.x >= 0.0 && at.y >= 0.0 && at.x <= size.x && at.y <= size.y;
    bool forward = umbrage_cleared_depth() > 0.5;
    bool past_far = forward ? at.z > 1.0 : at.z < 0.0;
    bool past_near = forward ? at.z < 0.0 : at.z > 1.0;
    UMBRAGE_HIGHP vec2 place = clamp(vec2(at.x, at.y), vec2(0.0, 0.0), vec2(65536.0, 65536.0));
    UMBRAGE_HIGHP float square = floor(place.x) + floor(place.y);
    UMBRAGE_HIGHP float shade = square - 2.0 * floor(square * 0.5) > 0.5 ? 0.75 : 1.0;
    UMBRAGE_HIGHP vec3 bits = floor(vec3(number, number * 0.5, number * 0.25));
    bits = bits - 2.0 * floor(bits * 0.5);
    UMBRAGE_HIGHP vec3 color = (bits * 0.5 + 0.375) * shade;
    color = bias < 1.0 ? color : vec3(1.0, 0.0, 0.0);
    color = past_near ? vec3(0.0, 0.0, 1.0) : color;
    color = past_far ? vec3(0.0, 1.0, 1.0) : color;
    color = inside ? color : vec3(1.0, 1.0, 1.0);
    color = at.x < 65536.0 ? color : vec3(0.0, 0.0, 0.0);
    return usable ? color : vec3(1.0, 0.0, 1.0);
}
#endif
