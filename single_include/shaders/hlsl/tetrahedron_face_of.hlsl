// umbrage 0.1.0, tetrahedron_face_of: face of a tetrahedron that contains a texel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_TETRAHEDRON_FACE_OF
#define UMBRAGE_HAS_TETRAHEDRON_FACE_OF
// umbrage_tetrahedron_face_of: face, 0.0 to 3.0, whose triangle contains a texel, in a map of size texels
float umbrage_tetrahedron_face_of(float2 texel, float size) {
    float2 off = texel * 2.0 + (1.0 - size);
    float column = off.y < 0.0 ? 0.0 : 1.0;
    float row = off.x < 0.0 ? 3.0 : 2.0;
    return abs(off.y) >= abs(off.x) ? column : row;
}
#endif
