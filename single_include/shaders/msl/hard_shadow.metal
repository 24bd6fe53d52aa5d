// umbrage 0.1.0, hard_shadow: unfiltered shadow test of the nearest texel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `depth2d<float> map, sampler map_sampler`, a depth texture. Its sampler passes receiver <= depth, clamps to
//   the edge and filters nearest.
// Render target of the map: depth attachment, one sample. Clear to 1.0.
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

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE_SHADOW
#define UMBRAGE_HAS_BEYOND_FAR_PLANE_SHADOW
// umbrage_beyond_far_plane_shadow: true if a receiver is beyond the far plane
inline bool umbrage_beyond_far_plane_shadow(float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN_SHADOW
#define UMBRAGE_HAS_IN_FILTER_DOMAIN_SHADOW
// umbrage_in_filter_domain_shadow: true if a filter compares; lit outside texel space and beyond the far plane
inline bool umbrage_in_filter_domain_shadow(float2 coord, float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane_shadow(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif

#ifndef UMBRAGE_HAS_LIT_TEXEL_SHADOW
#define UMBRAGE_HAS_LIT_TEXEL_SHADOW
// umbrage_lit_texel_shadow: the sampler's comparison with a texel inside the map. NaN is in shadow
inline float umbrage_lit_texel_shadow(metal::depth2d<float> map, metal::sampler map_sampler, float2 size, float2 texel,
                                      float receiver) {
    float lit = map.sample_compare(map_sampler, (texel + 0.5) / size, receiver, metal::level(0.0));
    return (receiver > 0.0 ? lit : 0.0) + (receiver <= 0.0 ? lit : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_COMPARE_SHADOW
#define UMBRAGE_HAS_COMPARE_SHADOW
// umbrage_compare_shadow: 1.0 when the receiver is no farther than the stored depth
inline float umbrage_compare_shadow(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_LIT_SHADOW
#define UMBRAGE_HAS_LIT_SHADOW
// umbrage_lit_shadow: visibility of one comparison with a texel, with the far plane when outside the map
inline float umbrage_lit_shadow(metal::depth2d<float> map, metal::sampler map_sampler, float2 size, float2 texel,
                                float receiver) {
    float2 inside = metal::clamp(texel, float2(0.0, 0.0), size - 1.0);
    float lit = umbrage_lit_texel_shadow(map, map_sampler, size, inside, receiver);
    float outside = umbrage_compare_shadow(receiver, 1.0);
    return inside.x == texel.x && inside.y == texel.y ? lit : outside;
}
#endif

#ifndef UMBRAGE_HAS_HARD_SHADOW
#define UMBRAGE_HAS_HARD_SHADOW
// umbrage_hard_shadow: shadow test without a filter. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
inline float umbrage_hard_shadow(metal::depth2d<float> map, metal::sampler map_sampler, float2 size, float2 coord,
                                 float receiver) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    float2 texel = compared ? metal::floor(coord) : float2(0.0, 0.0);  // no branch: fetches of several taps overlap
    float lit = umbrage_lit_shadow(map, map_sampler, size, texel, receiver);
    return compared ? lit : 1.0;
}
#endif
