// umbrage 0.1.0, warped_maps_choice: warped cascade that holds a point of the world, and weight of the next one.
//   Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// warped_maps_choice, tier C: within 12 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CASCADE_BY_DEPTH
#define UMBRAGE_HAS_CASCADE_BY_DEPTH
// umbrage_cascade_by_depth: cascade that contains a distance along the camera's axis, 0.0 to 3.0
//   ends  ends of the first three cascades, increasing
UMBRAGE_HIGHP float umbrage_cascade_by_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP vec3 ends) {
    UMBRAGE_HIGHP int reached = int(depth >= ends.x) + int(depth >= ends.y) + int(depth >= ends.z);
    return float(reached);
}
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

#ifndef UMBRAGE_HAS_CASCADE_WEIGHT
#define UMBRAGE_HAS_CASCADE_WEIGHT
// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
UMBRAGE_HIGHP float umbrage_cascade_weight(UMBRAGE_HIGHP float v) {
    return v > 0.0 ? min(floor(v * 256.0), 256.0) * (1.0 / 256.0) : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_FADE
#define UMBRAGE_HAS_CASCADE_FADE
// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis: depth * scale + offset
UMBRAGE_HIGHP float umbrage_cascade_fade(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float scale,
                                         UMBRAGE_HIGHP float offset) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float v = depth * scale + offset;
    return umbrage_cascade_weight(v);
}
#endif

#ifndef UMBRAGE_HAS_WARPED_MAPS_CHOICE
#define UMBRAGE_HAS_WARPED_MAPS_CHOICE
// umbrage_warped_maps_choice: number of the warped cascade that holds a point of the world, and weight of the next one
//   fades    one column per map: scale and offset of the next one's weight
//   anchor   the one anchor of all maps
//   ahead    distance along the camera's axis: dot(ahead.xyz, world - anchor) + ahead.w
//   ends     ends of the first three cascades, number of the last one
UMBRAGE_HIGHP vec2 umbrage_warped_maps_choice(UMBRAGE_HIGHP mat4 fades, UMBRAGE_HIGHP vec4 anchor,
                                              UMBRAGE_HIGHP vec4 ahead, UMBRAGE_HIGHP vec4 ends,
                                              UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = ahead.x * way.x + ahead.y * way.y + ahead.z * way.z + ahead.w;
    UMBRAGE_HIGHP float number = umbrage_cascade_by_depth(depth, vec3(ends.x, ends.y, ends.z));
    UMBRAGE_HIGHP vec4 own = umbrage_cascade_column(fades, number);
    return vec2(number, umbrage_cascade_fade(depth, own.x, own.y));
}
#endif
