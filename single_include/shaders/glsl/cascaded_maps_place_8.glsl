// umbrage 0.1.0, cascaded_maps_place_8: place of a point of the world in one of up to eight cascades. Exactness: tier
//   C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// cascaded_maps_place_8, tier C: within 38 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CASCADE_COLUMN_8
#define UMBRAGE_HAS_CASCADE_COLUMN_8
// umbrage_cascade_column_8: column of two matrices by its index, 0.0 to 7.0
UMBRAGE_HIGHP vec4 umbrage_cascade_column_8(UMBRAGE_HIGHP mat4 nearer, UMBRAGE_HIGHP mat4 farther,
                                            UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP vec4 low = umbrage_cascade_column(nearer, number);
    UMBRAGE_HIGHP vec4 high = umbrage_cascade_column(farther, number - 4.0);
    return number < 3.5 ? low : high;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_SLOPE
#define UMBRAGE_HAS_CASCADE_SLOPE
// umbrage_cascade_slope: change of depth per texel; (0.0, 0.0) for a normal of zero
//   normal  surface normal, rotated into the light's axes
//   scale   scale of the cascade
UMBRAGE_HIGHP vec2 umbrage_cascade_slope(UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec4 scale) {
    UMBRAGE_HIGHP vec2 up = vec2(normal.x, normal.y) * -scale.z;
    UMBRAGE_HIGHP float z = normal.z == 0.0 ? 1.0e-18 : normal.z;  // up is zero without a normal, and not where edge-on
    UMBRAGE_HIGHP vec2 across = vec2(scale.x, scale.y) * z;
    return vec2(up.x / across.x, up.y / across.y);
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_PLACE
#define UMBRAGE_HAS_CASCADE_PLACE
// umbrage_cascade_place: place of a point in one cascade
//   light, across   the point and its normal, rotated into the light's axes
//   scale, offset   those of the cascade. w: slack of a plane in texels of slope, and in depth
//   number, last    number of the cascade and of the last one; above it the place is outside all maps, where all is lit
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
UMBRAGE_HIGHP mat4 umbrage_cascade_place(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP vec3 across,
                                         UMBRAGE_HIGHP vec4 scale, UMBRAGE_HIGHP vec4 offset,
                                         UMBRAGE_HIGHP float number, UMBRAGE_HIGHP float last) {
    UMBRAGE_HIGHP vec4 none = vec4(0.0, 0.0, 0.0, 0.0);
    UMBRAGE_HIGHP vec3 at = light * vec3(scale.x, scale.y, scale.z) + vec3(offset.x, offset.y, offset.z);
    UMBRAGE_HIGHP float x = number <= last ? at.x : -65536.0;
    UMBRAGE_HIGHP vec2 slope = umbrage_cascade_slope(across, scale);
    UMBRAGE_HIGHP float slack = (abs(slope.x) + abs(slope.y)) * scale.w + offset.w;
    return mat4(vec4(x, at.y, at.z, min(number, last)), vec4(slope, 1.0, slack), none, none);
}
#endif

#ifndef UMBRAGE_HAS_CASCADED_MAPS_PLACE_8
#define UMBRAGE_HAS_CASCADED_MAPS_PLACE_8
// umbrage_cascaded_maps_place_8: umbrage_cascaded_maps_place for up to eight cascades
//   farther_scales, farther_offsets   those of the fifth cascade and of those after it
UMBRAGE_HIGHP mat4 umbrage_cascaded_maps_place_8(UMBRAGE_HIGHP mat4 rotation, UMBRAGE_HIGHP mat4 scales,
                                                 UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP mat4 farther_scales,
                                                 UMBRAGE_HIGHP mat4 farther_offsets, UMBRAGE_HIGHP vec4 anchor,
                                                 UMBRAGE_HIGHP vec4 blending, UMBRAGE_HIGHP vec4 terms,
                                                 UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal,
                                                 UMBRAGE_HIGHP float number) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 light =
        rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    UMBRAGE_HIGHP vec4 across =
        rotation[3] + rotation[0] * normal.x + rotation[1] * normal.y + rotation[2] * normal.z;
    UMBRAGE_HIGHP float own = min(number, blending.y);
    return umbrage_cascade_place(vec3(light.x, light.y, light.z), vec3(across.x, across.y, across.z),
                                 umbrage_cascade_column_8(scales, farther_scales, own),
                                 umbrage_cascade_column_8(offsets, farther_offsets, own), number, blending.y);
}
#endif
