// umbrage 0.1.0, decode_msm_hausdorff: mean of MSM texels to visibility, for depths on [-1, 1]. Exactness: tier C.
// decode_msm_hausdorff, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_BIAS_MOMENTS
#define UMBRAGE_HAS_BIAS_MOMENTS
// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
inline float4 umbrage_bias_moments(float4 b, float2 bias) {
    float x = b.x - b.x * bias.x;
    float y = b.y + (bias.y - b.y) * bias.x;
    float z = b.z - b.z * bias.x;
    float w = b.w + (bias.y - b.w) * bias.x;
    return float4(x, y, z, w);
}
#endif

#ifndef UMBRAGE_HAS_MOMENT_ATOMS
#define UMBRAGE_HAS_MOMENT_ATOMS
// umbrage_moment_atoms: the two depths that have the same moments with the receiver's, minus b.x, and their shares
//   b   moments, biased
//   x   the receiver's depth on -1.0 to 1.0 minus b.x
inline float4 umbrage_moment_atoms(float4 b, float x) {
    float d = b.y - b.x * b.x;
    float third = b.z - b.x * b.y;
    float l = third / d;
    float e = (b.w - b.y * b.y) - third * l;
    float h = b.x * 2.0 - l;
    float a = d * ((x + h) * x - d);
    float m = x * e + h * a;
    float c = d * (e - a);
    float square = m * m - 4.0 * a * c;
    float root = metal::sqrt(square > 0.0 ? square : 0.0);
    float w = (m < 0.0 ? root - m : -(m + root)) * 0.5;
    float2 t = float2(w / a, c / w);
    float2 q = (t + h) * t - d;
    float least = d * e;
    float2 sum = least + (t * t * e + q * q * d);
    return float4(t.x, t.y, least / sum.x, least / sum.y);
}
#endif

#ifndef UMBRAGE_HAS_HAUSDORFF_SHARE
#define UMBRAGE_HAS_HAUSDORFF_SHARE
// umbrage_hausdorff_share: smallest fraction of depths nearer than the receiver, from four moments of depths on [-1, 1]
// Returns a negative number where umbrage_moment_atoms gives the fraction
//   b   moments, biased
//   z   the receiver's depth on -1.0 to 1.0
inline float umbrage_hausdorff_share(float4 b, float z) {
    float variance = b.y - b.x * b.x;
    float third = b.z - b.x * b.y;
    float fourth = b.w - b.y * b.y;
    float rest = 1.0 - b.y;
    float x = z - b.x;
    float d = third + rest * x;
    float g = (fourth - variance * rest) - (z + b.x) * third;
    float p = d * (1.0 + b.x) + g;
    float q = d * (1.0 - b.x) - g;
    float k = rest * g + third * d;
    float first = (1.0 + z) * (d * variance + g * (1.0 - b.x)) - k;
    float last = (1.0 - z) * (d * variance - g * (1.0 + b.x)) + k;
    float square = d * d;
    float between = p * (q * (x * d - g));
    float end = first / (2.0 * ((1.0 + z) * p));
    float other = square * square / between;
    float share = end + (d > 0.0 ? other : 0.0);
    bool four = first * p > 0.0 && last * q > 0.0 && p * q > 0.0 && share >= 0.0;
    return z <= -1.0 ? 0.0 : (four ? (share < 1.0 ? share : 1.0) : -1.0);
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TO_FORWARD_DEPTH
#define UMBRAGE_HAS_TO_FORWARD_DEPTH
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
inline float umbrage_to_forward_depth(float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_MSM
#define UMBRAGE_HAS_DECODE_MSM
// umbrage_decode_msm: visibility of a receiver, at least its lit fraction minus bias.x. 1.0 = lit
//   b: mean of texels. receiver: depth in [0, 1], bias applied
//   bias: (3e-6, 0.375) for 32-bit floats, (6e-5, 0.628) for 16-bit channels
inline float umbrage_decode_msm(float4 b, float receiver, float2 bias) {
    float d = umbrage_to_forward_depth(receiver);
    float4 m = umbrage_bias_moments(b, bias);
    float x = ((d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0) - m.x;
    float4 atoms = umbrage_moment_atoms(m, x);
    float first = atoms.x < x ? atoms.z : 0.0;
    float second = atoms.y < x ? atoms.w : 0.0;
    float lit = 1.0 - (first + second);
    bool known = metal::abs(atoms.z + atoms.w) <= 4294967296.0;  // false for NaN
    lit = known ? (lit > 0.0 ? (lit < 1.0 ? lit : 1.0) : 0.0) : (x <= 0.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_MSM_HAUSDORFF
#define UMBRAGE_HAS_DECODE_MSM_HAUSDORFF
// umbrage_decode_msm_hausdorff: visibility of a receiver, at least its lit fraction minus bias.x. 1.0 = lit
//   b          mean of texels
//   receiver   receiver depth in [0, 1], bias applied
//   bias       (3e-6, 0.375)
inline float umbrage_decode_msm_hausdorff(float4 b, float receiver, float2 bias) {
    float plain = umbrage_decode_msm(b, receiver, bias);
    float d = umbrage_to_forward_depth(receiver);
    float z = (d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0;
    float share = umbrage_hausdorff_share(umbrage_bias_moments(b, bias), z);
    float lit = share >= 0.0 ? 1.0 - share : plain;
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
#endif
