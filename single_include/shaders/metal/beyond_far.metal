// umbrage 0.1.0, beyond_far: receivers behind the far plane. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_BEYOND_FAR
#define UMBRAGE_HAS_BEYOND_FAR
// umbrage_beyond_far: whether a receiver is behind the far plane
inline bool umbrage_beyond_far(float receiver) {
    return receiver > 1.0;
}
#endif
