// umbrage 0.1.0, hardened32: a disc's share in shadow, steepened. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_HARDENED32
#define UMBRAGE_HAS_HARDENED32
// umbrage_hardened32: the share of 32 points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
UMBRAGE_HIGHP float umbrage_hardened32(UMBRAGE_HIGHP float blocked, UMBRAGE_HIGHP float ratio) {
    UMBRAGE_HIGHP float u = blocked * 2.0 - 32.0;
    UMBRAGE_HIGHP float d = max(32.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    UMBRAGE_HIGHP float steep = 32768.0 - d * d * d;
    UMBRAGE_HIGHP float hard = u < 0.0 ? 32768.0 - steep : 32768.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 2048.0) * (1.0 / 16777216.0);
}
#endif
