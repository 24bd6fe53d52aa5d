// umbrage 0.1.0, covered: share of the texels around a point that lie in the map, along each axis. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// covered, tier C: within 6 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_covered: share of the texels around a point that lie in the map, along each axis. Here all of them count
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
fn umbrage_covered(size: vec2f, uv: vec2f) -> vec2f {
    return vec2f(1.0, 1.0);
}
