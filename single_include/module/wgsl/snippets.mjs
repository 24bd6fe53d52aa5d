import { wgsl as language } from '../languages.mjs';

export const shadow_coordinate = { language, name: "shadow_coordinate", summary: "world to texels and depth, before the division by w",
    exactness: "b", operations: 6, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_shadow_coordinate: texture matrix times world position: (x w, y w, depth w, w), x and y in texels
fn umbrage_shadow_coordinate(m: mat4x4f, world: vec3f) -> vec4f {
    let c: vec4f = m[3] + m[0] * world.x + m[1] * world.y + m[2] * world.z;
    return c;
}
` };

export const tap_coordinate = { language, name: "tap_coordinate", summary: "coordinate of a tap from the center's, before division by w",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_tap_coordinate: coordinate before the division by w, moved by offset texels
fn umbrage_tap_coordinate(coordinate: vec4f, offset: vec2f) -> vec4f {
    let moved: vec2f = vec2f(coordinate.x, coordinate.y) + offset * coordinate.w;
    return vec4f(moved.x, moved.y, coordinate.z, coordinate.w);
}
` };

export const project_coordinate = { language, name: "project_coordinate", summary: "division by w; lit behind the light",
    exactness: "c", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_project_coordinate: x and y in texels, and depth; w <= 0.0 gives a coordinate that every filter takes as lit
fn umbrage_project_coordinate(coordinate: vec4f) -> vec3f {
    let p: vec3f = vec3f(coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w);
    return select(vec3f(65536.0, 65536.0, 0.0), p, coordinate.w > 0.0);
}
` };

export const cascade_by_depth = { language, name: "cascade_by_depth", summary: "cascade that contains a view depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cascade_by_depth: cascade that contains a distance along the camera's axis, 0.0 to 3.0
//   ends  ends of the first three cascades, increasing
fn umbrage_cascade_by_depth(depth: f32, ends: vec3f) -> f32 {
    let reached: i32 = i32(depth >= ends.x) + i32(depth >= ends.y) + i32(depth >= ends.z);
    return f32(reached);
}
` };

export const cascade_column = { language, name: "cascade_column", summary: "one of four columns, without dynamic indexing",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
fn umbrage_cascade_column(columns: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = select(columns[1], columns[0], number < 0.5);
    let high: vec4f = select(columns[3], columns[2], number < 2.5);
    return select(high, low, number < 1.5);
}
` };

export const cascade_column_8 = { language, name: "cascade_column_8", summary: "one of eight columns, without dynamic indexing",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_column], text: `
// umbrage_cascade_column_8: column of two matrices by its index, 0.0 to 7.0
fn umbrage_cascade_column_8(nearer: mat4x4f, farther: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = umbrage_cascade_column(nearer, number);
    let high: vec4f = umbrage_cascade_column(farther, number - 4.0);
    return select(high, low, number < 3.5);
}
` };

export const cascade_coordinate = { language, name: "cascade_coordinate", summary: "position of a point in one cascade's map",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cascade_coordinate: position in a cascade's map, texels and depth, of a point rotated into the light's axes
fn umbrage_cascade_coordinate(light: vec3f, scale: vec4f, offset: vec4f) -> vec3f {
    let start: vec3f = vec3f(offset.x, offset.y, offset.z);
    let at: vec3f = light * vec3f(scale.x, scale.y, scale.z) + start;
    return at;
}
` };

export const inside_cascade = { language, name: "inside_cascade", summary: "true if a filter stays inside a cascade",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_inside_cascade: true if a filter of radius reach at a coordinate stays inside a map of size texels
fn umbrage_inside_cascade(coordinate: vec3f, size: vec2f, reach: f32) -> bool {
    let end: vec2f = size - reach;
    // y is doubled because Mesa turns two comparisons with one limit into min(x, y) >= reach, which loses a NaN
    let in_x: bool = coordinate.x >= reach && coordinate.x <= end.x;
    let in_y: bool = coordinate.y * 2.0 >= reach * 2.0 && coordinate.y * 2.0 <= end.y * 2.0;
    return in_x && in_y && coordinate.z >= 0.0 && coordinate.z <= 1.0;
}
` };

export const cascade_by_projection = { language, name: "cascade_by_projection", summary: "first cascade that contains a point and its filter",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_coordinate, inside_cascade], text: `
// umbrage_cascade_by_projection: (texels, texels, depth, index) in the first of four cascades that contains a point
//   and its filter; if there is none, index 4.0 and a coordinate that every filter takes as lit
//   light            the point, rotated into the light's axes
//   scales, offsets  scales and offsets of the cascades
//   size             size of each map, in texels
//   reach            filter radius, in texels
fn umbrage_cascade_by_projection(light: vec3f, scales: mat4x4f, offsets: mat4x4f, size: vec2f, reach: f32) -> vec4f {
    let a: vec3f = umbrage_cascade_coordinate(light, scales[0], offsets[0]);
    let b: vec3f = umbrage_cascade_coordinate(light, scales[1], offsets[1]);
    let c: vec3f = umbrage_cascade_coordinate(light, scales[2], offsets[2]);
    let d: vec3f = umbrage_cascade_coordinate(light, scales[3], offsets[3]);
    var found: vec4f = vec4f(65536.0, 65536.0, 0.0, 4.0);
    found = select(found, vec4f(d, 3.0), umbrage_inside_cascade(d, size, reach));
    found = select(found, vec4f(c, 2.0), umbrage_inside_cascade(c, size, reach));
    found = select(found, vec4f(b, 1.0), umbrage_inside_cascade(b, size, reach));
    return select(found, vec4f(a, 0.0), umbrage_inside_cascade(a, size, reach));
}
` };

export const cascade_by_projection_8 = { language, name: "cascade_by_projection_8", summary: "first of eight cascades that contains a point and its filter",
    exactness: "b", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_by_projection], text: `
// umbrage_cascade_by_projection_8: umbrage_cascade_by_projection for eight cascades, four and four; index 8.0 for none
fn umbrage_cascade_by_projection_8(light: vec3f, scales: mat4x4f, offsets: mat4x4f, farther_scales: mat4x4f,
                                   farther_offsets: mat4x4f, size: vec2f, reach: f32) -> vec4f {
    let nearer: vec4f = umbrage_cascade_by_projection(light, scales, offsets, size, reach);
    let farther: vec4f = umbrage_cascade_by_projection(light, farther_scales, farther_offsets, size, reach);
    return select(vec4f(farther.x, farther.y, farther.z, farther.w + 4.0), nearer, nearer.w < 3.5);
}
` };

export const cascade_tile = { language, name: "cascade_tile", summary: "first texel of a cascade in an atlas",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cascade_tile: first texel of a cascade in an atlas with two tiles of size texels per row
fn umbrage_cascade_tile(number: f32, size: vec2f) -> vec2f {
    let row: f32 = floor(number * 0.5);
    return vec2f(number - row * 2.0, row) * size;
}
` };

export const cascade_weight = { language, name: "cascade_weight", summary: "weight in steps of 1/256",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
fn umbrage_cascade_weight(v: f32) -> f32 {
    return select(0.0, min(floor(v * 256.0), 256.0) * (1.0 / 256.0), v > 0.0);
}
` };

export const cascade_fade = { language, name: "cascade_fade", summary: "weight of the next cascade, by view depth",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_weight], text: `
// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis: depth * scale + offset
fn umbrage_cascade_fade(depth: f32, scale: f32, offset: f32) -> f32 {
    let v: f32 = depth * scale + offset;
    return umbrage_cascade_weight(v);
}
` };

export const cascade_border_fade = { language, name: "cascade_border_fade", summary: "weight of the next cascade, by distance from the border",
    exactness: "b", operations: 8, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_weight], text: `
// umbrage_cascade_border_fade: weight of the next cascade, 1.0 up to reach texels from the border of a map
//   coordinate  position in the map, in texels
//   size        size of the map, in texels
//   per_texel   weight per texel: 1.0 / width of the band along the border
fn umbrage_cascade_border_fade(coordinate: vec2f, size: vec2f, reach: f32, per_texel: f32) -> f32 {
    let half_size: vec2f = size * 0.5;
    let beyond: vec2f = abs(coordinate - half_size) - (half_size - reach);
    let v: vec2f = beyond * per_texel + 1.0;
    let x: f32 = umbrage_cascade_weight(v.x);
    let y: f32 = umbrage_cascade_weight(v.y);
    return select(y, x, x > y);
}
` };

export const blend_cascades = { language, name: "blend_cascades", summary: "blend of two cascades' visibilities",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_blend_cascades: blend of the visibilities of a cascade and of the next one, by the next one's weight
fn umbrage_blend_cascades(nearer: f32, farther: f32, weight: f32) -> f32 {
    let sum: f32 = nearer + (farther - nearer) * weight;
    return select(farther, sum, weight < 1.0);
}
` };

export const inside_texel_space = { language, name: "inside_texel_space", summary: "true for coordinates that a filter can take",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
fn umbrage_inside_texel_space(coord: vec2f) -> bool {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}
` };

export const dither_threshold = { language, name: "dither_threshold", summary: "one of 16 dither thresholds for a pixel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [inside_texel_space], text: `
// umbrage_dither_threshold: dither threshold of a position in pixels: 1/32 to 31/32, each once in 4x4 pixels
fn umbrage_dither_threshold(pixel: vec2f) -> f32 {
    let whole: vec2f = select(vec2f(0.0, 0.0), floor(pixel), umbrage_inside_texel_space(pixel));
    let high: vec2f = floor(whole * 0.5);
    let above: vec2f = floor(whole * 0.25);
    let b0: vec2f = whole - high * 2.0;
    let b1: vec2f = high - above * 2.0;
    let m: f32 = abs(b0.x - b0.y) * 8.0 + b0.y * 4.0 + abs(b1.x - b1.y) * 2.0 + b1.y;
    return (m + 0.5) * (1.0 / 16.0);
}
` };

export const dithered_cascade = { language, name: "dithered_cascade", summary: "cascade of a pixel, or the next one, by its weight",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_dithered_cascade: index of a cascade, or of the next one if its weight is above the pixel's threshold
fn umbrage_dithered_cascade(number: f32, weight: f32, threshold: f32) -> f32 {
    return number + select(0.0, 1.0, weight > threshold);
}
` };

export const cube_face = { language, name: "cube_face", summary: "face of a cube that a direction meets",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cube_face: face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
fn umbrage_cube_face(direction: vec3f) -> f32 {
    let m: vec3f = abs(direction);
    let x: f32 = select(0.0, 1.0, direction.x < 0.0);
    let y: f32 = select(2.0, 3.0, direction.y < 0.0);
    let z: f32 = select(4.0, 5.0, direction.z < 0.0);
    // not m.x >= m.y && m.x >= m.z: Mesa turns it into one comparison with max(m.y, m.z), which loses a NaN
    return select(select(z, y, m.y >= m.z), select(z, x, m.x >= m.z), m.x >= m.y);
}
` };

export const cube_view_z = { language, name: "cube_view_z", summary: "distance along the axis of a direction's face",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cube_face], text: `
// umbrage_cube_view_z: magnitude of the largest component, the input of per-face depths
fn umbrage_cube_view_z(direction: vec3f) -> f32 {
    let face: f32 = umbrage_cube_face(direction);
    let side: f32 = select(direction.y, direction.x, face < 1.5);
    return abs(select(side, direction.z, face > 3.5));
}
` };

export const cube_plane = { language, name: "cube_plane", summary: "direction in the axes of its face",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cube_face], text: `
// umbrage_cube_plane: (sc, tc, face) of a direction: its components across the axis of its face
fn umbrage_cube_plane(direction: vec3f) -> vec3f {
    let face: f32 = umbrage_cube_face(direction);
    let x: vec3f = vec3f(select(direction.z, -direction.z, face < 0.5), -direction.y, face);
    let y: vec3f = vec3f(direction.x, select(-direction.z, direction.z, face < 2.5), face);
    let z: vec3f = vec3f(select(-direction.x, direction.x, face < 4.5), -direction.y, face);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}
` };

export const cube_point = { language, name: "cube_point", summary: "point from a face's axes",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cube_point: point from (sc, tc, distance along the axis) in a face, 0.0 to 5.0
fn umbrage_cube_point(face: f32, p: vec3f) -> vec3f {
    let x: vec3f = select(vec3f(-p.z, -p.y, p.x), vec3f(p.z, -p.y, -p.x), face < 0.5);
    let y: vec3f = select(vec3f(p.x, -p.z, -p.y), vec3f(p.x, p.z, p.y), face < 2.5);
    let z: vec3f = select(vec3f(-p.x, -p.y, -p.z), vec3f(p.x, -p.y, p.z), face < 4.5);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}
` };

export const cube_face_point = { language, name: "cube_face_point", summary: "point in a face's axes",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cube_face_point: (sc, tc, distance along the axis) in a face, 0.0 to 5.0, of a point from the cube's center
fn umbrage_cube_face_point(face: f32, p: vec3f) -> vec3f {
    let x: vec3f = select(vec3f(p.z, -p.y, -p.x), vec3f(-p.z, -p.y, p.x), face < 0.5);
    let y: vec3f = select(vec3f(p.x, -p.z, -p.y), vec3f(p.x, p.z, p.y), face < 2.5);
    let z: vec3f = select(vec3f(-p.x, -p.y, -p.z), vec3f(p.x, -p.y, p.z), face < 4.5);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}
` };

export const cube_coordinate = { language, name: "cube_coordinate", summary: "face of a direction, and the position on it",
    exactness: "c", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cube_view_z, cube_plane], text: `
// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
fn umbrage_cube_coordinate(direction: vec3f) -> vec3f {
    let p: vec3f = umbrage_cube_plane(direction);
    let m: f32 = umbrage_cube_view_z(direction);
    return vec3f((p.x + m) / (m + m), (p.y + m) / (m + m), p.z);
}
` };

export const cube_direction = { language, name: "cube_direction", summary: "direction to a point of a cube's face",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cube_point], text: `
// umbrage_cube_direction: direction from a cube's center to a point of a face, 0.0 to 5.0; st is in [0.0, 1.0]
fn umbrage_cube_direction(face: f32, st: vec2f) -> vec3f {
    let uv: vec2f = st * 2.0 - 1.0;  // the product is exact: fused or not, it rounds once
    return umbrage_cube_point(face, vec3f(uv, 1.0));
}
` };

export const cube_neighbor = { language, name: "cube_neighbor", summary: "texel beyond an edge of a cube's face",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cube_plane, cube_point], text: `
// umbrage_cube_neighbor: (s, t, face) of a texel that may lie beyond an edge of its face; face -1.0 beyond a corner
//   texel  (s, t, face), integers
//   size   size of a face, in texels
fn umbrage_cube_neighbor(texel: vec3f, size: f32) -> vec3f {
    let uv: vec2f = vec2f(texel.x, texel.y) * 2.0 + (1.0 - size);
    let beyond_u: bool = abs(uv.x) > size;
    let beyond_v: bool = abs(uv.y) > size;
    let m: f32 = select(size, size - 1.0, beyond_u || beyond_v);
    let p: vec3f = umbrage_cube_plane(umbrage_cube_point(texel.z, vec3f(uv, m)));
    let inside: vec2f = (vec2f(p.x, p.y) + (size - 1.0)) * 0.5;
    return select(vec3f(inside, p.z), vec3f(0.0, 0.0, -1.0), beyond_u && beyond_v);
}
` };

export const cube_tile = { language, name: "cube_tile", summary: "first texel of a face in an atlas",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
fn umbrage_cube_tile(face: f32, size: f32) -> vec2f {
    let row: f32 = select(1.0, 0.0, face < 2.5);
    return vec2f((face - row * 3.0) * size, row * size);
}
` };

export const cube_atlas_texel = { language, name: "cube_atlas_texel", summary: "face of an atlas texel, and the position on it",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cube_atlas_texel: (s, t, face) of a texel in an atlas of 3 x 2 tiles of size texels; integers
fn umbrage_cube_atlas_texel(texel: vec2f, size: f32) -> vec3f {
    let column: f32 = select(select(2.0, 1.0, texel.x < size * 2.0), 0.0, texel.x < size);
    let row: f32 = select(1.0, 0.0, texel.y < size);
    return vec3f(texel - vec2f(column, row) * size, column + row * 3.0);
}
` };

export const cube_atlas_direction = { language, name: "cube_atlas_direction", summary: "direction that reads an atlas texel from a cube texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cube_atlas_texel, cube_point], text: `
// umbrage_cube_atlas_direction: direction from a cube's center to an atlas texel, for 3 x 2 tiles of size texels
fn umbrage_cube_atlas_direction(texel: vec2f, size: f32) -> vec3f {
    let part: vec3f = umbrage_cube_atlas_texel(texel, size);
    let uv: vec2f = vec2f(part.x, part.y) * 2.0 + (1.0 - size);
    return umbrage_cube_point(part.z, vec3f(uv, size));
}
` };

export const dual_paraboloid_coordinate = { language, name: "dual_paraboloid_coordinate", summary: "paraboloid map that sees a direction, and position in it",
    exactness: "c", operations: 32, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_dual_paraboloid_coordinate: (s, t, map) of a direction: 0.0 to 1.0 over the map's square, map 0.0 or 1.0
fn umbrage_dual_paraboloid_coordinate(direction: vec3f) -> vec3f {
    let square: f32 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    let behind: bool = direction.z < 0.0;
    let m: f32 = sqrt(square) + select(direction.z, -direction.z, behind);
    let x: f32 = select(-direction.x, direction.x, behind);
    return vec3f((x + m) / (m + m), (direction.y + m) / (m + m), select(0.0, 1.0, behind));
}
` };

export const dual_paraboloid_position = { language, name: "dual_paraboloid_position", summary: "position of a vertex in a paraboloid map's depth pass",
    exactness: "c", operations: 18, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_dual_paraboloid_position: (x w, y w, distance w, w) of a vertex, for the depth pass' projection
//   direction  from the light to the vertex
//   map        index of the map, 0.0 or 1.0
fn umbrage_dual_paraboloid_position(direction: vec3f, map: f32) -> vec4f {
    let behind: bool = map > 0.5;
    let square: f32 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    let distance_to: f32 = sqrt(square);
    let w: f32 = distance_to + select(direction.z, -direction.z, behind);
    return vec4f(select(-direction.x, direction.x, behind), direction.y, distance_to * w, w);
}
` };

export const tetrahedron_face = { language, name: "tetrahedron_face", summary: "face of a tetrahedron that a direction meets",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_tetrahedron_face: face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
fn umbrage_tetrahedron_face(direction: vec3f) -> f32 {
    let beside: f32 = abs(direction.z) - abs(direction.x);
    let up: f32 = direction.y * 1.414213562;
    let z: f32 = select(0.0, 1.0, direction.z < 0.0);
    let x: f32 = select(2.0, 3.0, direction.x < 0.0);
    return select(x, z, beside >= up);
}
` };

export const tetrahedron_face_point = { language, name: "tetrahedron_face_point", summary: "direction in the axes of a tetrahedron's face",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
fn umbrage_tetrahedron_face_point(face: f32, d: vec3f) -> vec3f {
    let z: vec3f = select(vec3f(d.x, d.y, -d.z), vec3f(-d.x, d.y, d.z), face < 0.5);
    let x: vec3f = select(vec3f(d.z, -d.y, -d.x), vec3f(-d.z, -d.y, d.x), face < 2.5);
    return select(x, z, face < 1.5);
}
` };

export const tetrahedron_plane = { language, name: "tetrahedron_plane", summary: "direction in the axes of its tetrahedron face",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [tetrahedron_face, tetrahedron_face_point], text: `
// umbrage_tetrahedron_plane: (along the base, up, away) of a direction in the axes of the face that it meets
fn umbrage_tetrahedron_plane(direction: vec3f) -> vec3f {
    return umbrage_tetrahedron_face_point(umbrage_tetrahedron_face(direction), direction);
}
` };

export const tetrahedron_view_z = { language, name: "tetrahedron_view_z", summary: "distance along the normal of a direction's face",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [tetrahedron_plane], text: `
// umbrage_tetrahedron_view_z: distance along the face's normal, the input of per-face depths
fn umbrage_tetrahedron_view_z(direction: vec3f) -> f32 {
    let p: vec3f = umbrage_tetrahedron_plane(direction);
    let z: f32 = p.z * 0.816496581 + p.y * -0.577350269;
    return z;
}
` };

export const tetrahedron_coordinate = { language, name: "tetrahedron_coordinate", summary: "tetrahedron face of a direction, and the position on it",
    exactness: "c", operations: 6, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [tetrahedron_face, tetrahedron_plane], text: `
// umbrage_tetrahedron_coordinate: (s, t, face) of a direction
//   s  -1.0 to 1.0 along the base
//   t  0.0 at the base to 1.0 at the apex
fn umbrage_tetrahedron_coordinate(direction: vec3f) -> vec3f {
    let p: vec3f = umbrage_tetrahedron_plane(direction);
    let d: f32 = p.z * 2.0 + p.y * -1.414213562;
    return vec3f(p.x / d, p.z / d, umbrage_tetrahedron_face(direction));
}
` };

export const tetrahedron_turned = { language, name: "tetrahedron_turned", summary: "vector rotated from face 0's part of the map to another's",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_tetrahedron_turned: vector from face 0's part of the map, rotated to the part of a face, 0.0 to 3.0
fn umbrage_tetrahedron_turned(face: f32, v: vec2f) -> vec2f {
    let z: vec2f = select(vec2f(-v.x, -v.y), v, face < 0.5);
    let x: vec2f = select(vec2f(v.y, -v.x), vec2f(-v.y, v.x), face < 2.5);
    return select(x, z, face < 1.5);
}
` };

export const tetrahedron_texel = { language, name: "tetrahedron_texel", summary: "position in the map of a point on a tetrahedron's face",
    exactness: "b", operations: 9, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [tetrahedron_turned], text: `
// umbrage_tetrahedron_texel: position in a square map, in texels, from (s, t, face) on a tetrahedron
//   size    size of the map, in texels
//   border  border along the sides of each triangle, in texels
fn umbrage_tetrahedron_texel(at: vec3f, size: f32, border: f32) -> vec2f {
    let half_size: f32 = size * 0.5;
    let scale: f32 = half_size - border * 3.0;
    let x: f32 = at.x * scale;
    let y: f32 = at.y * scale + (border - half_size);
    let texel: vec2f = umbrage_tetrahedron_turned(at.z, vec2f(x, y)) + half_size;
    return texel;
}
` };

export const tetrahedron_face_of = { language, name: "tetrahedron_face_of", summary: "face of a tetrahedron that contains a texel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_tetrahedron_face_of: face, 0.0 to 3.0, whose triangle contains a texel, in a map of size texels
fn umbrage_tetrahedron_face_of(texel: vec2f, size: f32) -> f32 {
    let off: vec2f = texel * 2.0 + (1.0 - size);
    let column: f32 = select(1.0, 0.0, off.y < 0.0);
    let row: f32 = select(2.0, 3.0, off.x < 0.0);
    return select(row, column, abs(off.y) >= abs(off.x));
}
` };

export const pancake = { language, name: "pancake", summary: "casters clamped to the near plane (pancaking)",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_pancake: clip space position, clamped to the near plane if it lies in front of it
//   at_near  z/w of the near plane: 0.0 or -1.0, or 1.0 for reversed depth
fn umbrage_pancake(position: vec4f, at_near: f32) -> vec4f {
    let plane: f32 = at_near * position.w;
    let before: bool = select((position.z < plane), (position.z > plane), at_near > 0.5);
    return vec4f(position.x, position.y, select(position.z, plane, before), position.w);
}
` };

export const texel = { language, name: "texel", summary: "texel inside a map",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "texel", scaled: false,
    needs: [], text: `
// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
fn umbrage_texel(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return textureLoad(map, vec2i(texel), 0);
}
` };

