// umbrage 0.1.0, cube_atlas_direction: direction that reads an atlas texel from a cube texture. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_CUBE_ATLAS_TEXEL
#define UMBRAGE_HAS_CUBE_ATLAS_TEXEL
// umbrage_cube_atlas_texel: (s, t, face) of a texel in an atlas of 3 x 2 tiles of size texels; integers
float3 umbrage_cube_atlas_texel(float2 texel, float size) {
    float column = texel.x < size ? 0.0 : (texel.x < size * 2.0 ? 1.0 : 2.0);
    float row = texel.y < size ? 0.0 : 1.0;
    return float3(texel - float2(column, row) * size, column + row * 3.0);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_POINT
#define UMBRAGE_HAS_CUBE_POINT
// umbrage_cube_point: point from (sc, tc, distance along the axis) in a face, 0.0 to 5.0
float3 umbrage_cube_point(float face, float3 p) {
    float3 x = face < 0.5 ? float3(p.z, -p.y, -p.x) : float3(-p.z, -p.y, p.x);
    float3 y = face < 2.5 ? float3(p.x, p.z, p.y) : float3(p.x, -p.z, -p.y);
    float3 z = face < 4.5 ? float3(p.x, -p.y, p.z) : float3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_ATLAS_DIRECTION
#define UMBRAGE_HAS_CUBE_ATLAS_DIRECTION
// umbrage_cube_atlas_direction: direction from a cube's center to an atlas texel, for 3 x 2 tiles of size texels
float3 umbrage_cube_atlas_direction(float2 texel, float size) {
    float3 part = umbrage_cube_atlas_texel(texel, size);
    float2 uv = float2(part.x, part.y) * 2.0 + (1.0 - size);
    return umbrage_cube_point(part.z, float3(uv, size));
}
#endif
