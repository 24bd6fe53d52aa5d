// umbrage 0.1.0, level_rg15: two channels to a level to compare with. Exactness: tier B.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_LEVEL_RG15
#define UMBRAGE_HAS_LEVEL_RG15
// umbrage_level_rg15: two channels of a 15-bit code, as sampled, to the scale of umbrage_receiver_rg15, on which 1.0 is
//   not the far plane
float umbrage_level_rg15(float2 c) {
    return c.x + c.y * 128.0;  // an exact product: fused or not, it rounds once
}
#endif
