// umbrage 0.1.0, cascade_column_8: one of eight columns, without dynamic indexing. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_CASCADE_COLUMN_8
#define UMBRAGE_HAS_CASCADE_COLUMN_8
// umbrage_cascade_column_8: column of two matrices by its index, 0.0 to 7.0
float4 umbrage_cascade_column_8(float4x4 nearer, float4x4 farther, float number) {
    float4 low = umbrage_cascade_column(nearer, number);
    float4 high = umbrage_cascade_column(farther, number - 4.0);
    return number < 3.5 ? low : high;
}
#endif
