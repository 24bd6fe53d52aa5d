// umbrage 0.1.0, lit: one comparison with a texel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `sampler2D map`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Options, to define in front:
//   UMBRAGE_MAP                       type of the map, in place of sampler2D
//   UMBRAGE_FETCH(map, size, texel)   depth of a texel, in place of .x: for packed depths
//   UMBRAGE_CLAMPED                   outside the map the nearest texel inside counts; without it the far plane, lit
//   UMBRAGE_REVERSED                  depth is 1.0 at the near plane and 0.0 at the far plane
//   UMBRAGE_COMPARE(receiver, stored) 1.0 for a lit receiver, else 0.0

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

#ifndef UMBRAGE_HAS_COMPARE
#define UMBRAGE_HAS_COMPARE
// UMBRAGE_COMPARE: 1.0 when the receiver is no farther than the stored depth, after #define UMBRAGE_REVERSED no less
#ifndef UMBRAGE_COMPARE
#ifdef UMBRAGE_REVERSED
#define UMBRAGE_COMPARE(receiver, stored) ((receiver) >= (stored) ? 1.0 : 0.0)
#else
#define UMBRAGE_COMPARE(receiver, stored) ((receiver) <= (stored) ? 1.0 : 0.0)
#endif
#endif
// umbrage_compare: visibility of one comparison
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return UMBRAGE_COMPARE(receiver, stored);
}
#endif

#ifndef UMBRAGE_HAS_TEXEL
#define UMBRAGE_HAS_TEXEL
// umbrage_texel: value of a texel inside the map
//   map    2D sampler; before GLSL 1.30 its filter must be nearest
//   size   of the map in texels;   texel  whole numbers, (0, 0) is the first
#ifndef UMBRAGE_MAP
#define UMBRAGE_MAP UMBRAGE_HIGHP sampler2D
#endif
UMBRAGE_HIGHP vec4 umbrage_texel(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
#if __VERSION__ >= 130
    return texelFetch(map, ivec2(texel), 0);
#else
    return texture2D(map, (texel + 0.5) / size);
#endif
}
#endif

#ifndef UMBRAGE_HAS_FETCH_CLAMPED
#define UMBRAGE_HAS_FETCH_CLAMPED
// umbrage_fetch_clamped: texel of a map; coordinates outside move to the nearest texel inside
UMBRAGE_HIGHP vec4 umbrage_fetch_clamped(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return umbrage_texel(map, size, clamp(texel, vec2(0.0, 0.0), size - 1.0));
}
#endif

#ifndef UMBRAGE_HAS_FETCH_BORDERED
#define UMBRAGE_HAS_FETCH_BORDERED
// umbrage_fetch_bordered: texel of a map, or border outside of it
UMBRAGE_HIGHP vec4 umbrage_fetch_bordered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                          UMBRAGE_HIGHP vec4 border) {
    UMBRAGE_HIGHP vec2 at = clamp(texel, vec2(0.0, 0.0), size - 1.0);
    UMBRAGE_HIGHP vec4 value = umbrage_texel(map, size, at);
    return at.x == texel.x && at.y == texel.y ? value : border;
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane, 1.0; after #define UMBRAGE_REVERSED 0.0
UMBRAGE_HIGHP float umbrage_cleared_depth() {
#ifdef UMBRAGE_REVERSED
    return 0.0;
#else
    return 1.0;
#endif
}
#endif

#ifndef UMBRAGE_HAS_FETCH_DEPTH
#define UMBRAGE_HAS_FETCH_DEPTH
// UMBRAGE_FETCH: stored depth of a texel; define it beforehand for packed maps
// UMBRAGE_CLAMPED: define it and outside the map the nearest texel inside counts, where it is else the far plane
#ifndef UMBRAGE_FETCH
#ifdef UMBRAGE_CLAMPED
#define UMBRAGE_FETCH(map, size, texel) umbrage_fetch_clamped(map, size, texel).x
#else
#define UMBRAGE_FETCH(map, size, texel) umbrage_fetch_bordered(map, size, texel, vec4(umbrage_cleared_depth())).x
#endif
#endif
// umbrage_fetch_depth: stored depth of a texel
UMBRAGE_HIGHP float umbrage_fetch_depth(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return UMBRAGE_FETCH(map, size, texel);
}
#endif

#ifndef UMBRAGE_HAS_LIT
#define UMBRAGE_HAS_LIT
// umbrage_lit: visibility of one comparison with a texel
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
#endif
