// umbrage 0.1.0, MIT License: beyond_far

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
