// umbrage 0.1.0, adaptive_maps_places: place of a point of the world in the pages of an adaptive map. Exactness: tier
//   C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// adaptive_maps_places, tier C: within 68 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

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

#ifndef UMBRAGE_HAS_SHADOW_COORDINATE
#define UMBRAGE_HAS_SHADOW_COORDINATE
// umbrage_shadow_coordinate: texture matrix times world position: (x w, y w, depth w, w), x and y in texels
UMBRAGE_HIGHP vec4 umbrage_shadow_coordinate(UMBRAGE_HIGHP mat4 m, UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c = m[3] + m[0] * world.x + m[1] * world.y + m[2] * world.z;
    return c;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_COLUMN
#define UMBRAGE_HAS_CASCADE_COLUMN
// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
UMBRAGE_HIGHP vec4 umbrage_cascade_column(UMBRAGE_HIGHP mat4 columns, UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP vec4 low = number < 0.5 ? columns[0] : columns[1];
    UMBRAGE_HIGHP vec4 high = number < 2.5 ? columns[2] : columns[3];
    return number < 1.5 ? low : high;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_COLUMN_8
#define UMBRAGE_HAS_CASCADE_COLUMN_8
// umbrage_cascade_column_8: column of two matrices by its index, 0.0 to 7.0
UMBRAGE_HIGHP vec4 umbrage_cascade_column_8(UMBRAGE_HIGHP mat4 nearer, UMBRAGE_HIGHP mat4 farther,
                                            UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP vec4 low = umbrage_cascade_column(nearer, number);
    UMBRAGE_HIGHP vec4 high = umbrage_cascade_column(farther, number - 4.0);
    return number < 3.5 ? low : high;
}
#endif

#ifndef UMBRAGE_HAS_PLANE_IN_MAP
#define UMBRAGE_HAS_PLANE_IN_MAP
// umbrage_plane_in_map: normal, in texels, texels and depth, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse
//   normal        normal of the plane, any length
//   world         point on the plane
UMBRAGE_HIGHP vec3 umbrage_plane_in_map(UMBRAGE_HIGHP mat4 plane_matrix, UMBRAGE_HIGHP vec3 normal,
                                        UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_HIGHP float d = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    UMBRAGE_HIGHP vec4 q = plane_matrix[3] * d + plane_matrix[0] * normal.x + plane_matrix[1] * normal.y +
                           plane_matrix[2] * normal.z;
    return vec3(q.x, q.y, q.z);
}
#endif

#ifndef UMBRAGE_HAS_RECEIVER_SLOPE
#define UMBRAGE_HAS_RECEIVER_SLOPE
// umbrage_receiver_slope: umbrage_plane_slope without its clamps; (0.0, 0.0) for a normal of zero (the caller has none)
UMBRAGE_HIGHP vec2 umbrage_receiver_slope(UMBRAGE_HIGHP mat4 plane_matrix, UMBRAGE_HIGHP vec3 normal,
                                          UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_HIGHP vec3 q = umbrage_plane_in_map(plane_matrix, normal, world);
    UMBRAGE_HIGHP float depth = q.z == 0.0 ? 1.0e-30 : q.z;  // q is zero without a normal, and not where edge-on
    return vec2(-q.x / depth, -q.y / depth);
}
#endif

#ifndef UMBRAGE_HAS_ADAPTIVE_MAPS_PLACES
#define UMBRAGE_HAS_ADAPTIVE_MAPS_PLACES
// umbrage_adaptive_maps_places: place of a point of the world in the page that holds it
//   to_root              matrix from the world to 1.0 to 2.0 across the root page
//   planes               plane matrix in texels of the deepest level
//   cells_0 to cells_7   16 x 16 cells of that level, row by row, two in each number: first + 1024.0 second; a cell is
//                        slot + 64.0 (2^level - 1.0)
//   anchor               position that is subtracted from world
//   pages                size of a page and width of its gutter, in texels
//   slack                of a plane: texels of slope of the page and of the deepest level; depth, and depth there
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
UMBRAGE_HIGHP mat4 umbrage_adaptive_maps_places(UMBRAGE_HIGHP mat4 to_root, UMBRAGE_HIGHP mat4 planes,
                                                UMBRAGE_HIGHP mat4 cells_0, UMBRAGE_HIGHP mat4 cells_1,
                                                UMBRAGE_HIGHP mat4 cells_2, UMBRAGE_HIGHP mat4 cells_3,
                                                UMBRAGE_HIGHP mat4 cells_4, UMBRAGE_HIGHP mat4 cells_5,
                                                UMBRAGE_HIGHP mat4 cells_6, UMBRAGE_HIGHP mat4 cells_7,
                                                UMBRAGE_HIGHP vec4 anchor, UMBRAGE_HIGHP vec4 pages,
                                                UMBRAGE_HIGHP vec4 slack, UMBRAGE_HIGHP vec4 terms,
                                                UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec4 none = vec4(0.0, 0.0, 0.0, 0.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 in_root = umbrage_shadow_coordinate(to_root, way);
    bool inside = in_root.x >= 1.0 && in_root.x < 2.0 && in_root.y >= 1.0 && in_root.y < 2.0;
    UMBRAGE_HIGHP vec2 coord = inside ? vec2(in_root.x, in_root.y) : vec2(1.0, 1.0);
    UMBRAGE_HIGHP vec2 cell = floor(coord * 16.0 - 16.0);
    UMBRAGE_HIGHP float right = floor(cell.x * 0.125);
    UMBRAGE_HIGHP float column = cell.y * 2.0 + right;
    UMBRAGE_HIGHP vec4 a = umbrage_cascade_column_8(cells_0, cells_1, column);
    UMBRAGE_HIGHP vec4 b = umbrage_cascade_column_8(cells_2, cells_3, column - 8.0);
    UMBRAGE_HIGHP vec4 c = umbrage_cascade_column_8(cells_4, cells_5, column - 16.0);
    UMBRAGE_HIGHP vec4 d = umbrage_cascade_column_8(cells_6, cells_7, column - 24.0);
    UMBRAGE_HIGHP vec4 low = column < 7.5 ? a : b;
    UMBRAGE_HIGHP vec4 high = column < 23.5 ? c : d;
    UMBRAGE_HIGHP vec4 eight = column < 15.5 ? low : high;
    UMBRAGE_HIGHP float along = cell.x - right * 8.0;
    UMBRAGE_HIGHP float pair = floor(along * 0.5);
    UMBRAGE_HIGHP float left_two = pair < 0.5 ? eight.x : eight.y;
    UMBRAGE_HIGHP float right_two = pair < 2.5 ? eight.z : eight.w;
    UMBRAGE_HIGHP float two = pair < 1.5 ? left_two : right_two;
    UMBRAGE_HIGHP float second = floor(two * (1.0 / 1024.0));
    UMBRAGE_HIGHP float code = along - pair * 2.0 < 0.5 ? two - second * 1024.0 : second;
    UMBRAGE_HIGHP float before = floor(code * (1.0 / 64.0));
    UMBRAGE_HIGHP float across = before + 1.0;
    UMBRAGE_HIGHP vec2 place = coord * across;
    UMBRAGE_HIGHP vec2 within = (place - floor(place)) * pages.x + pages.y;
    UMBRAGE_HIGHP vec2 at = inside ? within : vec2(32768.0, 32768.0);
    UMBRAGE_HIGHP vec2 deepest = umbrage_receiver_slope(planes, normal, way);
    UMBRAGE_HIGHP float larger = 16.0 / across;
    UMBRAGE_HIGHP float steep = abs(deepest.x) + abs(deepest.y);
    UMBRAGE_HIGHP float off = (slack.x * larger + slack.y) * steep + (slack.w * larger + slack.z);
    return mat4(vec4(at, in_root.z, code - before * 64.0),
                vec4(deepest * larger, 1.0, off), none, none);
}
#endif