export const from_unorm = { language, name: "from_unorm", summary: "channel 0..255 of a value from an 8-bit texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_from_unorm: channel 0..255 of a value from an 8-bit texture, even if the division by 255 is inexact
fn umbrage_from_unorm(c: f32) -> f32 {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec2f(c: vec2f) -> vec2f {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec3f(c: vec3f) -> vec3f {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec4f(c: vec4f) -> vec4f {
    return floor(c * 255.0 + 0.5);
}
` };

export const page_coordinate = { language, name: "page_coordinate", summary: "position of a receiver in the atlas page that holds it",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [texel, from_unorm], text: `
// umbrage_page_coordinate: (x, y) of a receiver in an atlas page with its gutter, and (z, w) the page's first texel
//   table   page table, RGBA8, nearest filter
//   size    size of the table, in texels
//   coord   receiver position, 1.0 to 2.0 across the table without its border
//   page    side of a page, in texels
//   gutter  border around a page, in texels
fn umbrage_page_coordinate(table: texture_2d<f32>, size: vec2f, coord: vec2f, page: f32, gutter: f32) -> vec4f {
    // neither max changes a value; compilers cannot regroup sums across max and clamp
    let sides: vec2f = max(size - 2.0, vec2f(1.0, 1.0));
    let before: vec2f = max(size - 3.0, vec2f(0.0, 0.0));
    let cell: vec2f = min(max(vec2f(0.0, 0.0), coord * sides - before), size - 1.0);
    let texel: vec2i = vec2i(cell);  // the first texel for a NaN
    let entry: vec4f = umbrage_from_unorm_vec4f(umbrage_texel(table, size, vec2f(texel)));
    let slot: vec2f = vec2f(entry.x, entry.y);
    let across: f32 = entry.z + entry.w * 256.0;
    let within: vec2f = clamp(fract(coord * across), vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    let at: vec2f = within * page + select(32768.0, gutter, across > 0.0);
    return vec4f(at, slot * (page + gutter * 2.0));
}
` };

export const page_tile = { language, name: "page_tile", summary: "first texel of a page in an atlas of eight a row",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_page_tile: first texel of a page, a whole number, in an atlas of pages of size texels, eight a row
fn umbrage_page_tile(number: f32, size: f32) -> vec2f {
    let row: f32 = floor(number * 0.125);
    return vec2f(number - row * 8.0, row) * size;
}
` };

export const linear_depth = { language, name: "linear_depth", summary: "view-space z over z_far",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_linear_depth: distance along the light's axis, positive in front of the light, times 1 / z_far
fn umbrage_linear_depth(z_view: f32, inv_z_far: f32) -> f32 {
    return z_view * inv_z_far;
}
` };

export const project_depth = { language, name: "project_depth", summary: "z / w, and the far plane behind the light",
    exactness: "c", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_project_depth: z / w. Returns cleared for w <= 0.0: 1.0, or 0.0 where depth is reversed
fn umbrage_project_depth(z: f32, w: f32, cleared: f32) -> f32 {
    return select(cleared, z / w, w > 0.0);
}
` };

export const distance_depth = { language, name: "distance_depth", summary: "distance to the light over its range",
    exactness: "c", operations: 9, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_distance_depth: length of to_point, the vector from the light, times 1 / range
fn umbrage_distance_depth(to_point: vec3f, inv_range: f32) -> f32 {
    return sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}
` };

export const reverse_depth = { language, name: "reverse_depth", summary: "1 - depth",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_reverse_depth: forward depth from reversed depth, or reversed from forward
fn umbrage_reverse_depth(depth: f32) -> f32 {
    return 1.0 - depth;
}
` };

export const depth_from_ndc = { language, name: "depth_from_ndc", summary: "z/w in [-1, 1] to depth in [0, 1]",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_depth_from_ndc: depth in [0, 1] from z/w in [-1, 1]
fn umbrage_depth_from_ndc(ndc: f32) -> f32 {
    let depth: f32 = ndc * 0.5 + 0.5;
    return depth;
}
` };

export const view_z_from_depth = { language, name: "view_z_from_depth", summary: "perspective depth to view-space z",
    exactness: "c", operations: 8, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_view_z_from_depth: distance along the light's axis from perspective depth in [0, 1], 0.0 at z_near
fn umbrage_view_z_from_depth(depth: f32, z_near: f32, z_far: f32) -> f32 {
    return z_near / (1.0 - depth * (1.0 - z_near / z_far));
}
` };

export const depth_from_view_z = { language, name: "depth_from_view_z", summary: "view-space z to perspective depth",
    exactness: "c", operations: 10, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_depth_from_view_z: perspective depth in [0, 1], 0.0 at z_near, from the distance along the light's axis
fn umbrage_depth_from_view_z(z_view: f32, z_near: f32, z_far: f32) -> f32 {
    return (1.0 - z_near / z_view) / (1.0 - z_near / z_far);
}
` };

export const view_z_from_reversed_depth = { language, name: "view_z_from_reversed_depth", summary: "reversed perspective depth to view-space z",
    exactness: "c", operations: 11, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_view_z_from_reversed_depth: distance along the light's axis from perspective depth in [0, 1], 1.0 at z_near
fn umbrage_view_z_from_reversed_depth(depth: f32, z_near: f32, z_far: f32) -> f32 {
    return z_near / (z_near / z_far + depth * (1.0 - z_near / z_far));
}
` };

export const reversed_depth_from_view_z = { language, name: "reversed_depth_from_view_z", summary: "view-space z to reversed perspective depth",
    exactness: "c", operations: 13, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_reversed_depth_from_view_z: perspective depth in [0, 1], 1.0 at z_near, from the distance along the light's
// axis
fn umbrage_reversed_depth_from_view_z(z_view: f32, z_near: f32, z_far: f32) -> f32 {
    return z_near / z_view * (1.0 - z_view / z_far) / (1.0 - z_near / z_far);
}
` };

export const view_z_from_orthographic_depth = { language, name: "view_z_from_orthographic_depth", summary: "orthographic depth to view-space z",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_view_z_from_orthographic_depth: distance along the light's axis from orthographic depth in [0, 1]
// Depth is 0.0 at z_near. Exchange z_near and z_far where it is reversed
fn umbrage_view_z_from_orthographic_depth(depth: f32, z_near: f32, z_far: f32) -> f32 {
    let z_view: f32 = z_near + depth * (z_far - z_near);
    return z_view;
}
` };

export const orthographic_depth_from_view_z = { language, name: "orthographic_depth_from_view_z", summary: "view-space z to orthographic depth",
    exactness: "c", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_orthographic_depth_from_view_z: orthographic depth in [0, 1] from the distance along the light's axis
// Depth is 0.0 at z_near. Exchange z_near and z_far where it is reversed
fn umbrage_orthographic_depth_from_view_z(z_view: f32, z_near: f32, z_far: f32) -> f32 {
    return (z_view - z_near) / (z_far - z_near);
}
` };

export const cleared_depth = { language, name: "cleared_depth", summary: "depth of the far plane",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "cleared_depth", scaled: false,
    needs: [], text: `
// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}
` };

export const saturate = { language, name: "saturate", summary: "clamp to [0, 1]; NaN becomes the far plane",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
fn umbrage_saturate(v: f32) -> f32 {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return select(select(select(umbrage_cleared_depth(), 0.0, v <= 0.0), 1.0, v >= 1.0), v, v > 0.0 && v < 1.0);
}
` };

export const correct_quotient = { language, name: "correct_quotient", summary: "floor of a quotient, from a guess off by at most one",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_correct_quotient: floor(a / b) from a guess q, off by at most one
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
fn umbrage_correct_quotient(q: f32, a: f32, b: f32) -> f32 {
    let more: f32 = q + 1.0;
    let known: f32 = select(q, more, more * b <= a);
    return select(known, q - 1.0, q * b > a);
}
` };

export const floor_divide = { language, name: "floor_divide", summary: "integer division that rounds down, exact on any GPU",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [correct_quotient], text: `
// umbrage_floor_divide: floor(a / b) of integers; the quotient is at most 2^18
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
fn umbrage_floor_divide(a: f32, b: f32) -> f32 {
    return umbrage_correct_quotient(floor(a / b), a, b);
}
` };

export const to_unorm = { language, name: "to_unorm", summary: "value that makes an 8-bit target store channel 0..255",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_to_unorm: value that makes an 8-bit target store channel k, whether it rounds or truncates
// k * 257 / 65536 + 64 / 65536, in decimals because 65536.0 is infinite in mediump
fn umbrage_to_unorm(k: f32) -> f32 {
    return k * 0.0039215087890625 + 0.0009765625;
}
fn umbrage_to_unorm_vec2f(k: vec2f) -> vec2f {
    return k * 0.0039215087890625 + 0.0009765625;
}
fn umbrage_to_unorm_vec3f(k: vec3f) -> vec3f {
    return k * 0.0039215087890625 + 0.0009765625;
}
fn umbrage_to_unorm_vec4f(k: vec4f) -> vec4f {
    return k * 0.0039215087890625 + 0.0009765625;
}
` };

export const to_unorm10 = { language, name: "to_unorm10", summary: "value that makes a 10-bit target store channel 0..1023",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_to_unorm10: value that makes a 10-bit target store channel k, whether it rounds or truncates
// k * 4099 / 4194304 + 1056 / 4194304
fn umbrage_to_unorm10(k: f32) -> f32 {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
fn umbrage_to_unorm10_vec2f(k: vec2f) -> vec2f {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
fn umbrage_to_unorm10_vec3f(k: vec3f) -> vec3f {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
fn umbrage_to_unorm10_vec4f(k: vec4f) -> vec4f {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
` };

export const from_unorm10 = { language, name: "from_unorm10", summary: "channel 0..1023 of a value from a 10-bit texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_from_unorm10: channel 0..1023 of a value from a 10-bit texture, even if the division by 1023 is inexact
fn umbrage_from_unorm10(c: f32) -> f32 {
    return floor(c * 1023.0 + 0.5);
}
fn umbrage_from_unorm10_vec2f(c: vec2f) -> vec2f {
    return floor(c * 1023.0 + 0.5);
}
fn umbrage_from_unorm10_vec3f(c: vec3f) -> vec3f {
    return floor(c * 1023.0 + 0.5);
}
fn umbrage_from_unorm10_vec4f(c: vec4f) -> vec4f {
    return floor(c * 1023.0 + 0.5);
}
` };

export const to_unorm16 = { language, name: "to_unorm16", summary: "value that makes a 16-bit target store channel 0..65535",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_to_unorm16: value that makes a 16-bit target store channel k, whether it rounds or truncates
fn umbrage_to_unorm16(k: f32) -> f32 {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
fn umbrage_to_unorm16_vec2f(k: vec2f) -> vec2f {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), vec2f(65536.0)) * (1.0 / 65536.0);
}
fn umbrage_to_unorm16_vec3f(k: vec3f) -> vec3f {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), vec3f(65536.0)) * (1.0 / 65536.0);
}
fn umbrage_to_unorm16_vec4f(k: vec4f) -> vec4f {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), vec4f(65536.0)) * (1.0 / 65536.0);
}
` };

export const from_unorm16 = { language, name: "from_unorm16", summary: "channel 0..65535 of a value from a 16-bit texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_from_unorm16: channel 0..65535 of a value from a 16-bit texture, even if the division by 65535 is inexact
fn umbrage_from_unorm16(c: f32) -> f32 {
    return floor(c * 65535.0 + 0.5);
}
fn umbrage_from_unorm16_vec2f(c: vec2f) -> vec2f {
    return floor(c * 65535.0 + 0.5);
}
fn umbrage_from_unorm16_vec3f(c: vec3f) -> vec3f {
    return floor(c * 65535.0 + 0.5);
}
fn umbrage_from_unorm16_vec4f(c: vec4f) -> vec4f {
    return floor(c * 65535.0 + 0.5);
}
` };

export const encode_rg9 = { language, name: "encode_rg9", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg9: two channels of a 9-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg9(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 512.0), 511.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 128.0);
}
` };

export const encode_rg10 = { language, name: "encode_rg10", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg10: two channels of a 10-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg10(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 1024.0), 1023.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 64.0);
}
` };

export const encode_rg11 = { language, name: "encode_rg11", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg11: two channels of a 11-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg11(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 32.0);
}
` };

export const encode_rg12 = { language, name: "encode_rg12", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg12: two channels of a 12-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg12(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 4096.0), 4095.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 16.0);
}
` };

export const encode_rg13 = { language, name: "encode_rg13", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg13: two channels of a 13-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg13(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 8.0);
}
` };

export const encode_rg14 = { language, name: "encode_rg14", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg14: two channels of a 14-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg14(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 4.0);
}
` };

export const encode_rg15 = { language, name: "encode_rg15", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg15: two channels of a 15-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg15(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 2.0);
}
` };

export const encode_rg16 = { language, name: "encode_rg16", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg16: two channels of a 16-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg16(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 1.0);
}
` };

export const encode_rgb24 = { language, name: "encode_rgb24", summary: "depth to three 8-bit channels, R most significant",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rgb24: three channels of a depth, R most significant, integers 0..255 for umbrage_to_unorm
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rgb24(depth: f32) -> vec3f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    let high: f32 = floor(x * (1.0 / 65536.0));
    let rest: f32 = x - high * 65536.0;
    let middle: f32 = floor(rest * (1.0 / 256.0));
    return vec3f(high, middle, min(rest - middle * 256.0, 255.0));  // below already: no sum is regrouped across the min
}
` };

export const encode_rgb10 = { language, name: "encode_rgb10", summary: "depth to three 10-bit channels, R most significant",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rgb10: three channels of a depth, R most significant, integers 0..1023 for umbrage_to_unorm10
// The last four bits are the high ones of B, so a target cleared to white is at the far plane
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rgb10(depth: f32) -> vec3f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    let high: f32 = floor(x * (1.0 / 16384.0));
    let rest: f32 = x - high * 16384.0;
    let middle: f32 = floor(rest * (1.0 / 16.0));
    let low: f32 = min(rest - middle * 16.0, 15.0);  // below already: no sum is regrouped across the min
    return vec3f(high, middle, low * 64.0);
}
` };

export const encode_r16 = { language, name: "encode_r16", summary: "depth to one 16-bit channel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_r16: 16-bit channel of a depth, an integer 0..65535 for umbrage_to_unorm16
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_r16(depth: f32) -> f32 {
    return min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
}
` };

export const encode_float_bits = { language, name: "encode_float_bits", summary: "bit pattern of a float to four channels, R least significant",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "300 es", role: "none", scaled: false,
    needs: [], text: `
// umbrage_encode_float_bits: bit pattern of v as four channels, R least significant, integers 0..255
fn umbrage_encode_float_bits(v: f32) -> vec4f {
    let bits: u32 = bitcast<u32>(v);
    return vec4f(f32(bits & 255u), f32((bits >> 8) & 255u), f32((bits >> 16) & 255u), f32(bits >> 24));
}
` };

export const write_threejs_rgba = { language, name: "write_threejs_rgba", summary: "depth to three.js RGBA, r167 and later",
    exactness: "b", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_write_threejs_rgba: RGBA of a depth, as in three.js r167 and later, values to write as they are
fn umbrage_write_threejs_rgba(depth: f32) -> vec4f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = v * 16777216.0;
    let whole: f32 = floor(x);
    let high: f32 = floor(whole * (1.0 / 65536.0));
    let rest: f32 = whole - high * 65536.0;
    let middle: f32 = floor(rest * (1.0 / 256.0));
    let low: f32 = rest - middle * 256.0;
    let c: vec4f = vec4f(high * 0.00392156886, middle * 0.00392156886, low * 0.00392156886, x - whole);
    return select(vec4f(1.0, 1.0, 1.0, 1.0), c, v < 1.0);
}
` };

export const write_threejs_rgb = { language, name: "write_threejs_rgb", summary: "depth to three.js RGB, r167 and later",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_write_threejs_rgb: RGB of a depth, as in three.js r167 and later, values to write as they are
fn umbrage_write_threejs_rgb(depth: f32) -> vec3f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = v * 65536.0;
    let whole: f32 = floor(x);
    let high: f32 = floor(whole * (1.0 / 256.0));
    let c: vec3f = vec3f(high * 0.00392156886, (whole - high * 256.0) * 0.00392156886, x - whole);
    return select(vec3f(1.0, 1.0, 1.0), c, v < 1.0);
}
` };

export const write_threejs_rg = { language, name: "write_threejs_rg", summary: "depth to three.js RG, r167 and later",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_write_threejs_rg: RG of a depth, as in three.js r167 and later, values to write as they are
fn umbrage_write_threejs_rg(depth: f32) -> vec2f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = v * 256.0;
    let whole: f32 = floor(x);
    return select(vec2f(1.0, 1.0), vec2f(whole * 0.00392156886, x - whole), v < 1.0);
}
` };

export const write_threejs_legacy = { language, name: "write_threejs_legacy", summary: "depth to three.js RGBA, r73 to r166",
    exactness: "b", operations: 7, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_write_threejs_legacy: RGBA of a depth, as in three.js r73 to r166, values to write as they are
//   1.0 reads back as 255/256. umbrage_encode_threejs_legacy_repaired does not have this fault
fn umbrage_write_threejs_legacy(depth: f32) -> vec4f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = v * 16777216.0 - floor(v * 16777216.0);
    let y: f32 = v * 65536.0 - floor(v * 65536.0);
    let z: f32 = v * 256.0 - floor(v * 256.0);
    let c: vec4f = vec4f(x, y - x * (1.0 / 256.0), z - y * (1.0 / 256.0), v - z * (1.0 / 256.0));
    return c * 1.00392163;
}
` };

export const encode_threejs_legacy_repaired = { language, name: "encode_threejs_legacy_repaired", summary: "depth to three.js RGBA, r73 to r166, without its fault",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_threejs_legacy_repaired: channels of a depth for readers of three.js r73 to r166. 1.0 decodes to 1.0
//   Returns integers 0..255 (umbrage_to_unorm writes them)
fn umbrage_encode_threejs_legacy_repaired(depth: f32) -> vec4f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = floor(v * 16777216.0);
    let high: f32 = floor(x * (1.0 / 65536.0));
    let rest: f32 = x - high * 65536.0;
    let middle: f32 = floor(rest * (1.0 / 256.0));
    let low: f32 = min(rest - middle * 256.0, 255.0);  // below already: no sum is regrouped across the min
    return select(vec4f(255.0, 255.0, 255.0, 255.0), vec4f(0.0, low, middle, high), v < 1.0);
}
` };

export const write_base255 = { language, name: "write_base255", summary: "depth to base-255 RGBA of Cesium, Babylon.js, bgfx",
    exactness: "b", operations: 6, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_write_base255: base-255 RGBA of a depth, values to write as they are. The store must round
// 1.0 reads back as 0.0. umbrage_encode_base255_repaired has neither fault
fn umbrage_write_base255(depth: f32) -> vec4f {
    let v: f32 = umbrage_saturate(depth);
    var e: vec4f = vec4f(v, v * 255.0, v * 65025.0, v * 16581375.0);
    e = e - floor(e);
    let c: vec4f = vec4f(e.x - e.y * 0.00392156886, e.y - e.z * 0.00392156886, e.z - e.w * 0.00392156886, e.w);
    return c;
}
` };

export const encode_base255_repaired = { language, name: "encode_base255_repaired", summary: "depth to base-255 RGBA without its faults",
    exactness: "b", operations: 7, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_base255_repaired: channels of a depth for readers of base-255 RGBA. 1.0 decodes to 1.0
//   Returns integers 0..255 (umbrage_to_unorm writes them)
fn umbrage_encode_base255_repaired(depth: f32) -> vec4f {
    let x: f32 = umbrage_saturate(depth) * 255.0;
    let y: f32 = (x - floor(x)) * 255.0;
    let z: f32 = (y - floor(y)) * 255.0;
    let w: f32 = (z - floor(z)) * 255.0;
    return vec4f(floor(x), floor(y), floor(z), floor(w));
}
` };

export const fetch_clamped = { language, name: "fetch_clamped", summary: "texel of a map, clamped to the nearest one inside",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [texel], text: `
// umbrage_fetch_clamped: texel of a map, or the nearest one inside for coordinates outside
fn umbrage_fetch_clamped(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return umbrage_texel(map, size, clamp(texel, vec2f(0.0, 0.0), size - 1.0));
}
` };

export const encode_rg9_table = { language, name: "encode_rg9_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg9_table: two channels of a 9-bit depth code through a lookup table, integers 0..255
//   table   512 x 1 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg9_table(table: texture_2d<f32>, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 512.0), 511.0);
    let row: f32 = floor(x * (1.0 / 512.0));
    let texel: vec2f = vec2f(x - row * 512.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(512.0, 1.0), texel));
    return vec2f(k.x, k.y);
}
` };

export const encode_rg10_table = { language, name: "encode_rg10_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg10_table: two channels of a 10-bit depth code through a lookup table, integers 0..255
//   table   1024 x 1 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg10_table(table: texture_2d<f32>, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 1024.0), 1023.0);
    let row: f32 = floor(x * (1.0 / 1024.0));
    let texel: vec2f = vec2f(x - row * 1024.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(1024.0, 1.0), texel));
    return vec2f(k.x, k.y);
}
` };

export const encode_rg11_table = { language, name: "encode_rg11_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg11_table: two channels of a 11-bit depth code through a lookup table, integers 0..255
//   table   2048 x 1 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg11_table(table: texture_2d<f32>, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    let row: f32 = floor(x * (1.0 / 2048.0));
    let texel: vec2f = vec2f(x - row * 2048.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(2048.0, 1.0), texel));
    return vec2f(k.x, k.y);
}
` };

export const encode_rg12_table = { language, name: "encode_rg12_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg12_table: two channels of a 12-bit depth code through a lookup table, integers 0..255
//   table   2048 x 2 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg12_table(table: texture_2d<f32>, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 4096.0), 4095.0);
    let row: f32 = floor(x * (1.0 / 2048.0));
    let texel: vec2f = vec2f(x - row * 2048.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(2048.0, 2.0), texel));
    return vec2f(k.x, k.y);
}
` };

export const encode_rg13_table = { language, name: "encode_rg13_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg13_table: two channels of a 13-bit depth code through a lookup table, integers 0..255
//   table   2048 x 4 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg13_table(table: texture_2d<f32>, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    let row: f32 = floor(x * (1.0 / 2048.0));
    let texel: vec2f = vec2f(x - row * 2048.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(2048.0, 4.0), texel));
    return vec2f(k.x, k.y);
}
` };

export const encode_rg14_table = { language, name: "encode_rg14_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg14_table: two channels of a 14-bit depth code through a lookup table, integers 0..255
//   table   2048 x 8 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg14_table(table: texture_2d<f32>, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    let row: f32 = floor(x * (1.0 / 2048.0));
    let texel: vec2f = vec2f(x - row * 2048.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(2048.0, 8.0), texel));
    return vec2f(k.x, k.y);
}
` };

export const encode_rg15_table = { language, name: "encode_rg15_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg15_table: two channels of a 15-bit depth code through a lookup table, integers 0..255
//   table   2048 x 16 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg15_table(table: texture_2d<f32>, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    let row: f32 = floor(x * (1.0 / 2048.0));
    let texel: vec2f = vec2f(x - row * 2048.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(2048.0, 16.0), texel));
    return vec2f(k.x, k.y);
}
` };

export const encode_rg16_table = { language, name: "encode_rg16_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg16_table: two channels of a 16-bit depth code through a lookup table, integers 0..255
//   table   2048 x 32 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg16_table(table: texture_2d<f32>, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    let row: f32 = floor(x * (1.0 / 2048.0));
    let texel: vec2f = vec2f(x - row * 2048.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(2048.0, 32.0), texel));
    return vec2f(k.x, k.y);
}
` };

export const decode_rg9 = { language, name: "decode_rg9", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg9: depth from the two channels of a 9-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
fn umbrage_decode_rg9(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 2.0 + edge) * (1.0 / 512.0);
}
` };

export const decode_rg10 = { language, name: "decode_rg10", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg10: depth from the two channels of a 10-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
fn umbrage_decode_rg10(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 4.0 + edge) * (1.0 / 1024.0);
}
` };

export const decode_rg11 = { language, name: "decode_rg11", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg11: depth from the two channels of a 11-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
fn umbrage_decode_rg11(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 8.0 + edge) * (1.0 / 2048.0);
}
` };

export const decode_rg12 = { language, name: "decode_rg12", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg12: depth from the two channels of a 12-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
fn umbrage_decode_rg12(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 16.0 + edge) * (1.0 / 4096.0);
}
` };

export const decode_rg13 = { language, name: "decode_rg13", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg13: depth from the two channels of a 13-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
fn umbrage_decode_rg13(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 32.0 + edge) * (1.0 / 8192.0);
}
` };

export const decode_rg14 = { language, name: "decode_rg14", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg14: depth from the two channels of a 14-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
fn umbrage_decode_rg14(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 64.0 + edge) * (1.0 / 16384.0);
}
` };

export const decode_rg15 = { language, name: "decode_rg15", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg15: depth from the two channels of a 15-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
fn umbrage_decode_rg15(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 128.0 + edge) * (1.0 / 32768.0);
}
` };

export const decode_rg16 = { language, name: "decode_rg16", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg16: depth from the two channels of a 16-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
fn umbrage_decode_rg16(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 256.0 + edge) * (1.0 / 65536.0);
}
` };

export const decode_rgb24 = { language, name: "decode_rgb24", summary: "three 8-bit channels, R most significant, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rgb24: depth from three channels, as sampled
//   edge   0.0 or 1.0: lower or upper edge of the quantization step
fn umbrage_decode_rgb24(c: vec3f, edge: f32) -> f32 {
    let k: vec3f = umbrage_from_unorm_vec3f(c);
    return ((k.x * 256.0 + k.y) * 256.0 + k.z + edge) * (1.0 / 16777216.0);
}
` };

export const decode_rgb10 = { language, name: "decode_rgb10", summary: "three 10-bit channels, R most significant, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm10], text: `
// umbrage_decode_rgb10: depth from three 10-bit channels, as sampled
//   edge   0.0 or 1.0: lower or upper edge of the quantization step
fn umbrage_decode_rgb10(c: vec3f, edge: f32) -> f32 {
    let k: vec3f = umbrage_from_unorm10_vec3f(c);
    return ((k.x * 1024.0 + k.y) * 16.0 + floor(k.z * (1.0 / 64.0)) + edge) * (1.0 / 16777216.0);
}
` };

export const decode_r16 = { language, name: "decode_r16", summary: "one 16-bit channel to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm16], text: `
// umbrage_decode_r16: depth from one 16-bit channel, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
fn umbrage_decode_r16(c: f32, edge: f32) -> f32 {
    return (umbrage_from_unorm16(c) + edge) * (1.0 / 65536.0);
}
` };

export const decode_float_bits = { language, name: "decode_float_bits", summary: "four channels, R least significant, to the float they hold",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "300 es", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_decode_float_bits: float from the four channels of its bit pattern, as sampled, R least significant
fn umbrage_decode_float_bits(c: vec4f) -> f32 {
    let r: u32 = u32(umbrage_saturate(c.x) * 255.0 + 0.5);
    let g: u32 = u32(umbrage_saturate(c.y) * 255.0 + 0.5);
    let b: u32 = u32(umbrage_saturate(c.z) * 255.0 + 0.5);
    let a: u32 = u32(umbrage_saturate(c.w) * 255.0 + 0.5);
    return bitcast<f32>(r | (g << 8) | (b << 16) | (a << 24));
}
` };

export const decode_threejs_rgba = { language, name: "decode_threejs_rgba", summary: "three.js RGBA, r167 and later, to depth",
    exactness: "b", operations: 7, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_decode_threejs_rgba: depth from the RGBA format of three.js r167 and later, as sampled
fn umbrage_decode_threejs_rgba(c: vec4f) -> f32 {
    let depth: f32 = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (255.0 / 16777216.0) + c.w *
        (1.0 / 16777216.0);
    return depth;
}
` };

export const decode_threejs_rgb = { language, name: "decode_threejs_rgb", summary: "three.js RGB, r167 and later, to depth",
    exactness: "b", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_decode_threejs_rgb: depth from the RGB format of three.js r167 and later, as sampled
fn umbrage_decode_threejs_rgb(c: vec3f) -> f32 {
    let depth: f32 = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (1.0 / 65536.0);
    return depth;
}
` };

export const decode_threejs_rg = { language, name: "decode_threejs_rg", summary: "three.js RG, r167 and later, to depth",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_decode_threejs_rg: depth from the RG format of three.js r167 and later, as sampled
fn umbrage_decode_threejs_rg(c: vec2f) -> f32 {
    let depth: f32 = c.x * (255.0 / 256.0) + c.y * (1.0 / 256.0);
    return depth;
}
` };

export const decode_threejs_legacy = { language, name: "decode_threejs_legacy", summary: "three.js RGBA, r73 to r166, to depth",
    exactness: "b", operations: 7, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_decode_threejs_legacy: depth from the RGBA format of three.js r73 to r166, as sampled
fn umbrage_decode_threejs_legacy(c: vec4f) -> f32 {
    let depth: f32 = c.x * (255.0 / 4294967296.0) + c.y * (255.0 / 16777216.0) + c.z * (255.0 / 65536.0) + c.w *
        (255.0 / 256.0);
    return depth;
}
` };

