// umbrage 0.1.0, page_coordinate: position of a receiver in the atlas page that holds it. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `Texture2D<float4> map`, texels of the kind that the function's comment names, read unfiltered.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other

#ifndef UMBRAGE_HAS_FROM_UNORM
#define UMBRAGE_HAS_FROM_UNORM
// umbrage_from_unorm: channel 0..255 of a value from an 8-bit texture, even if the division by 255 is inexact
float umbrage_from_unorm(float c) {
    return floor(c * 255.0 + 0.5);
}
float2 umbrage_from_unorm(float2 c) {
    return floor(c * 255.0 + 0.5);
}
float3 umbrage_from_unorm(float3 c) {
    return floor(c * 255.0 + 0.5);
}
float4 umbrage_from_unorm(float4 c) {
    return floor(c * 255.0 + 0.5);
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

#ifndef UMBRAGE_HAS_PAGE_COORDINATE
#define UMBRAGE_HAS_PAGE_COORDINATE
// umbrage_page_coordinate: (x, y) of a receiver in an atlas page with its gutter, and (z, w) the page's first texel
//   table   page table, RGBA8, nearest filter
//   size    size of the table, in texels
//   coord   receiver position, 1.0 to 2.0 across the table without its border
//   page    side of a page, in texels
//   gutter  border around a page, in texels
float4 umbrage_page_coordinate(Texture2D<float4> table, float2 size, float2 coord, float page, float gutter) {
    // neither max changes a value; compilers cannot regroup sums across max and clamp
    float2 sides = max(size - 2.0, float2(1.0, 1.0));
    float2 before = max(size - 3.0, float2(0.0, 0.0));
    float2 cell = min(max(float2(0.0, 0.0), coord * sides - before), size - 1.0);
    int2 texel = (int2)cell;  // the first texel for a NaN
    float4 entry = umbrage_from_unorm(umbrage_texel(table, size, (float2)texel));
    float2 slot = float2(entry.x, entry.y);
    float across = entry.z + entry.w * 256.0;
    float2 within = clamp(frac(coord * across), float2(0.0, 0.0), float2(1.0, 1.0));
    float2 at = within * page + (across > 0.0 ? gutter : 32768.0);
    return float4(at, slot * (page + gutter * 2.0));
}
#endif
