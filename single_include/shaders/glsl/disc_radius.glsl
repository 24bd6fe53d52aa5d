// umbrage 0.1.0, disc_radius: radius of a disc, rounded down to 1/16 texel. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_DISC_RADIUS
#define UMBRAGE_HAS_DISC_RADIUS
// umbrage_disc_radius: radius of a disc in 1/16 texel, from one in texels
// Returns an integer from 0 to 4095, and 0 for NaN
UMBRAGE_HIGHP float umbrage_disc_radius(UMBRAGE_HIGHP float radius) {
    UMBRAGE_HIGHP float inside = radius > 0.0 ? floor(radius * 16.0) : 0.0;
    return radius >= 255.9375 ? 4095.0 : inside;
}
#endif
