// umbrage 0.1.0, MIT License: page_coordinate

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_FROM_UNORM
#define UMBRAGE_HAS_FROM_UNORM
// umbrage_from_unorm: channel 0..255 behind a value read from an 8-bit texture, however the driver divides by 255
inline float umbrage_from_unorm(float c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float2 umbrage_from_unorm(float2 c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float3 umbrage_from_unorm(float3 c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float4 umbrage_from_unorm(float4 c) {
    return metal::floor(c * 255.0 + 0.5);
}
#endif

#ifndef UMBRAGE_HAS_TEXEL
#define UMBRAGE_HAS_TEXEL
// umbrage_texel: value of a texel inside the map; whole numbers, (0, 0) is the first
inline float4 umbrage_texel(metal::texture2d<float> map, float2 size, float2 texel) {
    return map.read(uint2(texel));
}
#endif

#ifndef UMBRAGE_HAS_PAGE_COORDINATE
#define UMBRAGE_HAS_PAGE_COORDINATE
// umbrage_page_coordinate: a receiver in a page of an atlas: texels of the page with its gutter, the page's first texel
//   table, size   page table, RGBA8, nearest filter;   coord   receiver, from 1.0 to 2.0 across all but its border
//   page, gutter  side of a page and what it has around it, texels
inline float4 umbrage_page_coordinate(metal::texture2d<float> table, float2 size, float2 coord, float page,
                                      float gutter) {
    float2 cell = metal::min(metal::max(float2(0.0, 0.0), coord * (size - 2.0) - (size - 3.0)), size - 1.0);
    int2 texel = int2(cell);  // of a NaN the first
    float4 entry = umbrage_texel(table, size, float2(texel));
    float2 slot = umbrage_from_unorm(float2(entry.x, entry.y));
    float across = metal::floor(entry.z * 255.0 + entry.w * 65280.0 + 0.5);  // one of the two is 0.0
    float2 at = metal::fract(coord * across) * page + (across > 0.0 ? gutter : 32768.0);
    return float4(at, slot * (page + gutter * 2.0));
}
#endif
