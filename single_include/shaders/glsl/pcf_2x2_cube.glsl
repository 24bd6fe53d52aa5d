// umbrage 0.1.0, pcf_2x2_cube: bilinear 2x2 PCF of a cube map, across its edges. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// pcf_2x2_cube, tier C: within 33 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `sampler2D map`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, depth, outside, compare,
//   direction.

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

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
bool umbrage_inside_texel_space(UMBRAGE_HIGHP vec2 coord) {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}
#endif

#ifndef UMBRAGE_HAS_CUBE_FACE
#define UMBRAGE_HAS_CUBE_FACE
// umbrage_cube_face: face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
UMBRAGE_HIGHP float umbrage_cube_face(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 m = abs(direction);
    UMBRAGE_HIGHP float x = direction.x < 0.0 ? 1.0 : 0.0;
    UMBRAGE_HIGHP float y = direction.y < 0.0 ? 3.0 : 2.0;
    UMBRAGE_HIGHP float z = direction.z < 0.0 ? 5.0 : 4.0;
    // not m.x >= m.y && m.x >= m.z: Mesa turns it into one comparison with max(m.y, m.z), which loses a NaN
    return m.x >= m.y ? (m.x >= m.z ? x : z) : (m.y >= m.z ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_PLANE
#define UMBRAGE_HAS_CUBE_PLANE
// umbrage_cube_plane: (sc, tc, face) of a direction: its components across the axis of its face
UMBRAGE_HIGHP vec3 umbrage_cube_plane(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP float face = umbrage_cube_face(direction);
    UMBRAGE_HIGHP vec3 x = vec3(face < 0.5 ? -direction.z : direction.z, -direction.y, face);
    UMBRAGE_HIGHP vec3 y = vec3(direction.x, face < 2.5 ? direction.z : -direction.z, face);
    UMBRAGE_HIGHP vec3 z = vec3(face < 4.5 ? direction.x : -direction.x, -direction.y, face);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_POINT
#define UMBRAGE_HAS_CUBE_POINT
// umbrage_cube_point: point from (sc, tc, distance along the axis) in a face, 0.0 to 5.0
UMBRAGE_HIGHP vec3 umbrage_cube_point(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec3 p) {
    UMBRAGE_HIGHP vec3 x = face < 0.5 ? vec3(p.z, -p.y, -p.x) : vec3(-p.z, -p.y, p.x);
    UMBRAGE_HIGHP vec3 y = face < 2.5 ? vec3(p.x, p.z, p.y) : vec3(p.x, -p.z, -p.y);
    UMBRAGE_HIGHP vec3 z = face < 4.5 ? vec3(p.x, -p.y, p.z) : vec3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_NEIGHBOR
#define UMBRAGE_HAS_CUBE_NEIGHBOR
// umbrage_cube_neighbor: (s, t, face) of a texel that may lie beyond an edge of its face; face -1.0 beyond a corner
//   texel  (s, t, face), integers
//   size   size of a face, in texels
UMBRAGE_HIGHP vec3 umbrage_cube_neighbor(UMBRAGE_HIGHP vec3 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP vec2 uv = vec2(texel.x, texel.y) * 2.0 + (1.0 - size);
    bool beyond_u = abs(uv.x) > size;
    bool beyond_v = abs(uv.y) > size;
    UMBRAGE_HIGHP float m = beyond_u || beyond_v ? size - 1.0 : size;
    UMBRAGE_HIGHP vec3 p = umbrage_cube_plane(umbrage_cube_point(texel.z, vec3(uv, m)));
    UMBRAGE_HIGHP vec2 inside = (vec2(p.x, p.y) + (size - 1.0)) * 0.5;
    return beyond_u && beyond_v ? vec3(0.0, 0.0, -1.0) : vec3(inside, p.z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_TILE
#define UMBRAGE_HAS_CUBE_TILE
// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
UMBRAGE_HIGHP vec2 umbrage_cube_tile(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP float row = face < 2.5 ? 0.0 : 1.0;
    return vec2((face - row * 3.0) * size, row * size);
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

#ifndef UMBRAGE_HAS_COMPARE
#define UMBRAGE_HAS_COMPARE
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return receiver <= stored ? 1.0 : 0.0;
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

#ifndef UMBRAGE_HAS_LIT
#define UMBRAGE_HAS_LIT
// umbrage_lit: visibility from one comparison with a texel
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
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
UMBRAGE_HIGHP vec2 umbrage_cube_lit(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec3 texel,
                                    UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float side = size.y * 0.5;
    UMBRAGE_HIGHP vec3 n = umbrage_cube_neighbor(texel, side);
    UMBRAGE_HIGHP vec2 at = umbrage_cube_tile(n.z, side) + vec2(n.x, n.y);
    UMBRAGE_HIGHP float lit = umbrage_lit(map, size, at, receiver);
    return n.z < 0.0 ? vec2(0.0, 0.0) : vec2(lit, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_PCF_2X2_CUBE
#define UMBRAGE_HAS_PCF_2X2_CUBE
// umbrage_pcf_2x2_cube: bilinear 2x2 PCF across the edges of a cube map. Returns visibility, 1.0 = lit
//   map, size   atlas of 3 x 2 faces and its size in texels
//   at          (s, t, face): s and t in texels of the face, from 0.0 on
//   receiver    distance from the light, bias applied
UMBRAGE_HIGHP float umbrage_pcf_2x2_cube(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec3 at,
                                         UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 coord = vec2(at.x, at.y);
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0 + 0.5) - 128.0 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    UMBRAGE_HIGHP vec2 hi = clamp(x * (1.0 / 256.0) - texel, vec2(0.0, 0.0), vec2(1.0, 1.0));
    UMBRAGE_HIGHP vec2 lo = 1.0 - hi;
    UMBRAGE_HIGHP vec2 sum = umbrage_cube_lit(map, size, vec3(texel, at.z), receiver) * (lo.x * lo.y);
    sum += umbrage_cube_lit(map, size, vec3(texel + vec2(1.0, 0.0), at.z), receiver) * (hi.x * lo.y);
    sum += umbrage_cube_lit(map, size, vec3(texel + vec2(0.0, 1.0), at.z), receiver) * (lo.x * hi.y);
    sum += umbrage_cube_lit(map, size, vec3(texel + vec2(1.0, 1.0), at.z), receiver) * (hi.x * hi.y);
    return compared && sum.y > 0.0 ? sum.x / sum.y : 1.0;
}
#endif
