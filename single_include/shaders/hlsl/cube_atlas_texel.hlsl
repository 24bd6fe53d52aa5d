// umbrage 0.1.0, cube_atlas_texel: face of an atlas texel, and the position on it. Exactness: tier A.
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
