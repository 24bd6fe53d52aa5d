// umbrage 0.1.0, texels_to_world: texels across a light to world units. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// texels_to_world, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_texels_to_world: texels across a light as world units; 0.0 for w <= 0.0
//   units  (edge of a texel, depth per world unit) at w = 1.0
//   w      w of the point's shadow coordinate
fn umbrage_texels_to_world(texels: f32, units: vec2f, w: f32) -> f32 {
    let world: f32 = texels * units.x * w;
    return select(0.0, world, world >= (1.0 / 18446744073709551616.0) && world < 18446744073709551616.0);
}
