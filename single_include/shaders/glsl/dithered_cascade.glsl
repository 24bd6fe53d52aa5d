// umbrage 0.1.0, dithered_cascade: cascade of a pixel, or the next one, by its weight. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_DITHERED_CASCADE
#define UMBRAGE_HAS_DITHERED_CASCADE
// umbrage_dithered_cascade: index of a cascade, or of the next one if its weight is above the pixel's threshold
UMBRAGE_HIGHP float umbrage_dithered_cascade(UMBRAGE_HIGHP float number, UMBRAGE_HIGHP float weight,
                                             UMBRAGE_HIGHP float threshold) {
    return number + (weight > threshold ? 1.0 : 0.0);
}
#endif
