// umbrage 0.1.0, to_unorm: value that makes an 8-bit target store channel 0..255. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_TO_UNORM
#define UMBRAGE_HAS_TO_UNORM
// umbrage_to_unorm: value that makes an 8-bit target store channel k, whether it rounds or truncates
// k * 257 / 65536 + 64 / 65536, in decimals because 65536.0 is infinite in mediump
UMBRAGE_HIGHP float umbrage_to_unorm(UMBRAGE_HIGHP float k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
UMBRAGE_HIGHP vec2 umbrage_to_unorm(UMBRAGE_HIGHP vec2 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
UMBRAGE_HIGHP vec3 umbrage_to_unorm(UMBRAGE_HIGHP vec3 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
UMBRAGE_HIGHP vec4 umbrage_to_unorm(UMBRAGE_HIGHP vec4 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
#endif
