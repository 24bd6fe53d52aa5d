// umbrage 0.1.0, tetrahedron_face_point: direction in the axes of a tetrahedron's face. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_TETRAHEDRON_FACE_POINT
#define UMBRAGE_HAS_TETRAHEDRON_FACE_POINT
// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
inline float3 umbrage_tetrahedron_face_point(float face, float3 d) {
    float3 z = face < 0.5 ? float3(-d.x, d.y, d.z) : float3(d.x, d.y, -d.z);
    float3 x = face < 2.5 ? float3(-d.z, -d.y, d.x) : float3(d.z, -d.y, -d.x);
    return face < 1.5 ? z : x;
}
#endif
