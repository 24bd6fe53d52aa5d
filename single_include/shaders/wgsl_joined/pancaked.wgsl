// umbrage 0.1.0, pancaked: casters before the near plane, onto it. Exactness: tier B.
// Tier B: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_pancaked: a clip space position, moved onto the near plane where it lies before it
//   at_near  z/w of the near plane: 0.0 or -1.0, or 1.0 for reversed depth
fn umbrage_pancaked(position: vec4f, at_near: f32) -> vec4f {
    let plane: f32 = at_near * position.w;
    let before: bool = select((position.z < plane), (position.z > plane), at_near > 0.5);
    return vec4f(position.x, position.y, select(position.z, plane, before), position.w);
}
