// umbrage 0.1.0, halve_texels: mean of 2x2 texels, for mip chains. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// halve_texels, tier B: within 8 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
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

#ifndef UMBRAGE_HAS_TEXEL
#define UMBRAGE_HAS_TEXEL
// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
UMBRAGE_HIGHP vec4 umbrage_texel(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
#if __VERSION__ >= 130
    return texelFetch(map, ivec2(texel), 0);
#else
    return texture2D(map, (texel + 0.5) / size);
#endif
}
#endif

#ifndef UMBRAGE_HAS_FETCH_CLAMPED
#define UMBRAGE_HAS_FETCH_CLAMPED
// umbrage_fetch_clamped: texel of a map, or the nearest one inside for coordinates outside
UMBRAGE_HIGHP vec4 umbrage_fetch_clamped(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                         UMBRAGE_HIGHP vec2 texel) {
    return umbrage_texel(map, size, clamp(texel, vec2(0.0, 0.0), size - 1.0));
}
#endif

#ifndef UMBRAGE_HAS_HALVE_TEXELS
#define UMBRAGE_HAS_HALVE_TEXELS
// umbrage_halve_texels: mean of the 2x2 texels behind one texel of the next mip level
//   map, size   map that is read, and its size in texels
//   texel       index in the next level, integers
UMBRAGE_HIGHP vec4 umbrage_halve_texels(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                        UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 at = texel * 2.0;
    UMBRAGE_HIGHP vec4 a = umbrage_fetch_clamped(map, size, at);
    UMBRAGE_HIGHP vec4 b = umbrage_fetch_clamped(map, size, at + vec2(1.0, 0.0));
    UMBRAGE_HIGHP vec4 c = umbrage_fetch_clamped(map, size, at + vec2(0.0, 1.0));
    UMBRAGE_HIGHP vec4 d = umbrage_fetch_clamped(map, size, at + vec2(1.0, 1.0));
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = (a + b) + (c + d);
    return sum * 0.25;
}
#endif
