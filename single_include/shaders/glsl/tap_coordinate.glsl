// umbrage 0.1.0, tap_coordinate: coordinate of a tap from the center's, before division by w. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// tap_coordinate, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
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

#ifndef UMBRAGE_HAS_TAP_COORDINATE
#define UMBRAGE_HAS_TAP_COORDINATE
// umbrage_tap_coordinate: coordinate before the division by w, moved by offset texels
UMBRAGE_HIGHP vec4 umbrage_tap_coordinate(UMBRAGE_HIGHP vec4 coordinate, UMBRAGE_HIGHP vec2 offset) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 moved = vec2(coordinate.x, coordinate.y) + offset * coordinate.w;
    return vec4(moved.x, moved.y, coordinate.z, coordinate.w);
}
#endif
