// umbrage 0.1.0, tetrahedron_face: face of a tetrahedron that a direction meets. Exactness: tier B.
// tetrahedron_face, tier B: within 1 x 2^-23 x S of the exact result.
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
