// umbrage 0.1.0, cascade_by_projection_8: first of eight cascades that contains a point and its filter. Exactness:
//   tier B.
// cascade_by_projection_8, tier B: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_CASCADE_COORDINATE
#define UMBRAGE_HAS_CASCADE_COORDINATE
// umbrage_cascade_coordinate: position in a cascade's map, texels and depth, of a point rotated into the light's axes
float3 umbrage_cascade_coordinate(float3 light, float4 scale, float4 offset) {
    float3 start = float3(offset.x, offset.y, offset.z);
    precise float3 at = light * float3(scale.x, scale.y, scale.z) + start;
    return at;
}
#endif

#ifndef UMBRAGE_HAS_INSIDE_CASCADE
#define UMBRAGE_HAS_INSIDE_CASCADE
// umbrage_inside_cascade: true if a filter of radius reach at a coordinate stays inside a map of size texels
precise bool umbrage_inside_cascade(float3 coordinate, float2 size, float reach) {
    precise float2 end = size - reach;
    // y is doubled because Mesa turns two comparisons with one limit into min(x, y) >= reach, which loses a NaN
    bool in_x = coordinate.x >= reach && coordinate.x <= end.x;
    bool in_y = coordinate.y * 2.0 >= reach * 2.0 && coordinate.y * 2.0 <= end.y * 2.0;
    return in_x && in_y && coordinate.z >= 0.0 && coordinate.z <= 1.0;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_BY_PROJECTION
#define UMBRAGE_HAS_CASCADE_BY_PROJECTION
// umbrage_cascade_by_projection: (texels, texels, depth, index) in the first of four cascades that contains a point
//   and its filter; if there is none, index 4.0 and a coordinate that every filter takes as lit
//   light            the point, rotated into the light's axes
//   scales, offsets  scales and offsets of the cascades
//   size             size of each map, in texels
//   reach            filter radius, in texels
float4 umbrage_cascade_by_projection(float3 light, float4x4 scales, float4x4 offsets, float2 size, float reach) {
    float3 a = umbrage_cascade_coordinate(light, transpose(scales)[0], transpose(offsets)[0]);
    float3 b = umbrage_cascade_coordinate(light, transpose(scales)[1], transpose(offsets)[1]);
    float3 c = umbrage_cascade_coordinate(light, transpose(scales)[2], transpose(offsets)[2]);
    float3 d = umbrage_cascade_coordinate(light, transpose(scales)[3], transpose(offsets)[3]);
    float4 found = float4(65536.0, 65536.0, 0.0, 4.0);
    found = umbrage_inside_cascade(d, size, reach) ? float4(d, 3.0) : found;
    found = umbrage_inside_cascade(c, size, reach) ? float4(c, 2.0) : found;
    found = umbrage_inside_cascade(b, size, reach) ? float4(b, 1.0) : found;
    return umbrage_inside_cascade(a, size, reach) ? float4(a, 0.0) : found;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_BY_PROJECTION_8
#define UMBRAGE_HAS_CASCADE_BY_PROJECTION_8
// umbrage_cascade_by_projection_8: umbrage_cascade_by_projection for eight cascades, four and four; index 8.0 for none
float4 umbrage_cascade_by_projection_8(float3 light, float4x4 scales, float4x4 offsets, float4x4 farther_scales,
                                       float4x4 farther_offsets, float2 size, float reach) {
    float4 nearer = umbrage_cascade_by_projection(light, scales, offsets, size, reach);
    float4 farther = umbrage_cascade_by_projection(light, farther_scales, farther_offsets, size, reach);
    return nearer.w < 3.5 ? nearer : float4(farther.x, farther.y, farther.z, farther.w + 4.0);
}
#endif