export const decode_base255 = { language, name: "decode_base255", summary: "base-255 RGBA to depth",
    exactness: "b", operations: 6, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_decode_base255: depth from base-255 RGBA, as sampled
fn umbrage_decode_base255(c: vec4f) -> f32 {
    let depth: f32 = c.x + c.y * 0.00392156886 + c.z * 0.0000153787005 + c.w * 0.0000000603086294;
    return depth;
}
` };

export const level_rg9 = { language, name: "level_rg9", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg9: level of a texel from two channels of a 9-bit code, on the scale of umbrage_receiver_rg9
//   1.0 is not the far plane on this scale
fn umbrage_level_rg9(c: vec2f) -> f32 {
    return c.x + c.y * 2.0;  // an exact product: fused or not, it rounds once
}
` };

export const level_rg10 = { language, name: "level_rg10", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg10: level of a texel from two channels of a 10-bit code, on the scale of umbrage_receiver_rg10
//   1.0 is not the far plane on this scale
fn umbrage_level_rg10(c: vec2f) -> f32 {
    return c.x + c.y * 4.0;  // an exact product: fused or not, it rounds once
}
` };

export const level_rg11 = { language, name: "level_rg11", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg11: level of a texel from two channels of a 11-bit code, on the scale of umbrage_receiver_rg11
//   1.0 is not the far plane on this scale
fn umbrage_level_rg11(c: vec2f) -> f32 {
    return c.x + c.y * 8.0;  // an exact product: fused or not, it rounds once
}
` };

export const level_rg12 = { language, name: "level_rg12", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg12: level of a texel from two channels of a 12-bit code, on the scale of umbrage_receiver_rg12
//   1.0 is not the far plane on this scale
fn umbrage_level_rg12(c: vec2f) -> f32 {
    return c.x + c.y * 16.0;  // an exact product: fused or not, it rounds once
}
` };

export const level_rg13 = { language, name: "level_rg13", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg13: level of a texel from two channels of a 13-bit code, on the scale of umbrage_receiver_rg13
//   1.0 is not the far plane on this scale
fn umbrage_level_rg13(c: vec2f) -> f32 {
    return c.x + c.y * 32.0;  // an exact product: fused or not, it rounds once
}
` };

export const level_rg14 = { language, name: "level_rg14", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg14: level of a texel from two channels of a 14-bit code, on the scale of umbrage_receiver_rg14
//   1.0 is not the far plane on this scale
fn umbrage_level_rg14(c: vec2f) -> f32 {
    return c.x + c.y * 64.0;  // an exact product: fused or not, it rounds once
}
` };

export const level_rg15 = { language, name: "level_rg15", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg15: level of a texel from two channels of a 15-bit code, on the scale of umbrage_receiver_rg15
//   1.0 is not the far plane on this scale
fn umbrage_level_rg15(c: vec2f) -> f32 {
    return c.x + c.y * 128.0;  // an exact product: fused or not, it rounds once
}
` };

export const level_rg16 = { language, name: "level_rg16", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg16: level of a texel from two channels of a 16-bit code, on the scale of umbrage_receiver_rg16
//   1.0 is not the far plane on this scale
fn umbrage_level_rg16(c: vec2f) -> f32 {
    return c.x + c.y * 256.0;  // an exact product: fused or not, it rounds once
}
` };

export const receiver_rg9 = { language, name: "receiver_rg9", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg9: receiver depth on the scale of umbrage_level_rg9. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg9(texel, edge), or beyond the far plane
fn umbrage_receiver_rg9(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 512.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
` };

