// umbrage 0.1.0, texel_inside: texel of the map, itself if the map has it. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `sampler2D map`, texels of the kind that the function's comment names, read unfiltered.
// Other maps: bind() of the library or of its npm package prints this text, by texture.

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

#ifndef UMBRAGE_HAS_TEXEL_INSIDE
#define UMBRAGE_HAS_TEXEL_INSIDE
// umbrage_texel_inside: texel of the map, itself if the map has it; otherwise any, whose value does not count
UMBRAGE_HIGHP vec2 umbrage_texel_inside(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return min(abs(texel), size - 1.0);
}
#endif
