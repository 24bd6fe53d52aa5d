// umbrage 0.1.0, correct_quotient: floor of a quotient, from a guess off by at most one. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_CORRECT_QUOTIENT
#define UMBRAGE_HAS_CORRECT_QUOTIENT
// umbrage_correct_quotient: floor(a / b) from a guess q, off by at most one
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
UMBRAGE_HIGHP float umbrage_correct_quotient(UMBRAGE_HIGHP float q, UMBRAGE_HIGHP float a, UMBRAGE_HIGHP float b) {
    UMBRAGE_HIGHP float more = q + 1.0;
    UMBRAGE_HIGHP float known = more * b <= a ? more : q;
    return q * b > a ? q - 1.0 : known;
}
#endif
