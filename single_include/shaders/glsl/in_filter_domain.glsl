// umbrage 0.1.0, in_filter_domain: receivers that a filter compares; it takes the others as lit. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

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

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: whether a receiver is behind the far plane
bool umbrage_beyond_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN
#define UMBRAGE_HAS_IN_FILTER_DOMAIN
// umbrage_in_filter_domain: whether a filter compares; outside texel space and beyond the far plane all is lit
bool umbrage_in_filter_domain(UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver) {
    // a choice, not a && !b: of !(receiver > 1.0) FXC makes receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif
