// umbrage 0.1.0, cascade_column: one of four columns, without dynamic indexing. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CASCADE_COLUMN
#define UMBRAGE_HAS_CASCADE_COLUMN
// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
inline float4 umbrage_cascade_column(metal::float4x4 columns, float number) {
    float4 low = number < 0.5 ? columns[0] : columns[1];
    float4 high = number < 2.5 ? columns[2] : columns[3];
    return number < 1.5 ? low : high;
}
#endif
