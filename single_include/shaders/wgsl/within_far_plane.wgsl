// umbrage 0.1.0, within_far_plane: receivers up to the far plane; NaN is not. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

// umbrage_within_far_plane: true if a receiver is a number and not beyond the far plane
fn umbrage_within_far_plane(receiver: f32) -> bool {
    return receiver <= 1.0;
}
