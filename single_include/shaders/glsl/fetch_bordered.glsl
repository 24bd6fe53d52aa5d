// umbrage 0.1.0, fetch_bordered: texel of a map, or a border value outside it. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_TEXEL_INSIDE
#define UMBRAGE_HAS_TEXEL_INSIDE
// umbrage_texel_inside: texel of the map, itself if the map has it; otherwise any, whose value does not count
UMBRAGE_HIGHP vec2 umbrage_texel_inside(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return min(abs(texel), size - 1.0);
}
#endif

#ifndef UMBRAGE_HAS_FETCH_BORDERED
#define UMBRAGE_HAS_FETCH_BORDERED
// umbrage_fetch_bordered: texel of a map, or border outside it
UMBRAGE_HIGHP vec4 umbrage_fetch_bordered(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                          UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP vec4 border) {
    UMBRAGE_HIGHP vec2 at = umbrage_texel_inside(size, texel);
    UMBRAGE_HIGHP vec4 value = umbrage_texel(map, size, at);
    return at.x == texel.x && at.y == texel.y ? value : border;
}
#endif
