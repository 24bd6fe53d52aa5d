// umbrage 0.1.0, MIT License: hausdorff_share

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_HAUSDORFF_SHARE
#define UMBRAGE_HAS_HAUSDORFF_SHARE
// umbrage_hausdorff_share: least share of depths on -1.0 to 1.0 before the receiver's, of four moments
//   b  moments, biased;   z  the receiver's depth on -1.0 to 1.0
inline float umbrage_hausdorff_share(float4 b, float z) {
    float d = (b.z - b.x) - z * (b.y - 1.0);
    float n = (b.w - b.y) - z * (b.z - b.x);
    float f = n / d;
    float s = z + f;
    float p = z * f;
    float above = (b.z - (1.0 + s) * b.y) + ((s + p) * b.x - p);
    float below = -2.0 * ((1.0 + z) * (1.0 + f));
    float between = (f * f - 1.0) * (f - z);
    float end = above / below;
    float other = d / between;
    return end + (f < z ? other : 0.0);
}
#endif