export const receiver_rg10 = { language, name: "receiver_rg10", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg10: receiver depth on the scale of umbrage_level_rg10. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg10(texel, edge), or beyond the far plane
fn umbrage_receiver_rg10(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 1024.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
` };

export const receiver_rg11 = { language, name: "receiver_rg11", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg11: receiver depth on the scale of umbrage_level_rg11. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg11(texel, edge), or beyond the far plane
fn umbrage_receiver_rg11(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 2048.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
` };

export const receiver_rg12 = { language, name: "receiver_rg12", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg12: receiver depth on the scale of umbrage_level_rg12. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg12(texel, edge), or beyond the far plane
fn umbrage_receiver_rg12(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 4096.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
` };

export const receiver_rg13 = { language, name: "receiver_rg13", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg13: receiver depth on the scale of umbrage_level_rg13. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg13(texel, edge), or beyond the far plane
fn umbrage_receiver_rg13(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 8192.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
` };

export const receiver_rg14 = { language, name: "receiver_rg14", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg14: receiver depth on the scale of umbrage_level_rg14. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg14(texel, edge), or beyond the far plane
fn umbrage_receiver_rg14(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 16384.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
` };

export const receiver_rg15 = { language, name: "receiver_rg15", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg15: receiver depth on the scale of umbrage_level_rg15. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg15(texel, edge), or beyond the far plane
fn umbrage_receiver_rg15(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 32768.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
` };

export const receiver_rg16 = { language, name: "receiver_rg16", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg16: receiver depth on the scale of umbrage_level_rg16. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg16(texel, edge), or beyond the far plane
fn umbrage_receiver_rg16(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 65536.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
` };

export const decode_ps14 = { language, name: "decode_ps14", summary: "r / 8 + g as the Radeon 8500 computed it",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_decode_ps14: x / 2040 from the channels of an 11-bit code, as sampled. Compare with umbrage_receiver_ps14
//   1.0 is not the far plane on this scale
fn umbrage_decode_ps14(c: vec2f) -> f32 {
    return c.x * 0.125 + c.y;  // an exact product: fused or not, it rounds once
}
` };

export const receiver_ps14 = { language, name: "receiver_ps14", summary: "receiver depth on the scale of decode_ps14",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_ps14: depth * 256 / 255, the scale of umbrage_decode_ps14. Beyond the far plane every texel lights
// it
fn umbrage_receiver_ps14(depth: f32) -> f32 {
    return select(depth * 1.00392163, -1.0, depth > 1.0);
}
` };

export const fixed_ps14 = { language, name: "fixed_ps14", summary: "number in a register of the Radeon 8500",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_fixed_ps14: nearest multiple of 1 / 4096 from -8.0 to 8.0 - 1 / 4096; NaN becomes the last of them
fn umbrage_fixed_ps14(v: f32) -> f32 {
    // not v < 8.0 ? v : ...: Mesa turns it into min, and softpipe's min gives NaN
    let within: f32 = select(select(7.999755859375, -8.0, v < 0.0), v, v > -8.0 && v < 7.999755859375);
    let steps: f32 = within * 4096.0;
    let below: f32 = floor(steps);
    return select(below + 1.0, below, steps - below < 0.5) * 0.000244140625;
}
` };

export const decode_fixed_ps14 = { language, name: "decode_fixed_ps14", summary: "r / 8 + g in the Radeon 8500's fixed point",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [fixed_ps14], text: `
// umbrage_decode_fixed_ps14: x / 2040 in steps of 1 / 4096 from the channels of an 11-bit code, as sampled
//   compare with umbrage_fixed_ps14(umbrage_receiver_ps14(depth)); 1.0 is not the far plane on this scale
fn umbrage_decode_fixed_ps14(c: vec2f) -> f32 {
    return floor(umbrage_fixed_ps14(c.x) * 512.0) * 0.000244140625 + umbrage_fixed_ps14(c.y);
}
` };

export const inside_map = { language, name: "inside_map", summary: "true if a texel lies inside the map",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_inside_map: true if a texel lies inside a map of size texels
fn umbrage_inside_map(size: vec2f, texel: vec2f) -> bool {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}
` };

export const texel_inside = { language, name: "texel_inside", summary: "texel of the map, itself if the map has it",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "texel_inside", scaled: false,
    needs: [], text: `
// umbrage_texel_inside: texel of the map, itself if the map has it; otherwise any, whose value does not count
fn umbrage_texel_inside(size: vec2f, texel: vec2f) -> vec2f {
    return min(abs(texel), size - 1.0);
}
` };

export const fetch_bordered = { language, name: "fetch_bordered", summary: "texel of a map, or a border value outside it",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [texel, texel_inside], text: `
// umbrage_fetch_bordered: texel of a map, or border outside it
fn umbrage_fetch_bordered(map: texture_2d<f32>, size: vec2f, texel: vec2f, border: vec4f) -> vec4f {
    let at: vec2f = umbrage_texel_inside(size, texel);
    let value: vec4f = umbrage_texel(map, size, at);
    return select(border, value, at.x == texel.x && at.y == texel.y);
}
` };

export const fetch_depth = { language, name: "fetch_depth", summary: "stored depth of a texel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "fetch_depth", scaled: false,
    needs: [texel, texel_inside], text: `
// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
fn umbrage_fetch_depth(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> f32 {
    let inside: vec2f = umbrage_texel_inside(size, texel);
    let value: vec4f = umbrage_texel(map, size, inside);
    let depth: f32 = value.x;
    return select(1.0, depth, inside.x == texel.x && inside.y == texel.y);
}
` };

export const depth_at = { language, name: "depth_at", summary: "stored depth at a point of the map",
    exactness: "c", operations: 4, within: 0, as_written: false, lowest: "100", role: "depth_at", scaled: false,
    needs: [fetch_depth], text: `
// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the neighbor's
//   uv  point on the map, (0.0, 0.0) to (1.0, 1.0), no NaN
fn umbrage_depth_at(map: texture_2d<f32>, size: vec2f, uv: vec2f) -> f32 {
    return umbrage_fetch_depth(map, size, floor(uv * size));
}
` };

export const beyond_far_plane = { language, name: "beyond_far_plane", summary: "receivers beyond the far plane",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "beyond_far_plane", scaled: false,
    needs: [], text: `
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
fn umbrage_beyond_far_plane(receiver: f32) -> bool {
    return receiver > 1.0;
}
` };

export const in_filter_domain = { language, name: "in_filter_domain", summary: "true for receivers that a filter compares; others are lit",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [inside_texel_space, beyond_far_plane], text: `
// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
fn umbrage_in_filter_domain(coord: vec2f, receiver: f32) -> bool {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return select(umbrage_inside_texel_space(coord), false, umbrage_beyond_far_plane(receiver));
}
` };

export const compare = { language, name: "compare", summary: "visibility from one comparison",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "compare", scaled: false,
    needs: [], text: `
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
fn umbrage_compare(receiver: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, receiver <= stored);
}
` };

export const lit = { language, name: "lit", summary: "visibility from one comparison with a texel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "lit", scaled: false,
    needs: [compare, fetch_depth], text: `
// umbrage_lit: visibility from one comparison with a texel
fn umbrage_lit(map: texture_2d<f32>, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
` };

export const lit_2x2 = { language, name: "lit_2x2", summary: "visibility from comparisons with 2x2 texels",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "lit_2x2", scaled: false,
    needs: [lit], text: `
// umbrage_lit_2x2: visibility from the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
fn umbrage_lit_2x2(map: texture_2d<f32>, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let a: f32 = umbrage_lit(map, size, texel, receiver);
    let b: f32 = umbrage_lit(map, size, texel + vec2f(1.0, 0.0), receiver);
    let c: f32 = umbrage_lit(map, size, texel + vec2f(0.0, 1.0), receiver);
    let d: f32 = umbrage_lit(map, size, texel + vec2f(1.0, 1.0), receiver);
    return vec4f(a, b, c, d);
}
` };

export const map_covers = { language, name: "map_covers", summary: "true if a receiver lies in a prefiltered map",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "map_covers", scaled: false,
    needs: [], text: `
// umbrage_map_covers: true if a receiver lies in a prefiltered map or a table; elsewhere it is lit
fn umbrage_map_covers(size: vec2f, coord: vec2f) -> bool {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
` };

export const within_far_plane = { language, name: "within_far_plane", summary: "receivers up to the far plane; NaN is not",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "within_far_plane", scaled: false,
    needs: [], text: `
// umbrage_within_far_plane: true if a receiver is a number and not beyond the far plane
fn umbrage_within_far_plane(receiver: f32) -> bool {
    return receiver <= 1.0;
}
` };

export const compare_dx_sdk = { language, name: "compare_dx_sdk", summary: "shadow if stored + epsilon < receiver",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
fn umbrage_compare_dx_sdk(receiver: f32, stored: f32, epsilon: f32) -> f32 {
    let limit: f32 = stored + epsilon;
    return select(1.0, 0.0, limit < receiver);
}
` };

export const compare_exercise = { language, name: "compare_exercise", summary: "lit if current < stored + epsilon",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
fn umbrage_compare_exercise(current: f32, stored: f32, epsilon: f32) -> f32 {
    let limit: f32 = stored + epsilon;
    return select(0.0, 1.0, current < limit);
}
` };

export const window_sum3 = { language, name: "window_sum3", summary: "weighted count of lit texels under a 3x3 kernel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, lit_2x2], text: `
// umbrage_window_sum3: weighted count of the lit texels under a kernel that slides over the map, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   steps       per texel, a power of two up to 256
//   k0 .. k1    weights from the edge to the middle one. The others mirror them
// Steps times the sum of all weights must be an integer up to 4096. Its square is the count when all is lit
fn umbrage_window_sum3(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, steps: f32, k0: f32,
                       k1: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0) - 128.0, compared);
    let texel: vec2f = floor(x * (1.0 / 256.0));
    let s: vec2f = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    let r: vec2f = steps - s;
    let whole: f32 = steps * (k0 + k1 + k0);
    let w0: vec2f = floor(r * k0);
    let w2: vec2f = floor(r * k0 + s * k1);
    let w3: vec2f = floor(s * k0);
    let w1: vec2f = max(whole - (w0 + w2 + w3), vec2f(0.0, 0.0));
    let first: vec2f = texel - 1.0;
    var n: f32 = 0.0;
    var a: vec4f = umbrage_lit_2x2(map, size, first + vec2f(0.0, 0.0), receiver);
    var b: vec4f = umbrage_lit_2x2(map, size, first + vec2f(2.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    a = umbrage_lit_2x2(map, size, first + vec2f(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2f(2.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    return select(whole * whole, n, compared);
}
` };

export const window_sum5 = { language, name: "window_sum5", summary: "weighted count of lit texels under a 5x5 kernel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, lit_2x2], text: `
// umbrage_window_sum5: weighted count of the lit texels under a kernel that slides over the map, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   steps       per texel, a power of two up to 256
//   k0 .. k2    weights from the edge to the middle one. The others mirror them
// Steps times the sum of all weights must be an integer up to 4096. Its square is the count when all is lit
fn umbrage_window_sum5(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, steps: f32, k0: f32, k1: f32,
                       k2: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0) - 128.0, compared);
    let texel: vec2f = floor(x * (1.0 / 256.0));
    let s: vec2f = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    let r: vec2f = steps - s;
    let whole: f32 = steps * (k0 + k1 + k2 + k1 + k0);
    let w0: vec2f = floor(r * k0);
    let w1: vec2f = floor(r * k1 + s * k0);
    let w3: vec2f = floor(r * k1 + s * k2);
    let w4: vec2f = floor(r * k0 + s * k1);
    let w5: vec2f = floor(s * k0);
    let w2: vec2f = max(whole - (w0 + w1 + w3 + w4 + w5), vec2f(0.0, 0.0));
    let first: vec2f = texel - 2.0;
    var n: f32 = 0.0;
    var a: vec4f = umbrage_lit_2x2(map, size, first + vec2f(0.0, 0.0), receiver);
    var b: vec4f = umbrage_lit_2x2(map, size, first + vec2f(2.0, 0.0), receiver);
    var c: vec4f = umbrage_lit_2x2(map, size, first + vec2f(4.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + vec2f(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2f(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2f(4.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + vec2f(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2f(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2f(4.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    return select(whole * whole, n, compared);
}
` };

export const window_sum7 = { language, name: "window_sum7", summary: "weighted count of lit texels under a 7x7 kernel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, lit_2x2], text: `
// umbrage_window_sum7: weighted count of the lit texels under a kernel that slides over the map, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   steps       per texel, a power of two up to 256
//   k0 .. k3    weights from the edge to the middle one. The others mirror them
// Steps times the sum of all weights must be an integer up to 4096. Its square is the count when all is lit
fn umbrage_window_sum7(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, steps: f32, k0: f32, k1: f32,
                       k2: f32, k3: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0) - 128.0, compared);
    let texel: vec2f = floor(x * (1.0 / 256.0));
    let s: vec2f = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    let r: vec2f = steps - s;
    let whole: f32 = steps * (k0 + k1 + k2 + k3 + k2 + k1 + k0);
    let w0: vec2f = floor(r * k0);
    let w1: vec2f = floor(r * k1 + s * k0);
    let w2: vec2f = floor(r * k2 + s * k1);
    let w4: vec2f = floor(r * k2 + s * k3);
    let w5: vec2f = floor(r * k1 + s * k2);
    let w6: vec2f = floor(r * k0 + s * k1);
    let w7: vec2f = floor(s * k0);
    let w3: vec2f = max(whole - (w0 + w1 + w2 + w4 + w5 + w6 + w7), vec2f(0.0, 0.0));
    let first: vec2f = texel - 3.0;
    var n: f32 = 0.0;
    var a: vec4f = umbrage_lit_2x2(map, size, first + vec2f(0.0, 0.0), receiver);
    var b: vec4f = umbrage_lit_2x2(map, size, first + vec2f(2.0, 0.0), receiver);
    var c: vec4f = umbrage_lit_2x2(map, size, first + vec2f(4.0, 0.0), receiver);
    var d: vec4f = umbrage_lit_2x2(map, size, first + vec2f(6.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + vec2f(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2f(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2f(4.0, 2.0), receiver);
    d = umbrage_lit_2x2(map, size, first + vec2f(6.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + vec2f(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2f(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2f(4.0, 4.0), receiver);
    d = umbrage_lit_2x2(map, size, first + vec2f(6.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + vec2f(0.0, 6.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2f(2.0, 6.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2f(4.0, 6.0), receiver);
    d = umbrage_lit_2x2(map, size, first + vec2f(6.0, 6.0), receiver);
    n += w6.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w7.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    return select(whole * whole, n, compared);
}
` };

export const disc_rotation = { language, name: "disc_rotation", summary: "rotation of a disc for a pixel, one of 16",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [inside_texel_space], text: `
// umbrage_disc_rotation: rotation of a disc for a pixel. Returns (cos, -sin, sin, cos) in 1/64
//   pixel   gl_FragCoord.xy, for example. Each of the 16 rotations is used once in every 4 x 4 pixels
fn umbrage_disc_rotation(pixel: vec2f) -> vec4f {
    let whole: vec2f = select(vec2f(0.0, 0.0), floor(pixel), umbrage_inside_texel_space(pixel));
    var v: f32 = whole.x * 4.0 + whole.y;
    v = v - floor(v * (1.0 / 16.0)) * 16.0;
    let quarter: f32 = floor(v * 0.25);
    let base: f32 = v - quarter * 4.0;
    let low: vec2f = select(vec2f(59.0, 24.0), vec2f(64.0, 0.0), base < 0.5);
    let high: vec2f = select(vec2f(24.0, 59.0), vec2f(45.0, 45.0), base < 2.5);
    let first: vec2f = select(high, low, base < 1.5);
    let once: vec2f = select(vec2f(0.0 - first.y, first.x), first, quarter < 0.5);
    let twice: vec2f = select(vec2f(first.y, 0.0 - first.x), vec2f(0.0 - first.x, 0.0 - first.y), quarter < 2.5);
    let turned: vec2f = select(twice, once, quarter < 1.5);
    return vec4f(turned.x, 0.0 - turned.y, turned.y, turned.x);
}
` };

export const sheared_rotation = { language, name: "sheared_rotation", summary: "rotation of a disc, sheared to an ellipse",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_sheared_rotation: rotation of a disc, and then a shear along x
//   rotation   from umbrage_disc_rotation
//   shear      by how much x grows with y, both in radii of the ellipse; -2.0 to 2.0
fn umbrage_sheared_rotation(rotation: vec4f, shear: f32) -> vec4f {
    let x: f32 = rotation.x + shear * rotation.z;
    let y: f32 = rotation.y + shear * rotation.w;
    return vec4f(x, y, rotation.z, rotation.w);
}
` };

export const disc_tap = { language, name: "disc_tap", summary: "texel that a point of a disc falls on",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_disc_tap: texel that a point of a disc falls on
//   position   floor(256 coord) of the receiver
//   p          point, in 1/16 of the radius
//   rotation   from umbrage_disc_rotation
//   radius     along x and y, in 1/16 texel, integers from 0 to 4095
fn umbrage_disc_tap(position: vec2f, p: vec2f, rotation: vec4f, radius: vec2f) -> vec2f {
    let at: vec2f = position * (1.0 / 256.0);
    let texel: vec2f = floor(at);
    let within: vec2f = clamp(at - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0));  // no sum is regrouped across it
    let wide: vec2f = vec2f(rotation.x, rotation.y) * (radius.x * (1.0 / 16384.0));
    let high: vec2f = vec2f(rotation.z, rotation.w) * (radius.y * (1.0 / 16384.0));
    let x: f32 = wide.x * p.x + within.x + wide.y * p.y;
    let y: f32 = high.x * p.x + within.y + high.y * p.y;
    return texel + floor(vec2f(x, y));
}
` };

export const disc_radius = { language, name: "disc_radius", summary: "radius of a disc, rounded down to 1/16 texel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_disc_radius: radius of a disc in 1/16 texel, from one in texels
// Returns an integer from 0 to 4095, and 0 for NaN
fn umbrage_disc_radius(radius: f32) -> f32 {
    let inside: f32 = select(0.0, floor(radius * 16.0), radius > 0.0);
    return select(inside, 4095.0, radius >= 255.9375);
}
` };

export const ellipse8 = { language, name: "ellipse8", summary: "PCF over an ellipse, 8 points, rotated per pixel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, disc_tap, lit], text: `
// umbrage_ellipse8: PCF over a rotated ellipse of 8 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_ellipse8(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: vec2f,
                    rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);  // no branch: fetches overlap
    var n: f32 = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(3.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-4.0, 5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(1.0, -11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-12.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(11.0, 6.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, 13.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(11.0, -7.0), rotation, radius), receiver);
    return select(1.0, n * (1.0 / 8.0), compared);
}
` };

export const ellipse16 = { language, name: "ellipse16", summary: "PCF over an ellipse, 16 points, rotated per pixel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, disc_tap, lit], text: `
// umbrage_ellipse16: PCF over a rotated ellipse of 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_ellipse16(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: vec2f,
                     rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);  // no branch: fetches overlap
    var n: f32 = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, 7.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(8.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(11.0, 5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-12.0, 4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-9.0, 10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-13.0, -4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(7.0, -12.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-7.0, -12.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(14.0, -2.0), rotation, radius), receiver);
    return select(1.0, n * (1.0 / 16.0), compared);
}
` };

export const ellipse32 = { language, name: "ellipse32", summary: "PCF over an ellipse, 32 points, rotated per pixel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, disc_tap, lit], text: `
// umbrage_ellipse32: PCF over a rotated ellipse of 32 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_ellipse32(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: vec2f,
                     rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);  // no branch: fetches overlap
    var n: f32 = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-2.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(3.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(1.0, -4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-4.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, 6.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-5.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(7.0, -2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-8.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(8.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(5.0, 7.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(1.0, -9.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(6.0, -7.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-8.0, 5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, 10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-3.0, -10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-6.0, 10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(11.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(5.0, -12.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-13.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(13.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-13.0, 4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(10.0, -10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(14.0, -2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-11.0, 9.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(3.0, 14.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-13.0, -6.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(12.0, 8.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-4.0, 14.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-7.0, -13.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, -15.0), rotation, radius), receiver);
    return select(1.0, n * (1.0 / 32.0), compared);
}
` };

export const disc8 = { language, name: "disc8", summary: "disc PCF, 8 points, rotated per pixel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [disc_radius, ellipse8], filter: { reads: "comparisons", reach: 2.1328125, arguments: [{ name: "radius", type: "float", value: 2 }, { name: "rotation", type: "vec4", value: [64, 0, 0, 64] }], in_shadow: true, disc: true, linear: { name: "disc_hardware8", weights: "" } }, text: `
// umbrage_disc8: PCF over a rotated disc of 8 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_disc8(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32, rotation: vec4f) -> f32 {
    let rho: f32 = umbrage_disc_radius(radius);
    return umbrage_ellipse8(map, size, coord, receiver, vec2f(rho, rho), rotation);
}
` };

export const disc16 = { language, name: "disc16", summary: "disc PCF, 16 points, rotated per pixel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [disc_radius, ellipse16], filter: { reads: "comparisons", reach: 2.2578125, arguments: [{ name: "radius", type: "float", value: 2 }, { name: "rotation", type: "vec4", value: [64, 0, 0, 64] }], in_shadow: true, disc: true, linear: { name: "disc_hardware16", weights: "" } }, text: `
// umbrage_disc16: PCF over a rotated disc of 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_disc16(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32, rotation: vec4f) -> f32 {
    let rho: f32 = umbrage_disc_radius(radius);
    return umbrage_ellipse16(map, size, coord, receiver, vec2f(rho, rho), rotation);
}
` };

export const disc32 = { language, name: "disc32", summary: "disc PCF, 32 points, rotated per pixel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [disc_radius, ellipse32], filter: { reads: "comparisons", reach: 2.3828125, arguments: [{ name: "radius", type: "float", value: 2 }, { name: "rotation", type: "vec4", value: [64, 0, 0, 64] }], in_shadow: true, disc: true, linear: { name: "disc_hardware32", weights: "" } }, text: `
// umbrage_disc32: PCF over a rotated disc of 32 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_disc32(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32, rotation: vec4f) -> f32 {
    let rho: f32 = umbrage_disc_radius(radius);
    return umbrage_ellipse32(map, size, coord, receiver, vec2f(rho, rho), rotation);
}
` };

export const hard = { language, name: "hard", summary: "unfiltered shadow test of the nearest texel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, lit], filter: { reads: "comparisons", reach: 0.5, arguments: [], in_shadow: true }, text: `
// umbrage_hard: shadow test without a filter. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_hard(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let texel: vec2f = select(vec2f(0.0, 0.0), floor(coord), compared);  // no branch: fetches of several taps overlap
    let lit: f32 = umbrage_lit(map, size, texel, receiver);
    return select(1.0, lit, compared);
}
` };

export const four_tap = { language, name: "four_tap", summary: "mean of four taps, each with its own coordinates",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [lit, beyond_far_plane], filter: { reads: "comparisons", reach: 1, arguments: [], offsets: [[-0.5, -0.5], [0.5, -0.5], [-0.5, 0.5], [0.5, 0.5]] }, text: `
// umbrage_four_tap: mean of the shadow test at four taps. Returns visibility, 1.0 = lit
//   map, size    shadow map and its size in texels
//   a, b, c, d   taps in texels. All are lit where their mean magnitude is 2^15 or more along an axis
//   receiver     receiver depth in [0, 1], bias applied
fn umbrage_four_tap(map: texture_2d<f32>, size: vec2f, a: vec2f, b: vec2f, c: vec2f, d: vec2f, receiver: f32) -> f32 {
    let a_texel: vec2f = floor(a);
    let b_texel: vec2f = floor(b);
    let c_texel: vec2f = floor(c);
    let d_texel: vec2f = floor(d);
    let sum: vec2f = abs(a_texel) + abs(b_texel) + abs(c_texel) + abs(d_texel);
    // two different limits on purpose: Mesa turns a single one into max(x, y) < limit, which loses a NaN
    let compared: bool = select(sum.x < 131072.0 && sum.y * 2.0 < 262144.0, false, umbrage_beyond_far_plane(receiver));
    let count: f32 = umbrage_lit(map, size, a_texel, receiver) + umbrage_lit(map, size, b_texel, receiver) +
        umbrage_lit(map, size, c_texel, receiver) + umbrage_lit(map, size, d_texel, receiver);
    return select(1.0, count * 0.25, compared);
}
` };

export const pcf_2x2 = { language, name: "pcf_2x2", summary: "bilinear 2x2 PCF, weights in steps of 1/256",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, lit_2x2], filter: { reads: "comparisons", reach: 1, arguments: [], in_shadow: true, linear: { name: "pcf_2x2_hardware", weights: "" } }, text: `
// umbrage_pcf_2x2: bilinear 2x2 PCF. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_pcf_2x2(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0) - 128.0, compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    let hi: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    let lo: vec2f = 1.0 - hi;
    let lit: vec4f = umbrage_lit_2x2(map, size, texel, receiver);
    let visibility: f32 = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    return select(1.0, visibility, compared);
}
` };

export const pcf_2x2_dx_sdk = { language, name: "pcf_2x2_dx_sdk", summary: "bilinear 2x2 PCF of the DirectX SDK sample, plain floats",
    exactness: "b", operations: 20, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [compare_dx_sdk, in_filter_domain, fetch_depth], filter: { reads: "depths", reach: 1, arguments: [{ name: "epsilon", type: "float", value: 0 }] }, text: `
// umbrage_pcf_2x2_dx_sdk: 2x2 PCF of the DirectX SDK sample. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], no bias applied
//   epsilon     depth added to each stored depth
fn umbrage_pcf_2x2_dx_sdk(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, epsilon: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), coord - 0.5, compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x);
    let weight: vec2f = x - texel;
    let a: f32 = umbrage_compare_dx_sdk(receiver, umbrage_fetch_depth(map, size, texel), epsilon);
    let right: f32 = umbrage_fetch_depth(map, size, texel + vec2f(1.0, 0.0));
    let above: f32 = umbrage_fetch_depth(map, size, texel + vec2f(0.0, 1.0));
    let beyond: f32 = umbrage_fetch_depth(map, size, texel + vec2f(1.0, 1.0));
    let b: f32 = umbrage_compare_dx_sdk(receiver, right, epsilon);
    let c: f32 = umbrage_compare_dx_sdk(receiver, above, epsilon);
    let d: f32 = umbrage_compare_dx_sdk(receiver, beyond, epsilon);
    let low: f32 = a + weight.x * (b - a);
    let high: f32 = c + weight.x * (d - c);
    let visibility: f32 = low + weight.y * (high - low);
    return select(1.0, visibility, compared);
}
` };

export const box_count = { language, name: "box_count", summary: "number of lit texels in a box of radius 0..8",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, lit], text: `
// umbrage_box_count: number of lit texels in the (2r+1) x (2r+1) box around the receiver's texel, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      r, clamped to 0..8. Compilers unroll the loops if it is a constant
fn umbrage_box_count(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: i32) -> f32 {
    let r: i32 = select(select(8, radius, radius < 8), 0, radius < 0);
    let width: i32 = 2 * r + 1;
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let first: vec2f = select(vec2f(0.0, 0.0), floor(coord) - f32(r), compared);
    var count: f32 = 0.0;
    for (var j: i32 = 0; j < 17; j++) {
        if (j >= width) { break; }
        for (var i: i32 = 0; i < 17; i++) {
            if (i >= width) { break; }
            count += umbrage_lit(map, size, first + vec2f(f32(i), f32(j)), receiver);
        }
    }
    return select(f32(width * width), count, compared);
}
` };

export const box_scale = { language, name: "box_scale", summary: "1 / (2r+1)^2",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_box_scale: 1 / (2r+1)^2, rounded to nearest
fn umbrage_box_scale(radius: i32) -> f32 {
    var scale: f32 = 0.00346020772;  // not returned as a literal: that would have the host's precision
    if (radius < 8) { scale = 0.00444444455; }
    if (radius < 7) { scale = 0.00591715984; }
    if (radius < 6) { scale = 0.00826446246; }
    if (radius < 5) { scale = 0.0123456791; }
    if (radius < 4) { scale = 0.0204081628; }
    if (radius < 3) { scale = 0.0399999991; }
    if (radius < 2) { scale = 0.111111112; }
    if (radius < 1) { scale = 1.0; }
    return scale;
}
` };

export const box = { language, name: "box", summary: "lit fraction of a box of radius 0..8 (box PCF)",
    exactness: "b", operations: 290, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [box_count, box_scale], filter: { reads: "comparisons", reach: 1.5, arguments: [{ name: "radius", type: "int", value: 1 }], in_shadow: true }, text: `
// umbrage_box: box PCF, the lit fraction of a (2r+1) x (2r+1) box. Returns visibility, 1.0 = lit
//   parameters as for umbrage_box_count
fn umbrage_box(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: i32) -> f32 {
    let visibility: f32 = umbrage_box_count(map, size, coord, receiver, radius) * umbrage_box_scale(radius);
    return select(1.0, visibility, visibility < 0.999);  // 121 times the rounded 1/121 is not 1
}
` };

export const tent2 = { language, name: "tent2", summary: "PCF kernel 1 1",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, lit_2x2], filter: { reads: "comparisons", reach: 1.5, arguments: [], in_shadow: true }, text: `
// umbrage_tent2: PCF over 3 x 3 texels, weights 1 1. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_tent2(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative. clamp and max keep compilers from regrouping sums across them
    let s: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0)) * 256.0;
    let r: vec2f = 256.0 - s;
    let w0: vec2f = r * 8.0;
    let w2: vec2f = s * 8.0;
    let w1: vec2f = max(4096.0 - w0 - w2, vec2f(0.0, 0.0));
    let a: vec4f = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    let b: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(1.0, -1.0), receiver);
    let c: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(-1.0, 1.0), receiver);
    let d: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(1.0, 1.0), receiver);
    var n: f32 = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return select(1.0, n * (1.0 / 16777216.0), compared);
}
` };

export const tent3 = { language, name: "tent3", summary: "PCF kernel 1 2 1",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [window_sum3], filter: { reads: "comparisons", reach: 2, arguments: [], in_shadow: true, linear: { name: "window_hardware3", weights: ", 4.0, 8.0" } }, text: `
// umbrage_tent3: PCF under 3 x 3 weights, 1 2 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_tent3(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum3(map, size, coord, receiver, 256.0, 4.0, 8.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
` };

export const quadratic_b_spline = { language, name: "quadratic_b_spline", summary: "PCF kernel of the quadratic B-spline, 3x3 texels",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, lit_2x2], filter: { reads: "comparisons", reach: 1.5, arguments: [], in_shadow: true }, text: `
// umbrage_quadratic_b_spline: PCF over 3 x 3 texels, weighted by the quadratic B-spline. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_quadratic_b_spline(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative. clamp and max keep compilers from regrouping sums across them
    let s: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0)) * 256.0;
    let r: vec2f = 256.0 - s;
    let w0: vec2f = floor(r * r * (1.0 / 32.0));
    let w2: vec2f = floor(s * s * (1.0 / 32.0));
    let w1: vec2f = max(4096.0 - w0 - w2, vec2f(0.0, 0.0));
    let a: vec4f = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    let b: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(1.0, -1.0), receiver);
    let c: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(-1.0, 1.0), receiver);
    let d: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(1.0, 1.0), receiver);
    var n: f32 = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return select(1.0, n * (1.0 / 16777216.0), compared);
}
` };

export const binomial5 = { language, name: "binomial5", summary: "PCF kernel 1 4 6 4 1",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [window_sum5], filter: { reads: "comparisons", reach: 3, arguments: [], in_shadow: true, linear: { name: "window_hardware5", weights: ", 1.0, 4.0, 6.0" } }, text: `
// umbrage_binomial5: PCF under 5 x 5 weights, 1 4 6 4 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_binomial5(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 4.0, 6.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
` };

export const castano_dyadic5 = { language, name: "castano_dyadic5", summary: "PCF kernel 5 16 22 16 5",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [window_sum5], filter: { reads: "comparisons", reach: 3, arguments: [], in_shadow: true, linear: { name: "window_hardware5", weights: ", 1.25, 4.0, 5.5" } }, text: `
// umbrage_castano_dyadic5: PCF under 5 x 5 weights, 5 16 22 16 5, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_castano_dyadic5(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.25, 4.0, 5.5);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
` };

export const castano5 = { language, name: "castano5", summary: "PCF kernel 1 3 4 3 1",
    exactness: "b", operations: 80, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [window_sum5], filter: { reads: "comparisons", reach: 3, arguments: [], in_shadow: true, linear: { name: "window_hardware5", weights: ", 1.0, 3.0, 4.0" } }, text: `
// umbrage_castano5: PCF under 5 x 5 weights, 1 3 4 3 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_castano5(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 3.0, 4.0);
    return select(1.0, n * (1.0 / 65536.0) * 0.00694444450, n < 9437184.0);
}
` };

export const binomial7 = { language, name: "binomial7", summary: "PCF kernel 1 6 15 20 15 6 1",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [window_sum7], filter: { reads: "comparisons", reach: 4, arguments: [], in_shadow: true, linear: { name: "window_hardware7", weights: ", 0.25, 1.5, 3.75, 5.0" } }, text: `
// umbrage_binomial7: PCF under 7 x 7 weights, 1 6 15 20 15 6 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_binomial7(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum7(map, size, coord, receiver, 256.0, 0.25, 1.5, 3.75, 5.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
` };

export const tent7 = { language, name: "tent7", summary: "PCF kernel 1 2 3 4 3 2 1",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [window_sum7], filter: { reads: "comparisons", reach: 4, arguments: [], in_shadow: true, linear: { name: "window_hardware7", weights: ", 1.0, 2.0, 3.0, 4.0" } }, text: `
// umbrage_tent7: PCF under 7 x 7 weights, 1 2 3 4 3 2 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_tent7(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum7(map, size, coord, receiver, 256.0, 1.0, 2.0, 3.0, 4.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
` };

export const castano7 = { language, name: "castano7", summary: "PCF kernel 1 5 12 16 12 5 1",
    exactness: "b", operations: 138, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [window_sum7], filter: { reads: "comparisons", reach: 4, arguments: [], in_shadow: true, linear: { name: "window_hardware7", weights: ", 1.0, 5.0, 12.0, 16.0" } }, text: `
// umbrage_castano7: PCF under 7 x 7 weights, 1 5 12 16 12 5 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_castano7(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum7(map, size, coord, receiver, 64.0, 1.0, 5.0, 12.0, 16.0);
    return select(1.0, n * (1.0 / 4096.0) * 0.000369822490, n < 11075584.0);
}
` };

export const cube_lit = { language, name: "cube_lit", summary: "one comparison with a texel of a cube map",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cube_neighbor, cube_tile, lit], text: `
// umbrage_cube_lit: one comparison with a texel of a cube map
// Returns (visibility, 1.0), or (0.0, 0.0) beyond a corner
//   map, size   atlas of 3 x 2 faces and its size in texels
//   texel       (s, t, face), integers
//   receiver    distance from the light, bias applied
fn umbrage_cube_lit(map: texture_2d<f32>, size: vec2f, texel: vec3f, receiver: f32) -> vec2f {
    let side: f32 = size.y * 0.5;
    let n: vec3f = umbrage_cube_neighbor(texel, side);
    let at: vec2f = umbrage_cube_tile(n.z, side) + vec2f(n.x, n.y);
    let lit: f32 = umbrage_lit(map, size, at, receiver);
    return select(vec2f(lit, 1.0), vec2f(0.0, 0.0), n.z < 0.0);
}
` };

export const pcf_2x2_cube = { language, name: "pcf_2x2_cube", summary: "bilinear 2x2 PCF of a cube map, across its edges",
    exactness: "c", operations: 33, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, cube_lit], text: `
// umbrage_pcf_2x2_cube: bilinear 2x2 PCF across the edges of a cube map. Returns visibility, 1.0 = lit
//   map, size   atlas of 3 x 2 faces and its size in texels
//   at          (s, t, face): s and t in texels of the face, from 0.0 on
//   receiver    distance from the light, bias applied
fn umbrage_pcf_2x2_cube(map: texture_2d<f32>, size: vec2f, at: vec3f, receiver: f32) -> f32 {
    let coord: vec2f = vec2f(at.x, at.y);
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0 + 0.5) - 128.0, compared);
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    let hi: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    let lo: vec2f = 1.0 - hi;
    var sum: vec2f = umbrage_cube_lit(map, size, vec3f(texel, at.z), receiver) * (lo.x * lo.y);
    sum += umbrage_cube_lit(map, size, vec3f(texel + vec2f(1.0, 0.0), at.z), receiver) * (hi.x * lo.y);
    sum += umbrage_cube_lit(map, size, vec3f(texel + vec2f(0.0, 1.0), at.z), receiver) * (lo.x * hi.y);
    sum += umbrage_cube_lit(map, size, vec3f(texel + vec2f(1.0, 1.0), at.z), receiver) * (hi.x * hi.y);
    return select(1.0, sum.x / sum.y, compared && sum.y > 0.0);
}
` };

export const four_tap_hardware = { language, name: "four_tap_hardware", summary: "mean of four taps from a nearest-texel sampler",
    exactness: "c", operations: 39, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [beyond_far_plane, compare, depth_at], text: `
// umbrage_four_tap_hardware: mean of the shadow test at four taps of a nearest-texel sampler
// Returns visibility, 1.0 = lit
//   map, size    shadow map and its size in texels
//   a, b, c, d   taps from (0.0, 0.0) to (1.0, 1.0) over the map
//                All are lit where the mean of |x| + |y| is 2^15 texels or more
//   receiver     receiver depth in [0, 1], bias applied
fn umbrage_four_tap_hardware(map: texture_2d<f32>, size: vec2f, a: vec2f, b: vec2f, c: vec2f, d: vec2f,
                             receiver: f32) -> f32 {
    let sum: vec2f = (abs(a) + abs(b) + abs(c) + abs(d)) * size;
    let compared: bool = select((sum.x + sum.y < 131072.0), false, umbrage_beyond_far_plane(receiver));
    let count: f32 = umbrage_compare(receiver, umbrage_depth_at(map, size, a)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, b)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, c)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, d));
    return select(1.0, count * 0.25, compared);
}
` };

export const lit_filtered = { language, name: "lit_filtered", summary: "weighted comparisons around a point in texels",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "lit_filtered", scaled: false,
    needs: [pcf_2x2], text: `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
// The sampler of this map cannot weight comparisons, so the shader does
//   coord   in texels, no NaN. Outside texel space it is clamped
fn umbrage_lit_filtered(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    return umbrage_pcf_2x2(map, size, clamp(coord, vec2f(-32767.0, -32767.0), vec2f(32767.0, 32767.0)), receiver);
}
` };

export const covered = { language, name: "covered", summary: "share of the texels around a point that lie in the map, along each axis",
    exactness: "c", operations: 6, within: 0, as_written: false, lowest: "100", role: "covered", scaled: false,
    needs: [], text: `
// umbrage_covered: share of the texels around a point that lie in the map, along each axis. Here all of them count
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
fn umbrage_covered(size: vec2f, uv: vec2f) -> vec2f {
    return vec2f(1.0, 1.0);
}
` };

export const lit_between = { language, name: "lit_between", summary: "weighted comparisons around a point, where four texels meet",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "lit_between", scaled: false,
    needs: [lit_filtered], text: `
// umbrage_lit_between: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv    over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   way   from the receiver to where the four texels meet, in texels. Only a receiver's plane uses it
fn umbrage_lit_between(map: texture_2d<f32>, size: vec2f, uv: vec2f, way: vec2f, receiver: f32) -> f32 {
    return umbrage_lit_filtered(map, size, uv * size, receiver);
}
` };

export const lit_at = { language, name: "lit_at", summary: "weighted comparisons around a point in [0, 1]",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [covered, lit_between], text: `
// umbrage_lit_at: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv      over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   coord   receiver in texels
fn umbrage_lit_at(map: texture_2d<f32>, size: vec2f, uv: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let way: vec2f = floor(uv * size + 0.5) - coord;
    let inside: vec2f = umbrage_covered(size, uv);
    let lit: f32 = umbrage_lit_between(map, size, uv, way, receiver);
    return 1.0 + inside.x * inside.y * (lit - 1.0);  // texels outside are lit
}
` };

export const pcf_2x2_hardware = { language, name: "pcf_2x2_hardware", summary: "bilinear 2x2 PCF by a linear comparison sampler",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, within_far_plane, lit_at], text: `
// umbrage_pcf_2x2_hardware: bilinear 2x2 PCF by the sampler. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_pcf_2x2_hardware(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), coord, compared);
    let lit: f32 = umbrage_lit_at(map, size, at / size, at, receiver);
    let visibility: f32 = select(0.0, lit, umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
` };

export const window_hardware3 = { language, name: "window_hardware3", summary: "3x3 kernel, 4 fetches from a linear comparison sampler",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, within_far_plane, covered, lit_between], text: `
// umbrage_window_hardware3: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k1    weights from the edge to the middle one. The others mirror them
fn umbrage_window_hardware3(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, k0: f32, k1: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), coord - 0.5, compared);
    let texel: vec2f = floor(x);
    let s: vec2f = x - texel;
    let whole: f32 = k0 + k1 + k0;
    let w0: vec2f = k0 + k1 + s * -k1;
    let p0: vec2f = (texel + (-k0 * 0.5 + k1 * 0.5 + s * (k0 - k1 * 0.5)) / w0) / size;
    let v0: vec2f = w0 * umbrage_covered(size, p0);
    let w1: vec2f = k0 + s * k1;
    let p1: vec2f = (texel + (k0 * 1.5 + s * (k0 + k1 * 1.5)) / w1) / size;
    let v1: vec2f = w1 * umbrage_covered(size, p1);
    let inside: vec2f = v0 + v1;
    // ... - s: from the receiver to where the four texels of a fetch meet
    var n: f32 = 0.0;
    var row: f32 = 0.0;
    row += v0.x * umbrage_lit_between(map, size, vec2f(p0.x, p0.y), vec2f(-0.5, -0.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, vec2f(p1.x, p0.y), vec2f(1.5, -0.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, vec2f(p0.x, p1.y), vec2f(-0.5, 1.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, vec2f(p1.x, p1.y), vec2f(1.5, 1.5) - s, receiver);
    n += v1.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    let share: f32 = clamp(n / (whole * whole), 0.0, 1.0);
    let visibility: f32 = select(0.0, share, umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
` };

export const window_hardware5 = { language, name: "window_hardware5", summary: "5x5 kernel, 9 fetches from a linear comparison sampler",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, within_far_plane, covered, lit_between], text: `
// umbrage_window_hardware5: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k2    weights from the edge to the middle one. The others mirror them
fn umbrage_window_hardware5(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, k0: f32, k1: f32,
                            k2: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), coord - 0.5, compared);
    let texel: vec2f = floor(x);
    let s: vec2f = x - texel;
    let whole: f32 = k0 + k1 + k2 + k1 + k0;
    let w0: vec2f = k0 + k1 + s * -k1;
    let p0: vec2f = (texel + (-k0 * 1.5 - k1 * 0.5 + s * (k0 + k1 * 0.5)) / w0) / size;
    let v0: vec2f = w0 * umbrage_covered(size, p0);
    let w1: vec2f = vec2f(k1 + k2, k1 + k2);
    let p1: vec2f = (texel + (k1 * 1.5 + k2 * 0.5 + s * (-k1 + k2)) / w1) / size;
    let v1: vec2f = w1 * umbrage_covered(size, p1);
    let w2: vec2f = k0 + s * k1;
    let p2: vec2f = (texel + (k0 * 2.5 + s * (k0 + k1 * 2.5)) / w2) / size;
    let v2: vec2f = w2 * umbrage_covered(size, p2);
    let inside: vec2f = v0 + v1 + v2;
    // ... - s: from the receiver to where the four texels of a fetch meet
    var n: f32 = 0.0;
    var row: f32 = 0.0;
    row += v0.x * umbrage_lit_between(map, size, vec2f(p0.x, p0.y), vec2f(-1.5, -1.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, vec2f(p1.x, p0.y), vec2f(0.5, -1.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, vec2f(p2.x, p0.y), vec2f(2.5, -1.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, vec2f(p0.x, p1.y), vec2f(-1.5, 0.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, vec2f(p1.x, p1.y), vec2f(0.5, 0.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, vec2f(p2.x, p1.y), vec2f(2.5, 0.5) - s, receiver);
    n += v1.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, vec2f(p0.x, p2.y), vec2f(-1.5, 2.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, vec2f(p1.x, p2.y), vec2f(0.5, 2.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, vec2f(p2.x, p2.y), vec2f(2.5, 2.5) - s, receiver);
    n += v2.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    let share: f32 = clamp(n / (whole * whole), 0.0, 1.0);
    let visibility: f32 = select(0.0, share, umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
` };

export const window_hardware7 = { language, name: "window_hardware7", summary: "7x7 kernel, 16 fetches from a linear comparison sampler",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, within_far_plane, covered, lit_between], text: `
// umbrage_window_hardware7: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k3    weights from the edge to the middle one. The others mirror them
fn umbrage_window_hardware7(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, k0: f32, k1: f32, k2: f32,
                            k3: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), coord - 0.5, compared);
    let texel: vec2f = floor(x);
    let s: vec2f = x - texel;
    let whole: f32 = k0 + k1 + k2 + k3 + k2 + k1 + k0;
    let w0: vec2f = k0 + k1 + s * -k1;
    let p0: vec2f = (texel + (-k0 * 2.5 - k1 * 1.5 + s * (k0 + k1 * 1.5)) / w0) / size;
    let v0: vec2f = w0 * umbrage_covered(size, p0);
    let w1: vec2f = k2 + k3 + s * (k1 - k3);
    let p1: vec2f = (texel + (-k2 * 0.5 + k3 * 0.5 + s * (-k1 * 0.5 + k2 - k3 * 0.5)) / w1) / size;
    let v1: vec2f = w1 * umbrage_covered(size, p1);
    let w2: vec2f = k1 + k2 + s * (-k1 + k3);
    let p2: vec2f = (texel + (k1 * 2.5 + k2 * 1.5 + s * (-k1 * 2.5 + k2 + k3 * 1.5)) / w2) / size;
    let v2: vec2f = w2 * umbrage_covered(size, p2);
    let w3: vec2f = k0 + s * k1;
    let p3: vec2f = (texel + (k0 * 3.5 + s * (k0 + k1 * 3.5)) / w3) / size;
    let v3: vec2f = w3 * umbrage_covered(size, p3);
    let inside: vec2f = v0 + v1 + v2 + v3;
    // ... - s: from the receiver to where the four texels of a fetch meet
    var n: f32 = 0.0;
    var row: f32 = 0.0;
    row += v0.x * umbrage_lit_between(map, size, vec2f(p0.x, p0.y), vec2f(-2.5, -2.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, vec2f(p1.x, p0.y), vec2f(-0.5, -2.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, vec2f(p2.x, p0.y), vec2f(1.5, -2.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, vec2f(p3.x, p0.y), vec2f(3.5, -2.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, vec2f(p0.x, p1.y), vec2f(-2.5, -0.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, vec2f(p1.x, p1.y), vec2f(-0.5, -0.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, vec2f(p2.x, p1.y), vec2f(1.5, -0.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, vec2f(p3.x, p1.y), vec2f(3.5, -0.5) - s, receiver);
    n += v1.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, vec2f(p0.x, p2.y), vec2f(-2.5, 1.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, vec2f(p1.x, p2.y), vec2f(-0.5, 1.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, vec2f(p2.x, p2.y), vec2f(1.5, 1.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, vec2f(p3.x, p2.y), vec2f(3.5, 1.5) - s, receiver);
    n += v2.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, vec2f(p0.x, p3.y), vec2f(-2.5, 3.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, vec2f(p1.x, p3.y), vec2f(-0.5, 3.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, vec2f(p2.x, p3.y), vec2f(1.5, 3.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, vec2f(p3.x, p3.y), vec2f(3.5, 3.5) - s, receiver);
    n += v3.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    let share: f32 = clamp(n / (whole * whole), 0.0, 1.0);
    let visibility: f32 = select(0.0, share, umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
` };

export const ellipse_hardware8 = { language, name: "ellipse_hardware8", summary: "PCF over an ellipse, 8 fetches from a linear comparison sampler",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, within_far_plane, lit_at], text: `
// umbrage_ellipse_hardware8: PCF over 8 points of an ellipse, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_ellipse_hardware8(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: vec2f,
                             rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let wide: f32 = select(0.0, min(radius.x, 255.9375), radius.x > 0.0);
    let high: f32 = select(0.0, min(radius.y, 255.9375), radius.y > 0.0);
    let part: vec2f = vec2f(wide, high) * (1.0 / 1024.0) / size;
    let x: vec2f = vec2f(rotation.x, rotation.z) * part;
    let y: vec2f = vec2f(rotation.y, rotation.w) * part;
    var n: f32 = 0.0;
    n += umbrage_lit_at(map, size, center + x * 3.0 - y * 1.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 11.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 6.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 13.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 7.0, coord, receiver);
    let visibility: f32 = select(0.0, n * (1.0 / 8.0), umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
` };

export const ellipse_hardware16 = { language, name: "ellipse_hardware16", summary: "PCF over an ellipse, 16 fetches from a linear comparison sampler",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, within_far_plane, lit_at], text: `
// umbrage_ellipse_hardware16: PCF over 16 points of an ellipse, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_ellipse_hardware16(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: vec2f,
                              rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let wide: f32 = select(0.0, min(radius.x, 255.9375), radius.x > 0.0);
    let high: f32 = select(0.0, min(radius.y, 255.9375), radius.y > 0.0);
    let part: vec2f = vec2f(wide, high) * (1.0 / 1024.0) / size;
    let x: vec2f = vec2f(rotation.x, rotation.z) * part;
    let y: vec2f = vec2f(rotation.y, rotation.w) * part;
    var n: f32 = 0.0;
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 + y * 2.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 5.0 + y * 2.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 7.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 6.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 8.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 - y * 11.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 4.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 1.0 + y * 13.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 + y * 11.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 + y * 10.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 4.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 - y * 12.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 7.0 - y * 12.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 14.0 - y * 2.0, coord, receiver);
    let visibility: f32 = select(0.0, n * (1.0 / 16.0), umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
` };

export const ellipse_hardware32 = { language, name: "ellipse_hardware32", summary: "PCF over an ellipse, 32 fetches from a linear comparison sampler",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, within_far_plane, lit_at], text: `
// umbrage_ellipse_hardware32: PCF over 32 points of an ellipse, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_ellipse_hardware32(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: vec2f,
                              rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let wide: f32 = select(0.0, min(radius.x, 255.9375), radius.x > 0.0);
    let high: f32 = select(0.0, min(radius.y, 255.9375), radius.y > 0.0);
    let part: vec2f = vec2f(wide, high) * (1.0 / 1024.0) / size;
    let x: vec2f = vec2f(rotation.x, rotation.z) * part;
    let y: vec2f = vec2f(rotation.y, rotation.w) * part;
    var n: f32 = 0.0;
    n += umbrage_lit_at(map, size, center - x * 2.0 - y * 1.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 2.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 4.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 6.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 5.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 - y * 2.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 - y * 1.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 8.0 + y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 + y * 7.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 9.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 6.0 - y * 7.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 + y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 10.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 3.0 - y * 10.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 6.0 + y * 10.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 - y * 12.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 1.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 + y * 11.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 13.0 + y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 + y * 4.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 10.0 - y * 10.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 14.0 - y * 2.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 11.0 + y * 9.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 14.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 6.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 12.0 + y * 8.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 14.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 7.0 - y * 13.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 - y * 15.0, coord, receiver);
    let visibility: f32 = select(0.0, n * (1.0 / 32.0), umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
` };

export const disc_hardware8 = { language, name: "disc_hardware8", summary: "disc PCF, 8 fetches from a linear comparison sampler",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [ellipse_hardware8], text: `
// umbrage_disc_hardware8: PCF over 8 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_disc_hardware8(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                          rotation: vec4f) -> f32 {
    return umbrage_ellipse_hardware8(map, size, coord, receiver, vec2f(radius, radius), rotation);
}
` };

export const disc_hardware16 = { language, name: "disc_hardware16", summary: "disc PCF, 16 fetches from a linear comparison sampler",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [ellipse_hardware16], text: `
// umbrage_disc_hardware16: PCF over 16 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_disc_hardware16(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                           rotation: vec4f) -> f32 {
    return umbrage_ellipse_hardware16(map, size, coord, receiver, vec2f(radius, radius), rotation);
}
` };

export const disc_hardware32 = { language, name: "disc_hardware32", summary: "disc PCF, 32 fetches from a linear comparison sampler",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [ellipse_hardware32], text: `
// umbrage_disc_hardware32: PCF over 32 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_disc_hardware32(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                           rotation: vec4f) -> f32 {
    return umbrage_ellipse_hardware32(map, size, coord, receiver, vec2f(radius, radius), rotation);
}
` };

export const bounds_lit = { language, name: "bounds_lit", summary: "visibility from depth bounds, an early exit of a filter",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, compare, fetch_clamped], text: `
// umbrage_bounds_lit: early exit of a filter. Returns 1.0 where all texels are lit, 0.0 where none is
// Returns -1.0 where the bounds do not decide it: call the filter there
//   bounds, size      map of the texels' smallest and largest depths, and its size in texels
//   coord, receiver   as passed to the filter
//   place             maps a receiver to its bounds, from make_filter_bounds
fn umbrage_bounds_lit(bounds: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, place: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let b: vec4f = umbrage_fetch_clamped(bounds, size, floor((x + place.x) * place.y));
    let all: f32 = umbrage_compare(receiver, b.x);
    let some: f32 = umbrage_compare(receiver, b.y);
    let known: f32 = select(-1.0, all, b.x <= b.y && all == some);  // NaN bounds decide nothing
    return select(1.0, known, compared);
}
` };

export const distance_code = { language, name: "distance_code", summary: "distance of a depth from the near plane, 16 bits",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_distance_code: distance of a depth from the near plane, an integer from 0.0 to 65535.0
// Returns 0.0 at the near plane, also where depth is reversed
fn umbrage_distance_code(depth: f32) -> f32 {
    let v: f32 = depth * 65536.0;
    let forward: f32 = select(65535.0, floor(max(v, 0.0)), v < 65535.0);
    let reversed: f32 = select(0.0, floor(min(v, 65535.0)), v > 0.0);
    return select(65535.0 - reversed, forward, umbrage_cleared_depth() > 0.5);
}
` };

export const penumbra = { language, name: "penumbra", summary: "radius of a penumbra from the distance to the blocker",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_penumbra: radius of a penumbra along x and y in 1/16 texel, integers
//   apart      umbrage_distance_code of the receiver minus that of the blocker
//   softness   (1/16 texel per distance code along x and y, min_radius, max_radius), from make_penumbra_params
fn umbrage_penumbra(apart: f32, softness: vec4f) -> vec2f {
    let radius: vec2f = floor(vec2f(softness.x, softness.y) * apart);
    return min(max(radius, vec2f(softness.z, softness.z)), vec2f(softness.w, softness.w));
}
` };

export const blocker = { language, name: "blocker", summary: "count and distance code of one possible blocker",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [fetch_depth, compare, distance_code], text: `
// umbrage_blocker: (1.0, umbrage_distance_code) of a texel nearer to the light than the receiver, else (0.0, 0.0)
fn umbrage_blocker(map: texture_2d<f32>, size: vec2f, texel: vec2f, receiver: f32) -> vec2f {
    let stored: f32 = umbrage_fetch_depth(map, size, texel);
    let code: f32 = umbrage_distance_code(stored);
    return select(vec2f(1.0, code), vec2f(0.0, 0.0), umbrage_compare(receiver, stored) > 0.5);
}
` };

export const blockers8 = { language, name: "blockers8", summary: "blocker search over an ellipse's points",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [disc_tap, blocker], text: `
// umbrage_blockers8: (number of blockers, sum of their distance codes) at 8 points of an ellipse
//   map, size   shadow map and its size in texels
//   position    floor(256 coord) of the receiver
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_blockers8(map: texture_2d<f32>, size: vec2f, position: vec2f, receiver: f32, radius: vec2f,
                     rotation: vec4f) -> vec2f {
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(3.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-4.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(1.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-12.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(11.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(0.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(11.0, -7.0), rotation, radius), receiver);
    return n;
}
` };

export const blockers16 = { language, name: "blockers16", summary: "blocker search over an ellipse's points",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [disc_tap, blocker], text: `
// umbrage_blockers16: (number of blockers, sum of their distance codes) at 16 points of an ellipse
//   map, size   shadow map and its size in texels
//   position    floor(256 coord) of the receiver
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_blockers16(map: texture_2d<f32>, size: vec2f, position: vec2f, receiver: f32, radius: vec2f,
                      rotation: vec4f) -> vec2f {
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(0.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(8.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(11.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-12.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-9.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-13.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(14.0, -2.0), rotation, radius), receiver);
    return n;
}
` };

export const blockers32 = { language, name: "blockers32", summary: "blocker search over an ellipse's points",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [disc_tap, blocker], text: `
// umbrage_blockers32: (number of blockers, sum of their distance codes) at 32 points of an ellipse
//   map, size   shadow map and its size in texels
//   position    floor(256 coord) of the receiver
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_blockers32(map: texture_2d<f32>, size: vec2f, position: vec2f, receiver: f32, radius: vec2f,
                      rotation: vec4f) -> vec2f {
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-2.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(3.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(1.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-4.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(0.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-5.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(7.0, -2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-8.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(8.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(5.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(1.0, -9.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(6.0, -7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-8.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(0.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-3.0, -10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-6.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(11.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(5.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-13.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(13.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-13.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(10.0, -10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(14.0, -2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-11.0, 9.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(3.0, 14.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-13.0, -6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(12.0, 8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-4.0, 14.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-7.0, -13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(0.0, -15.0), rotation, radius), receiver);
    return n;
}
` };

export const pcss8 = { language, name: "pcss8", summary: "percentage-closer soft shadows (PCSS), 8 points twice",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, distance_code, penumbra, blockers8, floor_divide, ellipse8], filter: { reads: "depths", reach: 5.3828125, arguments: [{ name: "softness", type: "vec4", value: [0.0625, 0.0625, 16, 96] }, { name: "rotation", type: "vec4", value: [64, 0, 0, 64] }], in_shadow: true }, text: `
// umbrage_pcss8: percentage-closer soft shadows (PCSS), 8 points twice. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_pcss8(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, softness: vec4f,
                 rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let z: f32 = umbrage_distance_code(receiver);
    let search_radius: vec2f = umbrage_penumbra(z, softness);
    let found: vec2f = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    let mean: f32 = umbrage_floor_divide(found.y, max(found.x, 1.0));
    let radius: vec2f = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is that of the search, whose points are all lit
    return umbrage_ellipse8(map, size, coord, receiver, radius, rotation);
}
` };

export const pcss16 = { language, name: "pcss16", summary: "percentage-closer soft shadows (PCSS), 16 points twice",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, distance_code, penumbra, blockers16, floor_divide, ellipse16], filter: { reads: "depths", reach: 5.7578125, arguments: [{ name: "softness", type: "vec4", value: [0.0625, 0.0625, 16, 96] }, { name: "rotation", type: "vec4", value: [64, 0, 0, 64] }], in_shadow: true }, text: `
// umbrage_pcss16: percentage-closer soft shadows (PCSS), 16 points twice. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_pcss16(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, softness: vec4f,
                  rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let z: f32 = umbrage_distance_code(receiver);
    let search_radius: vec2f = umbrage_penumbra(z, softness);
    let found: vec2f = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    let mean: f32 = umbrage_floor_divide(found.y, max(found.x, 1.0));
    let radius: vec2f = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is that of the search, whose points are all lit
    return umbrage_ellipse16(map, size, coord, receiver, radius, rotation);
}
` };

export const pcss32 = { language, name: "pcss32", summary: "percentage-closer soft shadows (PCSS), 32 points twice",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, distance_code, penumbra, blockers32, floor_divide, ellipse32], filter: { reads: "depths", reach: 6.1328125, arguments: [{ name: "softness", type: "vec4", value: [0.0625, 0.0625, 16, 96] }, { name: "rotation", type: "vec4", value: [64, 0, 0, 64] }], in_shadow: true }, text: `
// umbrage_pcss32: percentage-closer soft shadows (PCSS), 32 points twice. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_pcss32(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, softness: vec4f,
                  rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let z: f32 = umbrage_distance_code(receiver);
    let search_radius: vec2f = umbrage_penumbra(z, softness);
    let found: vec2f = umbrage_blockers32(map, size, at, receiver, search_radius, rotation);
    let mean: f32 = umbrage_floor_divide(found.y, max(found.x, 1.0));
    let radius: vec2f = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is that of the search, whose points are all lit
    return umbrage_ellipse32(map, size, coord, receiver, radius, rotation);
}
` };

export const blocker_at = { language, name: "blocker_at", summary: "count and depth of one possible blocker",
    exactness: "c", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [depth_at, compare], text: `
// umbrage_blocker_at: (1.0, depth) of the texel at a point if it is nearer to the light, else (0.0, 0.0)
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
fn umbrage_blocker_at(map: texture_2d<f32>, size: vec2f, uv: vec2f, receiver: f32) -> vec2f {
    let stored: f32 = umbrage_depth_at(map, size, uv);
    return select(vec2f(1.0, stored), vec2f(0.0, 0.0), umbrage_compare(receiver, stored) > 0.5);
}
` };

export const pcss_radius = { language, name: "pcss_radius", summary: "penumbra radius from the mean depth of blockers",
    exactness: "c", operations: 0, within: 0.0009765625, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_pcss_radius: radius of a penumbra along x and y in texels
// Without a blocker it is the radius for one at the near plane
//   found      (number of blockers, sum of their depths)
//   receiver   receiver depth in [0, 1], bias applied
//   softness   (1/16 texel per distance code along x and y, min_radius, max_radius), from make_penumbra_params
fn umbrage_pcss_radius(found: vec2f, receiver: f32, softness: vec4f) -> vec2f {
    let forward: bool = umbrage_cleared_depth() > 0.5;
    let mean: f32 = select(select(1.0, 0.0, forward), found.y / found.x, found.x > 0.5);
    let apart: f32 = select(mean - receiver, receiver - mean, forward);
    let radius: vec2f = vec2f(softness.x, softness.y) * 4096.0 * apart;
    let min_radius: f32 = softness.z * 0.0625;
    let max_radius: f32 = softness.w * 0.0625;
    return vec2f(select(min_radius, min(radius.x, max_radius), radius.x > min_radius),
                 select(min_radius, min(radius.y, max_radius), radius.y > min_radius));
}
` };

export const blockers_hardware8 = { language, name: "blockers_hardware8", summary: "blocker search, 8 points of a nearest-texel sampler",
    exactness: "c", operations: 24, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, blocker_at], text: `
// umbrage_blockers_hardware8: (number of blockers, sum of their depths) at 8 points of an ellipse
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_blockers_hardware8(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: vec2f,
                              rotation: vec4f) -> vec2f {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let wide: f32 = select(0.0, min(radius.x, 255.9375), radius.x > 0.0);
    let high: f32 = select(0.0, min(radius.y, 255.9375), radius.y > 0.0);
    let part: vec2f = vec2f(wide, high) * (1.0 / 1024.0) / size;
    let x: vec2f = vec2f(rotation.x, rotation.z) * part;
    let y: vec2f = vec2f(rotation.y, rotation.w) * part;
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 3.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 - y * 7.0, receiver);
    return select(vec2f(0.0, 0.0), n, compared);
}
` };

export const blockers_hardware16 = { language, name: "blockers_hardware16", summary: "blocker search, 16 points of a nearest-texel sampler",
    exactness: "c", operations: 24, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, blocker_at], text: `
// umbrage_blockers_hardware16: (number of blockers, sum of their depths) at 16 points of an ellipse
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_blockers_hardware16(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: vec2f,
                               rotation: vec4f) -> vec2f {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let wide: f32 = select(0.0, min(radius.x, 255.9375), radius.x > 0.0);
    let high: f32 = select(0.0, min(radius.y, 255.9375), radius.y > 0.0);
    let part: vec2f = vec2f(wide, high) * (1.0 / 1024.0) / size;
    let x: vec2f = vec2f(rotation.x, rotation.z) * part;
    let y: vec2f = vec2f(rotation.y, rotation.w) * part;
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    return select(vec2f(0.0, 0.0), n, compared);
}
` };

export const blockers_hardware32 = { language, name: "blockers_hardware32", summary: "blocker search, 32 points of a nearest-texel sampler",
    exactness: "c", operations: 24, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, blocker_at], text: `
// umbrage_blockers_hardware32: (number of blockers, sum of their depths) at 32 points of an ellipse
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_blockers_hardware32(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: vec2f,
                               rotation: vec4f) -> vec2f {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let wide: f32 = select(0.0, min(radius.x, 255.9375), radius.x > 0.0);
    let high: f32 = select(0.0, min(radius.y, 255.9375), radius.y > 0.0);
    let part: vec2f = vec2f(wide, high) * (1.0 / 1024.0) / size;
    let x: vec2f = vec2f(rotation.x, rotation.z) * part;
    let y: vec2f = vec2f(rotation.y, rotation.w) * part;
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center - x * 2.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 3.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 5.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 - y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 8.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 8.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 + y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 9.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 6.0 - y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 8.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 3.0 - y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 6.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 13.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 + y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 10.0 - y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 11.0 + y * 9.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 3.0 + y * 14.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 12.0 + y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 14.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 7.0 - y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 - y * 15.0, receiver);
    return select(vec2f(0.0, 0.0), n, compared);
}
` };

export const hardened_kernel8 = { language, name: "hardened_kernel8", summary: "fraction of a disc in shadow, steepened",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_hardened_kernel8: fraction of 8 points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
fn umbrage_hardened_kernel8(blocked: f32, ratio: f32) -> f32 {
    let u: f32 = blocked * 2.0 - 8.0;
    let d: f32 = max(8.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    let steep: f32 = 512.0 - d * d * d;
    let hard: f32 = select(512.0 + steep, 512.0 - steep, u < 0.0);
    return (hard * (256.0 - ratio) + blocked * ratio * 128.0) * (1.0 / 262144.0);
}
` };

export const hardened_kernel16 = { language, name: "hardened_kernel16", summary: "fraction of a disc in shadow, steepened",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_hardened_kernel16: fraction of 16 points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
fn umbrage_hardened_kernel16(blocked: f32, ratio: f32) -> f32 {
    let u: f32 = blocked * 2.0 - 16.0;
    let d: f32 = max(16.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    let steep: f32 = 4096.0 - d * d * d;
    let hard: f32 = select(4096.0 + steep, 4096.0 - steep, u < 0.0);
    return (hard * (256.0 - ratio) + blocked * ratio * 512.0) * (1.0 / 2097152.0);
}
` };

export const hardened_kernel32 = { language, name: "hardened_kernel32", summary: "fraction of a disc in shadow, steepened",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_hardened_kernel32: fraction of 32 points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
fn umbrage_hardened_kernel32(blocked: f32, ratio: f32) -> f32 {
    let u: f32 = blocked * 2.0 - 32.0;
    let d: f32 = max(32.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    let steep: f32 = 32768.0 - d * d * d;
    let hard: f32 = select(32768.0 + steep, 32768.0 - steep, u < 0.0);
    return (hard * (256.0 - ratio) + blocked * ratio * 2048.0) * (1.0 / 16777216.0);
}
` };

export const dpcf8 = { language, name: "dpcf8", summary: "contact hardening from one pass (DPCF), 8 points",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, distance_code, penumbra, blockers8, floor_divide, hardened_kernel8], filter: { reads: "depths", reach: 5.3828125, arguments: [{ name: "softness", type: "vec4", value: [0.0625, 0.0625, 16, 96] }, { name: "rotation", type: "vec4", value: [64, 0, 0, 64] }], in_shadow: true }, text: `
// umbrage_dpcf8: soft shadow with contact hardening from 8 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_dpcf8(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, softness: vec4f,
                 rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let z: f32 = umbrage_distance_code(receiver);
    let search_radius: vec2f = umbrage_penumbra(z, softness);
    let found: vec2f = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    let mean: f32 = umbrage_floor_divide(found.y, max(found.x, 1.0));
    let radius: vec2f = umbrage_penumbra(z - mean, softness);
    let searched: f32 = max(search_radius.x + search_radius.y, 1.0);
    let ratio: f32 = umbrage_floor_divide((radius.x + radius.y) * 256.0, searched);
    let dark: f32 = umbrage_hardened_kernel8(found.x, ratio);
    return select(1.0, clamp(1.0 - dark, 0.0, 1.0), compared);
}
` };

export const dpcf16 = { language, name: "dpcf16", summary: "contact hardening from one pass (DPCF), 16 points",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, distance_code, penumbra, blockers16, floor_divide, hardened_kernel16], filter: { reads: "depths", reach: 5.7578125, arguments: [{ name: "softness", type: "vec4", value: [0.0625, 0.0625, 16, 96] }, { name: "rotation", type: "vec4", value: [64, 0, 0, 64] }], in_shadow: true }, text: `
// umbrage_dpcf16: soft shadow with contact hardening from 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_dpcf16(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, softness: vec4f,
                  rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let z: f32 = umbrage_distance_code(receiver);
    let search_radius: vec2f = umbrage_penumbra(z, softness);
    let found: vec2f = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    let mean: f32 = umbrage_floor_divide(found.y, max(found.x, 1.0));
    let radius: vec2f = umbrage_penumbra(z - mean, softness);
    let searched: f32 = max(search_radius.x + search_radius.y, 1.0);
    let ratio: f32 = umbrage_floor_divide((radius.x + radius.y) * 256.0, searched);
    let dark: f32 = umbrage_hardened_kernel16(found.x, ratio);
    return select(1.0, clamp(1.0 - dark, 0.0, 1.0), compared);
}
` };

export const dpcf32 = { language, name: "dpcf32", summary: "contact hardening from one pass (DPCF), 32 points",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, distance_code, penumbra, blockers32, floor_divide, hardened_kernel32], filter: { reads: "depths", reach: 6.1328125, arguments: [{ name: "softness", type: "vec4", value: [0.0625, 0.0625, 16, 96] }, { name: "rotation", type: "vec4", value: [64, 0, 0, 64] }], in_shadow: true }, text: `
// umbrage_dpcf32: soft shadow with contact hardening from 32 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_dpcf32(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, softness: vec4f,
                  rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let z: f32 = umbrage_distance_code(receiver);
    let search_radius: vec2f = umbrage_penumbra(z, softness);
    let found: vec2f = umbrage_blockers32(map, size, at, receiver, search_radius, rotation);
    let mean: f32 = umbrage_floor_divide(found.y, max(found.x, 1.0));
    let radius: vec2f = umbrage_penumbra(z - mean, softness);
    let searched: f32 = max(search_radius.x + search_radius.y, 1.0);
    let ratio: f32 = umbrage_floor_divide((radius.x + radius.y) * 256.0, searched);
    let dark: f32 = umbrage_hardened_kernel32(found.x, ratio);
    return select(1.0, clamp(1.0 - dark, 0.0, 1.0), compared);
}
` };

export const box_moments = { language, name: "box_moments", summary: "mean and squared distances over a box, from a SAT",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [texel, floor_divide], text: `
// umbrage_box_moments: (mean, rest, high, low) of the quantized depths in a box of n texels, integers
//   The sum of the depths is n mean + rest. The sum of their squared distances from mean is 4096 high + low
//   map, size    table from make_variance_table and its size
//   first, end   lowest texel of the box, and one past its highest. first < end
fn umbrage_box_moments(map: texture_2d<f32>, size: vec2f, first: vec2f, end: vec2f) -> vec4f {
    let a: vec4f = umbrage_texel(map, size, end);
    let b: vec4f = umbrage_texel(map, size, vec2f(first.x, end.y));
    let c: vec4f = umbrage_texel(map, size, vec2f(end.x, first.y));
    let d: vec4f = umbrage_texel(map, size, first);
    let part: vec4f = (a - b) - (c - d);
    var low: vec2f = vec2f(part.x, part.z);
    let carry: vec2f = floor(low * (1.0 / 65536.0));
    var above: vec2f = vec2f(part.y, part.w) + carry;
    // nothing below is negative. The maxima keep compilers from regrouping sums across them
    low = max(low - carry * 65536.0, vec2f(0.0, 0.0));
    above = max(above - floor(above * (1.0 / 65536.0)) * 65536.0, vec2f(0.0, 0.0));
    let sum: f32 = above.x * 65536.0 + low.x;
    let sides: vec2f = max(end - first, vec2f(1.0, 1.0));
    let n: f32 = sides.x * sides.y;
    let mean: f32 = umbrage_floor_divide(sum, n);
    let rest: f32 = max(sum - mean * n, 0.0);
    var digits: vec2f = vec2f(sum + rest, low.y);
    let high: vec2f = floor(digits * (1.0 / 4096.0));
    digits = max(digits - high * 4096.0, vec2f(0.0, 0.0));
    let below: f32 = digits.y - mean * digits.x;
    let borrow: f32 = floor(below * (1.0 / 4096.0));
    var wide: f32 = above.y * 16.0 + high.y - mean * high.x + borrow;
    wide = wide - floor(wide * (1.0 / 1048576.0)) * 1048576.0;
    return vec4f(mean, rest, wide, below - borrow * 4096.0);
}
` };

export const summed_variance = { language, name: "summed_variance", summary: "variance shadow over a box of any size, from a SAT",
    exactness: "c", operations: 0, within: 1.52587890625e-05, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, cleared_depth, box_moments], text: `
// umbrage_summed_variance: variance shadow from a summed-area table. Returns visibility, 1.0 = lit
//   map, size   table from make_variance_table and its size: the shadow map's plus one
//   coord       receiver in texels of the shadow map. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      an integer. The box has 2 radius + 1 texels per side
//   codes       2^bits of the table
fn umbrage_summed_variance(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                           codes: f32) -> f32 {
    let last: vec2f = size - 1.0;
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(last, coord));
    let texel: vec2f = select(vec2f(0.0, 0.0), clamp(floor(coord), vec2f(0.0, 0.0), last - 1.0), compared);
    let first: vec2f = max(texel - radius, vec2f(0.0, 0.0));
    let end: vec2f = min(texel + radius + 1.0, last);
    let m: vec4f = umbrage_box_moments(map, size, first, end);
    let sides: vec2f = end - first;
    let n: f32 = sides.x * sides.y;
    let share: f32 = m.y / n;
    let variance: f32 = (m.z * 4096.0 + (m.w - m.y)) / n + share * (1.0 - share);
    let scaled: f32 = receiver * codes;
    let t: f32 = select(codes - scaled, scaled, umbrage_cleared_depth() > 0.5);
    let d: f32 = (t - 1.0 - m.x) - share;
    let behind: f32 = select(0.0, variance / (variance + d * d), d > 0.0);
    return select(1.0, select(behind, 1.0, d <= 0.0), compared);
}
` };

export const box_mean = { language, name: "box_mean", summary: "mean of four integers over a box, from a SAT in two halves",
    exactness: "c", operations: 19, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [texel], text: `
// umbrage_box_mean: mean over a box of four integers below 65536.0
//   map, size    table from make_moment_table and its size
//   first, end   lowest texel of the box, and one past its highest. first < end
fn umbrage_box_mean(map: texture_2d<f32>, size: vec2f, first: vec2f, end: vec2f) -> vec4f {
    let right: f32 = size.x * 0.5;
    var a: vec4f = umbrage_texel(map, size, end);
    var b: vec4f = umbrage_texel(map, size, vec2f(first.x, end.y));
    var c: vec4f = umbrage_texel(map, size, vec2f(end.x, first.y));
    var d: vec4f = umbrage_texel(map, size, first);
    let low: vec4f = (a - b) - (c - d);
    let carry: vec4f = floor(low * (1.0 / 65536.0));
    a = umbrage_texel(map, size, vec2f(right + end.x, end.y));
    b = umbrage_texel(map, size, vec2f(right + first.x, end.y));
    c = umbrage_texel(map, size, vec2f(right + end.x, first.y));
    d = umbrage_texel(map, size, vec2f(right + first.x, first.y));
    let above: vec4f = (a - b) - (c - d) + carry;
    let high: vec4f = above - floor(above * (1.0 / 65536.0)) * 65536.0;
    let sum: vec4f = high * 65536.0 + (low - carry * 65536.0);
    let sides: vec2f = end - first;
    return sum / (sides.x * sides.y);
}
` };

export const from_optimized_moments = { language, name: "from_optimized_moments", summary: "four 16-bit channels to four moments (MSM)",
    exactness: "b", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_from_optimized_moments: four moments from the result of umbrage_to_optimized_moments
fn umbrage_from_optimized_moments(o: vec4f) -> vec4f {
    let x: f32 = o.x - 0.5;
    let z: f32 = o.z - 0.5;
    let eighth: f32 = o.y * 0.125;
    let b1: f32 = z * 1.73205078 - x * 0.333333343;
    let b2: f32 = o.w + eighth;
    let b3: f32 = z * 1.29903817 - x * 0.75;
    let b4: f32 = o.w - eighth;
    return vec4f(b1, b2, b3, b4);
}
` };

export const bias_moments = { language, name: "bias_moments", summary: "four moments (MSM) with a bias against rounding",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
fn umbrage_bias_moments(b: vec4f, bias: vec2f) -> vec4f {
    let x: f32 = b.x - b.x * bias.x;
    let y: f32 = b.y + (bias.y - b.y) * bias.x;
    let z: f32 = b.z - b.z * bias.x;
    let w: f32 = b.w + (bias.y - b.w) * bias.x;
    return vec4f(x, y, z, w);
}
` };

export const to_forward_depth = { language, name: "to_forward_depth", summary: "depth that grows with the distance from the light",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
fn umbrage_to_forward_depth(depth: f32) -> f32 {
    return select(depth, 1.0 - depth, umbrage_cleared_depth() < 0.5);
}
` };

export const moment_atoms = { language, name: "moment_atoms", summary: "two depths that have the moments with the receiver's",
    exactness: "c", operations: 0, within: 0.015625, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_moment_atoms: the two depths that have the same moments with the receiver's, minus b.x, and their shares
//   b   moments, biased
//   x   the receiver's depth on -1.0 to 1.0 minus b.x
fn umbrage_moment_atoms(b: vec4f, x: f32) -> vec4f {
    let d: f32 = b.y - b.x * b.x;
    let third: f32 = b.z - b.x * b.y;
    let l: f32 = third / d;
    let e: f32 = (b.w - b.y * b.y) - third * l;
    let h: f32 = b.x * 2.0 - l;
    let a: f32 = d * ((x + h) * x - d);
    let m: f32 = x * e + h * a;
    let c: f32 = d * (e - a);
    let square: f32 = m * m - 4.0 * a * c;
    let root: f32 = sqrt(select(0.0, square, square > 0.0));
    let w: f32 = select(-(m + root), root - m, m < 0.0) * 0.5;
    let t: vec2f = vec2f(w / a, c / w);
    let q: vec2f = (t + h) * t - d;
    let least: f32 = d * e;
    let sum: vec2f = least + (t * t * e + q * q * d);
    return vec4f(t.x, t.y, least / sum.x, least / sum.y);
}
` };

export const decode_msm = { language, name: "decode_msm", summary: "mean of MSM texels to visibility",
    exactness: "c", operations: 0, within: 0.015625, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [bias_moments, to_forward_depth, moment_atoms], text: `
// umbrage_decode_msm: visibility of a receiver, at least its lit fraction minus bias.x. 1.0 = lit
//   b: mean of texels. receiver: depth in [0, 1], bias applied
//   bias: (3e-6, 0.375) for 32-bit floats, (6e-5, 0.628) for 16-bit channels
fn umbrage_decode_msm(b: vec4f, receiver: f32, bias: vec2f) -> f32 {
    let d: f32 = umbrage_to_forward_depth(receiver);
    let m: vec4f = umbrage_bias_moments(b, bias);
    let x: f32 = (select(0.0, select(1.0, d, d < 1.0), d > 0.0) * 2.0 - 1.0) - m.x;
    let atoms: vec4f = umbrage_moment_atoms(m, x);
    let first: f32 = select(0.0, atoms.z, atoms.x < x);
    let second: f32 = select(0.0, atoms.w, atoms.y < x);
    var lit: f32 = 1.0 - (first + second);
    let known: bool = abs(atoms.z + atoms.w) <= 4294967296.0;  // false for NaN
    lit = select(select(0.0, 1.0, x <= 0.0), select(0.0, select(1.0, lit, lit < 1.0), lit > 0.0), known);
    return select(select(0.0, lit, d <= 0.0), lit, d > 0.0);
}
` };

export const summed_moments = { language, name: "summed_moments", summary: "moment shadow over a box of any size, from a SAT",
    exactness: "c", operations: 0, within: 0.015625, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, box_mean, from_optimized_moments, decode_msm], text: `
// umbrage_summed_moments: moment shadow from a summed-area table. Returns visibility, 1.0 = lit
//   map, size   table from make_moment_table and its size: twice the shadow map's width plus two, its height plus one
//   coord       receiver in texels of the shadow map. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      an integer. The box has 2 radius + 1 texels per side
//   bias        (6e-5, 0.628)
fn umbrage_summed_moments(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                          bias: vec2f) -> f32 {
    let last: vec2f = vec2f(size.x * 0.5, size.y) - 1.0;
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(last, coord));
    let texel: vec2f = select(vec2f(0.0, 0.0), clamp(floor(coord), vec2f(0.0, 0.0), last - 1.0), compared);
    let first: vec2f = max(texel - radius, vec2f(0.0, 0.0));
    let end: vec2f = min(texel + radius + 1.0, last);
    let turned: vec4f = umbrage_box_mean(map, size, first, end) * (1.0 / 65535.0);
    let lit: f32 = umbrage_decode_msm(umbrage_from_optimized_moments(turned), receiver, bias);
    return select(1.0, lit, compared);
}
` };

