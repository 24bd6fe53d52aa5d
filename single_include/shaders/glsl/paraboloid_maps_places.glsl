// umbrage 0.1.0, paraboloid_maps_places: place of a point of the world in two paraboloid maps. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// paraboloid_maps_places, tier C: within 57 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_DUAL_PARABOLOID_COORDINATE
#define UMBRAGE_HAS_DUAL_PARABOLOID_COORDINATE
// umbrage_dual_paraboloid_coordinate: (s, t, map) of a direction: 0.0 to 1.0 over the map's square, map 0.0 or 1.0
UMBRAGE_HIGHP vec3 umbrage_dual_paraboloid_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square =
        direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    bool behind = direction.z < 0.0;
    UMBRAGE_HIGHP float m = sqrt(square) + (behind ? -direction.z : direction.z);
    UMBRAGE_HIGHP float x = behind ? direction.x : -direction.x;
    return vec3((x + m) / (m + m), (direction.y + m) / (m + m), behind ? 1.0 : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_DISTANCE_DEPTH
#define UMBRAGE_HAS_DISTANCE_DEPTH
// umbrage_distance_depth: length of to_point, the vector from the light, times 1 / range
UMBRAGE_HIGHP float umbrage_distance_depth(UMBRAGE_HIGHP vec3 to_point, UMBRAGE_HIGHP float inv_range) {
    return sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}
#endif

#ifndef UMBRAGE_HAS_CLAMP_SLOPE
#define UMBRAGE_HAS_CLAMP_SLOPE
// umbrage_clamp_slope: change of depth per texel clamped to [-2, 2]; NaN becomes 2.0
UMBRAGE_HIGHP float umbrage_clamp_slope(UMBRAGE_HIGHP float slope) {
    return abs(slope) < 2.0 ? slope : (slope <= -2.0 ? -2.0 : 2.0);
}
#endif

#ifndef UMBRAGE_HAS_DUAL_PARABOLOID_SLOPE
#define UMBRAGE_HAS_DUAL_PARABOLOID_SLOPE
// umbrage_dual_paraboloid_slope: change of distance per texel, the same in x and y; 0.0 without a normal
//   way        from the light to the receiver
//   normal     surface normal
//   per_texel  2.0 / (range * (size - 2.0 * border))
UMBRAGE_HIGHP vec2 umbrage_dual_paraboloid_slope(UMBRAGE_HIGHP vec3 way, UMBRAGE_HIGHP vec3 normal,
                                                 UMBRAGE_HIGHP float per_texel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = way.x * way.x + way.y * way.y + way.z * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = normal.y * way.z - normal.z * way.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = normal.z * way.x - normal.x * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = normal.x * way.y - normal.y * way.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float across = x * x + y * y + z * z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float wide = (sqrt(square) + abs(way.z)) * (per_texel * 0.707106781);
    UMBRAGE_HIGHP float slope = umbrage_clamp_slope(wide * sqrt(across) / abs(along));
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return none ? vec2(0.0, 0.0) : vec2(slope, slope);
}
#endif

#ifndef UMBRAGE_HAS_PARABOLOID_MAPS_PLACES
#define UMBRAGE_HAS_PARABOLOID_MAPS_PLACES
// umbrage_paraboloid_maps_places: place of a point of the world in two paraboloid maps
//   position   position of the light, and depth per world unit
//   halves     size of a paraboloid's image and its border in texels, slope of a depth per texel, depth at the light
//   rounding   error of a depth by rounding
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
UMBRAGE_HIGHP mat4 umbrage_paraboloid_maps_places(UMBRAGE_HIGHP vec4 position, UMBRAGE_HIGHP vec4 halves,
                                                  UMBRAGE_HIGHP vec4 rounding, UMBRAGE_HIGHP vec4 terms,
                                                  UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec4 none = vec4(0.0, 0.0, 0.0, 0.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(position.x, position.y, position.z);
    UMBRAGE_HIGHP vec3 found = umbrage_dual_paraboloid_coordinate(way);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 at = vec2(found.x, found.y) * halves.x + halves.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = umbrage_distance_depth(way, position.w) + halves.w;
    UMBRAGE_HIGHP vec2 slope = umbrage_dual_paraboloid_slope(way, normal, halves.z);
    return mat4(vec4(at, depth, found.z), vec4(slope, 1.0, rounding.x), none, none);
}
#endif
