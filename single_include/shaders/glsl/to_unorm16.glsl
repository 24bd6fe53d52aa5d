// umbrage 0.1.0, to_unorm16: value that makes a 16-bit target store channel 0..65535. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_TO_UNORM16
#define UMBRAGE_HAS_TO_UNORM16
// umbrage_to_unorm16: value that makes a 16-bit target store channel k, whether it rounds or truncates
UMBRAGE_HIGHP float umbrage_to_unorm16(UMBRAGE_HIGHP float k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
UMBRAGE_HIGHP vec2 umbrage_to_unorm16(UMBRAGE_HIGHP vec2 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
UMBRAGE_HIGHP vec3 umbrage_to_unorm16(UMBRAGE_HIGHP vec3 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
UMBRAGE_HIGHP vec4 umbrage_to_unorm16(UMBRAGE_HIGHP vec4 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
#endif
