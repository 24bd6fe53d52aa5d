// umbrage 0.1.0, cascade_column_8: one of eight columns, without dynamic indexing. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
fn umbrage_cascade_column(columns: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = select(columns[1], columns[0], number < 0.5);
    let high: vec4f = select(columns[3], columns[2], number < 2.5);
    return select(high, low, number < 1.5);
}

// umbrage_cascade_column_8: column of two matrices by its index, 0.0 to 7.0
fn umbrage_cascade_column_8(nearer: mat4x4f, farther: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = umbrage_cascade_column(nearer, number);
    let high: vec4f = umbrage_cascade_column(farther, number - 4.0);
    return select(high, low, number < 3.5);
}
