// umbrage 0.1.0, to_unorm10: value that makes a 10-bit target store channel 0..1023. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_TO_UNORM10
#define UMBRAGE_HAS_TO_UNORM10
// umbrage_to_unorm10: value that makes a 10-bit target store channel k, whether it rounds or truncates
// k * 4099 / 4194304 + 1056 / 4194304
UMBRAGE_HIGHP float umbrage_to_unorm10(UMBRAGE_HIGHP float k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
UMBRAGE_HIGHP vec2 umbrage_to_unorm10(UMBRAGE_HIGHP vec2 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
UMBRAGE_HIGHP vec3 umbrage_to_unorm10(UMBRAGE_HIGHP vec3 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
UMBRAGE_HIGHP vec4 umbrage_to_unorm10(UMBRAGE_HIGHP vec4 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
#endif
