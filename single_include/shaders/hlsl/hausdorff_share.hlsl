// umbrage 0.1.0, MIT License: hausdorff_share

#ifndef UMBRAGE_HAS_HAUSDORFF_SHARE
#define UMBRAGE_HAS_HAUSDORFF_SHARE
// umbrage_hausdorff_share: least share of depths on -1.0 to 1.0 before the receiver's, of four moments
//   b  moments, biased;   z  the receiver's depth on -1.0 to 1.0
float umbrage_hausdorff_share(float4 b, float z) {
    precise float d = (b.z - b.x) - z * (b.y - 1.0);
    precise float n = (b.w - b.y) - z * (b.z - b.x);
    float f = n / d;
    precise float s = z + f;
    precise float p = z * f;
    precise float above = (b.z - (1.0 + s) * b.y) + ((s + p) * b.x - p);
    precise float below = -2.0 * ((1.0 + z) * (1.0 + f));
    precise float between = (f * f - 1.0) * (f - z);
    float end = above / below;
    float other = d / between;
    return end + (f < z ? other : 0.0);
}
#endif
