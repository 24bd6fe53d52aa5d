// umbrage 0.1.0, cube_face_point: point in a face's axes. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_CUBE_FACE_POINT
#define UMBRAGE_HAS_CUBE_FACE_POINT
// umbrage_cube_face_point: (sc, tc, distance along the axis) in a face, 0.0 to 5.0, of a point from the cube's center
float3 umbrage_cube_face_point(float face, float3 p) {
    float3 x = face < 0.5 ? float3(-p.z, -p.y, p.x) : float3(p.z, -p.y, -p.x);
    float3 y = face < 2.5 ? float3(p.x, p.z, p.y) : float3(p.x, -p.z, -p.y);
    float3 z = face < 4.5 ? float3(p.x, -p.y, p.z) : float3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
#endif
