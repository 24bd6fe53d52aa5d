// umbrage 0.1.0, cascade_tile: first texel of a cascade in an atlas. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_CASCADE_TILE
#define UMBRAGE_HAS_CASCADE_TILE
// umbrage_cascade_tile: first texel of a cascade in an atlas with two tiles of size texels per row
float2 umbrage_cascade_tile(float number, float2 size) {
    float row = floor(number * 0.5);
    return float2(number - row * 2.0, row) * size;
}
#endif