export const power_of_two = { language, name: "power_of_two", summary: "2^n of integers n from -64 to 63",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
fn umbrage_power_of_two(n: f32) -> f32 {
    let exponent: u32 = u32(n + 127.0);
    return bitcast<f32>(exponent << 23);
}
` };

export const exp2_polynomial = { language, name: "exp2_polynomial", summary: "2^y, off by at most 1.8e-7 of itself",
    exactness: "b", operations: 16, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [power_of_two], text: `
// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of itself
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
fn umbrage_exp2_polynomial(y: f32) -> f32 {
    let x: f32 = select(-64.0, min(y, 63.0), y > -64.0);
    let n: f32 = floor(x);
    let f: f32 = x - n;
    var p: f32 = 0.00187931862 * f + 0.00899099465;
    p = p * f + 0.0558186769;
    p = p * f + 0.240159273;
    p = p * f + 0.693151712;
    p = p * f + 1.0;
    return p * umbrage_power_of_two(n);
}
` };

export const exp2_steps = { language, name: "exp2_steps", summary: "2^y in steps of 12 bits",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [power_of_two], text: `
// umbrage_exp2_steps: 2^y, an integer below 2^12 times a power of two. y is rounded down to 1/2048
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
fn umbrage_exp2_steps(y: f32) -> f32 {
    let x: f32 = floor(select(-64.0, min(y, 63.0), y > -64.0) * 2048.0);
    let n: f32 = floor(x * (1.0 / 2048.0));
    let f: f32 = max(x - n * 2048.0, 0.0);  // not negative already: no sum is regrouped across the max
    let g: f32 = floor(f * (2048.0 - f) * (1.0 / 256.0));
    let r: f32 = 1251.0 + floor(f * 314.0 * (1.0 / 2048.0));
    let m: f32 = 2048.0 + f - floor((g * r + 16384.0) * (1.0 / 32768.0));
    return m * (1.0 / 2048.0) * umbrage_power_of_two(n);
}
` };

export const chebyshev = { language, name: "chebyshev", summary: "upper bound on visibility from mean and variance",
    exactness: "c", operations: 11, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_chebyshev: upper bound on the fraction of depths at the receiver's depth or farther. 0.0 for NaN
//   m              mean of the depths, mean of their squares
//   receiver       receiver depth, on the same scale
//   min_variance   0.0 or more
fn umbrage_chebyshev(m: vec2f, receiver: f32, min_variance: f32) -> f32 {
    let difference: f32 = m.y - m.x * m.x;
    let variance: f32 = select(min_variance, difference, difference > min_variance);
    let distance: f32 = receiver - m.x;
    let sum: f32 = variance + distance * distance;
    let p: f32 = variance / sum;
    return select(select(0.0, min(p, 1.0), p > 0.0), 1.0, receiver <= m.x);  // a GPU's v / v may be more than 1.0
}
` };

