// umbrage 0.1.0, msm_unorm16: visibility from a blurred MSM of optimized moments. Exactness: tier C.
// msm_unorm16, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `Texture2D<float4> map`, texels of the kind that the function's comment names, read unfiltered.
// Render target of msm_unorm16: RGBA16 UNORM, not sRGB, no blending, one sample. Clear to
//   umbrage_to_optimized_moments of umbrage_encode_msm of the far plane's depth.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
precise bool umbrage_inside_texel_space(float2 coord) {
    // two different limits: of one limit Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) * 2.0 < 65536.0;
}
#endif

#ifndef UMBRAGE_HAS_BIAS_MOMENTS
#define UMBRAGE_HAS_BIAS_MOMENTS
// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
float4 umbrage_bias_moments(float4 b, float2 bias) {
    precise float x = b.x - b.x * bias.x;
    precise float y = b.y + (bias.y - b.y) * bias.x;
    precise float z = b.z - b.z * bias.x;
    precise float w = b.w + (bias.y - b.w) * bias.x;
    return float4(x, y, z, w);
}
#endif

#ifndef UMBRAGE_HAS_MOMENT_ATOMS
#define UMBRAGE_HAS_MOMENT_ATOMS
// umbrage_moment_atoms: the two depths that have the same moments with the receiver's, minus b.x, and their shares
//   b   moments, biased
//   x   the receiver's depth on -1.0 to 1.0 minus b.x
float4 umbrage_moment_atoms(float4 b, float x) {
    precise float d = b.y - b.x * b.x;
    precise float third = b.z - b.x * b.y;
    float l = third / d;
    precise float e = (b.w - b.y * b.y) - third * l;
    precise float h = b.x * 2.0 - l;
    precise float a = d * ((x + h) * x - d);
    precise float m = x * e + h * a;
    precise float c = d * (e - a);
    precise float square = m * m - 4.0 * a * c;
    float root = sqrt(square > 0.0 ? square : 0.0);
    precise float w = (m < 0.0 ? root - m : -(m + root)) * 0.5;
    float2 t = float2(w / a, c / w);
    precise float2 q = (t + h) * t - d;
    float least = d * e;
    precise float2 sum = least + (t * t * e + q * q * d);
    return float4(t.x, t.y, least / sum.x, least / sum.y);
}
#endif

#ifndef UMBRAGE_HAS_FROM_OPTIMIZED_MOMENTS
#define UMBRAGE_HAS_FROM_OPTIMIZED_MOMENTS
// umbrage_from_optimized_moments: four moments from the result of umbrage_to_optimized_moments
float4 umbrage_from_optimized_moments(float4 o) {
    precise float x = o.x - 0.5;
    precise float z = o.z - 0.5;
    float eighth = o.y * 0.125;
    precise float b1 = z * 1.73205078 - x * 0.333333343;
    precise float b2 = o.w + eighth;
    precise float b3 = z * 1.29903817 - x * 0.75;
    precise float b4 = o.w - eighth;
    return float4(b1, b2, b3, b4);
}
#endif

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
precise bool umbrage_beyond_far_plane(float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN
#define UMBRAGE_HAS_IN_FILTER_DOMAIN
// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
precise bool umbrage_in_filter_domain(float2 coord, float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif

#ifndef UMBRAGE_HAS_MAP_COVERS
#define UMBRAGE_HAS_MAP_COVERS
// umbrage_map_covers: true if a receiver lies in a prefiltered map or a table; elsewhere it is lit
precise bool umbrage_map_covers(float2 size, float2 coord) {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
#endif

#ifndef UMBRAGE_HAS_TEXEL
#define UMBRAGE_HAS_TEXEL
// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
float4 umbrage_texel(Texture2D<float4> map, float2 size, float2 texel) {
    return map.Load(int3(int2(texel), 0));
}
#endif

#ifndef UMBRAGE_HAS_FETCH_CLAMPED
#define UMBRAGE_HAS_FETCH_CLAMPED
// umbrage_fetch_clamped: texel of a map, or the nearest one inside for coordinates outside
float4 umbrage_fetch_clamped(Texture2D<float4> map, float2 size, float2 texel) {
    return umbrage_texel(map, size, clamp(texel, float2(0.0, 0.0), size - 1.0));
}
#endif

#ifndef UMBRAGE_HAS_FETCH_BILINEAR
#define UMBRAGE_HAS_FETCH_BILINEAR
// umbrage_fetch_bilinear: bilinear mean of the four texels around a point, weights in steps of 1/256
//   coord   in texels. (0.5, 0.5) is the center of the first texel
float4 umbrage_fetch_bilinear(Texture2D<float4> map, float2 size, float2 coord) {
    float2 x = floor(coord * 256.0) - 128.0;
    float2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already. The clamp keeps compilers from regrouping sums across it
    float2 hi = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 lo = 256.0 - hi;  // 1.0 - hi would become an interpolation, which rounds differently
    float4 a = umbrage_fetch_clamped(map, size, texel);
    float4 b = umbrage_fetch_clamped(map, size, texel + float2(1.0, 0.0));
    float4 c = umbrage_fetch_clamped(map, size, texel + float2(0.0, 1.0));
    float4 d = umbrage_fetch_clamped(map, size, texel + float2(1.0, 1.0));
    precise float4 low = a * lo.x + b * hi.x;
    precise float4 high = c * lo.x + d * hi.x;
    precise float4 sum = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TO_FORWARD_DEPTH
#define UMBRAGE_HAS_TO_FORWARD_DEPTH
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
float umbrage_to_forward_depth(float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_MSM
#define UMBRAGE_HAS_DECODE_MSM
// umbrage_decode_msm: visibility of a receiver, at least its lit fraction minus bias.x. 1.0 = lit
//   b: mean of texels. receiver: depth in [0, 1], bias applied
//   bias: (3e-6, 0.375) for 32-bit floats, (6e-5, 0.628) for 16-bit channels
float umbrage_decode_msm(float4 b, float receiver, float2 bias) {
    float d = umbrage_to_forward_depth(receiver);
    float4 m = umbrage_bias_moments(b, bias);
    precise float x = ((d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0) - m.x;
    float4 atoms = umbrage_moment_atoms(m, x);
    float first = atoms.x < x ? atoms.z : 0.0;
    float second = atoms.y < x ? atoms.w : 0.0;
    precise float lit = 1.0 - (first + second);
    bool known = abs(atoms.z + atoms.w) <= 4294967296.0;  // false for NaN
    lit = known ? (lit > 0.0 ? (lit < 1.0 ? lit : 1.0) : 0.0) : (x <= 0.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_MSM_UNORM16
#define UMBRAGE_HAS_MSM_UNORM16
// umbrage_msm_unorm16: visibility from a blurred map of optimized moments, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
float umbrage_msm_unorm16(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_msm(umbrage_from_optimized_moments(m), receiver, bias);
    return compared ? lit : 1.0;
}
#endif
