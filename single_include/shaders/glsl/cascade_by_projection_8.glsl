// umbrage 0.1.0, cascade_by_projection_8: first of eight cascades that contains a point and its filter. Exactness:
//   tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// cascade_by_projection_8, tier B: within 5 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CASCADE_COORDINATE
#define UMBRAGE_HAS_CASCADE_COORDINATE
// umbrage_cascade_coordinate: position in a cascade's map, texels and depth, of a point rotated into the light's axes
UMBRAGE_HIGHP vec3 umbrage_cascade_coordinate(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP vec4 scale,
                                              UMBRAGE_HIGHP vec4 offset) {
    UMBRAGE_HIGHP vec3 start = vec3(offset.x, offset.y, offset.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 at = light * vec3(scale.x, scale.y, scale.z) + start;
    return at;
}
#endif

#ifndef UMBRAGE_HAS_INSIDE_CASCADE
#define UMBRAGE_HAS_INSIDE_CASCADE
// umbrage_inside_cascade: true if a filter of radius reach at a coordinate stays inside a map of size texels
bool umbrage_inside_cascade(UMBRAGE_HIGHP vec3 coordinate, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP float reach) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 end = size - reach;
    // y is doubled because Mesa turns two comparisons with one limit into min(x, y) >= reach, which loses a NaN
    bool in_x = coordinate.x >= reach && coordinate.x <= end.x;
    bool in_y = coordinate.y * 2.0 >= reach * 2.0 && coordinate.y * 2.0 <= end.y * 2.0;
    return in_x && in_y && coordinate.z >= 0.0 && coordinate.z <= 1.0;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_BY_PROJECTION
#define UMBRAGE_HAS_CASCADE_BY_PROJECTION
// umbrage_cascade_by_projection: (texels, texels, depth, index) in the first of four cascades that contains a point
//   and its filter; if there is none, index 4.0 and a coordinate that every filter takes as lit
//   light            the point, rotated into the light's axes
//   scales, offsets  scales and offsets of the cascades
//   size             size of each map, in texels
//   reach            filter radius, in texels
UMBRAGE_HIGHP vec4 umbrage_cascade_by_projection(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP mat4 scales,
                                                 UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP vec2 size,
                                                 UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec3 a = umbrage_cascade_coordinate(light, scales[0], offsets[0]);
    UMBRAGE_HIGHP vec3 b = umbrage_cascade_coordinate(light, scales[1], offsets[1]);
    UMBRAGE_HIGHP vec3 c = umbrage_cascade_coordinate(light, scales[2], offsets[2]);
    UMBRAGE_HIGHP vec3 d = umbrage_cascade_coordinate(light, scales[3], offsets[3]);
    UMBRAGE_HIGHP vec4 found = vec4(65536.0, 65536.0, 0.0, 4.0);
    found = umbrage_inside_cascade(d, size, reach) ? vec4(d, 3.0) : found;
    found = umbrage_inside_cascade(c, size, reach) ? vec4(c, 2.0) : found;
    found = umbrage_inside_cascade(b, size, reach) ? vec4(b, 1.0) : found;
    return umbrage_inside_cascade(a, size, reach) ? vec4(a, 0.0) : found;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_BY_PROJECTION_8
#define UMBRAGE_HAS_CASCADE_BY_PROJECTION_8
// umbrage_cascade_by_projection_8: umbrage_cascade_by_projection for eight cascades, four and four; index 8.0 for none
UMBRAGE_HIGHP vec4 umbrage_cascade_by_projection_8(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP mat4 scales,
                                                   UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP mat4 farther_scales,
                                                   UMBRAGE_HIGHP mat4 farther_offsets, UMBRAGE_HIGHP vec2 size,
                                                   UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec4 nearer = umbrage_cascade_by_projection(light, scales, offsets, size, reach);
    UMBRAGE_HIGHP vec4 farther = umbrage_cascade_by_projection(light, farther_scales, farther_offsets, size, reach);
    return nearer.w < 3.5 ? nearer : vec4(farther.x, farther.y, farther.z, farther.w + 4.0);
}
#endif
