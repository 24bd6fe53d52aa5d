// umbrage 0.1.0, mend_quotient: a quotient of whole numbers, from one at most one off. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_MEND_QUOTIENT
#define UMBRAGE_HAS_MEND_QUOTIENT
// umbrage_mend_quotient: floor(a / b) from q, at most one off;  whole numbers, a below 2^24, b from 1 to 2^24
UMBRAGE_HIGHP float umbrage_mend_quotient(UMBRAGE_HIGHP float q, UMBRAGE_HIGHP float a, UMBRAGE_HIGHP float b) {
    UMBRAGE_HIGHP float low = q * b > a ? q - 1.0 : q;
    return (low + 1.0) * b <= a ? low + 1.0 : low;
}
#endif
