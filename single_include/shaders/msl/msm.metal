// umbrage 0.1.0, msm: visibility from a blurred moment shadow map (MSM). Exactness: tier C.
// msm, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `texture2d<float> map`, texels of the kind that the function's comment names, read unfiltered.
// Render target of msm: RGBA32F, not sRGB, no blending, one sample. Clear to umbrage_encode_msm of the far plane's
//   depth.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
inline bool umbrage_inside_texel_space(float2 coord) {
    // two different limits: of one limit Mesa makes max(x, y) < limit, which loses a NaN
    return metal::abs(coord.x) < 32768.0 && metal::abs(coord.y) * 2.0 < 65536.0;
}
#endif

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

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
inline bool umbrage_beyond_far_plane(float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN
#define UMBRAGE_HAS_IN_FILTER_DOMAIN
// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
inline bool umbrage_in_filter_domain(float2 coord, float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif

#ifndef UMBRAGE_HAS_MAP_COVERS
#define UMBRAGE_HAS_MAP_COVERS
// umbrage_map_covers: true if a receiver lies in a prefiltered map or a table; elsewhere it is lit
inline bool umbrage_map_covers(float2 size, float2 coord) {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
#endif

#ifndef UMBRAGE_HAS_TEXEL
#define UMBRAGE_HAS_TEXEL
// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
inline float4 umbrage_texel(metal::texture2d<float> map, float2 size, float2 texel) {
    return map.read(uint2(texel));
}
#endif

#ifndef UMBRAGE_HAS_FETCH_CLAMPED
#define UMBRAGE_HAS_FETCH_CLAMPED
// umbrage_fetch_clamped: texel of a map, or the nearest one inside for coordinates outside
inline float4 umbrage_fetch_clamped(metal::texture2d<float> map, float2 size, float2 texel) {
    return umbrage_texel(map, size, metal::clamp(texel, float2(0.0, 0.0), size - 1.0));
}
#endif

#ifndef UMBRAGE_HAS_FETCH_BILINEAR
#define UMBRAGE_HAS_FETCH_BILINEAR
// umbrage_fetch_bilinear: bilinear mean of the four texels around a point, weights in steps of 1/256
//   coord   in texels. (0.5, 0.5) is the center of the first texel
inline float4 umbrage_fetch_bilinear(metal::texture2d<float> map, float2 size, float2 coord) {
    float2 x = metal::floor(coord * 256.0) - 128.0;
    float2 texel = metal::floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already. The clamp keeps compilers from regrouping sums across it
    float2 hi = metal::clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 lo = 256.0 - hi;  // 1.0 - hi would become an interpolation, which rounds differently
    float4 a = umbrage_fetch_clamped(map, size, texel);
    float4 b = umbrage_fetch_clamped(map, size, texel + float2(1.0, 0.0));
    float4 c = umbrage_fetch_clamped(map, size, texel + float2(0.0, 1.0));
    float4 d = umbrage_fetch_clamped(map, size, texel + float2(1.0, 1.0));
    float4 low = a * lo.x + b * hi.x;
    float4 high = c * lo.x + d * hi.x;
    float4 sum = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
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

#ifndef UMBRAGE_HAS_MSM
#define UMBRAGE_HAS_MSM
// umbrage_msm: visibility from a blurred map of encode_msm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
inline float umbrage_msm(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_msm(m, receiver, bias);
    return compared ? lit : 1.0;
}
#endif
