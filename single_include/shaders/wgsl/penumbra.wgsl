// umbrage 0.1.0, penumbra: radius of a penumbra from the distance to the blocker. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_penumbra: radius of a penumbra in 1/16 texel, an integer
//   apart      umbrage_distance_code of the receiver minus that of the blocker
//   softness   (1/16 texel per distance code, min_radius, max_radius), from make_penumbra_params
fn umbrage_penumbra(apart: f32, softness: vec3f) -> f32 {
    return min(max(floor(apart * softness.x), softness.y), softness.z);
}
