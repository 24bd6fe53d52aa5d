// umbrage 0.1.0, cascade_edge: texels beyond the part of a cascade where a filter stays inside. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// cascade_edge, tier C: within 13 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CASCADE_EDGE
#define UMBRAGE_HAS_CASCADE_EDGE
// umbrage_cascade_edge: texels beyond the part of a cascade's map where a filter stays inside, at most 0.0 inside
//   light          the point, rotated into the light's axes
//   scale, offset  those of the cascade
//   size, reach    size of the map and filter radius, in texels
// Returns 65536.0 for a depth outside [0, 1], and for NaN there
UMBRAGE_HIGHP float umbrage_cascade_edge(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP vec4 scale, UMBRAGE_HIGHP vec4 offset,
                                         UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec3 at = light * vec3(scale.x, scale.y, scale.z) + vec3(offset.x, offset.y, offset.z);
    UMBRAGE_HIGHP vec2 half_size = size * 0.5;
    UMBRAGE_HIGHP vec2 beyond = abs(vec2(at.x, at.y) - half_size) - (half_size - reach);
    return abs(at.z - 0.5) <= 0.5 ? max(beyond.x, beyond.y) : 65536.0;
}
#endif
