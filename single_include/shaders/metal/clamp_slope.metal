// umbrage 0.1.0, MIT License: clamp_slope

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CLAMP_SLOPE
#define UMBRAGE_HAS_CLAMP_SLOPE
// umbrage_clamp_slope: change of depth a texel clamped to [-2, 2]; NaN becomes 2.0
inline float umbrage_clamp_slope(float slope) {
    return slope > -2.0 && slope < 2.0 ? slope : (slope <= -2.0 ? -2.0 : 2.0);
}
#endif
