// umbrage 0.1.0, bounds_lit: visibility from depth bounds, an early exit of a filter. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `Texture2D<float4> map`, texels of the kind that the function's comment names, read unfiltered.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   compare    one comparison, in place of receiver <= stored
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

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

#ifndef UMBRAGE_HAS_COMPARE
#define UMBRAGE_HAS_COMPARE
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
float umbrage_compare(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
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

#ifndef UMBRAGE_HAS_BOUNDS_LIT
#define UMBRAGE_HAS_BOUNDS_LIT
// umbrage_bounds_lit: early exit of a filter. Returns 1.0 where all texels are lit, 0.0 where none is
// Returns -1.0 where the bounds do not decide it: call the filter there
//   bounds, size      map of the texels' smallest and largest depths, and its size in texels
//   coord, receiver   as passed to the filter
//   place             maps a receiver to its bounds, from make_filter_bounds
float umbrage_bounds_lit(Texture2D<float4> bounds, float2 size, float2 coord, float receiver, float2 place) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float4 b = umbrage_fetch_clamped(bounds, size, floor((x + place.x) * place.y));
    float all = umbrage_compare(receiver, b.x);
    float some = umbrage_compare(receiver, b.y);
    float known = b.x <= b.y && all == some ? all : -1.0;  // NaN bounds decide nothing
    return compared ? known : 1.0;
}
#endif
