// umbrage 0.1.0, MIT License: before_far

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
