// umbrage 0.1.0, is_compared: receivers that a filter compares; it takes the others as lit. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Options, to define in front:
//   UMBRAGE_REVERSED                  depth is 1.0 at the near plane and 0.0 at the far plane
//   UMBRAGE_BEYOND_FAR(receiver)      whether a receiver is behind the far plane

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

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: coordinates in texels that a filter can take; it takes all others, NaN included, as lit
bool umbrage_inside_texel_space(UMBRAGE_HIGHP vec2 coord) {
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) * 2.0 < 65536.0;
}
#endif

#ifndef UMBRAGE_HAS_BEYOND_FAR
#define UMBRAGE_HAS_BEYOND_FAR
// UMBRAGE_BEYOND_FAR: receivers behind the far plane, which no map shadows
#ifndef UMBRAGE_BEYOND_FAR
#ifdef UMBRAGE_REVERSED
#define UMBRAGE_BEYOND_FAR(receiver) ((receiver) < 0.0)
#else
#define UMBRAGE_BEYOND_FAR(receiver) ((receiver) > 1.0)
#endif
#endif
// umbrage_beyond_far: whether a receiver is behind the far plane
bool umbrage_beyond_far(UMBRAGE_HIGHP float receiver) {
    return UMBRAGE_BEYOND_FAR(receiver);
}
#endif

#ifndef UMBRAGE_HAS_IS_COMPARED
#define UMBRAGE_HAS_IS_COMPARED
// umbrage_is_compared: whether a filter compares a receiver; outside texel space and beyond the far plane all is lit
bool umbrage_is_compared(UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver) {
    // a choice, not a && !b: of !(receiver > 1.0) FXC makes receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif
