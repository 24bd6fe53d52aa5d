// umbrage 0.1.0, hardened_kernel16: fraction of a disc in shadow, steepened. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_HARDENED_KERNEL16
#define UMBRAGE_HAS_HARDENED_KERNEL16
// umbrage_hardened_kernel16: fraction of 16 points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
UMBRAGE_HIGHP float umbrage_hardened_kernel16(UMBRAGE_HIGHP float blocked, UMBRAGE_HIGHP float ratio) {
    UMBRAGE_HIGHP float u = blocked * 2.0 - 16.0;
    UMBRAGE_HIGHP float d = max(16.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    UMBRAGE_HIGHP float steep = 4096.0 - d * d * d;
    UMBRAGE_HIGHP float hard = u < 0.0 ? 4096.0 - steep : 4096.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 512.0) * (1.0 / 2097152.0);
}
#endif
