// umbrage 0.1.0, parallel_map_places: place of a point of the world in the one map of a light with parallel rays.
//   Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// parallel_map_places, tier C: within 121 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_PARALLEL_MAP_PLACES
#define UMBRAGE_HAS_PARALLEL_MAP_PLACES
// umbrage_parallel_map_places: umbrage_single_map_places under parallel rays, where w is 1
UMBRAGE_HIGHP mat4 umbrage_parallel_map_places(UMBRAGE_HIGHP mat4 to_texels, UMBRAGE_HIGHP mat4 planes,
                                               UMBRAGE_HIGHP vec4 anchor, UMBRAGE_HIGHP vec4 rounding,
                                               UMBRAGE_HIGHP vec4 slack, UMBRAGE_HIGHP vec4 terms,
                                               UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec4 none = vec4(0.0, 0.0, 0.0, 0.0);
    UMBRAGE_HIGHP vec4 one = vec4(1.0, 1.0, 1.0, 1.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 c = to_texels[3] + to_texels[0] * way.x + to_texels[1] * way.y + to_texels[2] * way.z;
    UMBRAGE_HIGHP vec4 q = planes[0] * normal.x + planes[1] * normal.y + planes[2] * normal.z;
    UMBRAGE_HIGHP vec2 slope = umbrage_cascade_slope(vec3(q.x, q.y, q.z), one);
    UMBRAGE_HIGHP float steep = abs(slope.x) + abs(slope.y);
    UMBRAGE_HIGHP float off = abs(c.z) * slack.y + slack.z;
    return mat4(vec4(c.x, c.y, c.z + slack.w, 0.0), vec4(slope, 1.0, slack.x * steep + off), none, none);
}
#endif
