// umbrage 0.1.0, adaptive_maps_places: place of a point of the world in the pages of an adaptive map. Exactness: tier
//   C.
// WGSL lets compilers fuse or reorder sums.
// adaptive_maps_places, tier C: within 68 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_shadow_coordinate: texture matrix times world position: (x w, y w, depth w, w), x and y in texels
fn umbrage_shadow_coordinate(m: mat4x4f, world: vec3f) -> vec4f {
    let c: vec4f = m[3] + m[0] * world.x + m[1] * world.y + m[2] * world.z;
    return c;
}

// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
fn umbrage_cascade_column(columns: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = select(columns[1], columns[0], number < 0.5);
    let high: vec4f = select(columns[3], columns[2], number < 2.5);
    return select(high, low, number < 1.5);
}

// umbrage_cascade_column_8: column of two matrices by its index, 0.0 to 7.0
fn umbrage_cascade_column_8(nearer: mat4x4f, farther: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = umbrage_cascade_column(nearer, number);
    let high: vec4f = umbrage_cascade_column(farther, number - 4.0);
    return select(high, low, number < 3.5);
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

// umbrage_adaptive_maps_places: place of a point of the world in the page that holds it
//   to_root              matrix from the world to 1.0 to 2.0 across the root page
//   planes               plane matrix in texels of the deepest level
//   cells_0 to cells_7   16 x 16 cells of that level, row by row, two in each number: first + 1024.0 second; a cell is
//                        slot + 64.0 (2^level - 1.0)
//   anchor               position that is subtracted from world
//   pages                size of a page and width of its gutter, in texels
//   slack                of a plane: texels of slope of the page and of the deepest level; depth, and depth there
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
fn umbrage_adaptive_maps_places(to_root: mat4x4f, planes: mat4x4f, cells_0: mat4x4f, cells_1: mat4x4f, cells_2: mat4x4f,
                                cells_3: mat4x4f, cells_4: mat4x4f, cells_5: mat4x4f, cells_6: mat4x4f,
                                cells_7: mat4x4f, anchor: vec4f, pages: vec4f, slack: vec4f, terms: vec4f, world: vec3f,
                                normal: vec3f) -> mat4x4f {
    let none: vec4f = vec4f(0.0, 0.0, 0.0, 0.0);
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let in_root: vec4f = umbrage_shadow_coordinate(to_root, way);
    let inside: bool = in_root.x >= 1.0 && in_root.x < 2.0 && in_root.y >= 1.0 && in_root.y < 2.0;
    let coord: vec2f = select(vec2f(1.0, 1.0), vec2f(in_root.x, in_root.y), inside);
    let cell: vec2f = floor(coord * 16.0 - 16.0);
    let right: f32 = floor(cell.x * 0.125);
    let column: f32 = cell.y * 2.0 + right;
    let a: vec4f = umbrage_cascade_column_8(cells_0, cells_1, column);
    let b: vec4f = umbrage_cascade_column_8(cells_2, cells_3, column - 8.0);
    let c: vec4f = umbrage_cascade_column_8(cells_4, cells_5, column - 16.0);
    let d: vec4f = umbrage_cascade_column_8(cells_6, cells_7, column - 24.0);
    let low: vec4f = select(b, a, column < 7.5);
    let high: vec4f = select(d, c, column < 23.5);
    let eight: vec4f = select(high, low, column < 15.5);
    let along: f32 = cell.x - right * 8.0;
    let pair: f32 = floor(along * 0.5);
    let left_two: f32 = select(eight.y, eight.x, pair < 0.5);
    let right_two: f32 = select(eight.w, eight.z, pair < 2.5);
    let two: f32 = select(right_two, left_two, pair < 1.5);
    let second: f32 = floor(two * (1.0 / 1024.0));
    let code: f32 = select(second, two - second * 1024.0, along - pair * 2.0 < 0.5);
    let before: f32 = floor(code * (1.0 / 64.0));
    let across: f32 = before + 1.0;
    let place: vec2f = coord * across;
    let within: vec2f = (place - floor(place)) * pages.x + pages.y;
    let at: vec2f = select(vec2f(32768.0, 32768.0), within, inside);
    let deepest: vec2f = umbrage_receiver_slope(planes, normal, way);
    let larger: f32 = 16.0 / across;
    let steep: f32 = abs(deepest.x) + abs(deepest.y);
    let off: f32 = (slack.x * larger + slack.y) * steep + (slack.w * larger + slack.z);
    return mat4x4f(vec4f(at, in_root.z, code - before * 64.0), vec4f(deepest * larger, 1.0, off), none, none);
}
