// umbrage 0.1.0, tetrahedron_turned: vector rotated from face 0's part of the map to another's. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_TETRAHEDRON_TURNED
#define UMBRAGE_HAS_TETRAHEDRON_TURNED
// umbrage_tetrahedron_turned: vector from face 0's part of the map, rotated to the part of a face, 0.0 to 3.0
float2 umbrage_tetrahedron_turned(float face, float2 v) {
    float2 z = face < 0.5 ? v : float2(-v.x, -v.y);
    float2 x = face < 2.5 ? float2(-v.y, v.x) : float2(v.y, -v.x);
    return face < 1.5 ? z : x;
}
#endif
