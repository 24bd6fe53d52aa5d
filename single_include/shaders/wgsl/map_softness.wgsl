// umbrage 0.1.0, map_softness: one of 16 numbers of a matrix, without dynamic indexing. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
fn umbrage_cascade_column(columns: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = select(columns[1], columns[0], number < 0.5);
    let high: vec4f = select(columns[3], columns[2], number < 2.5);
    return select(high, low, number < 1.5);
}

// umbrage_map_softness: one of 16 numbers of a matrix, column by column, by its index, 0.0 to 15.0
fn umbrage_map_softness(sixteen: mat4x4f, number: f32) -> f32 {
    let column: f32 = floor(number * 0.25);
    let i: f32 = number - 4.0 * column;
    let four: vec4f = umbrage_cascade_column(sixteen, column);
    let low: f32 = select(four.y, four.x, i < 0.5);
    let high: f32 = select(four.w, four.z, i < 2.5);
    return select(high, low, i < 1.5);
}
