// umbrage 0.1.0, decode_threejs_rgba: three.js RGBA, r167 and later, to depth. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// decode_threejs_rgba, tier B: within 7 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of threejs_rgba: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255, 255) / 255,
//   with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_write_threejs_rgba.

// umbrage_decode_threejs_rgba: depth from the RGBA format of three.js r167 and later, as sampled
fn umbrage_decode_threejs_rgba(c: vec4f) -> f32 {
    let depth: f32 = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (255.0 / 16777216.0) + c.w *
        (1.0 / 16777216.0);
    return depth;
}
