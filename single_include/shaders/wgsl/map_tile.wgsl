// umbrage 0.1.0, map_tile: first texel of a map in an atlas of equal maps. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_map_tile: first texel of a map in an atlas of maps of size texels, row by row
//   number    number of the map, a whole number
//   columns   maps per row, and 1.0 / their number
fn umbrage_map_tile(number: f32, columns: vec2f, size: vec2f) -> vec2f {
    let row: f32 = floor((number + 0.5) * columns.y);
    return vec2f(number - row * columns.x, row) * size;
}
