// umbrage 0.1.0, decode_threejs_rg: three.js RG, r167 and later, to depth. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// decode_threejs_rg, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of threejs_rg: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255) / 255, with reversed
//   depth to (0, 0) / 255. Write umbrage_write_threejs_rg.

// umbrage_decode_threejs_rg: depth from the RG format of three.js r167 and later, as sampled
fn umbrage_decode_threejs_rg(c: vec2f) -> f32 {
    let depth: f32 = c.x * (255.0 / 256.0) + c.y * (1.0 / 256.0);
    return depth;
}
