// umbrage 0.1.0, from_unorm16: channel 0..65535 of a value from a 16-bit texture. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_FROM_UNORM16
#define UMBRAGE_HAS_FROM_UNORM16
// umbrage_from_unorm16: channel 0..65535 of a value from a 16-bit texture, even if the division by 65535 is inexact
UMBRAGE_HIGHP float umbrage_from_unorm16(UMBRAGE_HIGHP float c) {
    return floor(c * 65535.0 + 0.5);
}
UMBRAGE_HIGHP vec2 umbrage_from_unorm16(UMBRAGE_HIGHP vec2 c) {
    return floor(c * 65535.0 + 0.5);
}
UMBRAGE_HIGHP vec3 umbrage_from_unorm16(UMBRAGE_HIGHP vec3 c) {
    return floor(c * 65535.0 + 0.5);
}
UMBRAGE_HIGHP vec4 umbrage_from_unorm16(UMBRAGE_HIGHP vec4 c) {
    return floor(c * 65535.0 + 0.5);
}
#endif
