// umbrage 0.1.0, map_softness: one of eight pairs of a matrix, without dynamic indexing. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
fn umbrage_cascade_column(columns: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = select(columns[1], columns[0], number < 0.5);
    let high: vec4f = select(columns[3], columns[2], number < 2.5);
    return select(high, low, number < 1.5);
}

// umbrage_map_softness: one of eight pairs of a matrix, two a column, by its index, 0.0 to 7.0
fn umbrage_map_softness(eight: mat4x4f, number: f32) -> vec2f {
    let column: f32 = floor(number * 0.5);
    let two: vec4f = umbrage_cascade_column(eight, column);
    return select(vec2f(two.z, two.w), vec2f(two.x, two.y), number - 2.0 * column < 0.5);
}
