// umbrage 0.1.0, compare: one comparison. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Options, to define in front:
//   UMBRAGE_REVERSED                  depth is 1.0 at the near plane and 0.0 at the far plane
//   UMBRAGE_COMPARE(receiver, stored) 1.0 for a lit receiver, else 0.0

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

#ifndef UMBRAGE_HAS_COMPARE
#define UMBRAGE_HAS_COMPARE
// UMBRAGE_COMPARE: 1.0 when the receiver is no farther than the stored depth, after #define UMBRAGE_REVERSED no less
#ifndef UMBRAGE_COMPARE
#ifdef UMBRAGE_REVERSED
#define UMBRAGE_COMPARE(receiver, stored) ((receiver) >= (stored) ? 1.0 : 0.0)
#else
#define UMBRAGE_COMPARE(receiver, stored) ((receiver) <= (stored) ? 1.0 : 0.0)
#endif
#endif
// umbrage_compare: visibility of one comparison
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return UMBRAGE_COMPARE(receiver, stored);
}
#endif
