// umbrage 0.1.0, tetrahedron_texel: position in the map of a point on a tetrahedron's face. Exactness: tier B.
// tetrahedron_texel, tier B: within 9 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
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

#ifndef UMBRAGE_HAS_TETRAHEDRON_TEXEL
#define UMBRAGE_HAS_TETRAHEDRON_TEXEL
// umbrage_tetrahedron_texel: position in a square map, in texels, from (s, t, face) on a tetrahedron
//   size    size of the map, in texels
//   border  border along the sides of each triangle, in texels
float2 umbrage_tetrahedron_texel(float3 at, float size, float border) {
    float half_size = size * 0.5;
    float scale = half_size - border * 3.0;
    precise float x = at.x * scale;
    precise float y = at.y * scale + (border - half_size);
    precise float2 texel = umbrage_tetrahedron_turned(at.z, float2(x, y)) + half_size;
    return texel;
}
#endif
