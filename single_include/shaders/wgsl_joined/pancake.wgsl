// umbrage 0.1.0, pancake: casters clamped to the near plane (pancaking). Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// pancake, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_pancake: clip space position, clamped to the near plane if it lies in front of it
//   at_near  z/w of the near plane: 0.0 or -1.0, or 1.0 for reversed depth
fn umbrage_pancake(position: vec4f, at_near: f32) -> vec4f {
    let plane: f32 = at_near * position.w;
    let before: bool = select((position.z < plane), (position.z > plane), at_near > 0.5);
    return vec4f(position.x, position.y, select(position.z, plane, before), position.w);
}
