// umbrage 0.1.0, penumbra: radius of a penumbra from the distance to the blocker. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_penumbra: radius of a penumbra along x and y in 1/16 texel, integers
//   apart      umbrage_distance_code of the receiver minus that of the blocker
//   softness   (1/16 texel per distance code along x and y, min_radius, max_radius), from make_penumbra_params
fn umbrage_penumbra(apart: f32, softness: vec4f) -> vec2f {
    let radius: vec2f = floor(vec2f(softness.x, softness.y) * apart);
    return min(max(radius, vec2f(softness.z, softness.z)), vec2f(softness.w, softness.w));
}
