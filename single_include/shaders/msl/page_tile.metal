// umbrage 0.1.0, page_tile: first texel of a page in an atlas of eight a row. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_PAGE_TILE
#define UMBRAGE_HAS_PAGE_TILE
// umbrage_page_tile: first texel of a page, a whole number, in an atlas of pages of size texels, eight a row
inline float2 umbrage_page_tile(float number, float size) {
    float row = metal::floor(number * 0.125);
    return float2(number - row * 8.0, row) * size;
}
#endif
