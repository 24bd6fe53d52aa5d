// umbrage 0.1.0, paraboloid_maps_places: place of a point of the world in two paraboloid maps. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// paraboloid_maps_places, tier C: within 57 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_dual_paraboloid_coordinate: (s, t, map) of a direction: 0.0 to 1.0 over the map's square, map 0.0 or 1.0
fn umbrage_dual_paraboloid_coordinate(direction: vec3f) -> vec3f {
    let square: f32 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    let behind: bool = direction.z < 0.0;
    let m: f32 = sqrt(square) + select(direction.z, -direction.z, behind);
    let x: f32 = select(-direction.x, direction.x, behind);
    return vec3f((x + m) / (m + m), (direction.y + m) / (m + m), select(0.0, 1.0, behind));
}

// umbrage_distance_depth: length of to_point, the vector from the light, times 1 / range
fn umbrage_distance_depth(to_point: vec3f, inv_range: f32) -> f32 {
    return sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}

// umbrage_clamp_slope: change of depth per texel clamped to [-2, 2]; NaN becomes 2.0
fn umbrage_clamp_slope(slope: f32) -> f32 {
    return select(select(2.0, -2.0, slope <= -2.0), slope, abs(slope) < 2.0);
}

// umbrage_dual_paraboloid_slope: change of distance per texel, the same in x and y; 0.0 without a normal
//   way        from the light to the receiver
//   normal     surface normal
//   per_texel  2.0 / (range * (size - 2.0 * border))
fn umbrage_dual_paraboloid_slope(way: vec3f, normal: vec3f, per_texel: f32) -> vec2f {
    let square: f32 = way.x * way.x + way.y * way.y + way.z * way.z;
    let x: f32 = normal.y * way.z - normal.z * way.y;
    let y: f32 = normal.z * way.x - normal.x * way.z;
    let z: f32 = normal.x * way.y - normal.y * way.x;
    let across: f32 = x * x + y * y + z * z;
    let along: f32 = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    let wide: f32 = (sqrt(square) + abs(way.z)) * (per_texel * 0.707106781);
    let slope: f32 = umbrage_clamp_slope(wide * sqrt(across) / abs(along));
    let none: bool = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return select(vec2f(slope, slope), vec2f(0.0, 0.0), none);
}

// umbrage_paraboloid_maps_places: place of a point of the world in two paraboloid maps
//   position   position of the light, and depth per world unit
//   halves     size of a paraboloid's image and its border in texels, slope of a depth per texel, depth at the light
//   rounding   error of a depth by rounding
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
fn umbrage_paraboloid_maps_places(position: vec4f, halves: vec4f, rounding: vec4f, terms: vec4f, world: vec3f,
                                  normal: vec3f) -> mat4x4f {
    let none: vec4f = vec4f(0.0, 0.0, 0.0, 0.0);
    let way: vec3f = world - vec3f(position.x, position.y, position.z);
    let found: vec3f = umbrage_dual_paraboloid_coordinate(way);
    let at: vec2f = vec2f(found.x, found.y) * halves.x + halves.y;
    let depth: f32 = umbrage_distance_depth(way, position.w) + halves.w;
    let slope: vec2f = umbrage_dual_paraboloid_slope(way, normal, halves.z);
    return mat4x4f(vec4f(at, depth, found.z), vec4f(slope, 1.0, rounding.x), none, none);
}
