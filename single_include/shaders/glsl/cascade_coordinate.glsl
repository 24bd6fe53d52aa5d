// umbrage 0.1.0, cascade_coordinate: position of a point in one cascade's map. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// cascade_coordinate, tier B: within 2 x 2^-23 x S of the exact result.
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
