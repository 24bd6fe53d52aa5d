// umbrage 0.1.0, bordered_plane_reference: plane_reference in a map whose border is lit. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// bordered_plane_reference, tier B: within 8 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

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

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_BORDERED_PLANE_REFERENCE
#define UMBRAGE_HAS_BORDERED_PLANE_REFERENCE
// umbrage_bordered_plane_reference: umbrage_plane_reference, but before every stored depth outside the map
//   slope, at, texel   as for umbrage_plane_reference
//   inside             texel if the map has it, otherwise any other
UMBRAGE_HIGHP float umbrage_bordered_plane_reference(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP vec3 at,
                                                     UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP vec2 inside) {
    UMBRAGE_HIGHP float lights = umbrage_cleared_depth() > 0.5 ? -16777216.0 : 16777216.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 moves = slope * (texel - (vec2(at.x, at.y) - 0.5));
    UMBRAGE_HIGHP float x = inside.x == texel.x ? moves.x : lights;  // the same for all texels of a column
    UMBRAGE_HIGHP float y = inside.y == texel.y ? moves.y : lights;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float plane = (at.z + x) + y;
    return umbrage_cleared_depth() > 0.5 ? min(plane, at.z) : max(plane, at.z);
}
#endif
