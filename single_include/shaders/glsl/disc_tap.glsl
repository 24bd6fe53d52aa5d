// umbrage 0.1.0, disc_tap: texel that a point of a disc falls on. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

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

#ifndef UMBRAGE_HAS_DISC_TAP
#define UMBRAGE_HAS_DISC_TAP
// umbrage_disc_tap: texel that a point of a disc falls on
//   position   floor(256 coord) of the receiver
//   p          point, in 1/16 of the radius
//   rotation   from umbrage_disc_rotation
//   radius     along x and y, in 1/16 texel, integers from 0 to 4095
UMBRAGE_HIGHP vec2 umbrage_disc_tap(UMBRAGE_HIGHP vec2 position, UMBRAGE_HIGHP vec2 p, UMBRAGE_HIGHP vec4 rotation,
                                    UMBRAGE_HIGHP vec2 radius) {
    UMBRAGE_HIGHP vec2 at = position * (1.0 / 256.0);
    UMBRAGE_HIGHP vec2 texel = floor(at);
    UMBRAGE_HIGHP vec2 within = clamp(at - texel, vec2(0.0, 0.0), vec2(1.0, 1.0));  // no sum is regrouped across it
    UMBRAGE_HIGHP vec2 wide = vec2(rotation.x, rotation.y) * (radius.x * (1.0 / 16384.0));
    UMBRAGE_HIGHP vec2 high = vec2(rotation.z, rotation.w) * (radius.y * (1.0 / 16384.0));
    UMBRAGE_HIGHP float x = wide.x * p.x + within.x + wide.y * p.y;
    UMBRAGE_HIGHP float y = high.x * p.x + within.y + high.y * p.y;
    return texel + floor(vec2(x, y));
}
#endif
