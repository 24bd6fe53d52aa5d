// umbrage 0.1.0, within_far_plane: receivers up to the far plane; NaN is not. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#ifndef UMBRAGE_HAS_WITHIN_FAR_PLANE
#define UMBRAGE_HAS_WITHIN_FAR_PLANE
// umbrage_within_far_plane: true if a receiver is a number and not beyond the far plane
precise bool umbrage_within_far_plane(float receiver) {
    return receiver <= 1.0;
}
#endif