export const reduce_light_bleeding = { language, name: "reduce_light_bleeding", summary: "visibility above a threshold, stretched to [0, 1]",
    exactness: "c", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_reduce_light_bleeding: visibility from amount to 1.0, stretched to 0.0 to 1.0
fn umbrage_reduce_light_bleeding(visibility: f32, amount: f32) -> f32 {
    let stretched: f32 = (visibility - amount) / (1.0 - amount);
    return select(0.0, stretched, visibility > amount);
}
` };

export const encode_vsm = { language, name: "encode_vsm", summary: "depth to a texel of a variance shadow map (VSM)",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, to_forward_depth], text: `
// umbrage_encode_vsm: texel of a variance shadow map, depth and its square. NaN counts as far
fn umbrage_encode_vsm(depth: f32) -> vec2f {
    let d: f32 = umbrage_to_forward_depth(umbrage_saturate(depth));
    return vec2f(d, d * d);
}
` };

export const decode_vsm = { language, name: "decode_vsm", summary: "mean of VSM texels to visibility",
    exactness: "c", operations: 13, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [chebyshev, to_forward_depth], text: `
// umbrage_decode_vsm: visibility of a receiver from a variance shadow map, at least its lit fraction. 1.0 = lit
//   m              mean of texels
//   receiver       receiver depth, bias applied
//   min_variance   0.0 or more
fn umbrage_decode_vsm(m: vec2f, receiver: f32, min_variance: f32) -> f32 {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}
` };

export const encode_deviation = { language, name: "encode_deviation", summary: "two moments of depth (VSM) to mean and deviation",
    exactness: "c", operations: 7, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_encode_deviation: mean and mean square of depths to mean and twice the standard deviation, each 0.0 to 1.0
fn umbrage_encode_deviation(m: vec2f) -> vec2f {
    let variance: f32 = m.y - m.x * m.x;
    return vec2f(m.x, 2.0 * sqrt(select(0.0, variance, variance > 0.0)));
}
` };

export const decode_deviation = { language, name: "decode_deviation", summary: "mean and deviation to two moments of depth (VSM)",
    exactness: "b", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
fn umbrage_decode_deviation(held: vec2f) -> vec2f {
    let half_of_it: f32 = held.y * 0.5;
    let square: f32 = held.x * held.x + half_of_it * half_of_it;
    return vec2f(held.x, square);
}
` };

export const decode_deviation_rgba8 = { language, name: "decode_deviation_rgba8", summary: "mean and deviation in RGBA8 to two moments (VSM)",
    exactness: "b", operations: 21, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [decode_deviation, decode_rg16], text: `
// umbrage_decode_deviation_rgba8: RGBA8 mean and deviation to mean and mean square of depths
//   c   as sampled, mean in xy and deviation in zw
fn umbrage_decode_deviation_rgba8(c: vec4f) -> vec2f {
    let mean: f32 = umbrage_decode_rg16(vec2f(c.x, c.y), 1.0);
    let deviation: f32 = umbrage_decode_rg16(vec2f(c.z, c.w), 1.0);
    return umbrage_decode_deviation(vec2f(mean, deviation));
}
` };

export const exponential_warp = { language, name: "exponential_warp", summary: "depth on the scale of exponential shadow maps",
    exactness: "b", operations: 31, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [exp2_polynomial], text: `
// umbrage_exponential_warp: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
fn umbrage_exponential_warp(depth: f32, exponent: f32) -> f32 {
    let y: f32 = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
` };

export const encode_esm = { language, name: "encode_esm", summary: "depth to a texel of an exponential shadow map (ESM)",
    exactness: "b", operations: 36, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, to_forward_depth, exponential_warp], text: `
// umbrage_encode_esm: texel of an exponential shadow map, from depth in [0, 1]. NaN counts as far
fn umbrage_encode_esm(depth: f32, exponent: f32) -> f32 {
    return umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
}
` };

export const decode_esm = { language, name: "decode_esm", summary: "mean of ESM texels to visibility",
    exactness: "b", operations: 37, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [to_forward_depth, exponential_warp], text: `
// umbrage_decode_esm: visibility of a receiver from an exponential shadow map, at least its lit fraction. 1.0 = lit
//   m          mean of texels
//   receiver   receiver depth, bias applied
//   exponent   same as for the texels
fn umbrage_decode_esm(m: f32, receiver: f32, exponent: f32) -> f32 {
    let d: f32 = umbrage_to_forward_depth(receiver);
    let p: f32 = m * umbrage_exponential_warp(d, -exponent);
    let lit: f32 = select(select(0.0, 1.0, p >= 1.0), p, p > 0.0 && p < 1.0);
    return select(select(0.0, lit, d <= 0.0), lit, d > 0.0);
}
` };

export const encode_evsm2 = { language, name: "encode_evsm2", summary: "depth to an EVSM texel of two components",
    exactness: "b", operations: 73, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, to_forward_depth, exponential_warp], text: `
// umbrage_encode_evsm2: texel of two components, a power of depth and its square. NaN counts as far
fn umbrage_encode_evsm2(depth: f32, exponent: f32) -> vec2f {
    let w: f32 = umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
    return vec2f(w, w * w);
}
` };

export const encode_evsm4 = { language, name: "encode_evsm4", summary: "depth to an EVSM texel of four components",
    exactness: "b", operations: 73, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, to_forward_depth, exponential_warp], text: `
// umbrage_encode_evsm4: texel of four components, a growing power, its square, a negative falling power, its square
// NaN counts as far
fn umbrage_encode_evsm4(depth: f32, exponents: vec2f) -> vec4f {
    let d: f32 = umbrage_to_forward_depth(umbrage_saturate(depth));
    let w: f32 = umbrage_exponential_warp(d, exponents.x);
    let n: f32 = -umbrage_exponential_warp(d, -exponents.y);
    return vec4f(w, w * w, n, n * n);
}
` };

export const decode_evsm2 = { language, name: "decode_evsm2", summary: "mean of EVSM texels of two components to visibility",
    exactness: "c", operations: 229, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [chebyshev, to_forward_depth, saturate, exponential_warp], text: `
// umbrage_decode_evsm2: visibility of a receiver from a mean of texels, at least its lit fraction. 1.0 = lit
//   m           mean of texels
//   receiver    receiver depth in [0, 1], bias applied
//   exponent    same as for the texels
//   deviation   minimum standard deviation, relative to the receiver's power
fn umbrage_decode_evsm2(m: vec2f, receiver: f32, exponent: f32, deviation: f32) -> f32 {
    let d: f32 = umbrage_to_forward_depth(umbrage_saturate(receiver));
    let w: f32 = umbrage_exponential_warp(d, exponent);
    let least: f32 = deviation * w;
    let least_variance: f32 = least * least;
    let lit: f32 = umbrage_chebyshev(m, w, least_variance);
    return select(select(0.0, lit, receiver <= 0.0), lit, receiver > 0.0);
}
` };

export const decode_evsm4 = { language, name: "decode_evsm4", summary: "mean of EVSM texels of four components to visibility",
    exactness: "c", operations: 229, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [chebyshev, to_forward_depth, saturate, exponential_warp], text: `
// umbrage_decode_evsm4: visibility of a receiver from a mean of texels, at least its lit fraction. 1.0 = lit
//   m            mean of texels
//   receiver     receiver depth in [0, 1], bias applied
//   exponents    same as for the texels
//   deviations   minimum standard deviations, relative to the receiver's powers
fn umbrage_decode_evsm4(m: vec4f, receiver: f32, exponents: vec2f, deviations: vec2f) -> f32 {
    let d: f32 = umbrage_to_forward_depth(umbrage_saturate(receiver));
    let w: f32 = umbrage_exponential_warp(d, exponents.x);
    let n: f32 = -umbrage_exponential_warp(d, -exponents.y);
    let least: vec2f = deviations * vec2f(w, n);
    let least_variance: vec2f = least * least;
    let a: f32 = umbrage_chebyshev(vec2f(m.x, m.y), w, least_variance.x);
    let b: f32 = umbrage_chebyshev(vec2f(m.z, m.w), n, least_variance.y);
    let lit: f32 = select(b, a, a < b);
    return select(select(0.0, lit, receiver <= 0.0), lit, receiver > 0.0);
}
` };

export const encode_msm = { language, name: "encode_msm", summary: "depth to a texel of a moment shadow map (MSM)",
    exactness: "b", operations: 15, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, to_forward_depth], text: `
// umbrage_encode_msm: first four powers of depth on -1.0 to 1.0, the texel of a moment shadow map. NaN counts as far
fn umbrage_encode_msm(depth: f32) -> vec4f {
    let z: f32 = umbrage_to_forward_depth(umbrage_saturate(depth)) * 2.0 - 1.0;
    let square: f32 = z * z;
    return vec4f(z, square, square * z, square * square);
}
` };

export const to_optimized_moments = { language, name: "to_optimized_moments", summary: "four moments (MSM) to four 16-bit channels",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_to_optimized_moments: four moments for four 16-bit channels, each over all of 0.0 to 1.0
fn umbrage_to_optimized_moments(b: vec4f) -> vec4f {
    let x: f32 = (b.x * 0.75 - b.z) * 2.0 + 0.5;
    let y: f32 = (b.y - b.w) * 4.0;
    let z: f32 = (b.x * 2.25 - b.z) * 0.384900182 + 0.5;
    let w: f32 = (b.y + b.w) * 0.5;
    return vec4f(x, y, z, w);
}
` };

export const hausdorff_share = { language, name: "hausdorff_share", summary: "smallest fraction of nearer depths, for depths on [-1, 1]",
    exactness: "c", operations: 0, within: 9.5367431640625e-07, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_hausdorff_share: smallest fraction of depths nearer than the receiver, from four moments of depths on [-1, 1]
// Returns a negative number where umbrage_moment_atoms gives the fraction
//   b   moments, biased
//   z   the receiver's depth on -1.0 to 1.0
fn umbrage_hausdorff_share(b: vec4f, z: f32) -> f32 {
    let variance: f32 = b.y - b.x * b.x;
    let third: f32 = b.z - b.x * b.y;
    let fourth: f32 = b.w - b.y * b.y;
    let rest: f32 = 1.0 - b.y;
    let x: f32 = z - b.x;
    let d: f32 = third + rest * x;
    let g: f32 = (fourth - variance * rest) - (z + b.x) * third;
    let p: f32 = d * (1.0 + b.x) + g;
    let q: f32 = d * (1.0 - b.x) - g;
    let k: f32 = rest * g + third * d;
    let first: f32 = (1.0 + z) * (d * variance + g * (1.0 - b.x)) - k;
    let last: f32 = (1.0 - z) * (d * variance - g * (1.0 + b.x)) + k;
    let square: f32 = d * d;
    let between: f32 = p * (q * (x * d - g));
    let end: f32 = first / (2.0 * ((1.0 + z) * p));
    let other: f32 = square * square / between;
    let share: f32 = end + select(0.0, other, d > 0.0);
    let four: bool = first * p > 0.0 && last * q > 0.0 && p * q > 0.0 && share >= 0.0;
    return select(select(-1.0, select(1.0, share, share < 1.0), four), 0.0, z <= -1.0);
}
` };

export const decode_msm_hausdorff = { language, name: "decode_msm_hausdorff", summary: "mean of MSM texels to visibility, for depths on [-1, 1]",
    exactness: "c", operations: 0, within: 0.015625, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [bias_moments, decode_msm, to_forward_depth, hausdorff_share], text: `
// umbrage_decode_msm_hausdorff: visibility of a receiver, at least its lit fraction minus bias.x. 1.0 = lit
//   b          mean of texels
//   receiver   receiver depth in [0, 1], bias applied
//   bias       (3e-6, 0.375)
fn umbrage_decode_msm_hausdorff(b: vec4f, receiver: f32, bias: vec2f) -> f32 {
    let plain: f32 = umbrage_decode_msm(b, receiver, bias);
    let d: f32 = umbrage_to_forward_depth(receiver);
    let z: f32 = select(0.0, select(1.0, d, d < 1.0), d > 0.0) * 2.0 - 1.0;
    let share: f32 = umbrage_hausdorff_share(umbrage_bias_moments(b, bias), z);
    let lit: f32 = select(plain, 1.0 - share, share >= 0.0);
    return select(select(0.0, lit, d <= 0.0), lit, d > 0.0);
}
` };

export const fetch_bilinear = { language, name: "fetch_bilinear", summary: "bilinear mean of the four texels around a point",
    exactness: "b", operations: 19, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [fetch_clamped], text: `
// umbrage_fetch_bilinear: bilinear mean of the four texels around a point, weights in steps of 1/256
//   coord   in texels. (0.5, 0.5) is the center of the first texel
fn umbrage_fetch_bilinear(map: texture_2d<f32>, size: vec2f, coord: vec2f) -> vec4f {
    let x: vec2f = floor(coord * 256.0) - 128.0;
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already. The clamp keeps compilers from regrouping sums across it
    let hi: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0)) * 256.0;
    let lo: vec2f = 256.0 - hi;  // 1.0 - hi would become an interpolation, which rounds differently
    let a: vec4f = umbrage_fetch_clamped(map, size, texel);
    let b: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(1.0, 0.0));
    let c: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(0.0, 1.0));
    let d: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(1.0, 1.0));
    let low: vec4f = a * lo.x + b * hi.x;
    let high: vec4f = c * lo.x + d * hi.x;
    let sum: vec4f = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
` };

const write_vsm = { language, name: "write", summary: "texel of a depth, as a color",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, encode_vsm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
fn umbrage_write(depth: f32) -> vec4f {
    let texel: vec2f = umbrage_encode_vsm(depth);
    return vec4f(texel.x, texel.y, 0.0, 0.0);
}
` };

export const vsm = { language, name: "vsm", summary: "visibility from a blurred variance shadow map (VSM)",
    exactness: "c", operations: 165, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, fetch_bilinear, decode_vsm], filter: { reads: "moments", reach: 1, arguments: [{ name: "min_variance", type: "float", value: 1e-06 }], in_shadow: true, format: "RG32F", cleared: [1, 1, 0, 0], cleared_reversed: [1, 1, 0, 0], write: write_vsm }, text: `
// umbrage_vsm: visibility from a blurred map of encode_vsm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. min_variance: 0.0 or more
fn umbrage_vsm(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, min_variance: f32) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_vsm(vec2f(m.x, m.y), receiver, min_variance);
    return select(1.0, lit, compared);
}
` };

const write_esm = { language, name: "write", summary: "texel of a depth, as a color",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, encode_esm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
fn umbrage_write(depth: f32, filter_terms: vec4f) -> vec4f {
    let texel: f32 = umbrage_encode_esm(depth, filter_terms.x);
    return vec4f(texel, 0.0, 0.0, 0.0);
}
` };

export const esm = { language, name: "esm", summary: "visibility from a blurred exponential shadow map (ESM)",
    exactness: "b", operations: 56, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, fetch_bilinear, decode_esm], filter: { reads: "moments", reach: 1, arguments: [{ name: "exponent", type: "float", value: 40 }], in_shadow: true, format: "R32F", cleared: [1099511627776, 0, 0, 0], cleared_reversed: [1099511627776, 0, 0, 0], write: write_esm }, text: `
// umbrage_esm: visibility from a blurred map of encode_esm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. exponent: same as for the texels
fn umbrage_esm(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, exponent: f32) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_esm(m.x, receiver, exponent);
    return select(1.0, lit, compared);
}
` };

const write_evsm2 = { language, name: "write", summary: "texel of a depth, as a color",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, encode_evsm2], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
fn umbrage_write(depth: f32, filter_terms: vec4f) -> vec4f {
    let texel: vec2f = umbrage_encode_evsm2(depth, filter_terms.x);
    return vec4f(texel.x, texel.y, 0.0, 0.0);
}
` };

export const evsm2 = { language, name: "evsm2", summary: "visibility from a blurred EVSM of two components",
    exactness: "c", operations: 267, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, fetch_bilinear, decode_evsm2], filter: { reads: "moments", reach: 1, arguments: [{ name: "exponent", type: "float", value: 40 }, { name: "deviation", type: "float", value: 0.0055451775 }], in_shadow: true, format: "RG32F", cleared: [1099511627776, 1.2089258e+24, 0, 0], cleared_reversed: [1099511627776, 1.2089258e+24, 0, 0], write: write_evsm2 }, text: `
// umbrage_evsm2: visibility from a blurred map of encode_evsm2's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. exponent, deviation: as for decode_evsm2
fn umbrage_evsm2(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, exponent: f32, deviation: f32) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_evsm2(vec2f(m.x, m.y), receiver, exponent, deviation);
    return select(1.0, lit, compared);
}
` };

const write_evsm4 = { language, name: "write", summary: "texel of a depth, as a color",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, encode_evsm4], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
fn umbrage_write(depth: f32, filter_terms: vec4f) -> vec4f {
    let texel: vec4f = umbrage_encode_evsm4(depth, vec2f(filter_terms.x, filter_terms.y));
    return vec4f(texel.x, texel.y, texel.z, texel.w);
}
` };

export const evsm4 = { language, name: "evsm4", summary: "visibility from a blurred EVSM of four components",
    exactness: "c", operations: 267, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, fetch_bilinear, decode_evsm4], filter: { reads: "moments", reach: 1, arguments: [{ name: "exponents", type: "vec2", value: [40, 8] }, { name: "deviations", type: "vec2", value: [0.0055451775, 0.0011090355] }], in_shadow: true, format: "RGBA32F", cleared: [1099511627776, 1.2089258e+24, -0.00390625, 1.5258789e-05], cleared_reversed: [1099511627776, 1.2089258e+24, -0.00390625, 1.5258789e-05], write: write_evsm4 }, text: `
// umbrage_evsm4: visibility from a blurred map of encode_evsm4's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. exponents, deviations: as for decode_evsm4
fn umbrage_evsm4(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, exponents: vec2f,
                 deviations: vec2f) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_evsm4(m, receiver, exponents, deviations);
    return select(1.0, lit, compared);
}
` };

const write_msm = { language, name: "write", summary: "texel of a depth, as a color",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, encode_msm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
fn umbrage_write(depth: f32) -> vec4f {
    let texel: vec4f = umbrage_encode_msm(depth);
    return vec4f(texel.x, texel.y, texel.z, texel.w);
}
` };

export const msm = { language, name: "msm", summary: "visibility from a blurred moment shadow map (MSM)",
    exactness: "c", operations: 0, within: 0.015625, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, fetch_bilinear, decode_msm], filter: { reads: "moments", reach: 1, arguments: [{ name: "bias", type: "vec2", value: [3e-06, 0.375] }], in_shadow: true, format: "RGBA32F", cleared: [1, 1, 1, 1], cleared_reversed: [1, 1, 1, 1], write: write_msm }, text: `
// umbrage_msm: visibility from a blurred map of encode_msm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
fn umbrage_msm(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, bias: vec2f) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_msm(m, receiver, bias);
    return select(1.0, lit, compared);
}
` };

