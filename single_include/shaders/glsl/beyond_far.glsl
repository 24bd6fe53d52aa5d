// umbrage 0.1.0, beyond_far: receivers behind the far plane. Exactness: tier A.
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
