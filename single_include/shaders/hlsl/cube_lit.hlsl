// umbrage 0.1.0, cube_lit: one comparison with a texel of a cube map. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `Texture2D<float4> map`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   depth      depth of a texel's value, in place of .x: for packed depths
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   compare    one comparison, in place of receiver <= stored
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#ifndef UMBRAGE_HAS_CUBE_FACE
#define UMBRAGE_HAS_CUBE_FACE
// umbrage_cube_face: face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
float umbrage_cube_face(float3 direction) {
    float3 m = abs(direction);
    float x = direction.x < 0.0 ? 1.0 : 0.0;
    float y = direction.y < 0.0 ? 3.0 : 2.0;
    float z = direction.z < 0.0 ? 5.0 : 4.0;
    // not m.x >= m.y && m.x >= m.z: Mesa turns it into one comparison with max(m.y, m.z), which loses a NaN
    return m.x >= m.y ? (m.x >= m.z ? x : z) : (m.y >= m.z ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_PLANE
#define UMBRAGE_HAS_CUBE_PLANE
// umbrage_cube_plane: (sc, tc, face) of a direction: its components across the axis of its face
float3 umbrage_cube_plane(float3 direction) {
    float face = umbrage_cube_face(direction);
    float3 x = float3(face < 0.5 ? -direction.z : direction.z, -direction.y, face);
    float3 y = float3(direction.x, face < 2.5 ? direction.z : -direction.z, face);
    float3 z = float3(face < 4.5 ? direction.x : -direction.x, -direction.y, face);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_POINT
#define UMBRAGE_HAS_CUBE_POINT
// umbrage_cube_point: point from (sc, tc, distance along the axis) in a face, 0.0 to 5.0
float3 umbrage_cube_point(float face, float3 p) {
    float3 x = face < 0.5 ? float3(p.z, -p.y, -p.x) : float3(-p.z, -p.y, p.x);
    float3 y = face < 2.5 ? float3(p.x, p.z, p.y) : float3(p.x, -p.z, -p.y);
    float3 z = face < 4.5 ? float3(p.x, -p.y, p.z) : float3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_NEIGHBOR
#define UMBRAGE_HAS_CUBE_NEIGHBOR
// umbrage_cube_neighbor: (s, t, face) of a texel that may lie beyond an edge of its face; face -1.0 beyond a corner
//   texel  (s, t, face), integers
//   size   size of a face, in texels
float3 umbrage_cube_neighbor(float3 texel, float size) {
    float2 uv = float2(texel.x, texel.y) * 2.0 + (1.0 - size);
    bool beyond_u = abs(uv.x) > size;
    bool beyond_v = abs(uv.y) > size;
    float m = beyond_u || beyond_v ? size - 1.0 : size;
    float3 p = umbrage_cube_plane(umbrage_cube_point(texel.z, float3(uv, m)));
    float2 inside = (float2(p.x, p.y) + (size - 1.0)) * 0.5;
    return beyond_u && beyond_v ? float3(0.0, 0.0, -1.0) : float3(inside, p.z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_TILE
#define UMBRAGE_HAS_CUBE_TILE
// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
float2 umbrage_cube_tile(float face, float size) {
    float row = face < 2.5 ? 0.0 : 1.0;
    return float2((face - row * 3.0) * size, row * size);
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

#ifndef UMBRAGE_HAS_LIT
#define UMBRAGE_HAS_LIT
// umbrage_lit: visibility from one comparison with a texel
float umbrage_lit(Texture2D<float4> map, float2 size, float2 texel, float receiver) {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
#endif

#ifndef UMBRAGE_HAS_CUBE_LIT
#define UMBRAGE_HAS_CUBE_LIT
// umbrage_cube_lit: one comparison with a texel of a cube map
// Returns (visibility, 1.0), or (0.0, 0.0) beyond a corner
//   map, size   atlas of 3 x 2 faces and its size in texels
//   texel       (s, t, face), integers
//   receiver    distance from the light, bias applied
float2 umbrage_cube_lit(Texture2D<float4> map, float2 size, float3 texel, float receiver) {
    float side = size.y * 0.5;
    float3 n = umbrage_cube_neighbor(texel, side);
    float2 at = umbrage_cube_tile(n.z, side) + float2(n.x, n.y);
    float lit = umbrage_lit(map, size, at, receiver);
    return n.z < 0.0 ? float2(0.0, 0.0) : float2(lit, 1.0);
}
#endif
