// umbrage 0.1.0, cube_view_z: distance along the axis of a direction's face. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CUBE_FACE
#define UMBRAGE_HAS_CUBE_FACE
// umbrage_cube_face: face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
inline float umbrage_cube_face(float3 direction) {
    float3 m = metal::abs(direction);
    float x = direction.x < 0.0 ? 1.0 : 0.0;
    float y = direction.y < 0.0 ? 3.0 : 2.0;
    float z = direction.z < 0.0 ? 5.0 : 4.0;
    // not m.x >= m.y && m.x >= m.z: Mesa turns it into one comparison with max(m.y, m.z), which loses a NaN
    return m.x >= m.y ? (m.x >= m.z ? x : z) : (m.y >= m.z ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_VIEW_Z
#define UMBRAGE_HAS_CUBE_VIEW_Z
// umbrage_cube_view_z: magnitude of the largest component, the input of per-face depths
inline float umbrage_cube_view_z(float3 direction) {
    float face = umbrage_cube_face(direction);
    float side = face < 1.5 ? direction.x : direction.y;
    return metal::abs(face > 3.5 ? direction.z : side);
}
#endif