const write_msm_unorm16 = { language, name: "write", summary: "texel of a depth, as a color",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, encode_msm, to_optimized_moments], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
fn umbrage_write(depth: f32) -> vec4f {
    let texel: vec4f = umbrage_to_optimized_moments(umbrage_encode_msm(depth));
    return vec4f(texel.x, texel.y, texel.z, texel.w);
}
` };

export const msm_unorm16 = { language, name: "msm_unorm16", summary: "visibility from a blurred MSM of optimized moments",
    exactness: "c", operations: 0, within: 0.015625, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, fetch_bilinear, decode_msm, from_optimized_moments], filter: { reads: "moments", reach: 1, arguments: [{ name: "bias", type: "vec2", value: [6e-05, 0.628] }], in_shadow: true, format: "RGBA16", cleared: [0, 0, 0.98112524, 1], cleared_reversed: [0, 0, 0.98112524, 1], write: write_msm_unorm16 }, text: `
// umbrage_msm_unorm16: visibility from a blurred map of optimized moments, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
fn umbrage_msm_unorm16(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, bias: vec2f) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_msm(umbrage_from_optimized_moments(m), receiver, bias);
    return select(1.0, lit, compared);
}
` };

const write_msm_hausdorff = { language, name: "write", summary: "texel of a depth, as a color",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, encode_msm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
fn umbrage_write(depth: f32) -> vec4f {
    let texel: vec4f = umbrage_encode_msm(depth);
    return vec4f(texel.x, texel.y, texel.z, texel.w);
}
` };

export const msm_hausdorff = { language, name: "msm_hausdorff", summary: "visibility from a blurred MSM, for depths on [-1, 1]",
    exactness: "c", operations: 0, within: 0.015625, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, fetch_bilinear, decode_msm_hausdorff], filter: { reads: "moments", reach: 1, arguments: [{ name: "bias", type: "vec2", value: [3e-06, 0.375] }], in_shadow: true, format: "RGBA32F", cleared: [1, 1, 1, 1], cleared_reversed: [1, 1, 1, 1], write: write_msm_hausdorff }, text: `
// umbrage_msm_hausdorff: visibility from a blurred map of encode_msm's texels, for depths on [-1, 1]. 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
fn umbrage_msm_hausdorff(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, bias: vec2f) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_msm_hausdorff(m, receiver, bias);
    return select(1.0, lit, compared);
}
` };

export const chebyshev_hardware = { language, name: "chebyshev_hardware", summary: "Chebyshev bound with light bleeding reduced",
    exactness: "c", operations: 0, within: 1.9073486328125e-06, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_chebyshev_hardware: upper bound on visibility with light bleeding reduced
//   variance   above 0.0
//   distance   from the mean to the receiver, no NaN
//   amount     visibility that becomes 0.0, 0.0 to 0.5
fn umbrage_chebyshev_hardware(variance: f32, distance: f32, amount: f32) -> f32 {
    let beyond: f32 = max(distance, 0.0);
    let p: f32 = variance / (variance + beyond * beyond);
    return clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
}
` };

export const decode_vsm_hardware = { language, name: "decode_vsm_hardware", summary: "mean and deviation (VSM) to visibility, cheapest on GPUs",
    exactness: "c", operations: 0, within: 0.0009765625, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [chebyshev_hardware, to_forward_depth], text: `
// umbrage_decode_vsm_hardware: visibility of a receiver with light bleeding reduced. 1.0 = lit
//   held           mean and twice the standard deviation of depths, filtered
//   receiver       receiver depth, bias applied
//   min_variance   1e-7 or more
//   amount         visibility that becomes 0.0, 0.0 to 0.5
fn umbrage_decode_vsm_hardware(held: vec2f, receiver: f32, min_variance: f32, amount: f32) -> f32 {
    let variance: f32 = max(held.y * held.y * 0.25, min_variance);
    let distance: f32 = umbrage_to_forward_depth(receiver) - held.x;
    let lit: f32 = umbrage_chebyshev_hardware(variance, distance, amount);
    return select(0.0, lit, abs(receiver) < 1048576.0);
}
` };

export const decode_evsm2_hardware = { language, name: "decode_evsm2_hardware", summary: "EVSM of two components to visibility, by the GPU's exp2",
    exactness: "c", operations: 0, within: 0.015625, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [chebyshev_hardware, to_forward_depth], text: `
// umbrage_decode_evsm2_hardware: visibility of a receiver with light bleeding reduced. 1.0 = lit
//   m           mean of texels
//   receiver    receiver depth in [0, 1], bias applied
//   exponent    same as for the texels
//   deviation   minimum standard deviation, relative to the receiver's power
//   amount      visibility that becomes 0.0, 0.0 to 0.3
fn umbrage_decode_evsm2_hardware(m: vec2f, receiver: f32, exponent: f32, deviation: f32, amount: f32) -> f32 {
    let d: f32 = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0));
    let w: f32 = exp2(exponent * (d * 2.0 - 1.0));
    let least: f32 = deviation * w;
    let variance: f32 = max(m.y - m.x * m.x, least * least);
    let lit: f32 = umbrage_chebyshev_hardware(variance, w - m.x, amount);
    return select(0.0, lit, abs(receiver) < 1048576.0);
}
` };

export const decode_evsm4_hardware = { language, name: "decode_evsm4_hardware", summary: "EVSM of four components to visibility, by the GPU's exp2",
    exactness: "c", operations: 0, within: 0.015625, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [chebyshev_hardware, to_forward_depth], text: `
// umbrage_decode_evsm4_hardware: visibility of a receiver with light bleeding reduced. 1.0 = lit
//   m            mean of texels
//   receiver     receiver depth in [0, 1], bias applied
//   exponents    same as for the texels
//   deviations   minimum standard deviations, relative to the receiver's powers
//   amount       visibility that becomes 0.0, 0.0 to 0.3
fn umbrage_decode_evsm4_hardware(m: vec4f, receiver: f32, exponents: vec2f, deviations: vec2f, amount: f32) -> f32 {
    let d: f32 = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0)) * 2.0 - 1.0;
    let w: f32 = exp2(exponents.x * d);
    let n: f32 = 0.0 - exp2((0.0 - exponents.y) * d);
    let least: vec2f = deviations * vec2f(w, n);
    let growing: f32 = max(m.y - m.x * m.x, least.x * least.x);
    let falling: f32 = max(m.w - m.z * m.z, least.y * least.y);
    let a: f32 = umbrage_chebyshev_hardware(growing, w - m.x, amount);
    let b: f32 = umbrage_chebyshev_hardware(falling, n - m.z, amount);
    return select(0.0, min(a, b), abs(receiver) < 1048576.0);
}
` };

export const blur_row3 = { language, name: "blur_row3", summary: "binomial mean of texels in a row, for blurs",
    exactness: "b", operations: 7, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [fetch_clamped], text: `
// umbrage_blur_row3: mean of 3 texels in a row, with the weights of a row of Pascal's triangle
//   map, size   map that is read, and its size in texels
//   texel       index of the texel, integers. (0, 0) is the first
//   along       (1.0, 0.0) or (0.0, 1.0)
fn umbrage_blur_row3(map: texture_2d<f32>, size: vec2f, texel: vec2f, along: vec2f) -> vec4f {
    var sum: vec4f = umbrage_fetch_clamped(map, size, texel) * (2.0 / 4.0);
    let before1: vec4f = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    let after1: vec4f = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (1.0 / 4.0);
    return sum;
}
` };

export const blur_row5 = { language, name: "blur_row5", summary: "binomial mean of texels in a row, for blurs",
    exactness: "b", operations: 12, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [fetch_clamped], text: `
// umbrage_blur_row5: mean of 5 texels in a row, with the weights of a row of Pascal's triangle
//   map, size   map that is read, and its size in texels
//   texel       index of the texel, integers. (0, 0) is the first
//   along       (1.0, 0.0) or (0.0, 1.0)
fn umbrage_blur_row5(map: texture_2d<f32>, size: vec2f, texel: vec2f, along: vec2f) -> vec4f {
    var sum: vec4f = umbrage_fetch_clamped(map, size, texel) * (6.0 / 16.0);
    let before1: vec4f = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    let after1: vec4f = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (4.0 / 16.0);
    let before2: vec4f = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    let after2: vec4f = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (1.0 / 16.0);
    return sum;
}
` };

export const blur_row7 = { language, name: "blur_row7", summary: "binomial mean of texels in a row, for blurs",
    exactness: "b", operations: 17, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [fetch_clamped], text: `
// umbrage_blur_row7: mean of 7 texels in a row, with the weights of a row of Pascal's triangle
//   map, size   map that is read, and its size in texels
//   texel       index of the texel, integers. (0, 0) is the first
//   along       (1.0, 0.0) or (0.0, 1.0)
fn umbrage_blur_row7(map: texture_2d<f32>, size: vec2f, texel: vec2f, along: vec2f) -> vec4f {
    var sum: vec4f = umbrage_fetch_clamped(map, size, texel) * (20.0 / 64.0);
    let before1: vec4f = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    let after1: vec4f = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (15.0 / 64.0);
    let before2: vec4f = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    let after2: vec4f = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (6.0 / 64.0);
    let before3: vec4f = umbrage_fetch_clamped(map, size, texel - along * 3.0);
    let after3: vec4f = umbrage_fetch_clamped(map, size, texel + along * 3.0);
    sum = sum + (before3 + after3) * (1.0 / 64.0);
    return sum;
}
` };

export const halve_texels = { language, name: "halve_texels", summary: "mean of 2x2 texels, for mip chains",
    exactness: "b", operations: 8, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [fetch_clamped], text: `
// umbrage_halve_texels: mean of the 2x2 texels behind one texel of the next mip level
//   map, size   map that is read, and its size in texels
//   texel       index in the next level, integers
fn umbrage_halve_texels(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    let at: vec2f = texel * 2.0;
    let a: vec4f = umbrage_fetch_clamped(map, size, at);
    let b: vec4f = umbrage_fetch_clamped(map, size, at + vec2f(1.0, 0.0));
    let c: vec4f = umbrage_fetch_clamped(map, size, at + vec2f(0.0, 1.0));
    let d: vec4f = umbrage_fetch_clamped(map, size, at + vec2f(1.0, 1.0));
    let sum: vec4f = (a + b) + (c + d);
    return sum * 0.25;
}
` };

export const texels_to_world = { language, name: "texels_to_world", summary: "texels across a light to world units",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_texels_to_world: texels across a light as world units; 0.0 for w <= 0.0
//   units  (edge of a texel, depth per world unit) at w = 1.0
//   w      w of the point's shadow coordinate
fn umbrage_texels_to_world(texels: f32, units: vec2f, w: f32) -> f32 {
    let world: f32 = texels * units.x * w;
    return select(0.0, world, world >= (1.0 / 18446744073709551616.0) && world < 18446744073709551616.0);
}
` };

export const clamp_bias = { language, name: "clamp_bias", summary: "clamp of a bias to [0, 1]; NaN becomes 1",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_clamp_bias: bias in depth clamped to [0, 1]; 0.0 below 2^-64, and 1.0 (no shadows) for NaN
fn umbrage_clamp_bias(bias: f32) -> f32 {
    let least: f32 = (1.0 / 18446744073709551616.0);
    return select(1.0, select(0.0, bias, bias >= least), bias < 1.0);
}
` };

export const world_to_depth = { language, name: "world_to_depth", summary: "world units along a light to depth",
    exactness: "c", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [clamp_bias], text: `
// umbrage_world_to_depth: world units along a light as depth, 0.0 to 1.0
//   units  (edge of a texel, depth per world unit) at w = 1.0
//   w      w of the point's shadow coordinate, above 0.0
fn umbrage_world_to_depth(world: f32, units: vec2f, w: f32) -> f32 {
    let along: f32 = world * units.y;
    let square: f32 = w * w;
    return umbrage_clamp_bias(along / square);
}
` };

export const biased = { language, name: "biased", summary: "receiver moved towards the light",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_biased: receiver moved towards the light by bias, in depth; no move for NaN, or magnitudes of 2^64 or more
fn umbrage_biased(receiver: f32, bias: f32) -> f32 {
    let by: f32 = select(0.0, bias, abs(bias) < 18446744073709551616.0);
    return select(receiver + by, receiver - by, umbrage_cleared_depth() > 0.5);
}
` };

export const clamp_slope = { language, name: "clamp_slope", summary: "clamp of a slope to [-2, 2]; NaN becomes 2",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_clamp_slope: change of depth per texel clamped to [-2, 2]; NaN becomes 2.0
fn umbrage_clamp_slope(slope: f32) -> f32 {
    return select(select(2.0, -2.0, slope <= -2.0), slope, abs(slope) < 2.0);
}
` };

export const plane_in_map = { language, name: "plane_in_map", summary: "normal of a plane in a map",
    exactness: "b", operations: 12, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
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
` };

export const plane_slope = { language, name: "plane_slope", summary: "change of a plane's depth per texel",
    exactness: "c", operations: 27, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [clamp_slope, plane_in_map], text: `
// umbrage_plane_slope: change of depth per texel, in x and y, of the plane through a point
//   plane_matrix, normal, world   as for umbrage_plane_in_map
fn umbrage_plane_slope(plane_matrix: mat4x4f, normal: vec3f, world: vec3f) -> vec2f {
    let q: vec3f = umbrage_plane_in_map(plane_matrix, normal, world);
    return vec2f(umbrage_clamp_slope(-q.x / q.z), umbrage_clamp_slope(-q.y / q.z));
}
` };

export const receiver_slope = { language, name: "receiver_slope", summary: "change of a receiver's depth per texel",
    exactness: "c", operations: 27, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [plane_in_map], text: `
// umbrage_receiver_slope: umbrage_plane_slope without its clamps; (0.0, 0.0) for a normal of zero (the caller has none)
fn umbrage_receiver_slope(plane_matrix: mat4x4f, normal: vec3f, world: vec3f) -> vec2f {
    let q: vec3f = umbrage_plane_in_map(plane_matrix, normal, world);
    let depth: f32 = select(q.z, 1.0e-30, q.z == 0.0);  // q is zero without a normal, and not where edge-on
    return vec2f(-q.x / depth, -q.y / depth);
}
` };

export const cascade_slope = { language, name: "cascade_slope", summary: "change of a plane's depth per texel in a cascade",
    exactness: "c", operations: 6, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cascade_slope: change of depth per texel; (0.0, 0.0) for a normal of zero
//   normal  surface normal, rotated into the light's axes
//   scale   scale of the cascade
fn umbrage_cascade_slope(normal: vec3f, scale: vec4f) -> vec2f {
    let up: vec2f = vec2f(normal.x, normal.y) * -scale.z;
    let z: f32 = select(normal.z, 1.0e-18, normal.z == 0.0);  // up is zero without a normal, and not where edge-on
    let across: vec2f = vec2f(scale.x, scale.y) * z;
    return vec2f(up.x / across.x, up.y / across.y);
}
` };

export const slope_bias = { language, name: "slope_bias", summary: "slope-scaled bias, as rasterizers compute it",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [clamp_bias], text: `
// umbrage_slope_bias: factor times the larger slope, plus a base, 0.0 to 1.0
//   slope   change of depth per texel
//   factor  factor of the slope, in texels
//   base    constant bias, in depth
fn umbrage_slope_bias(slope: vec2f, factor: f32, base: f32) -> f32 {
    let bias: vec2f = abs(slope) * factor + base;
    let x: f32 = umbrage_clamp_bias(bias.x);  // clamp first: GPUs differ in the maximum of a NaN
    let y: f32 = umbrage_clamp_bias(bias.y);
    return select(y, x, x > y);
}
` };

export const dual_paraboloid_slope = { language, name: "dual_paraboloid_slope", summary: "change of distance per texel in a dual paraboloid map",
    exactness: "c", operations: 41, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [clamp_slope], text: `
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
` };

export const normal_offset = { language, name: "normal_offset", summary: "offset along the normal to the point to look up",
    exactness: "c", operations: 91, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_normal_offset: offset to add to a surface point before its lookup, world units
//   normal       surface normal, of length one
//   direction    direction of the light, of length one
//   way          from the light to the point over w; for a directional light its direction
//   width        sqrt(2) reach texel
//   error_world  error of the map's depths, world units
fn umbrage_normal_offset(normal: vec3f, direction: vec3f, way: vec3f, width: f32, error_world: f32) -> vec3f {
    let x: f32 = normal.y * direction.z + normal.z * -direction.y;
    let y: f32 = normal.z * direction.x + normal.x * -direction.z;
    let z: f32 = normal.x * direction.y + normal.y * -direction.x;
    let straight: f32 = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    let square: f32 = x * x + y * y + z * z;
    let along: f32 = width * sqrt(square) + error_world * abs(straight);
    let offset: vec3f = normal * along;
    return select(vec3f(0.0, 0.0, 0.0), offset, abs(offset.x) + abs(offset.y) + abs(offset.z) < 18446744073709551616.0);
}
` };

export const kernel_bias = { language, name: "kernel_bias", summary: "bias from kernel width and angle of the light",
    exactness: "c", operations: 30, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_kernel_bias: distance along the light that a kernel extends beyond a surface's plane, in width's unit
//   normal     surface normal
//   direction  direction of the light, of length one
//   way        from the light to the point over w; for a directional light its direction
//   width      sqrt(2) reach texel
//   greatest   limit of the tangent
fn umbrage_kernel_bias(normal: vec3f, direction: vec3f, way: vec3f, width: f32, greatest: f32) -> f32 {
    let x: f32 = normal.y * direction.z + normal.z * -direction.y;
    let y: f32 = normal.z * direction.x + normal.x * -direction.z;
    let z: f32 = normal.x * direction.y + normal.y * -direction.x;
    let square: f32 = x * x + y * y + z * z;
    let sine: f32 = sqrt(square);
    let cosine: f32 = -(normal.x * way.x + normal.y * way.y + normal.z * way.z);
    let edge: f32 = cosine * greatest;
    let tangent: f32 = select(greatest, sine / cosine, edge > sine);
    let bias: f32 = width * tangent;
    return select(0.0, bias, bias >= (1.0 / 18446744073709551616.0) && bias < 18446744073709551616.0);
}
` };

export const receiver_plane_slope = { language, name: "receiver_plane_slope", summary: "slope of a receiver's plane from derivatives, and its error",
    exactness: "c", operations: 31, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [clamp_slope], text: `
// umbrage_receiver_plane_slope: change of a receiver's depth per texel in x and y, and the largest error of their sum
//   dx, dy  dFdx and dFdy of (x and y in texels, depth); the result is zero where they do not give the plane
fn umbrage_receiver_plane_slope(dx: vec3f, dy: vec3f) -> vec3f {
    let determinant: f32 = dx.x * dy.y + dx.y * -dy.x;
    let sum: f32 = abs(dx.x) + abs(dx.y) + abs(dy.x) + abs(dy.y);
    let along_x: f32 = dy.y * dx.z + dx.y * -dy.z;
    let along_y: f32 = dx.x * dy.z + dy.x * -dx.z;
    let a: f32 = umbrage_clamp_slope(along_x / determinant);
    let b: f32 = umbrage_clamp_slope(along_y / determinant);
    let off: f32 = ((1.0 / 33554432.0) + (abs(a) + abs(b)) * (1.0 / 8192.0)) * 3.3;
    let error: f32 = off * (sum / abs(determinant));
    let least: f32 = sum * (1.0 / 1024.0);
    let known: bool = abs(determinant) > least && sum < 18446744073709551616.0;
    return select(vec3f(0.0, 0.0, 0.0), vec3f(a, b, umbrage_clamp_slope(error)), known);
}
` };

export const plane_reference = { language, name: "plane_reference", summary: "depth that a texel is compared with, by the receiver's plane",
    exactness: "b", operations: 8, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_plane_reference: depth of the receiver, or of its plane at a texel where that is nearer to the light
//   slope   slope of the receiver's plane, per texel, no NaN
//   at      receiver position in texels, and its depth, bias applied
//   texel   index of the texel
fn umbrage_plane_reference(slope: vec2f, at: vec3f, texel: vec2f) -> f32 {
    let way: vec2f = texel - (vec2f(at.x, at.y) - 0.5);
    let plane: f32 = (at.z + slope.x * way.x) + slope.y * way.y;
    return select(max(plane, at.z), min(plane, at.z), umbrage_cleared_depth() > 0.5);
}
` };

export const bordered_plane_reference = { language, name: "bordered_plane_reference", summary: "plane_reference in a map whose border is lit",
    exactness: "b", operations: 8, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_bordered_plane_reference: umbrage_plane_reference, but before every stored depth outside the map
//   slope, at, texel   as for umbrage_plane_reference
//   inside             texel if the map has it, otherwise any other
fn umbrage_bordered_plane_reference(slope: vec2f, at: vec3f, texel: vec2f, inside: vec2f) -> f32 {
    let lights: f32 = select(16777216.0, -16777216.0, umbrage_cleared_depth() > 0.5);
    let moves: vec2f = slope * (texel - (vec2f(at.x, at.y) - 0.5));
    let x: f32 = select(lights, moves.x, inside.x == texel.x);  // the same for all texels of a column
    let y: f32 = select(lights, moves.y, inside.y == texel.y);
    let plane: f32 = (at.z + x) + y;
    return select(max(plane, at.z), min(plane, at.z), umbrage_cleared_depth() > 0.5);
}
` };

export const corner_reference = { language, name: "corner_reference", summary: "depth that four texels are compared with, by the receiver's plane",
    exactness: "c", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_corner_reference: depth of the receiver, or of its plane where four texels meet, the nearer to the light
//   slope      slope of the receiver's plane, per texel, no NaN
//   way        from the receiver to where the texels meet, in texels
//   receiver   depth, bias applied
fn umbrage_corner_reference(slope: vec2f, way: vec2f, receiver: f32) -> f32 {
    let plane: f32 = (receiver + slope.x * way.x) + slope.y * way.y;
    return select(max(plane, receiver), min(plane, receiver), umbrage_cleared_depth() > 0.5);
}
` };

export const apply_receiver_plane = { language, name: "apply_receiver_plane", summary: "stored depth, or the far plane's if lit along the receiver's plane",
    exactness: "b", operations: 8, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, compare, plane_reference], text: `
// umbrage_apply_receiver_plane: depth of a texel that shadows the receiver's plane; any other has the far plane's
//   stored  depth of the texel
//   slope   slope of the receiver's plane, per texel
//   at      receiver position in texels, and its depth, bias applied
//   texel   index of the texel
fn umbrage_apply_receiver_plane(stored: f32, slope: vec2f, at: vec3f, texel: vec2f) -> f32 {
    let lit: f32 = umbrage_compare(umbrage_plane_reference(slope, at, texel), stored);
    return select(stored, umbrage_cleared_depth(), lit > 0.5);
}
` };

export const acne_free_bias = { language, name: "acne_free_bias", summary: "bias without acne, from slope, reach and error",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [clamp_bias], text: `
// umbrage_acne_free_bias: bias in depth without shadow acne, 0.0 to 1.0
//   slope  change of depth per texel, in x and y
//   reach  filter radius, in texels
//   error  largest error of a decoded depth towards the light
fn umbrage_acne_free_bias(slope: vec2f, reach: f32, error: f32) -> f32 {
    let bias: f32 = reach * (abs(slope.x) + abs(slope.y)) + (error + (1.0 / 8388608.0));
    return umbrage_clamp_bias(bias);
}
` };

export const acne_free_disc_bias = { language, name: "acne_free_disc_bias", summary: "bias without acne, for filters that read a disc",
    exactness: "c", operations: 13, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [clamp_bias], text: `
// umbrage_acne_free_disc_bias: bias in depth without shadow acne for a disc, 0.0 to 1.0
//   slope   change of depth per texel, in x and y
//   radius  distance to the disc's farthest point, in texels
//   error   largest error of a decoded depth towards the light
fn umbrage_acne_free_disc_bias(slope: vec2f, radius: f32, error: f32) -> f32 {
    let square: f32 = slope.x * slope.x + slope.y * slope.y;
    let beside: f32 = (abs(slope.x) + abs(slope.y)) * 0.5078125 + (error + (1.0 / 8388608.0));
    let bias: f32 = radius * sqrt(square) + beside;
    return umbrage_clamp_bias(bias);
}
` };

export const peter_panning_distance = { language, name: "peter_panning_distance", summary: "depth within which a bias detaches shadows (peter-panning)",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [acne_free_bias], text: `
// umbrage_peter_panning_distance: depth, 0.0 to 1.0, within which casters lose their shadow or part of it
//   bias          bias of the receiver, in depth
//   caster_slope  change of the caster's depth per texel
//   reach         filter radius, in texels
fn umbrage_peter_panning_distance(bias: f32, caster_slope: vec2f, reach: f32) -> f32 {
    return umbrage_acne_free_bias(caster_slope, reach, bias);
}
` };

export const spot_cone = { language, name: "spot_cone", summary: "1 inside a spot light's cone, else 0",
    exactness: "b", operations: 11, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_spot_cone: 1.0 inside the cone of a spot light, else 0.0
//   direction  of the light, unit length;   to_point  from the light, any length;   cos_outer  in [0, 1)
fn umbrage_spot_cone(direction: vec3f, to_point: vec3f, cos_outer: f32) -> f32 {
    let d: f32 = direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    let length2: f32 = to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    let edge2: f32 = cos_outer * cos_outer * length2;
    let d2: f32 = d * d;
    return select(0.0, 1.0, d > 0.0 && d2 > edge2);
}
` };

export const diffuse_ambient = { language, name: "diffuse_ambient", summary: "diffuse plus ambient light of a surface",
    exactness: "b", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_diffuse_ambient: albedo * (visibility * n_dot_l * (1 - ambient) + ambient)
//   for n_dot_l <= 0.0 and NaN: albedo * ambient
fn umbrage_diffuse_ambient(albedo: vec3f, ambient: vec3f, n_dot_l: f32, visibility: f32) -> vec3f {
    let light: vec3f = visibility * n_dot_l * (1.0 - ambient) + ambient;
    return albedo * select(ambient, light, n_dot_l > 0.0);  // max gives NaN for a signalling NaN on Mesa
}
` };

