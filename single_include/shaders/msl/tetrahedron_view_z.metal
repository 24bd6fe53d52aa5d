// umbrage 0.1.0, tetrahedron_view_z: distance along the normal of a direction's face. Exactness: tier B.
// tetrahedron_view_z, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_TETRAHEDRON_FACE
#define UMBRAGE_HAS_TETRAHEDRON_FACE
// umbrage_tetrahedron_face: face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
inline float umbrage_tetrahedron_face(float3 direction) {
    float beside = metal::abs(direction.z) - metal::abs(direction.x);
    float up = direction.y * 1.414213562;
    float z = direction.z < 0.0 ? 1.0 : 0.0;
    float x = direction.x < 0.0 ? 3.0 : 2.0;
    return beside >= up ? z : x;
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_FACE_POINT
#define UMBRAGE_HAS_TETRAHEDRON_FACE_POINT
// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
inline float3 umbrage_tetrahedron_face_point(float face, float3 d) {
    float3 z = face < 0.5 ? float3(-d.x, d.y, d.z) : float3(d.x, d.y, -d.z);
    float3 x = face < 2.5 ? float3(-d.z, -d.y, d.x) : float3(d.z, -d.y, -d.x);
    return face < 1.5 ? z : x;
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_PLANE
#define UMBRAGE_HAS_TETRAHEDRON_PLANE
// umbrage_tetrahedron_plane: (along the base, up, away) of a direction in the axes of the face that it meets
inline float3 umbrage_tetrahedron_plane(float3 direction) {
    return umbrage_tetrahedron_face_point(umbrage_tetrahedron_face(direction), direction);
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_VIEW_Z
#define UMBRAGE_HAS_TETRAHEDRON_VIEW_Z
// umbrage_tetrahedron_view_z: distance along the face's normal, the input of per-face depths
inline float umbrage_tetrahedron_view_z(float3 direction) {
    float3 p = umbrage_tetrahedron_plane(direction);
    float z = p.z * 0.816496581 + p.y * -0.577350269;
    return z;
}
#endif
