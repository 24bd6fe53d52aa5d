// umbrage 0.1.0, in_filter_domain: true for receivers that a filter compares; others are lit. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl; or paste wgsl_joined/in_filter_domain.wgsl alone.

// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
fn umbrage_in_filter_domain(coord: vec2f, receiver: f32) -> bool {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return select(umbrage_inside_texel_space(coord), false, umbrage_beyond_far_plane(receiver));
}
