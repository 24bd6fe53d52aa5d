// umbrage 0.1.0, cascade_place: place of a point in one cascade. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// cascade_place, tier C: within 14 x 2^-23 x S of the exact result.
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
