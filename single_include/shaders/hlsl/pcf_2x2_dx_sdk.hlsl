// umbrage 0.1.0, pcf_2x2_dx_sdk: bilinear 2x2 PCF of the DirectX SDK sample, plain floats. Exactness: tier B.
// pcf_2x2_dx_sdk, tier B: within 20 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `Texture2D<float4> map`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   depth      depth of a texel's value, in place of .x: for packed depths
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#ifndef UMBRAGE_HAS_COMPARE_DX_SDK
#define UMBRAGE_HAS_COMPARE_DX_SDK
// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
float umbrage_compare_dx_sdk(float receiver, float stored, float epsilon) {
    precise float limit = stored + epsilon;
    return limit < receiver ? 0.0 : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
precise bool umbrage_inside_texel_space(float2 coord) {
    // two different limits: of one limit Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) * 2.0 < 65536.0;
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

#ifndef UMBRAGE_HAS_FETCH_DEPTH
#define UMBRAGE_HAS_FETCH_DEPTH
// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
float umbrage_fetch_depth(Texture2D<float4> map, float2 size, float2 texel) {
    float2 inside = clamp(texel, float2(0.0, 0.0), size - 1.0);
    float4 value = umbrage_texel(map, size, inside);
    float depth = value.x;
    return inside.x == texel.x && inside.y == texel.y ? depth : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_PCF_2X2_DX_SDK
#define UMBRAGE_HAS_PCF_2X2_DX_SDK
// umbrage_pcf_2x2_dx_sdk: 2x2 PCF of the DirectX SDK sample. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], no bias applied
//   epsilon     depth added to each stored depth
float umbrage_pcf_2x2_dx_sdk(Texture2D<float4> map, float2 size, float2 coord, float receiver, float epsilon) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    precise float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = floor(x);
    precise float2 weight = x - texel;
    float a = umbrage_compare_dx_sdk(receiver, umbrage_fetch_depth(map, size, texel), epsilon);
    float right = umbrage_fetch_depth(map, size, texel + float2(1.0, 0.0));
    float above = umbrage_fetch_depth(map, size, texel + float2(0.0, 1.0));
    float beyond = umbrage_fetch_depth(map, size, texel + float2(1.0, 1.0));
    float b = umbrage_compare_dx_sdk(receiver, right, epsilon);
    float c = umbrage_compare_dx_sdk(receiver, above, epsilon);
    float d = umbrage_compare_dx_sdk(receiver, beyond, epsilon);
    precise float low = a + weight.x * (b - a);
    precise float high = c + weight.x * (d - c);
    precise float visibility = low + weight.y * (high - low);
    return compared ? visibility : 1.0;
}
#endif
