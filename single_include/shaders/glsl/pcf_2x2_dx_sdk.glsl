// umbrage 0.1.0, pcf_2x2_dx_sdk: bilinear 2x2 PCF of the DirectX SDK sample, plain floats. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// pcf_2x2_dx_sdk, tier B: within 20 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `sampler2D map`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, depth, outside, direction.

#ifndef UMBRAGE_HIGHP
#ifdef GL_ES
#define UMBRAGE_HIGHP highp
#else
#define UMBRAGE_HIGHP
#endif
#endif
#ifndef UMBRAGE_PRECISE
#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)
#define UMBRAGE_PRECISE precise
#else
#define UMBRAGE_PRECISE
#endif
#endif

#ifndef UMBRAGE_HAS_COMPARE_DX_SDK
#define UMBRAGE_HAS_COMPARE_DX_SDK
// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
UMBRAGE_HIGHP float umbrage_compare_dx_sdk(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored,
                                           UMBRAGE_HIGHP float epsilon) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float limit = stored + epsilon;
    return limit < receiver ? 0.0 : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
bool umbrage_inside_texel_space(UMBRAGE_HIGHP vec2 coord) {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}
#endif

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
bool umbrage_beyond_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN
#define UMBRAGE_HAS_IN_FILTER_DOMAIN
// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
bool umbrage_in_filter_domain(UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver) {
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
UMBRAGE_HIGHP vec4 umbrage_texel(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
#if __VERSION__ >= 130
    return texelFetch(map, ivec2(texel), 0);
#else
    return texture2D(map, (texel + 0.5) / size);
#endif
}
#endif

#ifndef UMBRAGE_HAS_TEXEL_INSIDE
#define UMBRAGE_HAS_TEXEL_INSIDE
// umbrage_texel_inside: texel of the map, itself if the map has it; otherwise any, whose value does not count
UMBRAGE_HIGHP vec2 umbrage_texel_inside(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return min(abs(texel), size - 1.0);
}
#endif

#ifndef UMBRAGE_HAS_FETCH_DEPTH
#define UMBRAGE_HAS_FETCH_DEPTH
// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
UMBRAGE_HIGHP float umbrage_fetch_depth(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                        UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 inside = umbrage_texel_inside(size, texel);
    UMBRAGE_HIGHP vec4 value = umbrage_texel(map, size, inside);
    UMBRAGE_HIGHP float depth = value.x;
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
UMBRAGE_HIGHP float umbrage_pcf_2x2_dx_sdk(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                           UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver,
                                           UMBRAGE_HIGHP float epsilon) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 x = compared ? coord - 0.5 : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 texel = floor(x);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 weight = x - texel;
    UMBRAGE_HIGHP float a = umbrage_compare_dx_sdk(receiver, umbrage_fetch_depth(map, size, texel), epsilon);
    UMBRAGE_HIGHP float right = umbrage_fetch_depth(map, size, texel + vec2(1.0, 0.0));
    UMBRAGE_HIGHP float above = umbrage_fetch_depth(map, size, texel + vec2(0.0, 1.0));
    UMBRAGE_HIGHP float beyond = umbrage_fetch_depth(map, size, texel + vec2(1.0, 1.0));
    UMBRAGE_HIGHP float b = umbrage_compare_dx_sdk(receiver, right, epsilon);
    UMBRAGE_HIGHP float c = umbrage_compare_dx_sdk(receiver, above, epsilon);
    UMBRAGE_HIGHP float d = umbrage_compare_dx_sdk(receiver, beyond, epsilon);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float low = a + weight.x * (b - a);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float high = c + weight.x * (d - c);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float visibility = low + weight.y * (high - low);
    return compared ? visibility : 1.0;
}
#endif
