// umbrage 0.1.0, warp_shape: shape of penumbras at a texel of a warped map. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// warp_shape, tier C: within 29 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
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

#ifndef UMBRAGE_HAS_CASCADE_COLUMN
#define UMBRAGE_HAS_CASCADE_COLUMN
// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
UMBRAGE_HIGHP vec4 umbrage_cascade_column(UMBRAGE_HIGHP mat4 columns, UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP vec4 low = number < 0.5 ? columns[0] : columns[1];
    UMBRAGE_HIGHP vec4 high = number < 2.5 ? columns[2] : columns[3];
    return number < 1.5 ? low : high;
}
#endif

#ifndef UMBRAGE_HAS_WARP_SHAPE
#define UMBRAGE_HAS_WARP_SHAPE
// umbrage_warp_shape: shape of penumbras at a texel of a warped map
//   warps    one column per map: (change of w along both axes, shear, ratio) of its texel (0, 0)
//   number   number of the map
//   at       place in the map, texels
//   returns factors of the map's softness in x and y, and the shear
UMBRAGE_HIGHP vec3 umbrage_warp_shape(UMBRAGE_HIGHP mat4 warps, UMBRAGE_HIGHP float number, UMBRAGE_HIGHP vec2 at) {
    UMBRAGE_HIGHP vec4 own = umbrage_cascade_column(warps, number);
    UMBRAGE_HIGHP vec2 a = vec2(1.0 - at.x * own.x, own.z - at.x * own.y);
    UMBRAGE_HIGHP vec2 b = vec2(-at.y * own.w * own.x, 1.0 - at.y * own.w * own.y);
    UMBRAGE_HIGHP float area = abs(a.x * b.y - a.y * b.x);
    UMBRAGE_HIGHP float rows = length(b);
    return vec3(area / rows, rows, clamp(dot(a, b) / area, -8.0, 8.0));
}
#endif
