// umbrage 0.1.0, tetrahedron_shape: shape of penumbras at a texel of a tetrahedron's map. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_TETRAHEDRON_SHAPE
#define UMBRAGE_HAS_TETRAHEDRON_SHAPE
// umbrage_tetrahedron_shape: shape of penumbras at a texel of a tetrahedron's map
//   center   x: half the map's size in texels
//   number   not read
//   at       place in the map, texels
//   returns factors of face 0's softness in x and y, and no shear
UMBRAGE_HIGHP vec3 umbrage_tetrahedron_shape(UMBRAGE_HIGHP vec4 center, UMBRAGE_HIGHP float number,
                                             UMBRAGE_HIGHP vec2 at) {
    bool beside = abs(at.x - center.x) > abs(at.y - center.x);
    return beside ? vec3(0.577350269, 1.73205081, 0.0) : vec3(1.0, 1.0, 0.0);
}
#endif
