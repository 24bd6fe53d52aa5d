// umbrage 0.1.0, before_far: receivers up to the far plane, NaN is none. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_BEFORE_FAR
#define UMBRAGE_HAS_BEFORE_FAR
// umbrage_before_far: whether a receiver is a number, and not behind the far plane
inline bool umbrage_before_far(float receiver) {
    return receiver <= 1.0;
}
#endif
