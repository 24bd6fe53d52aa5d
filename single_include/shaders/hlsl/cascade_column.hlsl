// umbrage 0.1.0, cascade_column: one of four columns, without dynamic indexing. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_CASCADE_COLUMN
#define UMBRAGE_HAS_CASCADE_COLUMN
// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
float4 umbrage_cascade_column(float4x4 columns, float number) {
    float4 low = number < 0.5 ? transpose(columns)[0] : transpose(columns)[1];
    float4 high = number < 2.5 ? transpose(columns)[2] : transpose(columns)[3];
    return number < 1.5 ? low : high;
}
#endif
