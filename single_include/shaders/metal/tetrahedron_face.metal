// umbrage 0.1.0, MIT License: tetrahedron_face

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_TETRAHEDRON_FACE
#define UMBRAGE_HAS_TETRAHEDRON_FACE
// umbrage_tetrahedron_face: the face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
inline float umbrage_tetrahedron_face(float3 direction) {
    float beside = metal::abs(direction.z) - metal::abs(direction.x);
    float up = direction.y * 1.414213562;
    float z = direction.z < 0.0 ? 1.0 : 0.0;
    float x = direction.x < 0.0 ? 3.0 : 2.0;
    return beside >= up ? z : x;
}
#endif
