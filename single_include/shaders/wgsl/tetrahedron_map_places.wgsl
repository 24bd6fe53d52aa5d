// umbrage 0.1.0, tetrahedron_map_places: place of a point of the world in a tetrahedron's map. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// tetrahedron_map_places, tier C: within 121 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_tetrahedron_face: face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
fn umbrage_tetrahedron_face(direction: vec3f) -> f32 {
    let beside: f32 = abs(direction.z) - abs(direction.x);
    let up: f32 = direction.y * 1.414213562;
    let z: f32 = select(0.0, 1.0, direction.z < 0.0);
    let x: f32 = select(2.0, 3.0, direction.x < 0.0);
    return select(x, z, beside >= up);
}

// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
fn umbrage_tetrahedron_face_point(face: f32, d: vec3f) -> vec3f {
    let z: vec3f = select(vec3f(d.x, d.y, -d.z), vec3f(-d.x, d.y, d.z), face < 0.5);
    let x: vec3f = select(vec3f(d.z, -d.y, -d.x), vec3f(-d.z, -d.y, d.x), face < 2.5);
    return select(x, z, face < 1.5);
}

// umbrage_tetrahedron_turned: vector from face 0's part of the map, rotated to the part of a face, 0.0 to 3.0
fn umbrage_tetrahedron_turned(face: f32, v: vec2f) -> vec2f {
    let z: vec2f = select(vec2f(-v.x, -v.y), v, face < 0.5);
    let x: vec2f = select(vec2f(v.y, -v.x), vec2f(-v.y, v.x), face < 2.5);
    return select(x, z, face < 1.5);
}

// umbrage_plane_in_map: normal, in texels, texels and depth, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse
//   normal        normal of the plane, any length
//   world         point on the plane
fn umbrage_plane_in_map(plane_matrix: mat4x4f, normal: vec3f, world: vec3f) -> vec3f {
    let d: f32 = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    let q: vec4f = plane_matrix[3] * d + plane_matrix[0] * normal.x + plane_matrix[1] * normal.y + plane_matrix[2] *
        normal.z;
    return vec3f(q.x, q.y, q.z);
}

// umbrage_receiver_slope: umbrage_plane_slope without its clamps; (0.0, 0.0) for a normal of zero (the caller has none)
fn umbrage_receiver_slope(plane_matrix: mat4x4f, normal: vec3f, world: vec3f) -> vec2f {
    let q: vec3f = umbrage_plane_in_map(plane_matrix, normal, world);
    let depth: f32 = select(q.z, 1.0e-30, q.z == 0.0);  // q is zero without a normal, and not where edge-on
    return vec2f(-q.x / depth, -q.y / depth);
}

// umbrage_anchored_place: place of a point in one map, and the slack of its plane
//   to_texels, planes   matrices from positions less the anchor to texels of the map, and to their planes
//   rounding, slack     of anchored_map; slack.w is added to depth
//   way                 position less the anchor
//   returns (texels, texels, depth, 0.0), (slope, slope, weight, slack); behind the light: a place taken as lit
fn umbrage_anchored_place(to_texels: mat4x4f, planes: mat4x4f, rounding: vec4f, slack: vec4f, way: vec3f,
                          normal: vec3f) -> mat4x4f {
    let none: vec4f = vec4f(0.0, 0.0, 0.0, 0.0);
    let c: vec4f = to_texels[3] + to_texels[0] * way.x + to_texels[1] * way.y + to_texels[2] * way.z;
    let slope: vec2f = umbrage_receiver_slope(planes, normal, way);
    let before: bool = c.w > 0.0;
    let i: f32 = select(0.0, 1.0 / c.w, before);
    let at: vec3f = vec3f(c.x, c.y, c.z) * i;
    let steep: f32 = abs(slope.x) + abs(slope.y);
    let moves: f32 = rounding.x + rounding.y * i;
    let off: f32 = moves * (rounding.w + abs(at.z)) + (abs(at.z) * slack.y + slack.z);
    let all: f32 = (moves * rounding.z + slack.x) * steep + off;
    return mat4x4f(vec4f(select(65536.0, at.x, before), at.y, at.z + slack.w, 0.0), vec4f(slope, 1.0, all), none, none);
}

// umbrage_tetrahedron_map_places: place of a point of the world in a tetrahedron's map
//   to_texels, planes, rounding, slack   of umbrage_anchored_place, from a face's axes to texels of face 0, relative
//                                        to the center
//   anchor                               position of the light
//   center                               half the map's size in texels
//   returns (texels, texels, depth, 0.0), (slope, slope, weight, slack)
fn umbrage_tetrahedron_map_places(to_texels: mat4x4f, planes: mat4x4f, anchor: vec4f, rounding: vec4f, slack: vec4f,
                                  center: vec4f, terms: vec4f, world: vec3f, normal: vec3f) -> mat4x4f {
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let face: f32 = umbrage_tetrahedron_face(way);
    let place: mat4x4f =
        umbrage_anchored_place(to_texels, planes, rounding, slack, umbrage_tetrahedron_face_point(face, way),
                               umbrage_tetrahedron_face_point(face, normal));
    let at: vec2f = umbrage_tetrahedron_turned(face, vec2f(place[0].x, place[0].y)) + center.x;
    let slope: vec2f = umbrage_tetrahedron_turned(face, vec2f(place[1].x, place[1].y));
    return mat4x4f(vec4f(at, place[0].z, 0.0), vec4f(slope, place[1].z, place[1].w), place[2], place[3]);
}
