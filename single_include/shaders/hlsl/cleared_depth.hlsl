// umbrage 0.1.0, cleared_depth: depth of the far plane. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
float umbrage_cleared_depth() {
    return 1.0;
}
#endif
