// umbrage 0.1.0, MIT License: dithered_cascade

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_DITHERED_CASCADE
#define UMBRAGE_HAS_DITHERED_CASCADE
// umbrage_dithered_cascade: number of a cascade, or of the next one where its weight is above the pixel's threshold
inline float umbrage_dithered_cascade(float number, float weight, float threshold) {
    return number + (weight > threshold ? 1.0 : 0.0);
}
#endif
