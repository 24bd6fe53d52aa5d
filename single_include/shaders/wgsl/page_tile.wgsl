// umbrage 0.1.0, page_tile: first texel of a page in an atlas of eight a row. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_page_tile: first texel of a page, a whole number, in an atlas of pages of size texels, eight a row
fn umbrage_page_tile(number: f32, size: f32) -> vec2f {
    let row: f32 = floor(number * 0.125);
    return vec2f(number - row * 8.0, row) * size;
}
