// umbrage 0.1.0, box_mean: mean of four integers over a box, from a SAT in two halves. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// box_mean, tier C: within 19 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_BOX_MEAN
#define UMBRAGE_HAS_BOX_MEAN
// umbrage_box_mean: mean over a box of four integers below 65536.0
//   map, size    table from make_moment_table and its size
//   first, end   lowest texel of the box, and one past its highest. first < end
UMBRAGE_HIGHP vec4 umbrage_box_mean(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 first,
                                    UMBRAGE_HIGHP vec2 end) {
    UMBRAGE_HIGHP float right = size.x * 0.5;
    UMBRAGE_HIGHP vec4 a = umbrage_texel(map, size, end);
    UMBRAGE_HIGHP vec4 b = umbrage_texel(map, size, vec2(first.x, end.y));
    UMBRAGE_HIGHP vec4 c = umbrage_texel(map, size, vec2(end.x, first.y));
    UMBRAGE_HIGHP vec4 d = umbrage_texel(map, size, first);
    UMBRAGE_HIGHP vec4 low = (a - b) - (c - d);
    UMBRAGE_HIGHP vec4 carry = floor(low * (1.0 / 65536.0));
    a = umbrage_texel(map, size, vec2(right + end.x, end.y));
    b = umbrage_texel(map, size, vec2(right + first.x, end.y));
    c = umbrage_texel(map, size, vec2(right + end.x, first.y));
    d = umbrage_texel(map, size, vec2(right + first.x, first.y));
    UMBRAGE_HIGHP vec4 above = (a - b) - (c - d) + carry;
    UMBRAGE_HIGHP vec4 high = above - floor(above * (1.0 / 65536.0)) * 65536.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = high * 65536.0 + (low - carry * 65536.0);
    UMBRAGE_HIGHP vec2 sides = end - first;
    return sum / (sides.x * sides.y);
}
#endif
