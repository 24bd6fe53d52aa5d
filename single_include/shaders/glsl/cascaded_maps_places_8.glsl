// umbrage 0.1.0, cascaded_maps_places_8: places of a point of the world in up to eight cascades. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// cascaded_maps_places_8, tier C: within 38 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CASCADE_COORDINATE
#define UMBRAGE_HAS_CASCADE_COORDINATE
// umbrage_cascade_coordinate: position in a cascade's map, texels and depth, of a point rotated into the light's axes
UMBRAGE_HIGHP vec3 umbrage_cascade_coordinate(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP vec4 scale,
                                              UMBRAGE_HIGHP vec4 offset) {
    UMBRAGE_HIGHP vec3 start = vec3(offset.x, offset.y, offset.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 at = light * vec3(scale.x, scale.y, scale.z) + start;
    return at;
}
#endif

#ifndef UMBRAGE_HAS_INSIDE_CASCADE
#define UMBRAGE_HAS_INSIDE_CASCADE
// umbrage_inside_cascade: true if a filter of radius reach at a coordinate stays inside a map of size texels
bool umbrage_inside_cascade(UMBRAGE_HIGHP vec3 coordinate, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP float reach) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 end = size - reach;
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
UMBRAGE_HIGHP vec4 umbrage_cascade_by_projection(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP mat4 scales,
                                                 UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP vec2 size,
                                                 UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec3 a = umbrage_cascade_coordinate(light, scales[0], offsets[0]);
    UMBRAGE_HIGHP vec3 b = umbrage_cascade_coordinate(light, scales[1], offsets[1]);
    UMBRAGE_HIGHP vec3 c = umbrage_cascade_coordinate(light, scales[2], offsets[2]);
    UMBRAGE_HIGHP vec3 d = umbrage_cascade_coordinate(light, scales[3], offsets[3]);
    UMBRAGE_HIGHP vec4 found = vec4(65536.0, 65536.0, 0.0, 4.0);
    found = umbrage_inside_cascade(d, size, reach) ? vec4(d, 3.0) : found;
    found = umbrage_inside_cascade(c, size, reach) ? vec4(c, 2.0) : found;
    found = umbrage_inside_cascade(b, size, reach) ? vec4(b, 1.0) : found;
    return umbrage_inside_cascade(a, size, reach) ? vec4(a, 0.0) : found;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_BY_PROJECTION_8
#define UMBRAGE_HAS_CASCADE_BY_PROJECTION_8
// umbrage_cascade_by_projection_8: umbrage_cascade_by_projection for eight cascades, four and four; index 8.0 for none
UMBRAGE_HIGHP vec4 umbrage_cascade_by_projection_8(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP mat4 scales,
                                                   UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP mat4 farther_scales,
                                                   UMBRAGE_HIGHP mat4 farther_offsets, UMBRAGE_HIGHP vec2 size,
                                                   UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec4 nearer = umbrage_cascade_by_projection(light, scales, offsets, size, reach);
    UMBRAGE_HIGHP vec4 farther = umbrage_cascade_by_projection(light, farther_scales, farther_offsets, size, reach);
    return nearer.w < 3.5 ? nearer : vec4(farther.x, farther.y, farther.z, farther.w + 4.0);
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

#ifndef UMBRAGE_HAS_CASCADE_EDGE
#define UMBRAGE_HAS_CASCADE_EDGE
// umbrage_cascade_edge: texels beyond the part of a cascade's map where a filter stays inside, at most 0.0 inside
//   coordinate   position in the cascade's map: texels, texels, depth
//   size, reach  size of the map and filter radius, in texels
// Returns 65536.0 for a depth outside [0, 1], far from the map, and for NaN
UMBRAGE_HIGHP float umbrage_cascade_edge(UMBRAGE_HIGHP vec3 coordinate, UMBRAGE_HIGHP vec2 size,
                                         UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec2 half_size = size * 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 beyond =
        abs(vec2(coordinate.x, coordinate.y) - half_size) - (half_size - reach);
    bool near_map = beyond.x + beyond.y < 65536.0;  // false for NaN
    return coordinate.z >= 0.0 && coordinate.z <= 1.0 && near_map ? max(beyond.x, beyond.y) : 65536.0;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_SLOPE
#define UMBRAGE_HAS_CASCADE_SLOPE
// umbrage_cascade_slope: change of depth per texel; (0.0, 0.0) for a normal of zero
//   normal  surface normal, rotated into the light's axes
//   scale   scale of the cascade
UMBRAGE_HIGHP vec2 umbrage_cascade_slope(UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec4 scale) {
    UMBRAGE_HIGHP vec2 up = vec2(normal.x, normal.y) * -scale.z;
    UMBRAGE_HIGHP float z = normal.z == 0.0 ? 1.0e-18 : normal.z;  // up is zero without a normal, and not where edge-on
    UMBRAGE_HIGHP vec2 across = vec2(scale.x, scale.y) * z;
    return vec2(up.x / across.x, up.y / across.y);
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_WEIGHT
#define UMBRAGE_HAS_CASCADE_WEIGHT
// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
UMBRAGE_HIGHP float umbrage_cascade_weight(UMBRAGE_HIGHP float v) {
    return v > 0.0 ? min(floor(v * 256.0), 256.0) * (1.0 / 256.0) : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_PAIR
#define UMBRAGE_HAS_CASCADE_PAIR
// umbrage_cascade_pair: places in a cascade and in the next one, whose weight grows towards the border of the map
//   across                    normal, rotated into the light's axes
//   found                     (texels, texels, depth, index) in the cascade; an index above the last: in none
//   there                     (texels, texels, depth) in the next one
//   edges                     umbrage_cascade_edge of both
//   slacks                    w of the offsets of both: slack of a plane in depth
//   scale                     scale of the cascade; w: slack of a plane in texels of slope
//   next_scale                that of the next one
//   blending                  1.0 / width of the band in texels, or 0.0; index of the last cascade
//   returns (texels, texels, depth, number), (slope, slope, weight, slack) of both. After the last: outside, lit
UMBRAGE_HIGHP mat4 umbrage_cascade_pair(UMBRAGE_HIGHP vec3 across, UMBRAGE_HIGHP vec4 found, UMBRAGE_HIGHP vec3 there,
                                        UMBRAGE_HIGHP vec2 edges, UMBRAGE_HIGHP vec2 slacks,
                                        UMBRAGE_HIGHP vec4 scale, UMBRAGE_HIGHP vec4 next_scale,
                                        UMBRAGE_HIGHP vec4 blending) {
    bool last = found.w >= blending.y;
    UMBRAGE_HIGHP vec2 v = edges * blending.x + 1.0;
    UMBRAGE_HIGHP float leaves = blending.x > 0.0 && found.w <= blending.y ? umbrage_cascade_weight(v.x) : 0.0;
    UMBRAGE_HIGHP float held = edges.y <= 0.0 ? 1.0 - umbrage_cascade_weight(v.y) : 0.0;
    UMBRAGE_HIGHP float weight = last ? leaves : min(leaves, held);
    UMBRAGE_HIGHP vec3 next = last ? vec3(-65536.0, -65536.0, 0.0) : there;
    UMBRAGE_HIGHP vec2 slope = umbrage_cascade_slope(across, scale);
    UMBRAGE_HIGHP vec2 next_slope = umbrage_cascade_slope(across, next_scale);
    UMBRAGE_HIGHP float slack = (abs(slope.x) + abs(slope.y)) * scale.w + slacks.x;
    UMBRAGE_HIGHP float next_slack = (abs(next_slope.x) + abs(next_slope.y)) * next_scale.w + slacks.y;
    return mat4(vec4(found.x, found.y, found.z, min(found.w, blending.y)), vec4(slope, 1.0, slack),
                vec4(next, min(found.w + 1.0, blending.y)), vec4(next_slope, weight, next_slack));
}
#endif

#ifndef UMBRAGE_HAS_CASCADED_MAPS_PLACES_8
#define UMBRAGE_HAS_CASCADED_MAPS_PLACES_8
// umbrage_cascaded_maps_places_8: places of a point of the world in one or two of up to eight cascades
//   farther_scales, farther_offsets   those of the fifth cascade and of those after it
//   the others, and what it returns   as umbrage_cascaded_maps_places
UMBRAGE_HIGHP mat4 umbrage_cascaded_maps_places_8(UMBRAGE_HIGHP mat4 rotation, UMBRAGE_HIGHP mat4 scales,
                                                  UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP mat4 farther_scales,
                                                  UMBRAGE_HIGHP mat4 farther_offsets, UMBRAGE_HIGHP vec4 anchor,
                                                  UMBRAGE_HIGHP vec4 blending, UMBRAGE_HIGHP vec4 terms,
                                                  UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec2 size = vec2(terms.x, terms.y);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 turned = umbrage_shadow_coordinate(rotation, way);
    UMBRAGE_HIGHP vec4 turned_normal = umbrage_shadow_coordinate(rotation, normal);
    UMBRAGE_HIGHP vec3 light = vec3(turned.x, turned.y, turned.z);
    UMBRAGE_HIGHP vec3 across = vec3(turned_normal.x, turned_normal.y, turned_normal.z);
    UMBRAGE_HIGHP vec4 found = umbrage_cascade_by_projection_8(light, scales, offsets, farther_scales, farther_offsets,
                                                               size, terms.z);
    UMBRAGE_HIGHP float number = min(found.w, blending.y);
    UMBRAGE_HIGHP float next = min(number + 1.0, blending.y);
    UMBRAGE_HIGHP vec4 next_scale = umbrage_cascade_column_8(scales, farther_scales, next);
    UMBRAGE_HIGHP vec4 next_offset = umbrage_cascade_column_8(offsets, farther_offsets, next);
    UMBRAGE_HIGHP vec3 there = umbrage_cascade_coordinate(light, next_scale, next_offset);
    UMBRAGE_HIGHP vec4 offset = umbrage_cascade_column_8(offsets, farther_offsets, number);
    UMBRAGE_HIGHP float edge = umbrage_cascade_edge(vec3(found.x, found.y, found.z), size, terms.z);
    UMBRAGE_HIGHP float next_edge = umbrage_cascade_edge(there, size, terms.z);
    return umbrage_cascade_pair(across, found, there, vec2(edge, next_edge), vec2(offset.w, next_offset.w),
                                umbrage_cascade_column_8(scales, farther_scales, number), next_scale, blending);
}
#endif
