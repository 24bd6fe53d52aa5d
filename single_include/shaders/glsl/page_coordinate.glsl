// umbrage 0.1.0, page_coordinate: position of a receiver in the atlas page that holds it. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `sampler2D map`, texels of the kind that the function's comment names, read unfiltered.
// Other maps: bind() of the library or of its npm package prints this text, by texture.

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

#ifndef UMBRAGE_HAS_FROM_UNORM
#define UMBRAGE_HAS_FROM_UNORM
// umbrage_from_unorm: channel 0..255 of a value from an 8-bit texture, even if the division by 255 is inexact
UMBRAGE_HIGHP float umbrage_from_unorm(UMBRAGE_HIGHP float c) {
    return floor(c * 255.0 + 0.5);
}
UMBRAGE_HIGHP vec2 umbrage_from_unorm(UMBRAGE_HIGHP vec2 c) {
    return floor(c * 255.0 + 0.5);
}
UMBRAGE_HIGHP vec3 umbrage_from_unorm(UMBRAGE_HIGHP vec3 c) {
    return floor(c * 255.0 + 0.5);
}
UMBRAGE_HIGHP vec4 umbrage_from_unorm(UMBRAGE_HIGHP vec4 c) {
    return floor(c * 255.0 + 0.5);
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

#ifndef UMBRAGE_HAS_PAGE_COORDINATE
#define UMBRAGE_HAS_PAGE_COORDINATE
// umbrage_page_coordinate: (x, y) of a receiver in an atlas page with its gutter, and (z, w) the page's first texel
//   table   page table, RGBA8, nearest filter
//   size    size of the table, in texels
//   coord   receiver position, 1.0 to 2.0 across the table without its border
//   page    side of a page, in texels
//   gutter  border around a page, in texels
UMBRAGE_HIGHP vec4 umbrage_page_coordinate(UMBRAGE_HIGHP sampler2D table, UMBRAGE_HIGHP vec2 size,
                                           UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float page,
                                           UMBRAGE_HIGHP float gutter) {
    // neither max changes a value; compilers cannot regroup sums across max and clamp
    UMBRAGE_HIGHP vec2 sides = max(size - 2.0, vec2(1.0, 1.0));
    UMBRAGE_HIGHP vec2 before = max(size - 3.0, vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec2 cell = min(max(vec2(0.0, 0.0), coord * sides - before), size - 1.0);
    UMBRAGE_HIGHP ivec2 texel = ivec2(cell);  // the first texel for a NaN
    UMBRAGE_HIGHP vec4 entry = umbrage_from_unorm(umbrage_texel(table, size, vec2(texel)));
    UMBRAGE_HIGHP vec2 slot = vec2(entry.x, entry.y);
    UMBRAGE_HIGHP float across = entry.z + entry.w * 256.0;
    UMBRAGE_HIGHP vec2 within = clamp(fract(coord * across), vec2(0.0, 0.0), vec2(1.0, 1.0));
    UMBRAGE_HIGHP vec2 at = within * page + (across > 0.0 ? gutter : 32768.0);
    return vec4(at, slot * (page + gutter * 2.0));
}
#endif
