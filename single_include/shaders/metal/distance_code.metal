// umbrage 0.1.0, MIT License: distance_code

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_SATURATE
#define UMBRAGE_HAS_SATURATE
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
inline float umbrage_saturate(float v) {
    // not v > 0.0 ? v : 0.0, of which Mesa makes max(v, 0.0): softpipe's gives NaN for a signalling one
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
#endif

#ifndef UMBRAGE_HAS_DISTANCE_CODE
#define UMBRAGE_HAS_DISTANCE_CODE
// umbrage_distance_code: a depth as whole number from 0.0 at the near plane to 65535.0, also where depth is reversed
inline float umbrage_distance_code(float depth) {
    float code = metal::min(metal::floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    return umbrage_cleared_depth() > 0.5 ? code : 65535.0 - code;
}
#endif