export const false_color = { language, name: "false_color", summary: "depth 0..1 as a color from blue over green to red",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_false_color: blue for 0.0, through green, to red for 1.0
fn umbrage_false_color(v: f32) -> vec3f {
    let x: f32 = umbrage_saturate(v) * 4.0;
    let ramp: vec3f = 1.5 - abs(vec3f(x - 3.0, x - 2.0, x - 1.0));
    return vec3f(umbrage_saturate(ramp.x), umbrage_saturate(ramp.y), umbrage_saturate(ramp.z));
}
` };

export const overlay_texel = { language, name: "overlay_texel", summary: "texel under a pixel of a map drawn in the picture's corner",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_overlay_texel: texel under a pixel of a map drawn in the picture's corner; -1.0 outside the overlay
//   coord             center of the pixel, counted from the corner: 0.5, 1.5, ...
//   size              size of the overlay in pixels, an integer
//   map_size          size of the map in texels, an integer, at most 65536.0; times size at most 2^23
//   texels_per_pixel  map_size / size
fn umbrage_overlay_texel(coord: f32, size: f32, map_size: f32, texels_per_pixel: f32) -> f32 {
    var texel: f32 = floor(coord * texels_per_pixel - 0.5);
    texel += select(0.0, 1.0, (texel + 1.0) * size <= coord * map_size);
    return select(-1.0, texel, coord >= 0.0 && coord < size);
}
` };

export const probe_color = { language, name: "probe_color", summary: "debug color of a lookup: its texels, or why it fails",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_probe_color: debug color of a receiver's position in a map
//   at      x and y in texels, z depth
//   size    size of the map, in texels
//   bias    bias of the receiver, in depth
//   number  index of the map, an integer
//   magenta  not a number
//   black    behind the light
//   white    outside the map, or all cascades
//   cyan     beyond the far plane
//   blue     in front of the near plane
//   red      bias at its limit of 1.0
//   else     squares of one texel, gray or in the map's color: all is well
fn umbrage_probe_color(at: vec3f, size: vec2f, bias: f32, number: f32) -> vec3f {
    let limit: f32 = 18446744073709551616.0;
    // limits differ on purpose: Mesa makes max(x, y) < limit of equal ones, which loses a NaN
    let usable: bool = abs(at.x) < limit && abs(at.y) * 2.0 < limit * 2.0 && abs(at.z) * 4.0 < limit * 4.0;
    let inside: bool = at.x >= 0.0 && at.y >= 0.0 && at.x <= size.x && at.y <= size.y;
    let forward: bool = umbrage_cleared_depth() > 0.5;
    let past_far: bool = select((at.z < 0.0), (at.z > 1.0), forward);
    let past_near: bool = select((at.z > 1.0), (at.z < 0.0), forward);
    let place: vec2f = clamp(vec2f(at.x, at.y), vec2f(0.0, 0.0), vec2f(65536.0, 65536.0));
    let square: f32 = floor(place.x) + floor(place.y);
    let shade: f32 = select(1.0, 0.75, square - 2.0 * floor(square * 0.5) > 0.5);
    var bits: vec3f = floor(vec3f(number, number * 0.5, number * 0.25));
    bits = bits - 2.0 * floor(bits * 0.5);
    var color: vec3f = (bits * 0.5 + 0.375) * shade;
    color = select(vec3f(1.0, 0.0, 0.0), color, bias < 1.0);
    color = select(color, vec3f(0.0, 0.0, 1.0), past_near);
    color = select(color, vec3f(0.0, 1.0, 1.0), past_far);
    color = select(vec3f(1.0, 1.0, 1.0), color, inside);
    color = select(vec3f(0.0, 0.0, 0.0), color, at.x < 65536.0);
    return select(vec3f(1.0, 0.0, 1.0), color, usable);
}
` };

export const probe_inputs = { language, name: "probe_inputs", summary: "debug color, unless position or normal is wrong",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_probe_inputs: color, unless the receiver is wrong
//   magenta  position or normal is not a number
//   yellow   a normal of zero
fn umbrage_probe_inputs(color: vec3f, world: vec3f, normal: vec3f) -> vec3f {
    let limit: f32 = 18446744073709551616.0;
    // limits differ on purpose: Mesa makes max(x, y) < limit of equal ones, which loses a NaN
    var usable: bool = abs(world.x) < limit && abs(world.y) * 2.0 < limit * 2.0 && abs(world.z) * 4.0 < limit * 4.0;
    usable = usable && abs(normal.x) * 8.0 < limit * 8.0;
    usable = usable && abs(normal.y) * 16.0 < limit * 16.0 && abs(normal.z) * 32.0 < limit * 32.0;
    let zero: bool = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    let given: vec3f = select(color, vec3f(1.0, 1.0, 0.0), zero);
    return select(vec3f(1.0, 0.0, 1.0), given, usable);
}
` };

export const map_tile = { language, name: "map_tile", summary: "first texel of a map in an atlas of equal maps",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_map_tile: first texel of a map in an atlas of maps of size texels, row by row
//   number    number of the map, a whole number
//   columns   maps per row, and 1.0 / their number
fn umbrage_map_tile(number: f32, columns: vec2f, size: vec2f) -> vec2f {
    let row: f32 = floor((number + 0.5) * columns.y);
    return vec2f(number - row * columns.x, row) * size;
}
` };

export const anchored_vertex = { language, name: "anchored_vertex", summary: "vertex of a depth pass in clip space, far from the origin too",
    exactness: "b", operations: 20, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [shadow_coordinate], text: `
// umbrage_anchored_vertex: clip space position of a vertex of a depth pass
//   to_clip, anchor   of a depth_view: anchor.xyz is subtracted from world, and anchor.w times w is added to z
fn umbrage_anchored_vertex(to_clip: mat4x4f, world: vec3f, anchor: vec4f) -> vec4f {
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let c: vec4f = umbrage_shadow_coordinate(to_clip, way);
    let depth: f32 = c.z + anchor.w * c.w;
    return vec4f(c.x, c.y, depth, c.w);
}
` };

export const anchored_place = { language, name: "anchored_place", summary: "place of a point in one map, and the slack of its plane",
    exactness: "c", operations: 121, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [receiver_slope], text: `
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
` };

export const single_map_places = { language, name: "single_map_places", summary: "place of a point of the world in a light's one map",
    exactness: "c", operations: 121, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [anchored_place], text: `
// umbrage_single_map_places: place of a point of the world in a light's one map
//   to_texels, planes, rounding, slack   of umbrage_anchored_place, which has what it returns
//   anchor                               position that is subtracted from world
fn umbrage_single_map_places(to_texels: mat4x4f, planes: mat4x4f, anchor: vec4f, rounding: vec4f, slack: vec4f,
                             terms: vec4f, world: vec3f, normal: vec3f) -> mat4x4f {
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    return umbrage_anchored_place(to_texels, planes, rounding, slack, way, normal);
}
` };

export const parallel_map_places = { language, name: "parallel_map_places", summary: "place of a point of the world in the one map of a light with parallel rays",
    exactness: "c", operations: 121, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_slope], text: `
// umbrage_parallel_map_places: umbrage_single_map_places under parallel rays, where w is 1
fn umbrage_parallel_map_places(to_texels: mat4x4f, planes: mat4x4f, anchor: vec4f, rounding: vec4f, slack: vec4f,
                               terms: vec4f, world: vec3f, normal: vec3f) -> mat4x4f {
    let none: vec4f = vec4f(0.0, 0.0, 0.0, 0.0);
    let one: vec4f = vec4f(1.0, 1.0, 1.0, 1.0);
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let c: vec4f = to_texels[3] + to_texels[0] * way.x + to_texels[1] * way.y + to_texels[2] * way.z;
    let q: vec4f = planes[0] * normal.x + planes[1] * normal.y + planes[2] * normal.z;
    let slope: vec2f = umbrage_cascade_slope(vec3f(q.x, q.y, q.z), one);
    let steep: f32 = abs(slope.x) + abs(slope.y);
    let off: f32 = abs(c.z) * slack.y + slack.z;
    return mat4x4f(vec4f(c.x, c.y, c.z + slack.w, 0.0), vec4f(slope, 1.0, slack.x * steep + off), none, none);
}
` };

export const cascade_edge = { language, name: "cascade_edge", summary: "texels beyond the part of a cascade where a filter stays inside",
    exactness: "c", operations: 13, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cascade_edge: texels beyond the part of a cascade's map where a filter stays inside, at most 0.0 inside
//   light          the point, rotated into the light's axes
//   scale, offset  those of the cascade
//   size, reach    size of the map and filter radius, in texels
// Returns 65536.0 for a depth outside [0, 1], and for NaN there
fn umbrage_cascade_edge(light: vec3f, scale: vec4f, offset: vec4f, size: vec2f, reach: f32) -> f32 {
    let at: vec3f = light * vec3f(scale.x, scale.y, scale.z) + vec3f(offset.x, offset.y, offset.z);
    let half_size: vec2f = size * 0.5;
    let beyond: vec2f = abs(vec2f(at.x, at.y) - half_size) - (half_size - reach);
    return select(65536.0, max(beyond.x, beyond.y), abs(at.z - 0.5) <= 0.5);
}
` };

export const cascade_edges = { language, name: "cascade_edges", summary: "cascade_edge of four cascades",
    exactness: "c", operations: 13, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_edge], text: `
// umbrage_cascade_edges: umbrage_cascade_edge of four cascades
//   scales, offsets   one column per cascade
fn umbrage_cascade_edges(light: vec3f, scales: mat4x4f, offsets: mat4x4f, size: vec2f, reach: f32) -> vec4f {
    return vec4f(umbrage_cascade_edge(light, scales[0], offsets[0], size, reach),
                 umbrage_cascade_edge(light, scales[1], offsets[1], size, reach),
                 umbrage_cascade_edge(light, scales[2], offsets[2], size, reach),
                 umbrage_cascade_edge(light, scales[3], offsets[3], size, reach));
}
` };

export const first_cascade = { language, name: "first_cascade", summary: "first of four cascades that holds a point and its filter",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_first_cascade: number of the first of four cascades that holds a point and its filter, its edge, and the edge
// of the next one; (4.0, 65536.0, 65536.0) for none
//   edges   umbrage_cascade_edge of each
fn umbrage_first_cascade(edges: vec4f) -> vec3f {
    var found: vec3f = select(vec3f(4.0, 65536.0, 65536.0), vec3f(3.0, edges.w, 65536.0), edges.w <= 0.0);
    found = select(found, vec3f(2.0, edges.z, edges.w), edges.z <= 0.0);
    found = select(found, vec3f(1.0, edges.y, edges.z), edges.y <= 0.0);
    return select(found, vec3f(0.0, edges.x, edges.y), edges.x <= 0.0);
}
` };

export const next_cascade_weight = { language, name: "next_cascade_weight", summary: "weight of the next cascade, by both edges",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_weight], text: `
// umbrage_next_cascade_weight: weight of the next cascade, which grows towards the border of a cascade's map
//   found      of umbrage_first_cascade
//   blending   1.0 / width of the band in texels, or 0.0; number of the last cascade, after which comes light
fn umbrage_next_cascade_weight(found: vec3f, blending: vec4f) -> f32 {
    let v: vec2f = vec2f(found.y, found.z) * blending.x + 1.0;
    let leaves: f32 = umbrage_cascade_weight(v.x);
    let held: f32 = select(0.0, 1.0 - umbrage_cascade_weight(v.y), found.z <= 0.0);
    let weight: f32 = select(min(leaves, held), leaves, found.x >= blending.y);
    return select(0.0, weight, blending.x > 0.0 && found.x <= blending.y);
}
` };

export const cascaded_maps_choice = { language, name: "cascaded_maps_choice", summary: "those of up to four cascades that hold a point of the world",
    exactness: "c", operations: 38, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_edges, first_cascade, next_cascade_weight], text: `
// umbrage_cascaded_maps_choice: number of the first of up to four cascades that holds a point, and weight of the next
//   rotation          rotation from the world to the light's axes
//   scales, offsets   scales and offsets of the cascades
//   anchor            position that is subtracted from world
//   blending, terms   as for umbrage_next_cascade_weight; size of a map and reach of the filter
fn umbrage_cascaded_maps_choice(rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, anchor: vec4f, blending: vec4f,
                                terms: vec4f, world: vec3f) -> vec2f {
    let size: vec2f = vec2f(terms.x, terms.y);
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let turned: vec4f = rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    let light: vec3f = vec3f(turned.x, turned.y, turned.z);
    let found: vec3f = umbrage_first_cascade(umbrage_cascade_edges(light, scales, offsets, size, terms.z));
    return vec2f(found.x, umbrage_next_cascade_weight(found, blending));
}
` };

export const cascaded_maps_choice_8 = { language, name: "cascaded_maps_choice_8", summary: "those of up to eight cascades that hold a point of the world",
    exactness: "c", operations: 38, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_edges, first_cascade, next_cascade_weight], text: `
// umbrage_cascaded_maps_choice_8: umbrage_cascaded_maps_choice for up to eight cascades
//   farther_scales, farther_offsets   those of the fifth cascade and of those after it
fn umbrage_cascaded_maps_choice_8(rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, farther_scales: mat4x4f,
                                  farther_offsets: mat4x4f, anchor: vec4f, blending: vec4f, terms: vec4f,
                                  world: vec3f) -> vec2f {
    let size: vec2f = vec2f(terms.x, terms.y);
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let turned: vec4f = rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    let light: vec3f = vec3f(turned.x, turned.y, turned.z);
    let nearer: vec4f = umbrage_cascade_edges(light, scales, offsets, size, terms.z);
    let farther: vec4f = umbrage_cascade_edges(light, farther_scales, farther_offsets, size, terms.z);
    var found: vec3f = umbrage_first_cascade(nearer);
    let after: vec3f = umbrage_first_cascade(farther);
    let next: f32 = select(found.z, farther.x, found.x == 3.0);
    found = select(vec3f(after.x + 4.0, after.y, after.z), vec3f(found.x, found.y, next), found.x < 3.5);
    return vec2f(found.x, umbrage_next_cascade_weight(found, blending));
}
` };

export const cascade_place = { language, name: "cascade_place", summary: "place of a point in one cascade",
    exactness: "c", operations: 14, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_slope], text: `
// umbrage_cascade_place: place of a point in one cascade
//   light, across   the point and its normal, rotated into the light's axes
//   scale, offset   those of the cascade. w: slack of a plane in texels of slope, and in depth
//   number, last    number of the cascade and of the last one; above it the place is outside all maps, where all is lit
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
fn umbrage_cascade_place(light: vec3f, across: vec3f, scale: vec4f, offset: vec4f, number: f32, last: f32) -> mat4x4f {
    let none: vec4f = vec4f(0.0, 0.0, 0.0, 0.0);
    let at: vec3f = light * vec3f(scale.x, scale.y, scale.z) + vec3f(offset.x, offset.y, offset.z);
    let x: f32 = select(-65536.0, at.x, number <= last);
    let slope: vec2f = umbrage_cascade_slope(across, scale);
    let slack: f32 = (abs(slope.x) + abs(slope.y)) * scale.w + offset.w;
    return mat4x4f(vec4f(x, at.y, at.z, min(number, last)), vec4f(slope, 1.0, slack), none, none);
}
` };

export const cascaded_maps_place = { language, name: "cascaded_maps_place", summary: "place of a point of the world in one of up to four cascades",
    exactness: "c", operations: 38, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_column, cascade_place], text: `
// umbrage_cascaded_maps_place: umbrage_cascade_place of a point of the world, in one of up to four cascades
//   number   number of the cascade
//   the others as for umbrage_cascaded_maps_choice
fn umbrage_cascaded_maps_place(rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, anchor: vec4f, blending: vec4f,
                               terms: vec4f, world: vec3f, normal: vec3f, number: f32) -> mat4x4f {
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let light: vec4f = rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    let across: vec4f = rotation[3] + rotation[0] * normal.x + rotation[1] * normal.y + rotation[2] * normal.z;
    let own: f32 = min(number, blending.y);
    return umbrage_cascade_place(vec3f(light.x, light.y, light.z), vec3f(across.x, across.y, across.z),
                                 umbrage_cascade_column(scales, own), umbrage_cascade_column(offsets, own), number,
                                 blending.y);
}
` };

export const cascaded_maps_place_8 = { language, name: "cascaded_maps_place_8", summary: "place of a point of the world in one of up to eight cascades",
    exactness: "c", operations: 38, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_column_8, cascade_place], text: `
// umbrage_cascaded_maps_place_8: umbrage_cascaded_maps_place for up to eight cascades
//   farther_scales, farther_offsets   those of the fifth cascade and of those after it
fn umbrage_cascaded_maps_place_8(rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, farther_scales: mat4x4f,
                                 farther_offsets: mat4x4f, anchor: vec4f, blending: vec4f, terms: vec4f, world: vec3f,
                                 normal: vec3f, number: f32) -> mat4x4f {
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let light: vec4f = rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    let across: vec4f = rotation[3] + rotation[0] * normal.x + rotation[1] * normal.y + rotation[2] * normal.z;
    let own: f32 = min(number, blending.y);
    return umbrage_cascade_place(vec3f(light.x, light.y, light.z), vec3f(across.x, across.y, across.z),
                                 umbrage_cascade_column_8(scales, farther_scales, own),
                                 umbrage_cascade_column_8(offsets, farther_offsets, own), number, blending.y);
}
` };

export const cube_maps_places = { language, name: "cube_maps_places", summary: "place of a point of the world in a cube's six maps",
    exactness: "c", operations: 121, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cube_maps_places: place of a point of the world in a cube's six maps
//   face              texels a unit across the face's axis, at distance 1 along it; middle of a map; depth over
//                     1.0 / distance, and that by texels
//   anchor            position of the light
//   rounding, slack   of umbrage_anchored_place, from a face's axes
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
fn umbrage_cube_maps_places(face: vec4f, anchor: vec4f, rounding: vec4f, slack: vec4f, terms: vec4f, world: vec3f,
                            normal: vec3f) -> mat4x4f {
    let none: vec4f = vec4f(0.0, 0.0, 0.0, 0.0);
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let m: vec3f = abs(way);
    let on_x: bool = select(false, (m.x >= m.z), m.x >= m.y);
    let on_y: bool = select((m.y >= m.z), false, on_x);
    let along: f32 = select(select(way.z, way.y, on_y), way.x, on_x);
    let flip: f32 = select(1.0, -1.0, along < 0.0);
    let number: f32 = select(select(4.5, 2.5, on_y), 0.5, on_x) - 0.5 * flip;
    let signs: vec2f = vec2f(select(select(flip, 1.0, on_y), -flip, on_x), select(-1.0, flip, on_y));
    let there: vec2f = vec2f(select(way.x, way.z, on_x), select(way.y, way.z, on_y)) * signs;
    let across: vec2f = vec2f(select(normal.x, normal.z, on_x), select(normal.y, normal.z, on_y)) * signs;
    let off_plane: f32 = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    let rise: f32 = face.w / select(off_plane, 1.0e-30, off_plane == 0.0);  // as umbrage_receiver_slope
    let slope: vec2f = across * rise;
    let i: f32 = 1.0 / max(abs(along), 1.0e-30);
    let z: f32 = face.z * i;
    let at: vec2f = there * (face.x * i) + face.y;
    let steep: f32 = abs(slope.x) + abs(slope.y);
    let moves: f32 = rounding.x + rounding.y * i;
    let off: f32 = abs(z) * (moves + slack.y) + slack.z;  // a lens has no rounding.w
    let all: f32 = (moves * rounding.z + slack.x) * steep + off;
    return mat4x4f(vec4f(at, z + slack.w, number), vec4f(slope, 1.0, all), none, none);
}
` };

export const tetrahedron_map_places = { language, name: "tetrahedron_map_places", summary: "place of a point of the world in a tetrahedron's map",
    exactness: "c", operations: 121, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [tetrahedron_face, tetrahedron_face_point, tetrahedron_turned, anchored_place], text: `
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
` };

export const tetrahedron_shape = { language, name: "tetrahedron_shape", summary: "shape of penumbras at a texel of a tetrahedron's map",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_tetrahedron_shape: shape of penumbras at a texel of a tetrahedron's map
//   center   x: half the map's size in texels
//   number   not read
//   at       place in the map, texels
//   returns factors of face 0's softness in x and y, and no shear
fn umbrage_tetrahedron_shape(center: vec4f, number: f32, at: vec2f) -> vec3f {
    let beside: bool = abs(at.x - center.x) > abs(at.y - center.x);
    return select(vec3f(1.0, 1.0, 0.0), vec3f(0.577350269, 1.73205081, 0.0), beside);
}
` };

export const paraboloid_maps_places = { language, name: "paraboloid_maps_places", summary: "place of a point of the world in two paraboloid maps",
    exactness: "c", operations: 57, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [dual_paraboloid_coordinate, distance_depth, dual_paraboloid_slope], text: `
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
` };

export const paraboloid_vertex = { language, name: "paraboloid_vertex", summary: "clip space position of a vertex in a paraboloid map",
    exactness: "c", operations: 51, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [dual_paraboloid_position], text: `
// umbrage_paraboloid_vertex: clip space position of a vertex in a paraboloid map
//   to_clip    the light's projection
//   anchor     position of the light
//   number     0.0 or 1.0, the map
fn umbrage_paraboloid_vertex(to_clip: mat4x4f, world: vec3f, anchor: vec4f, number: f32) -> vec4f {
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let p: vec4f = umbrage_dual_paraboloid_position(way, number);
    let place: vec4f = to_clip[3] * p.w + to_clip[0] * p.x + to_clip[1] * p.y + to_clip[2] * p.z;
    return place;
}
` };

export const warped_maps_choice = { language, name: "warped_maps_choice", summary: "warped cascade that holds a point of the world, and weight of the next one",
    exactness: "c", operations: 12, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_by_depth, cascade_column, cascade_fade], text: `
// umbrage_warped_maps_choice: number of the warped cascade that holds a point of the world, and weight of the next one
//   fades    one column per map: scale and offset of the next one's weight
//   anchor   the one anchor of all maps
//   ahead    distance along the camera's axis: dot(ahead.xyz, world - anchor) + ahead.w
//   ends     ends of the first three cascades, number of the last one
fn umbrage_warped_maps_choice(fades: mat4x4f, anchor: vec4f, ahead: vec4f, ends: vec4f, world: vec3f) -> vec2f {
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let depth: f32 = ahead.x * way.x + ahead.y * way.y + ahead.z * way.z + ahead.w;
    let number: f32 = umbrage_cascade_by_depth(depth, vec3f(ends.x, ends.y, ends.z));
    let own: vec4f = umbrage_cascade_column(fades, number);
    return vec2f(number, umbrage_cascade_fade(depth, own.x, own.y));
}
` };

export const warped_maps_place = { language, name: "warped_maps_place", summary: "place of a point of the world in one of up to four warped cascades",
    exactness: "c", operations: 121, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [anchored_place, cascade_column], text: `
// umbrage_warped_maps_place: place of a point of the world in one of up to four warped cascades
//   to_texels_0 to planes_3   matrices of umbrage_anchored_place for each map
//   rounding, slack           one column per map: its rounding and slack there
//   fades, ahead              of umbrage_warped_maps_choice, not read
//   anchor                    the one anchor of all maps
//   ends                      w: number of the last cascade, after which the place is outside all maps, and lit
//   number                    number of the cascade
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
fn umbrage_warped_maps_place(to_texels_0: mat4x4f, to_texels_1: mat4x4f, to_texels_2: mat4x4f, to_texels_3: mat4x4f,
                             planes_0: mat4x4f, planes_1: mat4x4f, planes_2: mat4x4f, planes_3: mat4x4f,
                             rounding: mat4x4f, slack: mat4x4f, fades: mat4x4f, anchor: vec4f, ahead: vec4f,
                             ends: vec4f, terms: vec4f, world: vec3f, normal: vec3f, number: f32) -> mat4x4f {
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let own: f32 = min(number, ends.w);
    var to_texels: mat4x4f = to_texels_0;
    var planes: mat4x4f = planes_0;
    if (own > 0.5) {
        to_texels = to_texels_1;
        planes = planes_1;
    }
    if (own > 1.5) {
        to_texels = to_texels_2;
        planes = planes_2;
    }
    if (own > 2.5) {
        to_texels = to_texels_3;
        planes = planes_3;
    }
    let at: mat4x4f =
        umbrage_anchored_place(to_texels, planes, umbrage_cascade_column(rounding, own),
                               umbrage_cascade_column(slack, own), way, normal);
    let x: f32 = select(-65536.0, at[0].x, number <= ends.w);
    return mat4x4f(vec4f(x, at[0].y, at[0].z, own), at[1], at[2], at[3]);
}
` };

export const adaptive_maps_places = { language, name: "adaptive_maps_places", summary: "place of a point of the world in the pages of an adaptive map",
    exactness: "c", operations: 68, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [shadow_coordinate, cascade_column_8, receiver_slope], text: `
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
` };

export const map_softness = { language, name: "map_softness", summary: "one of eight pairs of a matrix, without dynamic indexing",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_column], text: `
// umbrage_map_softness: one of eight pairs of a matrix, two a column, by its index, 0.0 to 7.0
fn umbrage_map_softness(eight: mat4x4f, number: f32) -> vec2f {
    let column: f32 = floor(number * 0.5);
    let two: vec4f = umbrage_cascade_column(eight, column);
    return select(vec2f(two.z, two.w), vec2f(two.x, two.y), number - 2.0 * column < 0.5);
}
` };

export const warp_shape = { language, name: "warp_shape", summary: "shape of penumbras at a texel of a warped map",
    exactness: "c", operations: 29, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_column], text: `
// umbrage_warp_shape: shape of penumbras at a texel of a warped map
//   warps    one column per map: (change of w along both axes, shear, ratio) of its texel (0, 0)
//   number   number of the map
//   at       place in the map, texels
//   returns factors of the map's softness in x and y, and the shear
fn umbrage_warp_shape(warps: mat4x4f, number: f32, at: vec2f) -> vec3f {
    let own: vec4f = umbrage_cascade_column(warps, number);
    let a: vec2f = vec2f(1.0 - at.x * own.x, own.z - at.x * own.y);
    let b: vec2f = vec2f(-at.y * own.w * own.x, 1.0 - at.y * own.w * own.y);
    let area: f32 = abs(a.x * b.y - a.y * b.x);
    let rows: f32 = length(b);
    return vec3f(area / rows, rows, clamp(dot(a, b) / area, -8.0, 8.0));
}
` };

export const shaped_softness = { language, name: "shaped_softness", summary: "softness of a place, by its shape",
    exactness: "c", operations: 9, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_shaped_softness: softness of a place
//   softness   that of its map: (1/16 texel per distance code along x and y, min_radius, max_radius)
//   shape      factors in x and y, shear
fn umbrage_shaped_softness(softness: vec4f, shape: vec3f) -> vec4f {
    let max_radius: f32 = softness.w / sqrt(1.0 + shape.z * shape.z);
    return vec4f(softness.x * shape.x, softness.y * shape.y, softness.z, max_radius);
}
` };
