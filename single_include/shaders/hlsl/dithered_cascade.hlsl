// umbrage 0.1.0, dithered_cascade: cascade of a pixel, or the next one, by its weight. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_DITHERED_CASCADE
#define UMBRAGE_HAS_DITHERED_CASCADE
// umbrage_dithered_cascade: index of a cascade, or of the next one if its weight is above the pixel's threshold
float umbrage_dithered_cascade(float number, float weight, float threshold) {
    return number + (weight > threshold ? 1.0 : 0.0);
}
#endif
