// umbrage 0.1.0, tetrahedron_face_of: face of a tetrahedron that contains a texel. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_TETRAHEDRON_FACE_OF
#define UMBRAGE_HAS_TETRAHEDRON_FACE_OF
// umbrage_tetrahedron_face_of: face, 0.0 to 3.0, whose triangle contains a texel, in a map of size texels
UMBRAGE_HIGHP float umbrage_tetrahedron_face_of(UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP vec2 off = texel * 2.0 + (1.0 - size);
    UMBRAGE_HIGHP float column = off.y < 0.0 ? 0.0 : 1.0;
    UMBRAGE_HIGHP float row = off.x < 0.0 ? 3.0 : 2.0;
    return abs(off.y) >= abs(off.x) ? column : row;
}
#endif
