// umbrage 0.1.0, bleed_cut: visibility without its least values. Exactness: tier C.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_BLEED_CUT
#define UMBRAGE_HAS_BLEED_CUT
// umbrage_bleed_cut: visibility from amount to 1.0 stretched to 0.0 to 1.0, so that less light bleeds through
float umbrage_bleed_cut(float visibility, float amount) {
    float stretched = (visibility - amount) / (1.0 - amount);
    return visibility > amount ? stretched : 0.0;
}
#endif
