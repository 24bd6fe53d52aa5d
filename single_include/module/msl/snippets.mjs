import { msl as language } from '../languages.mjs';

export const shadow_coordinate = { language, name: "shadow_coordinate", summary: "world to texels and depth, before the division by w",
    exactness: "b", operations: 6, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_shadow_coordinate: texture matrix times world position: (x w, y w, depth w, w), x and y in texels
inline float4 umbrage_shadow_coordinate(metal::float4x4 m, float3 world) {
    float4 c = m[3] + m[0] * world.x + m[1] * world.y + m[2] * world.z;
    return c;
}
` };

export const tap_coordinate = { language, name: "tap_coordinate", summary: "coordinate of a tap from the center's, before division by w",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_tap_coordinate: coordinate before the division by w, moved by offset texels
inline float4 umbrage_tap_coordinate(float4 coordinate, float2 offset) {
    float2 moved = float2(coordinate.x, coordinate.y) + offset * coordinate.w;
    return float4(moved.x, moved.y, coordinate.z, coordinate.w);
}
` };

export const project_coordinate = { language, name: "project_coordinate", summary: "division by w; lit behind the light",
    exactness: "c", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_project_coordinate: x and y in texels, and depth; w <= 0.0 gives a coordinate that every filter takes as lit
inline float3 umbrage_project_coordinate(float4 coordinate) {
    float3 p = float3(coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w);
    return coordinate.w > 0.0 ? p : float3(65536.0, 65536.0, 0.0);
}
` };

export const cascade_by_depth = { language, name: "cascade_by_depth", summary: "cascade that contains a view depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cascade_by_depth: cascade that contains a distance along the camera's axis, 0.0 to 3.0
//   ends  ends of the first three cascades, increasing
inline float umbrage_cascade_by_depth(float depth, float3 ends) {
    int reached = int(depth >= ends.x) + int(depth >= ends.y) + int(depth >= ends.z);
    return float(reached);
}
` };

export const cascade_column = { language, name: "cascade_column", summary: "one of four columns, without dynamic indexing",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
inline float4 umbrage_cascade_column(metal::float4x4 columns, float number) {
    float4 low = number < 0.5 ? columns[0] : columns[1];
    float4 high = number < 2.5 ? columns[2] : columns[3];
    return number < 1.5 ? low : high;
}
` };

export const cascade_column_8 = { language, name: "cascade_column_8", summary: "one of eight columns, without dynamic indexing",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_column], text: `
// umbrage_cascade_column_8: column of two matrices by its index, 0.0 to 7.0
inline float4 umbrage_cascade_column_8(metal::float4x4 nearer, metal::float4x4 farther, float number) {
    float4 low = umbrage_cascade_column(nearer, number);
    float4 high = umbrage_cascade_column(farther, number - 4.0);
    return number < 3.5 ? low : high;
}
` };

export const cascade_coordinate = { language, name: "cascade_coordinate", summary: "position of a point in one cascade's map",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cascade_coordinate: position in a cascade's map, texels and depth, of a point rotated into the light's axes
inline float3 umbrage_cascade_coordinate(float3 light, float4 scale, float4 offset) {
    float3 start = float3(offset.x, offset.y, offset.z);
    float3 at = light * float3(scale.x, scale.y, scale.z) + start;
    return at;
}
` };

export const inside_cascade = { language, name: "inside_cascade", summary: "true if a filter stays inside a cascade",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_inside_cascade: true if a filter of radius reach at a coordinate stays inside a map of size texels
inline bool umbrage_inside_cascade(float3 coordinate, float2 size, float reach) {
    float2 end = size - reach;
    // y is doubled because Mesa turns two comparisons with one limit into min(x, y) >= reach, which loses a NaN
    bool in_x = coordinate.x >= reach && coordinate.x <= end.x;
    bool in_y = coordinate.y * 2.0 >= reach * 2.0 && coordinate.y * 2.0 <= end.y * 2.0;
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
inline float4 umbrage_cascade_by_projection(float3 light, metal::float4x4 scales, metal::float4x4 offsets, float2 size,
                                            float reach) {
    float3 a = umbrage_cascade_coordinate(light, scales[0], offsets[0]);
    float3 b = umbrage_cascade_coordinate(light, scales[1], offsets[1]);
    float3 c = umbrage_cascade_coordinate(light, scales[2], offsets[2]);
    float3 d = umbrage_cascade_coordinate(light, scales[3], offsets[3]);
    float4 found = float4(65536.0, 65536.0, 0.0, 4.0);
    found = umbrage_inside_cascade(d, size, reach) ? float4(d, 3.0) : found;
    found = umbrage_inside_cascade(c, size, reach) ? float4(c, 2.0) : found;
    found = umbrage_inside_cascade(b, size, reach) ? float4(b, 1.0) : found;
    return umbrage_inside_cascade(a, size, reach) ? float4(a, 0.0) : found;
}
` };

export const cascade_by_projection_8 = { language, name: "cascade_by_projection_8", summary: "first of eight cascades that contains a point and its filter",
    exactness: "b", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_by_projection], text: `
// umbrage_cascade_by_projection_8: umbrage_cascade_by_projection for eight cascades, four and four; index 8.0 for none
inline float4 umbrage_cascade_by_projection_8(float3 light, metal::float4x4 scales, metal::float4x4 offsets,
                                              metal::float4x4 farther_scales, metal::float4x4 farther_offsets,
                                              float2 size, float reach) {
    float4 nearer = umbrage_cascade_by_projection(light, scales, offsets, size, reach);
    float4 farther = umbrage_cascade_by_projection(light, farther_scales, farther_offsets, size, reach);
    return nearer.w < 3.5 ? nearer : float4(farther.x, farther.y, farther.z, farther.w + 4.0);
}
` };

export const cascade_tile = { language, name: "cascade_tile", summary: "first texel of a cascade in an atlas",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cascade_tile: first texel of a cascade in an atlas with two tiles of size texels per row
inline float2 umbrage_cascade_tile(float number, float2 size) {
    float row = metal::floor(number * 0.5);
    return float2(number - row * 2.0, row) * size;
}
` };

export const cascade_weight = { language, name: "cascade_weight", summary: "weight in steps of 1/256",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
inline float umbrage_cascade_weight(float v) {
    return v > 0.0 ? metal::min(metal::floor(v * 256.0), 256.0) * (1.0 / 256.0) : 0.0;
}
` };

export const cascade_fade = { language, name: "cascade_fade", summary: "weight of the next cascade, by view depth",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_weight], text: `
// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis: depth * scale + offset
inline float umbrage_cascade_fade(float depth, float scale, float offset) {
    float v = depth * scale + offset;
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
inline float umbrage_cascade_border_fade(float2 coordinate, float2 size, float reach, float per_texel) {
    float2 half_size = size * 0.5;
    float2 beyond = metal::abs(coordinate - half_size) - (half_size - reach);
    float2 v = beyond * per_texel + 1.0;
    float x = umbrage_cascade_weight(v.x);
    float y = umbrage_cascade_weight(v.y);
    return x > y ? x : y;
}
` };

export const blend_cascades = { language, name: "blend_cascades", summary: "blend of two cascades' visibilities",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_blend_cascades: blend of the visibilities of a cascade and of the next one, by the next one's weight
inline float umbrage_blend_cascades(float nearer, float farther, float weight) {
    float sum = nearer + (farther - nearer) * weight;
    return weight < 1.0 ? sum : farther;
}
` };

export const inside_texel_space = { language, name: "inside_texel_space", summary: "true for coordinates that a filter can take",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
inline bool umbrage_inside_texel_space(float2 coord) {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return metal::abs(coord.x) < 32768.0 && metal::abs(coord.y) <= 32767.998046875;
}
` };

export const dither_threshold = { language, name: "dither_threshold", summary: "one of 16 dither thresholds for a pixel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [inside_texel_space], text: `
// umbrage_dither_threshold: dither threshold of a position in pixels: 1/32 to 31/32, each once in 4x4 pixels
inline float umbrage_dither_threshold(float2 pixel) {
    float2 whole = umbrage_inside_texel_space(pixel) ? metal::floor(pixel) : float2(0.0, 0.0);
    float2 high = metal::floor(whole * 0.5);
    float2 above = metal::floor(whole * 0.25);
    float2 b0 = whole - high * 2.0;
    float2 b1 = high - above * 2.0;
    float m = metal::abs(b0.x - b0.y) * 8.0 + b0.y * 4.0 + metal::abs(b1.x - b1.y) * 2.0 + b1.y;
    return (m + 0.5) * (1.0 / 16.0);
}
` };

export const dithered_cascade = { language, name: "dithered_cascade", summary: "cascade of a pixel, or the next one, by its weight",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_dithered_cascade: index of a cascade, or of the next one if its weight is above the pixel's threshold
inline float umbrage_dithered_cascade(float number, float weight, float threshold) {
    return number + (weight > threshold ? 1.0 : 0.0);
}
` };

export const cube_face = { language, name: "cube_face", summary: "face of a cube that a direction meets",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cube_face: face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
inline float umbrage_cube_face(float3 direction) {
    float3 m = metal::abs(direction);
    float x = direction.x < 0.0 ? 1.0 : 0.0;
    float y = direction.y < 0.0 ? 3.0 : 2.0;
    float z = direction.z < 0.0 ? 5.0 : 4.0;
    // not m.x >= m.y && m.x >= m.z: Mesa turns it into one comparison with max(m.y, m.z), which loses a NaN
    return m.x >= m.y ? (m.x >= m.z ? x : z) : (m.y >= m.z ? y : z);
}
` };

export const cube_view_z = { language, name: "cube_view_z", summary: "distance along the axis of a direction's face",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cube_face], text: `
// umbrage_cube_view_z: magnitude of the largest component, the input of per-face depths
inline float umbrage_cube_view_z(float3 direction) {
    float face = umbrage_cube_face(direction);
    float side = face < 1.5 ? direction.x : direction.y;
    return metal::abs(face > 3.5 ? direction.z : side);
}
` };

export const cube_plane = { language, name: "cube_plane", summary: "direction in the axes of its face",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cube_face], text: `
// umbrage_cube_plane: (sc, tc, face) of a direction: its components across the axis of its face
inline float3 umbrage_cube_plane(float3 direction) {
    float face = umbrage_cube_face(direction);
    float3 x = float3(face < 0.5 ? -direction.z : direction.z, -direction.y, face);
    float3 y = float3(direction.x, face < 2.5 ? direction.z : -direction.z, face);
    float3 z = float3(face < 4.5 ? direction.x : -direction.x, -direction.y, face);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
` };

export const cube_point = { language, name: "cube_point", summary: "point from a face's axes",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cube_point: point from (sc, tc, distance along the axis) in a face, 0.0 to 5.0
inline float3 umbrage_cube_point(float face, float3 p) {
    float3 x = face < 0.5 ? float3(p.z, -p.y, -p.x) : float3(-p.z, -p.y, p.x);
    float3 y = face < 2.5 ? float3(p.x, p.z, p.y) : float3(p.x, -p.z, -p.y);
    float3 z = face < 4.5 ? float3(p.x, -p.y, p.z) : float3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
` };

export const cube_face_point = { language, name: "cube_face_point", summary: "point in a face's axes",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cube_face_point: (sc, tc, distance along the axis) in a face, 0.0 to 5.0, of a point from the cube's center
inline float3 umbrage_cube_face_point(float face, float3 p) {
    float3 x = face < 0.5 ? float3(-p.z, -p.y, p.x) : float3(p.z, -p.y, -p.x);
    float3 y = face < 2.5 ? float3(p.x, p.z, p.y) : float3(p.x, -p.z, -p.y);
    float3 z = face < 4.5 ? float3(p.x, -p.y, p.z) : float3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
` };

export const cube_coordinate = { language, name: "cube_coordinate", summary: "face of a direction, and the position on it",
    exactness: "c", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cube_view_z, cube_plane], text: `
// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
inline float3 umbrage_cube_coordinate(float3 direction) {
    float3 p = umbrage_cube_plane(direction);
    float m = umbrage_cube_view_z(direction);
    return float3((p.x + m) / (m + m), (p.y + m) / (m + m), p.z);
}
` };

export const cube_direction = { language, name: "cube_direction", summary: "direction to a point of a cube's face",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cube_point], text: `
// umbrage_cube_direction: direction from a cube's center to a point of a face, 0.0 to 5.0; st is in [0.0, 1.0]
inline float3 umbrage_cube_direction(float face, float2 st) {
    float2 uv = st * 2.0 - 1.0;  // the product is exact: fused or not, it rounds once
    return umbrage_cube_point(face, float3(uv, 1.0));
}
` };

export const cube_neighbor = { language, name: "cube_neighbor", summary: "texel beyond an edge of a cube's face",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cube_plane, cube_point], text: `
// umbrage_cube_neighbor: (s, t, face) of a texel that may lie beyond an edge of its face; face -1.0 beyond a corner
//   texel  (s, t, face), integers
//   size   size of a face, in texels
inline float3 umbrage_cube_neighbor(float3 texel, float size) {
    float2 uv = float2(texel.x, texel.y) * 2.0 + (1.0 - size);
    bool beyond_u = metal::abs(uv.x) > size;
    bool beyond_v = metal::abs(uv.y) > size;
    float m = beyond_u || beyond_v ? size - 1.0 : size;
    float3 p = umbrage_cube_plane(umbrage_cube_point(texel.z, float3(uv, m)));
    float2 inside = (float2(p.x, p.y) + (size - 1.0)) * 0.5;
    return beyond_u && beyond_v ? float3(0.0, 0.0, -1.0) : float3(inside, p.z);
}
` };

export const cube_tile = { language, name: "cube_tile", summary: "first texel of a face in an atlas",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
inline float2 umbrage_cube_tile(float face, float size) {
    float row = face < 2.5 ? 0.0 : 1.0;
    return float2((face - row * 3.0) * size, row * size);
}
` };

export const cube_atlas_texel = { language, name: "cube_atlas_texel", summary: "face of an atlas texel, and the position on it",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cube_atlas_texel: (s, t, face) of a texel in an atlas of 3 x 2 tiles of size texels; integers
inline float3 umbrage_cube_atlas_texel(float2 texel, float size) {
    float column = texel.x < size ? 0.0 : (texel.x < size * 2.0 ? 1.0 : 2.0);
    float row = texel.y < size ? 0.0 : 1.0;
    return float3(texel - float2(column, row) * size, column + row * 3.0);
}
` };

export const cube_atlas_direction = { language, name: "cube_atlas_direction", summary: "direction that reads an atlas texel from a cube texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cube_atlas_texel, cube_point], text: `
// umbrage_cube_atlas_direction: direction from a cube's center to an atlas texel, for 3 x 2 tiles of size texels
inline float3 umbrage_cube_atlas_direction(float2 texel, float size) {
    float3 part = umbrage_cube_atlas_texel(texel, size);
    float2 uv = float2(part.x, part.y) * 2.0 + (1.0 - size);
    return umbrage_cube_point(part.z, float3(uv, size));
}
` };

export const dual_paraboloid_coordinate = { language, name: "dual_paraboloid_coordinate", summary: "paraboloid map that sees a direction, and position in it",
    exactness: "c", operations: 32, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_dual_paraboloid_coordinate: (s, t, map) of a direction: 0.0 to 1.0 over the map's square, map 0.0 or 1.0
inline float3 umbrage_dual_paraboloid_coordinate(float3 direction) {
    float square = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    bool behind = direction.z < 0.0;
    float m = metal::sqrt(square) + (behind ? -direction.z : direction.z);
    float x = behind ? direction.x : -direction.x;
    return float3((x + m) / (m + m), (direction.y + m) / (m + m), behind ? 1.0 : 0.0);
}
` };

export const dual_paraboloid_position = { language, name: "dual_paraboloid_position", summary: "position of a vertex in a paraboloid map's depth pass",
    exactness: "c", operations: 18, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_dual_paraboloid_position: (x w, y w, distance w, w) of a vertex, for the depth pass' projection
//   direction  from the light to the vertex
//   map        index of the map, 0.0 or 1.0
inline float4 umbrage_dual_paraboloid_position(float3 direction, float map) {
    bool behind = map > 0.5;
    float square = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    float distance_to = metal::sqrt(square);
    float w = distance_to + (behind ? -direction.z : direction.z);
    return float4(behind ? direction.x : -direction.x, direction.y, distance_to * w, w);
}
` };

export const tetrahedron_face = { language, name: "tetrahedron_face", summary: "face of a tetrahedron that a direction meets",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_tetrahedron_face: face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
inline float umbrage_tetrahedron_face(float3 direction) {
    float beside = metal::abs(direction.z) - metal::abs(direction.x);
    float up = direction.y * 1.414213562;
    float z = direction.z < 0.0 ? 1.0 : 0.0;
    float x = direction.x < 0.0 ? 3.0 : 2.0;
    return beside >= up ? z : x;
}
` };

export const tetrahedron_face_point = { language, name: "tetrahedron_face_point", summary: "direction in the axes of a tetrahedron's face",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
inline float3 umbrage_tetrahedron_face_point(float face, float3 d) {
    float3 z = face < 0.5 ? float3(-d.x, d.y, d.z) : float3(d.x, d.y, -d.z);
    float3 x = face < 2.5 ? float3(-d.z, -d.y, d.x) : float3(d.z, -d.y, -d.x);
    return face < 1.5 ? z : x;
}
` };

export const tetrahedron_plane = { language, name: "tetrahedron_plane", summary: "direction in the axes of its tetrahedron face",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [tetrahedron_face, tetrahedron_face_point], text: `
// umbrage_tetrahedron_plane: (along the base, up, away) of a direction in the axes of the face that it meets
inline float3 umbrage_tetrahedron_plane(float3 direction) {
    return umbrage_tetrahedron_face_point(umbrage_tetrahedron_face(direction), direction);
}
` };

export const tetrahedron_view_z = { language, name: "tetrahedron_view_z", summary: "distance along the normal of a direction's face",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [tetrahedron_plane], text: `
// umbrage_tetrahedron_view_z: distance along the face's normal, the input of per-face depths
inline float umbrage_tetrahedron_view_z(float3 direction) {
    float3 p = umbrage_tetrahedron_plane(direction);
    float z = p.z * 0.816496581 + p.y * -0.577350269;
    return z;
}
` };

export const tetrahedron_coordinate = { language, name: "tetrahedron_coordinate", summary: "tetrahedron face of a direction, and the position on it",
    exactness: "c", operations: 6, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [tetrahedron_face, tetrahedron_plane], text: `
// umbrage_tetrahedron_coordinate: (s, t, face) of a direction
//   s  -1.0 to 1.0 along the base
//   t  0.0 at the base to 1.0 at the apex
inline float3 umbrage_tetrahedron_coordinate(float3 direction) {
    float3 p = umbrage_tetrahedron_plane(direction);
    float d = p.z * 2.0 + p.y * -1.414213562;
    return float3(p.x / d, p.z / d, umbrage_tetrahedron_face(direction));
}
` };

export const tetrahedron_turned = { language, name: "tetrahedron_turned", summary: "vector rotated from face 0's part of the map to another's",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_tetrahedron_turned: vector from face 0's part of the map, rotated to the part of a face, 0.0 to 3.0
inline float2 umbrage_tetrahedron_turned(float face, float2 v) {
    float2 z = face < 0.5 ? v : float2(-v.x, -v.y);
    float2 x = face < 2.5 ? float2(-v.y, v.x) : float2(v.y, -v.x);
    return face < 1.5 ? z : x;
}
` };

export const tetrahedron_texel = { language, name: "tetrahedron_texel", summary: "position in the map of a point on a tetrahedron's face",
    exactness: "b", operations: 9, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [tetrahedron_turned], text: `
// umbrage_tetrahedron_texel: position in a square map, in texels, from (s, t, face) on a tetrahedron
//   size    size of the map, in texels
//   border  border along the sides of each triangle, in texels
inline float2 umbrage_tetrahedron_texel(float3 at, float size, float border) {
    float half_size = size * 0.5;
    float scale = half_size - border * 3.0;
    float x = at.x * scale;
    float y = at.y * scale + (border - half_size);
    float2 texel = umbrage_tetrahedron_turned(at.z, float2(x, y)) + half_size;
    return texel;
}
` };

export const tetrahedron_face_of = { language, name: "tetrahedron_face_of", summary: "face of a tetrahedron that contains a texel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_tetrahedron_face_of: face, 0.0 to 3.0, whose triangle contains a texel, in a map of size texels
inline float umbrage_tetrahedron_face_of(float2 texel, float size) {
    float2 off = texel * 2.0 + (1.0 - size);
    float column = off.y < 0.0 ? 0.0 : 1.0;
    float row = off.x < 0.0 ? 3.0 : 2.0;
    return metal::abs(off.y) >= metal::abs(off.x) ? column : row;
}
` };

export const pancake = { language, name: "pancake", summary: "casters clamped to the near plane (pancaking)",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_pancake: clip space position, clamped to the near plane if it lies in front of it
//   at_near  z/w of the near plane: 0.0 or -1.0, or 1.0 for reversed depth
inline float4 umbrage_pancake(float4 position, float at_near) {
    float plane = at_near * position.w;
    bool before = at_near > 0.5 ? position.z > plane : position.z < plane;
    return float4(position.x, position.y, before ? plane : position.z, position.w);
}
` };

export const texel = { language, name: "texel", summary: "texel inside a map",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "texel", scaled: false,
    needs: [], text: `
// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
inline float4 umbrage_texel(metal::texture2d<float> map, float2 size, float2 texel) {
    return map.read(uint2(texel));
}
` };

export const from_unorm = { language, name: "from_unorm", summary: "channel 0..255 of a value from an 8-bit texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_from_unorm: channel 0..255 of a value from an 8-bit texture, even if the division by 255 is inexact
inline float umbrage_from_unorm(float c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float2 umbrage_from_unorm(float2 c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float3 umbrage_from_unorm(float3 c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float4 umbrage_from_unorm(float4 c) {
    return metal::floor(c * 255.0 + 0.5);
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
inline float4 umbrage_page_coordinate(metal::texture2d<float> table, float2 size, float2 coord, float page,
                                      float gutter) {
    // neither max changes a value; compilers cannot regroup sums across max and clamp
    float2 sides = metal::max(size - 2.0, float2(1.0, 1.0));
    float2 before = metal::max(size - 3.0, float2(0.0, 0.0));
    float2 cell = metal::min(metal::max(float2(0.0, 0.0), coord * sides - before), size - 1.0);
    int2 texel = int2(cell);  // the first texel for a NaN
    float4 entry = umbrage_from_unorm(umbrage_texel(table, size, float2(texel)));
    float2 slot = float2(entry.x, entry.y);
    float across = entry.z + entry.w * 256.0;
    float2 within = metal::clamp(metal::fract(coord * across), float2(0.0, 0.0), float2(1.0, 1.0));
    float2 at = within * page + (across > 0.0 ? gutter : 32768.0);
    return float4(at, slot * (page + gutter * 2.0));
}
` };

export const page_tile = { language, name: "page_tile", summary: "first texel of a page in an atlas of eight a row",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_page_tile: first texel of a page, a whole number, in an atlas of pages of size texels, eight a row
inline float2 umbrage_page_tile(float number, float size) {
    float row = metal::floor(number * 0.125);
    return float2(number - row * 8.0, row) * size;
}
` };

export const linear_depth = { language, name: "linear_depth", summary: "view-space z over z_far",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_linear_depth: distance along the light's axis, positive in front of the light, times 1 / z_far
inline float umbrage_linear_depth(float z_view, float inv_z_far) {
    return z_view * inv_z_far;
}
` };

export const project_depth = { language, name: "project_depth", summary: "z / w, and the far plane behind the light",
    exactness: "c", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_project_depth: z / w. Returns cleared for w <= 0.0: 1.0, or 0.0 where depth is reversed
inline float umbrage_project_depth(float z, float w, float cleared) {
    return w > 0.0 ? z / w : cleared;
}
` };

export const distance_depth = { language, name: "distance_depth", summary: "distance to the light over its range",
    exactness: "c", operations: 9, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_distance_depth: length of to_point, the vector from the light, times 1 / range
inline float umbrage_distance_depth(float3 to_point, float inv_range) {
    return metal::sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}
` };

export const reverse_depth = { language, name: "reverse_depth", summary: "1 - depth",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_reverse_depth: forward depth from reversed depth, or reversed from forward
inline float umbrage_reverse_depth(float depth) {
    return 1.0 - depth;
}
` };

export const depth_from_ndc = { language, name: "depth_from_ndc", summary: "z/w in [-1, 1] to depth in [0, 1]",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_depth_from_ndc: depth in [0, 1] from z/w in [-1, 1]
inline float umbrage_depth_from_ndc(float ndc) {
    float depth = ndc * 0.5 + 0.5;
    return depth;
}
` };

export const view_z_from_depth = { language, name: "view_z_from_depth", summary: "perspective depth to view-space z",
    exactness: "c", operations: 8, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_view_z_from_depth: distance along the light's axis from perspective depth in [0, 1], 0.0 at z_near
inline float umbrage_view_z_from_depth(float depth, float z_near, float z_far) {
    return z_near / (1.0 - depth * (1.0 - z_near / z_far));
}
` };

export const depth_from_view_z = { language, name: "depth_from_view_z", summary: "view-space z to perspective depth",
    exactness: "c", operations: 10, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_depth_from_view_z: perspective depth in [0, 1], 0.0 at z_near, from the distance along the light's axis
inline float umbrage_depth_from_view_z(float z_view, float z_near, float z_far) {
    return (1.0 - z_near / z_view) / (1.0 - z_near / z_far);
}
` };

export const view_z_from_reversed_depth = { language, name: "view_z_from_reversed_depth", summary: "reversed perspective depth to view-space z",
    exactness: "c", operations: 11, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_view_z_from_reversed_depth: distance along the light's axis from perspective depth in [0, 1], 1.0 at z_near
inline float umbrage_view_z_from_reversed_depth(float depth, float z_near, float z_far) {
    return z_near / (z_near / z_far + depth * (1.0 - z_near / z_far));
}
` };

export const reversed_depth_from_view_z = { language, name: "reversed_depth_from_view_z", summary: "view-space z to reversed perspective depth",
    exactness: "c", operations: 13, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_reversed_depth_from_view_z: perspective depth in [0, 1], 1.0 at z_near, from the distance along the light's
// axis
inline float umbrage_reversed_depth_from_view_z(float z_view, float z_near, float z_far) {
    return z_near / z_view * (1.0 - z_view / z_far) / (1.0 - z_near / z_far);
}
` };

export const view_z_from_orthographic_depth = { language, name: "view_z_from_orthographic_depth", summary: "orthographic depth to view-space z",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_view_z_from_orthographic_depth: distance along the light's axis from orthographic depth in [0, 1]
// Depth is 0.0 at z_near. Exchange z_near and z_far where it is reversed
inline float umbrage_view_z_from_orthographic_depth(float depth, float z_near, float z_far) {
    float z_view = z_near + depth * (z_far - z_near);
    return z_view;
}
` };

export const orthographic_depth_from_view_z = { language, name: "orthographic_depth_from_view_z", summary: "view-space z to orthographic depth",
    exactness: "c", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_orthographic_depth_from_view_z: orthographic depth in [0, 1] from the distance along the light's axis
// Depth is 0.0 at z_near. Exchange z_near and z_far where it is reversed
inline float umbrage_orthographic_depth_from_view_z(float z_view, float z_near, float z_far) {
    return (z_view - z_near) / (z_far - z_near);
}
` };

export const cleared_depth = { language, name: "cleared_depth", summary: "depth of the far plane",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "cleared_depth", scaled: false,
    needs: [], text: `
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 1.0;
}
` };

export const saturate = { language, name: "saturate", summary: "clamp to [0, 1]; NaN becomes the far plane",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
inline float umbrage_saturate(float v) {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
` };

export const correct_quotient = { language, name: "correct_quotient", summary: "floor of a quotient, from a guess off by at most one",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_correct_quotient: floor(a / b) from a guess q, off by at most one
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
inline float umbrage_correct_quotient(float q, float a, float b) {
    float more = q + 1.0;
    float known = more * b <= a ? more : q;
    return q * b > a ? q - 1.0 : known;
}
` };

export const floor_divide = { language, name: "floor_divide", summary: "integer division that rounds down, exact on any GPU",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [correct_quotient], text: `
// umbrage_floor_divide: floor(a / b) of integers; the quotient is at most 2^18
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
inline float umbrage_floor_divide(float a, float b) {
    return umbrage_correct_quotient(metal::floor(a / b), a, b);
}
` };

export const to_unorm = { language, name: "to_unorm", summary: "value that makes an 8-bit target store channel 0..255",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_to_unorm: value that makes an 8-bit target store channel k, whether it rounds or truncates
// k * 257 / 65536 + 64 / 65536, in decimals because 65536.0 is infinite in mediump
inline float umbrage_to_unorm(float k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
inline float2 umbrage_to_unorm(float2 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
inline float3 umbrage_to_unorm(float3 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
inline float4 umbrage_to_unorm(float4 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
` };

export const to_unorm10 = { language, name: "to_unorm10", summary: "value that makes a 10-bit target store channel 0..1023",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_to_unorm10: value that makes a 10-bit target store channel k, whether it rounds or truncates
// k * 4099 / 4194304 + 1056 / 4194304
inline float umbrage_to_unorm10(float k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
inline float2 umbrage_to_unorm10(float2 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
inline float3 umbrage_to_unorm10(float3 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
inline float4 umbrage_to_unorm10(float4 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
` };

export const from_unorm10 = { language, name: "from_unorm10", summary: "channel 0..1023 of a value from a 10-bit texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_from_unorm10: channel 0..1023 of a value from a 10-bit texture, even if the division by 1023 is inexact
inline float umbrage_from_unorm10(float c) {
    return metal::floor(c * 1023.0 + 0.5);
}
inline float2 umbrage_from_unorm10(float2 c) {
    return metal::floor(c * 1023.0 + 0.5);
}
inline float3 umbrage_from_unorm10(float3 c) {
    return metal::floor(c * 1023.0 + 0.5);
}
inline float4 umbrage_from_unorm10(float4 c) {
    return metal::floor(c * 1023.0 + 0.5);
}
` };

export const to_unorm16 = { language, name: "to_unorm16", summary: "value that makes a 16-bit target store channel 0..65535",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_to_unorm16: value that makes a 16-bit target store channel k, whether it rounds or truncates
inline float umbrage_to_unorm16(float k) {
    return metal::min(k + (metal::floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
inline float2 umbrage_to_unorm16(float2 k) {
    return metal::min(k + (metal::floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
inline float3 umbrage_to_unorm16(float3 k) {
    return metal::min(k + (metal::floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
inline float4 umbrage_to_unorm16(float4 k) {
    return metal::min(k + (metal::floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
` };

export const from_unorm16 = { language, name: "from_unorm16", summary: "channel 0..65535 of a value from a 16-bit texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_from_unorm16: channel 0..65535 of a value from a 16-bit texture, even if the division by 65535 is inexact
inline float umbrage_from_unorm16(float c) {
    return metal::floor(c * 65535.0 + 0.5);
}
inline float2 umbrage_from_unorm16(float2 c) {
    return metal::floor(c * 65535.0 + 0.5);
}
inline float3 umbrage_from_unorm16(float3 c) {
    return metal::floor(c * 65535.0 + 0.5);
}
inline float4 umbrage_from_unorm16(float4 c) {
    return metal::floor(c * 65535.0 + 0.5);
}
` };

export const encode_rg9 = { language, name: "encode_rg9", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg9: two channels of a 9-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg9(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 512.0), 511.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 128.0);
}
` };

export const encode_rg10 = { language, name: "encode_rg10", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg10: two channels of a 10-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg10(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 1024.0), 1023.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 64.0);
}
` };

export const encode_rg11 = { language, name: "encode_rg11", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg11: two channels of a 11-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg11(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 32.0);
}
` };

export const encode_rg12 = { language, name: "encode_rg12", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg12: two channels of a 12-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg12(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 4096.0), 4095.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 16.0);
}
` };

export const encode_rg13 = { language, name: "encode_rg13", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg13: two channels of a 13-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg13(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 8.0);
}
` };

export const encode_rg14 = { language, name: "encode_rg14", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg14: two channels of a 14-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg14(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 4.0);
}
` };

export const encode_rg15 = { language, name: "encode_rg15", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg15: two channels of a 15-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg15(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 2.0);
}
` };

export const encode_rg16 = { language, name: "encode_rg16", summary: "depth to two 8-bit channels, R the low byte",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rg16: two channels of a 16-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg16(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 1.0);
}
` };

export const encode_rgb24 = { language, name: "encode_rgb24", summary: "depth to three 8-bit channels, R most significant",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rgb24: three channels of a depth, R most significant, integers 0..255 for umbrage_to_unorm
//   depth   clamped to [0, 1]. NaN counts as far
inline float3 umbrage_encode_rgb24(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    float high = metal::floor(x * (1.0 / 65536.0));
    float rest = x - high * 65536.0;
    float middle = metal::floor(rest * (1.0 / 256.0));
    return float3(high, middle, metal::min(rest - middle * 256.0, 255.0));  // below already: no sum is regrouped across the min
}
` };

export const encode_rgb10 = { language, name: "encode_rgb10", summary: "depth to three 10-bit channels, R most significant",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_rgb10: three channels of a depth, R most significant, integers 0..1023 for umbrage_to_unorm10
// The last four bits are the high ones of B, so a target cleared to white is at the far plane
//   depth   clamped to [0, 1]. NaN counts as far
inline float3 umbrage_encode_rgb10(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    float high = metal::floor(x * (1.0 / 16384.0));
    float rest = x - high * 16384.0;
    float middle = metal::floor(rest * (1.0 / 16.0));
    float low = metal::min(rest - middle * 16.0, 15.0);  // below already: no sum is regrouped across the min
    return float3(high, middle, low * 64.0);
}
` };

export const encode_r16 = { language, name: "encode_r16", summary: "depth to one 16-bit channel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_r16: 16-bit channel of a depth, an integer 0..65535 for umbrage_to_unorm16
//   depth   clamped to [0, 1]. NaN counts as far
inline float umbrage_encode_r16(float depth) {
    return metal::min(metal::floor(umbrage_saturate(depth) * 65536.0), 65535.0);
}
` };

export const encode_float_bits = { language, name: "encode_float_bits", summary: "bit pattern of a float to four channels, R least significant",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "300 es", role: "none", scaled: false,
    needs: [], text: `
// umbrage_encode_float_bits: bit pattern of v as four channels, R least significant, integers 0..255
inline float4 umbrage_encode_float_bits(float v) {
    uint bits = as_type<uint>(v);
    return float4(float(bits & 255u), float((bits >> 8) & 255u), float((bits >> 16) & 255u), float(bits >> 24));
}
` };

export const write_threejs_rgba = { language, name: "write_threejs_rgba", summary: "depth to three.js RGBA, r167 and later",
    exactness: "b", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_write_threejs_rgba: RGBA of a depth, as in three.js r167 and later, values to write as they are
inline float4 umbrage_write_threejs_rgba(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 16777216.0;
    float whole = metal::floor(x);
    float high = metal::floor(whole * (1.0 / 65536.0));
    float rest = whole - high * 65536.0;
    float middle = metal::floor(rest * (1.0 / 256.0));
    float low = rest - middle * 256.0;
    float4 c = float4(high * 0.00392156886, middle * 0.00392156886, low * 0.00392156886, x - whole);
    return v < 1.0 ? c : float4(1.0, 1.0, 1.0, 1.0);
}
` };

export const write_threejs_rgb = { language, name: "write_threejs_rgb", summary: "depth to three.js RGB, r167 and later",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_write_threejs_rgb: RGB of a depth, as in three.js r167 and later, values to write as they are
inline float3 umbrage_write_threejs_rgb(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 65536.0;
    float whole = metal::floor(x);
    float high = metal::floor(whole * (1.0 / 256.0));
    float3 c = float3(high * 0.00392156886, (whole - high * 256.0) * 0.00392156886, x - whole);
    return v < 1.0 ? c : float3(1.0, 1.0, 1.0);
}
` };

export const write_threejs_rg = { language, name: "write_threejs_rg", summary: "depth to three.js RG, r167 and later",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_write_threejs_rg: RG of a depth, as in three.js r167 and later, values to write as they are
inline float2 umbrage_write_threejs_rg(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 256.0;
    float whole = metal::floor(x);
    return v < 1.0 ? float2(whole * 0.00392156886, x - whole) : float2(1.0, 1.0);
}
` };

export const write_threejs_legacy = { language, name: "write_threejs_legacy", summary: "depth to three.js RGBA, r73 to r166",
    exactness: "b", operations: 7, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_write_threejs_legacy: RGBA of a depth, as in three.js r73 to r166, values to write as they are
//   1.0 reads back as 255/256. umbrage_encode_threejs_legacy_repaired does not have this fault
inline float4 umbrage_write_threejs_legacy(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 16777216.0 - metal::floor(v * 16777216.0);
    float y = v * 65536.0 - metal::floor(v * 65536.0);
    float z = v * 256.0 - metal::floor(v * 256.0);
    float4 c = float4(x, y - x * (1.0 / 256.0), z - y * (1.0 / 256.0), v - z * (1.0 / 256.0));
    return c * 1.00392163;
}
` };

export const encode_threejs_legacy_repaired = { language, name: "encode_threejs_legacy_repaired", summary: "depth to three.js RGBA, r73 to r166, without its fault",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_threejs_legacy_repaired: channels of a depth for readers of three.js r73 to r166. 1.0 decodes to 1.0
//   Returns integers 0..255 (umbrage_to_unorm writes them)
inline float4 umbrage_encode_threejs_legacy_repaired(float depth) {
    float v = umbrage_saturate(depth);
    float x = metal::floor(v * 16777216.0);
    float high = metal::floor(x * (1.0 / 65536.0));
    float rest = x - high * 65536.0;
    float middle = metal::floor(rest * (1.0 / 256.0));
    float low = metal::min(rest - middle * 256.0, 255.0);  // below already: no sum is regrouped across the min
    return v < 1.0 ? float4(0.0, low, middle, high) : float4(255.0, 255.0, 255.0, 255.0);
}
` };

export const write_base255 = { language, name: "write_base255", summary: "depth to base-255 RGBA of Cesium, Babylon.js, bgfx",
    exactness: "b", operations: 6, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_write_base255: base-255 RGBA of a depth, values to write as they are. The store must round
// 1.0 reads back as 0.0. umbrage_encode_base255_repaired has neither fault
inline float4 umbrage_write_base255(float depth) {
    float v = umbrage_saturate(depth);
    float4 e = float4(v, v * 255.0, v * 65025.0, v * 16581375.0);
    e = e - metal::floor(e);
    float4 c = float4(e.x - e.y * 0.00392156886, e.y - e.z * 0.00392156886, e.z - e.w * 0.00392156886, e.w);
    return c;
}
` };

export const encode_base255_repaired = { language, name: "encode_base255_repaired", summary: "depth to base-255 RGBA without its faults",
    exactness: "b", operations: 7, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_encode_base255_repaired: channels of a depth for readers of base-255 RGBA. 1.0 decodes to 1.0
//   Returns integers 0..255 (umbrage_to_unorm writes them)
inline float4 umbrage_encode_base255_repaired(float depth) {
    float x = umbrage_saturate(depth) * 255.0;
    float y = (x - metal::floor(x)) * 255.0;
    float z = (y - metal::floor(y)) * 255.0;
    float w = (z - metal::floor(z)) * 255.0;
    return float4(metal::floor(x), metal::floor(y), metal::floor(z), metal::floor(w));
}
` };

export const fetch_clamped = { language, name: "fetch_clamped", summary: "texel of a map, clamped to the nearest one inside",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [texel], text: `
// umbrage_fetch_clamped: texel of a map, or the nearest one inside for coordinates outside
inline float4 umbrage_fetch_clamped(metal::texture2d<float> map, float2 size, float2 texel) {
    return umbrage_texel(map, size, metal::clamp(texel, float2(0.0, 0.0), size - 1.0));
}
` };

export const encode_rg9_table = { language, name: "encode_rg9_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg9_table: two channels of a 9-bit depth code through a lookup table, integers 0..255
//   table   512 x 1 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg9_table(metal::texture2d<float> table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 512.0), 511.0);
    float row = metal::floor(x * (1.0 / 512.0));
    float2 texel = float2(x - row * 512.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(512.0, 1.0), texel));
    return float2(k.x, k.y);
}
` };

export const encode_rg10_table = { language, name: "encode_rg10_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg10_table: two channels of a 10-bit depth code through a lookup table, integers 0..255
//   table   1024 x 1 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg10_table(metal::texture2d<float> table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 1024.0), 1023.0);
    float row = metal::floor(x * (1.0 / 1024.0));
    float2 texel = float2(x - row * 1024.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(1024.0, 1.0), texel));
    return float2(k.x, k.y);
}
` };

export const encode_rg11_table = { language, name: "encode_rg11_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg11_table: two channels of a 11-bit depth code through a lookup table, integers 0..255
//   table   2048 x 1 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg11_table(metal::texture2d<float> table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    float row = metal::floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 1.0), texel));
    return float2(k.x, k.y);
}
` };

export const encode_rg12_table = { language, name: "encode_rg12_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg12_table: two channels of a 12-bit depth code through a lookup table, integers 0..255
//   table   2048 x 2 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg12_table(metal::texture2d<float> table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 4096.0), 4095.0);
    float row = metal::floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 2.0), texel));
    return float2(k.x, k.y);
}
` };

export const encode_rg13_table = { language, name: "encode_rg13_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg13_table: two channels of a 13-bit depth code through a lookup table, integers 0..255
//   table   2048 x 4 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg13_table(metal::texture2d<float> table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    float row = metal::floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 4.0), texel));
    return float2(k.x, k.y);
}
` };

export const encode_rg14_table = { language, name: "encode_rg14_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg14_table: two channels of a 14-bit depth code through a lookup table, integers 0..255
//   table   2048 x 8 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg14_table(metal::texture2d<float> table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    float row = metal::floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 8.0), texel));
    return float2(k.x, k.y);
}
` };

export const encode_rg15_table = { language, name: "encode_rg15_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg15_table: two channels of a 15-bit depth code through a lookup table, integers 0..255
//   table   2048 x 16 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg15_table(metal::texture2d<float> table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    float row = metal::floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 16.0), texel));
    return float2(k.x, k.y);
}
` };

export const encode_rg16_table = { language, name: "encode_rg16_table", summary: "depth to two 8-bit channels through a lookup texture",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, from_unorm, fetch_clamped], text: `
// umbrage_encode_rg16_table: two channels of a 16-bit depth code through a lookup table, integers 0..255
//   table   2048 x 32 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
inline float2 umbrage_encode_rg16_table(metal::texture2d<float> table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    float row = metal::floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 32.0), texel));
    return float2(k.x, k.y);
}
` };

export const decode_rg9 = { language, name: "decode_rg9", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg9: depth from the two channels of a 9-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
inline float umbrage_decode_rg9(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 2.0 + edge) * (1.0 / 512.0);
}
` };

export const decode_rg10 = { language, name: "decode_rg10", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg10: depth from the two channels of a 10-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
inline float umbrage_decode_rg10(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 4.0 + edge) * (1.0 / 1024.0);
}
` };

export const decode_rg11 = { language, name: "decode_rg11", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg11: depth from the two channels of a 11-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
inline float umbrage_decode_rg11(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 8.0 + edge) * (1.0 / 2048.0);
}
` };

export const decode_rg12 = { language, name: "decode_rg12", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg12: depth from the two channels of a 12-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
inline float umbrage_decode_rg12(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 16.0 + edge) * (1.0 / 4096.0);
}
` };

export const decode_rg13 = { language, name: "decode_rg13", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg13: depth from the two channels of a 13-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
inline float umbrage_decode_rg13(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 32.0 + edge) * (1.0 / 8192.0);
}
` };

export const decode_rg14 = { language, name: "decode_rg14", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg14: depth from the two channels of a 14-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
inline float umbrage_decode_rg14(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 64.0 + edge) * (1.0 / 16384.0);
}
` };

export const decode_rg15 = { language, name: "decode_rg15", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg15: depth from the two channels of a 15-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
inline float umbrage_decode_rg15(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 128.0 + edge) * (1.0 / 32768.0);
}
` };

export const decode_rg16 = { language, name: "decode_rg16", summary: "two 8-bit channels, R the low byte, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rg16: depth from the two channels of a 16-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
inline float umbrage_decode_rg16(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 256.0 + edge) * (1.0 / 65536.0);
}
` };

export const decode_rgb24 = { language, name: "decode_rgb24", summary: "three 8-bit channels, R most significant, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm], text: `
// umbrage_decode_rgb24: depth from three channels, as sampled
//   edge   0.0 or 1.0: lower or upper edge of the quantization step
inline float umbrage_decode_rgb24(float3 c, float edge) {
    float3 k = umbrage_from_unorm(c);
    return ((k.x * 256.0 + k.y) * 256.0 + k.z + edge) * (1.0 / 16777216.0);
}
` };

export const decode_rgb10 = { language, name: "decode_rgb10", summary: "three 10-bit channels, R most significant, to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm10], text: `
// umbrage_decode_rgb10: depth from three 10-bit channels, as sampled
//   edge   0.0 or 1.0: lower or upper edge of the quantization step
inline float umbrage_decode_rgb10(float3 c, float edge) {
    float3 k = umbrage_from_unorm10(c);
    return ((k.x * 1024.0 + k.y) * 16.0 + metal::floor(k.z * (1.0 / 64.0)) + edge) * (1.0 / 16777216.0);
}
` };

export const decode_r16 = { language, name: "decode_r16", summary: "one 16-bit channel to depth",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [from_unorm16], text: `
// umbrage_decode_r16: depth from one 16-bit channel, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
inline float umbrage_decode_r16(float c, float edge) {
    return (umbrage_from_unorm16(c) + edge) * (1.0 / 65536.0);
}
` };

export const decode_float_bits = { language, name: "decode_float_bits", summary: "four channels, R least significant, to the float they hold",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "300 es", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_decode_float_bits: float from the four channels of its bit pattern, as sampled, R least significant
inline float umbrage_decode_float_bits(float4 c) {
    uint r = uint(umbrage_saturate(c.x) * 255.0 + 0.5);
    uint g = uint(umbrage_saturate(c.y) * 255.0 + 0.5);
    uint b = uint(umbrage_saturate(c.z) * 255.0 + 0.5);
    uint a = uint(umbrage_saturate(c.w) * 255.0 + 0.5);
    return as_type<float>(r | (g << 8) | (b << 16) | (a << 24));
}
` };

export const decode_threejs_rgba = { language, name: "decode_threejs_rgba", summary: "three.js RGBA, r167 and later, to depth",
    exactness: "b", operations: 7, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_decode_threejs_rgba: depth from the RGBA format of three.js r167 and later, as sampled
inline float umbrage_decode_threejs_rgba(float4 c) {
    float depth = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (255.0 / 16777216.0) + c.w *
        (1.0 / 16777216.0);
    return depth;
}
` };

export const decode_threejs_rgb = { language, name: "decode_threejs_rgb", summary: "three.js RGB, r167 and later, to depth",
    exactness: "b", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_decode_threejs_rgb: depth from the RGB format of three.js r167 and later, as sampled
inline float umbrage_decode_threejs_rgb(float3 c) {
    float depth = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (1.0 / 65536.0);
    return depth;
}
` };

export const decode_threejs_rg = { language, name: "decode_threejs_rg", summary: "three.js RG, r167 and later, to depth",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_decode_threejs_rg: depth from the RG format of three.js r167 and later, as sampled
inline float umbrage_decode_threejs_rg(float2 c) {
    float depth = c.x * (255.0 / 256.0) + c.y * (1.0 / 256.0);
    return depth;
}
` };

export const decode_threejs_legacy = { language, name: "decode_threejs_legacy", summary: "three.js RGBA, r73 to r166, to depth",
    exactness: "b", operations: 7, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_decode_threejs_legacy: depth from the RGBA format of three.js r73 to r166, as sampled
inline float umbrage_decode_threejs_legacy(float4 c) {
    float depth = c.x * (255.0 / 4294967296.0) + c.y * (255.0 / 16777216.0) + c.z * (255.0 / 65536.0) + c.w *
        (255.0 / 256.0);
    return depth;
}
` };

export const decode_base255 = { language, name: "decode_base255", summary: "base-255 RGBA to depth",
    exactness: "b", operations: 6, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_decode_base255: depth from base-255 RGBA, as sampled
inline float umbrage_decode_base255(float4 c) {
    float depth = c.x + c.y * 0.00392156886 + c.z * 0.0000153787005 + c.w * 0.0000000603086294;
    return depth;
}
` };

export const level_rg9 = { language, name: "level_rg9", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg9: level of a texel from two channels of a 9-bit code, on the scale of umbrage_receiver_rg9
//   1.0 is not the far plane on this scale
inline float umbrage_level_rg9(float2 c) {
    return c.x + c.y * 2.0;  // an exact product: fused or not, it rounds once
}
` };

export const level_rg10 = { language, name: "level_rg10", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg10: level of a texel from two channels of a 10-bit code, on the scale of umbrage_receiver_rg10
//   1.0 is not the far plane on this scale
inline float umbrage_level_rg10(float2 c) {
    return c.x + c.y * 4.0;  // an exact product: fused or not, it rounds once
}
` };

export const level_rg11 = { language, name: "level_rg11", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg11: level of a texel from two channels of a 11-bit code, on the scale of umbrage_receiver_rg11
//   1.0 is not the far plane on this scale
inline float umbrage_level_rg11(float2 c) {
    return c.x + c.y * 8.0;  // an exact product: fused or not, it rounds once
}
` };

export const level_rg12 = { language, name: "level_rg12", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg12: level of a texel from two channels of a 12-bit code, on the scale of umbrage_receiver_rg12
//   1.0 is not the far plane on this scale
inline float umbrage_level_rg12(float2 c) {
    return c.x + c.y * 16.0;  // an exact product: fused or not, it rounds once
}
` };

export const level_rg13 = { language, name: "level_rg13", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg13: level of a texel from two channels of a 13-bit code, on the scale of umbrage_receiver_rg13
//   1.0 is not the far plane on this scale
inline float umbrage_level_rg13(float2 c) {
    return c.x + c.y * 32.0;  // an exact product: fused or not, it rounds once
}
` };

export const level_rg14 = { language, name: "level_rg14", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg14: level of a texel from two channels of a 14-bit code, on the scale of umbrage_receiver_rg14
//   1.0 is not the far plane on this scale
inline float umbrage_level_rg14(float2 c) {
    return c.x + c.y * 64.0;  // an exact product: fused or not, it rounds once
}
` };

export const level_rg15 = { language, name: "level_rg15", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg15: level of a texel from two channels of a 15-bit code, on the scale of umbrage_receiver_rg15
//   1.0 is not the far plane on this scale
inline float umbrage_level_rg15(float2 c) {
    return c.x + c.y * 128.0;  // an exact product: fused or not, it rounds once
}
` };

export const level_rg16 = { language, name: "level_rg16", summary: "two channels to a level, for maps that are not decoded",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_level_rg16: level of a texel from two channels of a 16-bit code, on the scale of umbrage_receiver_rg16
//   1.0 is not the far plane on this scale
inline float umbrage_level_rg16(float2 c) {
    return c.x + c.y * 256.0;  // an exact product: fused or not, it rounds once
}
` };

export const receiver_rg9 = { language, name: "receiver_rg9", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg9: receiver depth on the scale of umbrage_level_rg9. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg9(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg9(float depth, float edge) {
    float level = (metal::ceil(depth * 512.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
` };

export const receiver_rg10 = { language, name: "receiver_rg10", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg10: receiver depth on the scale of umbrage_level_rg10. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg10(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg10(float depth, float edge) {
    float level = (metal::ceil(depth * 1024.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
` };

export const receiver_rg11 = { language, name: "receiver_rg11", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg11: receiver depth on the scale of umbrage_level_rg11. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg11(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg11(float depth, float edge) {
    float level = (metal::ceil(depth * 2048.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
` };

export const receiver_rg12 = { language, name: "receiver_rg12", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg12: receiver depth on the scale of umbrage_level_rg12. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg12(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg12(float depth, float edge) {
    float level = (metal::ceil(depth * 4096.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
` };

export const receiver_rg13 = { language, name: "receiver_rg13", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg13: receiver depth on the scale of umbrage_level_rg13. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg13(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg13(float depth, float edge) {
    float level = (metal::ceil(depth * 8192.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
` };

export const receiver_rg14 = { language, name: "receiver_rg14", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg14: receiver depth on the scale of umbrage_level_rg14. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg14(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg14(float depth, float edge) {
    float level = (metal::ceil(depth * 16384.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
` };

export const receiver_rg15 = { language, name: "receiver_rg15", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg15: receiver depth on the scale of umbrage_level_rg15. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg15(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg15(float depth, float edge) {
    float level = (metal::ceil(depth * 32768.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
` };

export const receiver_rg16 = { language, name: "receiver_rg16", summary: "receiver to a level, for maps that are not decoded",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_rg16: receiver depth on the scale of umbrage_level_rg16. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg16(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg16(float depth, float edge) {
    float level = (metal::ceil(depth * 65536.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
` };

export const decode_ps14 = { language, name: "decode_ps14", summary: "r / 8 + g as the Radeon 8500 computed it",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [], text: `
// umbrage_decode_ps14: x / 2040 from the channels of an 11-bit code, as sampled. Compare with umbrage_receiver_ps14
//   1.0 is not the far plane on this scale
inline float umbrage_decode_ps14(float2 c) {
    return c.x * 0.125 + c.y;  // an exact product: fused or not, it rounds once
}
` };

export const receiver_ps14 = { language, name: "receiver_ps14", summary: "receiver depth on the scale of decode_ps14",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_receiver_ps14: depth * 256 / 255, the scale of umbrage_decode_ps14. Beyond the far plane every texel lights
// it
inline float umbrage_receiver_ps14(float depth) {
    return depth > 1.0 ? -1.0 : depth * 1.00392163;
}
` };

export const fixed_ps14 = { language, name: "fixed_ps14", summary: "number in a register of the Radeon 8500",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_fixed_ps14: nearest multiple of 1 / 4096 from -8.0 to 8.0 - 1 / 4096; NaN becomes the last of them
inline float umbrage_fixed_ps14(float v) {
    // not v < 8.0 ? v : ...: Mesa turns it into min, and softpipe's min gives NaN
    float within = v > -8.0 && v < 7.999755859375 ? v : (v < 0.0 ? -8.0 : 7.999755859375);
    float steps = within * 4096.0;
    float below = metal::floor(steps);
    return (steps - below < 0.5 ? below : below + 1.0) * 0.000244140625;
}
` };

export const decode_fixed_ps14 = { language, name: "decode_fixed_ps14", summary: "r / 8 + g in the Radeon 8500's fixed point",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: true,
    needs: [fixed_ps14], text: `
// umbrage_decode_fixed_ps14: x / 2040 in steps of 1 / 4096 from the channels of an 11-bit code, as sampled
//   compare with umbrage_fixed_ps14(umbrage_receiver_ps14(depth)); 1.0 is not the far plane on this scale
inline float umbrage_decode_fixed_ps14(float2 c) {
    return metal::floor(umbrage_fixed_ps14(c.x) * 512.0) * 0.000244140625 + umbrage_fixed_ps14(c.y);
}
` };

export const inside_map = { language, name: "inside_map", summary: "true if a texel lies inside the map",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_inside_map: true if a texel lies inside a map of size texels
inline bool umbrage_inside_map(float2 size, float2 texel) {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}
` };

export const texel_inside = { language, name: "texel_inside", summary: "texel of the map, itself if the map has it",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "texel_inside", scaled: false,
    needs: [], text: `
// umbrage_texel_inside: texel of the map, itself if the map has it; otherwise any, whose value does not count
inline float2 umbrage_texel_inside(float2 size, float2 texel) {
    return metal::min(metal::abs(texel), size - 1.0);
}
` };

export const fetch_bordered = { language, name: "fetch_bordered", summary: "texel of a map, or a border value outside it",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [texel, texel_inside], text: `
// umbrage_fetch_bordered: texel of a map, or border outside it
inline float4 umbrage_fetch_bordered(metal::texture2d<float> map, float2 size, float2 texel, float4 border) {
    float2 at = umbrage_texel_inside(size, texel);
    float4 value = umbrage_texel(map, size, at);
    return at.x == texel.x && at.y == texel.y ? value : border;
}
` };

export const fetch_depth = { language, name: "fetch_depth", summary: "stored depth of a texel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "fetch_depth", scaled: false,
    needs: [texel, texel_inside], text: `
// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
inline float umbrage_fetch_depth(metal::texture2d<float> map, float2 size, float2 texel) {
    float2 inside = umbrage_texel_inside(size, texel);
    float4 value = umbrage_texel(map, size, inside);
    float depth = value.x;
    return inside.x == texel.x && inside.y == texel.y ? depth : 1.0;
}
` };

export const depth_at = { language, name: "depth_at", summary: "stored depth at a point of the map",
    exactness: "c", operations: 4, within: 0, as_written: false, lowest: "100", role: "depth_at", scaled: false,
    needs: [fetch_depth], text: `
// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the neighbor's
//   uv  point on the map, (0.0, 0.0) to (1.0, 1.0), no NaN
inline float umbrage_depth_at(metal::texture2d<float> map, float2 size, float2 uv) {
    return umbrage_fetch_depth(map, size, metal::floor(uv * size));
}
` };

export const beyond_far_plane = { language, name: "beyond_far_plane", summary: "receivers beyond the far plane",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "beyond_far_plane", scaled: false,
    needs: [], text: `
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
inline bool umbrage_beyond_far_plane(float receiver) {
    return receiver > 1.0;
}
` };

export const in_filter_domain = { language, name: "in_filter_domain", summary: "true for receivers that a filter compares; others are lit",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [inside_texel_space, beyond_far_plane], text: `
// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
inline bool umbrage_in_filter_domain(float2 coord, float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
` };

export const compare = { language, name: "compare", summary: "visibility from one comparison",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "compare", scaled: false,
    needs: [], text: `
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
inline float umbrage_compare(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
` };

export const lit = { language, name: "lit", summary: "visibility from one comparison with a texel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "lit", scaled: false,
    needs: [compare, fetch_depth], text: `
// umbrage_lit: visibility from one comparison with a texel
inline float umbrage_lit(metal::texture2d<float> map, float2 size, float2 texel, float receiver) {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
` };

export const lit_2x2 = { language, name: "lit_2x2", summary: "visibility from comparisons with 2x2 texels",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "lit_2x2", scaled: false,
    needs: [lit], text: `
// umbrage_lit_2x2: visibility from the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
inline float4 umbrage_lit_2x2(metal::texture2d<float> map, float2 size, float2 texel, float receiver) {
    float a = umbrage_lit(map, size, texel, receiver);
    float b = umbrage_lit(map, size, texel + float2(1.0, 0.0), receiver);
    float c = umbrage_lit(map, size, texel + float2(0.0, 1.0), receiver);
    float d = umbrage_lit(map, size, texel + float2(1.0, 1.0), receiver);
    return float4(a, b, c, d);
}
` };

export const map_covers = { language, name: "map_covers", summary: "true if a receiver lies in a prefiltered map",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "map_covers", scaled: false,
    needs: [], text: `
// umbrage_map_covers: true if a receiver lies in a prefiltered map or a table; elsewhere it is lit
inline bool umbrage_map_covers(float2 size, float2 coord) {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
` };

export const within_far_plane = { language, name: "within_far_plane", summary: "receivers up to the far plane; NaN is not",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "within_far_plane", scaled: false,
    needs: [], text: `
// umbrage_within_far_plane: true if a receiver is a number and not beyond the far plane
inline bool umbrage_within_far_plane(float receiver) {
    return receiver <= 1.0;
}
` };

export const compare_dx_sdk = { language, name: "compare_dx_sdk", summary: "shadow if stored + epsilon < receiver",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
inline float umbrage_compare_dx_sdk(float receiver, float stored, float epsilon) {
    float limit = stored + epsilon;
    return limit < receiver ? 0.0 : 1.0;
}
` };

export const compare_exercise = { language, name: "compare_exercise", summary: "lit if current < stored + epsilon",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
inline float umbrage_compare_exercise(float current, float stored, float epsilon) {
    float limit = stored + epsilon;
    return current < limit ? 1.0 : 0.0;
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
inline float umbrage_window_sum3(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float steps,
                                 float k0, float k1) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? metal::floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = metal::floor(x * (1.0 / 256.0));
    float2 s = metal::floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k0);
    float2 w0 = metal::floor(r * k0);
    float2 w2 = metal::floor(r * k0 + s * k1);
    float2 w3 = metal::floor(s * k0);
    float2 w1 = metal::max(whole - (w0 + w2 + w3), float2(0.0, 0.0));
    float2 first = texel - 1.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2(map, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2(map, size, first + float2(2.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    return compared ? n : whole * whole;
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
inline float umbrage_window_sum5(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float steps,
                                 float k0, float k1, float k2) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? metal::floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = metal::floor(x * (1.0 / 256.0));
    float2 s = metal::floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k2 + k1 + k0);
    float2 w0 = metal::floor(r * k0);
    float2 w1 = metal::floor(r * k1 + s * k0);
    float2 w3 = metal::floor(r * k1 + s * k2);
    float2 w4 = metal::floor(r * k0 + s * k1);
    float2 w5 = metal::floor(s * k0);
    float2 w2 = metal::max(whole - (w0 + w1 + w3 + w4 + w5), float2(0.0, 0.0));
    float2 first = texel - 2.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2(map, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2(map, size, first + float2(2.0, 0.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, first + float2(4.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    return compared ? n : whole * whole;
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
inline float umbrage_window_sum7(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float steps,
                                 float k0, float k1, float k2, float k3) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? metal::floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = metal::floor(x * (1.0 / 256.0));
    float2 s = metal::floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k2 + k3 + k2 + k1 + k0);
    float2 w0 = metal::floor(r * k0);
    float2 w1 = metal::floor(r * k1 + s * k0);
    float2 w2 = metal::floor(r * k2 + s * k1);
    float2 w4 = metal::floor(r * k2 + s * k3);
    float2 w5 = metal::floor(r * k1 + s * k2);
    float2 w6 = metal::floor(r * k0 + s * k1);
    float2 w7 = metal::floor(s * k0);
    float2 w3 = metal::max(whole - (w0 + w1 + w2 + w4 + w5 + w6 + w7), float2(0.0, 0.0));
    float2 first = texel - 3.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2(map, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2(map, size, first + float2(2.0, 0.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, first + float2(4.0, 0.0), receiver);
    float4 d = umbrage_lit_2x2(map, size, first + float2(6.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 2.0), receiver);
    d = umbrage_lit_2x2(map, size, first + float2(6.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 4.0), receiver);
    d = umbrage_lit_2x2(map, size, first + float2(6.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 6.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 6.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 6.0), receiver);
    d = umbrage_lit_2x2(map, size, first + float2(6.0, 6.0), receiver);
    n += w6.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w7.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    return compared ? n : whole * whole;
}
` };

export const disc_rotation = { language, name: "disc_rotation", summary: "rotation of a disc for a pixel, one of 16",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [inside_texel_space], text: `
// umbrage_disc_rotation: rotation of a disc for a pixel. Returns (cos, -sin, sin, cos) in 1/64
//   pixel   gl_FragCoord.xy, for example. Each of the 16 rotations is used once in every 4 x 4 pixels
inline float4 umbrage_disc_rotation(float2 pixel) {
    float2 whole = umbrage_inside_texel_space(pixel) ? metal::floor(pixel) : float2(0.0, 0.0);
    float v = whole.x * 4.0 + whole.y;
    v = v - metal::floor(v * (1.0 / 16.0)) * 16.0;
    float quarter = metal::floor(v * 0.25);
    float base = v - quarter * 4.0;
    float2 low = base < 0.5 ? float2(64.0, 0.0) : float2(59.0, 24.0);
    float2 high = base < 2.5 ? float2(45.0, 45.0) : float2(24.0, 59.0);
    float2 first = base < 1.5 ? low : high;
    float2 once = quarter < 0.5 ? first : float2(0.0 - first.y, first.x);
    float2 twice = quarter < 2.5 ? float2(0.0 - first.x, 0.0 - first.y) : float2(first.y, 0.0 - first.x);
    float2 turned = quarter < 1.5 ? once : twice;
    return float4(turned.x, 0.0 - turned.y, turned.y, turned.x);
}
` };

export const sheared_rotation = { language, name: "sheared_rotation", summary: "rotation of a disc, sheared to an ellipse",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_sheared_rotation: rotation of a disc, and then a shear along x
//   rotation   from umbrage_disc_rotation
//   shear      by how much x grows with y, both in radii of the ellipse; -2.0 to 2.0
inline float4 umbrage_sheared_rotation(float4 rotation, float shear) {
    float x = rotation.x + shear * rotation.z;
    float y = rotation.y + shear * rotation.w;
    return float4(x, y, rotation.z, rotation.w);
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
inline float2 umbrage_disc_tap(float2 position, float2 p, float4 rotation, float2 radius) {
    float2 at = position * (1.0 / 256.0);
    float2 texel = metal::floor(at);
    float2 within = metal::clamp(at - texel, float2(0.0, 0.0), float2(1.0, 1.0));  // no sum is regrouped across it
    float2 wide = float2(rotation.x, rotation.y) * (radius.x * (1.0 / 16384.0));
    float2 high = float2(rotation.z, rotation.w) * (radius.y * (1.0 / 16384.0));
    float x = wide.x * p.x + within.x + wide.y * p.y;
    float y = high.x * p.x + within.y + high.y * p.y;
    return texel + metal::floor(float2(x, y));
}
` };

export const disc_radius = { language, name: "disc_radius", summary: "radius of a disc, rounded down to 1/16 texel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_disc_radius: radius of a disc in 1/16 texel, from one in texels
// Returns an integer from 0 to 4095, and 0 for NaN
inline float umbrage_disc_radius(float radius) {
    float inside = radius > 0.0 ? metal::floor(radius * 16.0) : 0.0;
    return radius >= 255.9375 ? 4095.0 : inside;
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
inline float umbrage_ellipse8(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float2 radius,
                              float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(3.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-4.0, 5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-12.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, 6.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 13.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, -7.0), rotation, radius), receiver);
    return compared ? n * (1.0 / 8.0) : 1.0;
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
inline float umbrage_ellipse16(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float2 radius,
                               float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 7.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(8.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, 5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-12.0, 4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-9.0, 10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, -4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, -12.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-7.0, -12.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(14.0, -2.0), rotation, radius), receiver);
    return compared ? n * (1.0 / 16.0) : 1.0;
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
inline float umbrage_ellipse32(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float2 radius,
                               float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-2.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(3.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-4.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 6.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-5.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, -2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-8.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(8.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(5.0, 7.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -9.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(6.0, -7.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-8.0, 5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-3.0, -10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-6.0, 10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(5.0, -12.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(13.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, 4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(10.0, -10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(14.0, -2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-11.0, 9.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(3.0, 14.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, -6.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(12.0, 8.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-4.0, 14.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-7.0, -13.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, -15.0), rotation, radius), receiver);
    return compared ? n * (1.0 / 32.0) : 1.0;
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
inline float umbrage_disc8(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float radius,
                           float4 rotation) {
    float rho = umbrage_disc_radius(radius);
    return umbrage_ellipse8(map, size, coord, receiver, float2(rho, rho), rotation);
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
inline float umbrage_disc16(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float radius,
                            float4 rotation) {
    float rho = umbrage_disc_radius(radius);
    return umbrage_ellipse16(map, size, coord, receiver, float2(rho, rho), rotation);
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
inline float umbrage_disc32(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float radius,
                            float4 rotation) {
    float rho = umbrage_disc_radius(radius);
    return umbrage_ellipse32(map, size, coord, receiver, float2(rho, rho), rotation);
}
` };

export const hard = { language, name: "hard", summary: "unfiltered shadow test of the nearest texel",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, lit], filter: { reads: "comparisons", reach: 0.5, arguments: [], in_shadow: true }, text: `
// umbrage_hard: shadow test without a filter. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
inline float umbrage_hard(metal::texture2d<float> map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 texel = compared ? metal::floor(coord) : float2(0.0, 0.0);  // no branch: fetches of several taps overlap
    float lit = umbrage_lit(map, size, texel, receiver);
    return compared ? lit : 1.0;
}
` };

export const four_tap = { language, name: "four_tap", summary: "mean of four taps, each with its own coordinates",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [lit, beyond_far_plane], filter: { reads: "comparisons", reach: 1, arguments: [], offsets: [[-0.5, -0.5], [0.5, -0.5], [-0.5, 0.5], [0.5, 0.5]] }, text: `
// umbrage_four_tap: mean of the shadow test at four taps. Returns visibility, 1.0 = lit
//   map, size    shadow map and its size in texels
//   a, b, c, d   taps in texels. All are lit where their mean magnitude is 2^15 or more along an axis
//   receiver     receiver depth in [0, 1], bias applied
inline float umbrage_four_tap(metal::texture2d<float> map, float2 size, float2 a, float2 b, float2 c, float2 d,
                              float receiver) {
    float2 a_texel = metal::floor(a);
    float2 b_texel = metal::floor(b);
    float2 c_texel = metal::floor(c);
    float2 d_texel = metal::floor(d);
    float2 sum = metal::abs(a_texel) + metal::abs(b_texel) + metal::abs(c_texel) + metal::abs(d_texel);
    // two different limits on purpose: Mesa turns a single one into max(x, y) < limit, which loses a NaN
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x < 131072.0 && sum.y * 2.0 < 262144.0;
    float count = umbrage_lit(map, size, a_texel, receiver) + umbrage_lit(map, size, b_texel, receiver) +
        umbrage_lit(map, size, c_texel, receiver) + umbrage_lit(map, size, d_texel, receiver);
    return compared ? count * 0.25 : 1.0;
}
` };

export const pcf_2x2 = { language, name: "pcf_2x2", summary: "bilinear 2x2 PCF, weights in steps of 1/256",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, lit_2x2], filter: { reads: "comparisons", reach: 1, arguments: [], in_shadow: true, linear: { name: "pcf_2x2_hardware", weights: "" } }, text: `
// umbrage_pcf_2x2: bilinear 2x2 PCF. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
inline float umbrage_pcf_2x2(metal::texture2d<float> map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? metal::floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = metal::floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    float2 hi = metal::clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0));
    float2 lo = 1.0 - hi;
    float4 lit = umbrage_lit_2x2(map, size, texel, receiver);
    float visibility = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    return compared ? visibility : 1.0;
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
inline float umbrage_pcf_2x2_dx_sdk(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                    float epsilon) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = metal::floor(x);
    float2 weight = x - texel;
    float a = umbrage_compare_dx_sdk(receiver, umbrage_fetch_depth(map, size, texel), epsilon);
    float right = umbrage_fetch_depth(map, size, texel + float2(1.0, 0.0));
    float above = umbrage_fetch_depth(map, size, texel + float2(0.0, 1.0));
    float beyond = umbrage_fetch_depth(map, size, texel + float2(1.0, 1.0));
    float b = umbrage_compare_dx_sdk(receiver, right, epsilon);
    float c = umbrage_compare_dx_sdk(receiver, above, epsilon);
    float d = umbrage_compare_dx_sdk(receiver, beyond, epsilon);
    float low = a + weight.x * (b - a);
    float high = c + weight.x * (d - c);
    float visibility = low + weight.y * (high - low);
    return compared ? visibility : 1.0;
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
inline float umbrage_box_count(metal::texture2d<float> map, float2 size, float2 coord, float receiver, int radius) {
    int r = radius < 0 ? 0 : (radius < 8 ? radius : 8);
    int width = 2 * r + 1;
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 first = compared ? metal::floor(coord) - float(r) : float2(0.0, 0.0);
    float count = 0.0;
    for (int j = 0; j < 17; j++) {
        if (j >= width) break;
        for (int i = 0; i < 17; i++) {
            if (i >= width) break;
            count += umbrage_lit(map, size, first + float2(float(i), float(j)), receiver);
        }
    }
    return compared ? count : float(width * width);
}
` };

export const box_scale = { language, name: "box_scale", summary: "1 / (2r+1)^2",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_box_scale: 1 / (2r+1)^2, rounded to nearest
inline float umbrage_box_scale(int radius) {
    float scale = 0.00346020772;  // not returned as a literal: that would have the host's precision
    if (radius < 8) scale = 0.00444444455;
    if (radius < 7) scale = 0.00591715984;
    if (radius < 6) scale = 0.00826446246;
    if (radius < 5) scale = 0.0123456791;
    if (radius < 4) scale = 0.0204081628;
    if (radius < 3) scale = 0.0399999991;
    if (radius < 2) scale = 0.111111112;
    if (radius < 1) scale = 1.0;
    return scale;
}
` };

export const box = { language, name: "box", summary: "lit fraction of a box of radius 0..8 (box PCF)",
    exactness: "b", operations: 290, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [box_count, box_scale], filter: { reads: "comparisons", reach: 1.5, arguments: [{ name: "radius", type: "int", value: 1 }], in_shadow: true }, text: `
// umbrage_box: box PCF, the lit fraction of a (2r+1) x (2r+1) box. Returns visibility, 1.0 = lit
//   parameters as for umbrage_box_count
inline float umbrage_box(metal::texture2d<float> map, float2 size, float2 coord, float receiver, int radius) {
    float visibility = umbrage_box_count(map, size, coord, receiver, radius) * umbrage_box_scale(radius);
    return visibility < 0.999 ? visibility : 1.0;  // 121 times the rounded 1/121 is not 1
}
` };

export const tent2 = { language, name: "tent2", summary: "PCF kernel 1 1",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, lit_2x2], filter: { reads: "comparisons", reach: 1.5, arguments: [], in_shadow: true }, text: `
// umbrage_tent2: PCF over 3 x 3 texels, weights 1 1. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
inline float umbrage_tent2(metal::texture2d<float> map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = metal::floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative. clamp and max keep compilers from regrouping sums across them
    float2 s = metal::clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 r = 256.0 - s;
    float2 w0 = r * 8.0;
    float2 w2 = s * 8.0;
    float2 w1 = metal::max(4096.0 - w0 - w2, float2(0.0, 0.0));
    float4 a = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    float4 b = umbrage_lit_2x2(map, size, texel + float2(1.0, -1.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, texel + float2(-1.0, 1.0), receiver);
    float4 d = umbrage_lit_2x2(map, size, texel + float2(1.0, 1.0), receiver);
    float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
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
inline float umbrage_tent3(metal::texture2d<float> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum3(map, size, coord, receiver, 256.0, 4.0, 8.0);
    return metal::clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
` };

export const quadratic_b_spline = { language, name: "quadratic_b_spline", summary: "PCF kernel of the quadratic B-spline, 3x3 texels",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, lit_2x2], filter: { reads: "comparisons", reach: 1.5, arguments: [], in_shadow: true }, text: `
// umbrage_quadratic_b_spline: PCF over 3 x 3 texels, weighted by the quadratic B-spline. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
inline float umbrage_quadratic_b_spline(metal::texture2d<float> map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = metal::floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative. clamp and max keep compilers from regrouping sums across them
    float2 s = metal::clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 r = 256.0 - s;
    float2 w0 = metal::floor(r * r * (1.0 / 32.0));
    float2 w2 = metal::floor(s * s * (1.0 / 32.0));
    float2 w1 = metal::max(4096.0 - w0 - w2, float2(0.0, 0.0));
    float4 a = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    float4 b = umbrage_lit_2x2(map, size, texel + float2(1.0, -1.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, texel + float2(-1.0, 1.0), receiver);
    float4 d = umbrage_lit_2x2(map, size, texel + float2(1.0, 1.0), receiver);
    float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
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
inline float umbrage_binomial5(metal::texture2d<float> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 4.0, 6.0);
    return metal::clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
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
inline float umbrage_castano_dyadic5(metal::texture2d<float> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.25, 4.0, 5.5);
    return metal::clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
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
inline float umbrage_castano5(metal::texture2d<float> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 3.0, 4.0);
    return n < 9437184.0 ? n * (1.0 / 65536.0) * 0.00694444450 : 1.0;
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
inline float umbrage_binomial7(metal::texture2d<float> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum7(map, size, coord, receiver, 256.0, 0.25, 1.5, 3.75, 5.0);
    return metal::clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
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
inline float umbrage_tent7(metal::texture2d<float> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum7(map, size, coord, receiver, 256.0, 1.0, 2.0, 3.0, 4.0);
    return metal::clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
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
inline float umbrage_castano7(metal::texture2d<float> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum7(map, size, coord, receiver, 64.0, 1.0, 5.0, 12.0, 16.0);
    return n < 11075584.0 ? n * (1.0 / 4096.0) * 0.000369822490 : 1.0;
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
inline float2 umbrage_cube_lit(metal::texture2d<float> map, float2 size, float3 texel, float receiver) {
    float side = size.y * 0.5;
    float3 n = umbrage_cube_neighbor(texel, side);
    float2 at = umbrage_cube_tile(n.z, side) + float2(n.x, n.y);
    float lit = umbrage_lit(map, size, at, receiver);
    return n.z < 0.0 ? float2(0.0, 0.0) : float2(lit, 1.0);
}
` };

export const pcf_2x2_cube = { language, name: "pcf_2x2_cube", summary: "bilinear 2x2 PCF of a cube map, across its edges",
    exactness: "c", operations: 33, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, cube_lit], text: `
// umbrage_pcf_2x2_cube: bilinear 2x2 PCF across the edges of a cube map. Returns visibility, 1.0 = lit
//   map, size   atlas of 3 x 2 faces and its size in texels
//   at          (s, t, face): s and t in texels of the face, from 0.0 on
//   receiver    distance from the light, bias applied
inline float umbrage_pcf_2x2_cube(metal::texture2d<float> map, float2 size, float3 at, float receiver) {
    float2 coord = float2(at.x, at.y);
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? metal::floor(coord * 256.0 + 0.5) - 128.0 : float2(0.0, 0.0);
    float2 texel = metal::floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    float2 hi = metal::clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0));
    float2 lo = 1.0 - hi;
    float2 sum = umbrage_cube_lit(map, size, float3(texel, at.z), receiver) * (lo.x * lo.y);
    sum += umbrage_cube_lit(map, size, float3(texel + float2(1.0, 0.0), at.z), receiver) * (hi.x * lo.y);
    sum += umbrage_cube_lit(map, size, float3(texel + float2(0.0, 1.0), at.z), receiver) * (lo.x * hi.y);
    sum += umbrage_cube_lit(map, size, float3(texel + float2(1.0, 1.0), at.z), receiver) * (hi.x * hi.y);
    return compared && sum.y > 0.0 ? sum.x / sum.y : 1.0;
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
inline float umbrage_four_tap_hardware(metal::texture2d<float> map, float2 size, float2 a, float2 b, float2 c, float2 d,
                                       float receiver) {
    float2 sum = (metal::abs(a) + metal::abs(b) + metal::abs(c) + metal::abs(d)) * size;
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x + sum.y < 131072.0;
    float count = umbrage_compare(receiver, umbrage_depth_at(map, size, a)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, b)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, c)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, d));
    return compared ? count * 0.25 : 1.0;
}
` };

export const lit_filtered = { language, name: "lit_filtered", summary: "weighted comparisons around a point in texels",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "lit_filtered", scaled: false,
    needs: [pcf_2x2], text: `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
// The sampler of this map cannot weight comparisons, so the shader does
//   coord   in texels, no NaN. Outside texel space it is clamped
inline float umbrage_lit_filtered(metal::texture2d<float> map, float2 size, float2 coord, float receiver) {
    return umbrage_pcf_2x2(map, size, metal::clamp(coord, float2(-32767.0, -32767.0), float2(32767.0, 32767.0)),
                           receiver);
}
` };

export const covered = { language, name: "covered", summary: "share of the texels around a point that lie in the map, along each axis",
    exactness: "c", operations: 6, within: 0, as_written: false, lowest: "100", role: "covered", scaled: false,
    needs: [], text: `
// umbrage_covered: share of the texels around a point that lie in the map, along each axis. Here all of them count
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
inline float2 umbrage_covered(float2 size, float2 uv) {
    return float2(1.0, 1.0);
}
` };

export const lit_between = { language, name: "lit_between", summary: "weighted comparisons around a point, where four texels meet",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "lit_between", scaled: false,
    needs: [lit_filtered], text: `
// umbrage_lit_between: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv    over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   way   from the receiver to where the four texels meet, in texels. Only a receiver's plane uses it
inline float umbrage_lit_between(metal::texture2d<float> map, float2 size, float2 uv, float2 way, float receiver) {
    return umbrage_lit_filtered(map, size, uv * size, receiver);
}
` };

export const lit_at = { language, name: "lit_at", summary: "weighted comparisons around a point in [0, 1]",
    exactness: "c", operations: 0, within: 0.0078125, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [covered, lit_between], text: `
// umbrage_lit_at: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv      over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   coord   receiver in texels
inline float umbrage_lit_at(metal::texture2d<float> map, float2 size, float2 uv, float2 coord, float receiver) {
    float2 way = metal::floor(uv * size + 0.5) - coord;
    float2 inside = umbrage_covered(size, uv);
    float lit = umbrage_lit_between(map, size, uv, way, receiver);
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
inline float umbrage_pcf_2x2_hardware(metal::texture2d<float> map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? coord : float2(0.0, 0.0);
    float lit = umbrage_lit_at(map, size, at / size, at, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? lit : 0.0;
    return compared ? visibility : 1.0;
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
inline float umbrage_window_hardware3(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float k0,
                                      float k1) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = metal::floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k0;
    float2 w0 = k0 + k1 + s * -k1;
    float2 p0 = (texel + (-k0 * 0.5 + k1 * 0.5 + s * (k0 - k1 * 0.5)) / w0) / size;
    float2 v0 = w0 * umbrage_covered(size, p0);
    float2 w1 = k0 + s * k1;
    float2 p1 = (texel + (k0 * 1.5 + s * (k0 + k1 * 1.5)) / w1) / size;
    float2 v1 = w1 * umbrage_covered(size, p1);
    float2 inside = v0 + v1;
    // ... - s: from the receiver to where the four texels of a fetch meet
    float n = 0.0;
    float row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p0.y), float2(-0.5, -0.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p0.y), float2(1.5, -0.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p1.y), float2(-0.5, 1.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p1.y), float2(1.5, 1.5) - s, receiver);
    n += v1.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    float share = metal::clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
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
inline float umbrage_window_hardware5(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float k0,
                                      float k1, float k2) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = metal::floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k2 + k1 + k0;
    float2 w0 = k0 + k1 + s * -k1;
    float2 p0 = (texel + (-k0 * 1.5 - k1 * 0.5 + s * (k0 + k1 * 0.5)) / w0) / size;
    float2 v0 = w0 * umbrage_covered(size, p0);
    float2 w1 = float2(k1 + k2, k1 + k2);
    float2 p1 = (texel + (k1 * 1.5 + k2 * 0.5 + s * (-k1 + k2)) / w1) / size;
    float2 v1 = w1 * umbrage_covered(size, p1);
    float2 w2 = k0 + s * k1;
    float2 p2 = (texel + (k0 * 2.5 + s * (k0 + k1 * 2.5)) / w2) / size;
    float2 v2 = w2 * umbrage_covered(size, p2);
    float2 inside = v0 + v1 + v2;
    // ... - s: from the receiver to where the four texels of a fetch meet
    float n = 0.0;
    float row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p0.y), float2(-1.5, -1.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p0.y), float2(0.5, -1.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, float2(p2.x, p0.y), float2(2.5, -1.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p1.y), float2(-1.5, 0.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p1.y), float2(0.5, 0.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, float2(p2.x, p1.y), float2(2.5, 0.5) - s, receiver);
    n += v1.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p2.y), float2(-1.5, 2.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p2.y), float2(0.5, 2.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, float2(p2.x, p2.y), float2(2.5, 2.5) - s, receiver);
    n += v2.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    float share = metal::clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
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
inline float umbrage_window_hardware7(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float k0,
                                      float k1, float k2, float k3) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = metal::floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k2 + k3 + k2 + k1 + k0;
    float2 w0 = k0 + k1 + s * -k1;
    float2 p0 = (texel + (-k0 * 2.5 - k1 * 1.5 + s * (k0 + k1 * 1.5)) / w0) / size;
    float2 v0 = w0 * umbrage_covered(size, p0);
    float2 w1 = k2 + k3 + s * (k1 - k3);
    float2 p1 = (texel + (-k2 * 0.5 + k3 * 0.5 + s * (-k1 * 0.5 + k2 - k3 * 0.5)) / w1) / size;
    float2 v1 = w1 * umbrage_covered(size, p1);
    float2 w2 = k1 + k2 + s * (-k1 + k3);
    float2 p2 = (texel + (k1 * 2.5 + k2 * 1.5 + s * (-k1 * 2.5 + k2 + k3 * 1.5)) / w2) / size;
    float2 v2 = w2 * umbrage_covered(size, p2);
    float2 w3 = k0 + s * k1;
    float2 p3 = (texel + (k0 * 3.5 + s * (k0 + k1 * 3.5)) / w3) / size;
    float2 v3 = w3 * umbrage_covered(size, p3);
    float2 inside = v0 + v1 + v2 + v3;
    // ... - s: from the receiver to where the four texels of a fetch meet
    float n = 0.0;
    float row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p0.y), float2(-2.5, -2.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p0.y), float2(-0.5, -2.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, float2(p2.x, p0.y), float2(1.5, -2.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, float2(p3.x, p0.y), float2(3.5, -2.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p1.y), float2(-2.5, -0.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p1.y), float2(-0.5, -0.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, float2(p2.x, p1.y), float2(1.5, -0.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, float2(p3.x, p1.y), float2(3.5, -0.5) - s, receiver);
    n += v1.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p2.y), float2(-2.5, 1.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p2.y), float2(-0.5, 1.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, float2(p2.x, p2.y), float2(1.5, 1.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, float2(p3.x, p2.y), float2(3.5, 1.5) - s, receiver);
    n += v2.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p3.y), float2(-2.5, 3.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p3.y), float2(-0.5, 3.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, float2(p2.x, p3.y), float2(1.5, 3.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, float2(p3.x, p3.y), float2(3.5, 3.5) - s, receiver);
    n += v3.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    float share = metal::clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
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
inline float umbrage_ellipse_hardware8(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                       float2 radius, float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float wide = radius.x > 0.0 ? metal::min(radius.x, 255.9375) : 0.0;
    float high = radius.y > 0.0 ? metal::min(radius.y, 255.9375) : 0.0;
    float2 part = float2(wide, high) * (1.0 / 1024.0) / size;
    float2 x = float2(rotation.x, rotation.z) * part;
    float2 y = float2(rotation.y, rotation.w) * part;
    float n = 0.0;
    n += umbrage_lit_at(map, size, center + x * 3.0 - y * 1.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 11.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 6.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 13.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 7.0, coord, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 8.0) : 0.0;
    return compared ? visibility : 1.0;
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
inline float umbrage_ellipse_hardware16(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                        float2 radius, float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float wide = radius.x > 0.0 ? metal::min(radius.x, 255.9375) : 0.0;
    float high = radius.y > 0.0 ? metal::min(radius.y, 255.9375) : 0.0;
    float2 part = float2(wide, high) * (1.0 / 1024.0) / size;
    float2 x = float2(rotation.x, rotation.z) * part;
    float2 y = float2(rotation.y, rotation.w) * part;
    float n = 0.0;
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
    float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 16.0) : 0.0;
    return compared ? visibility : 1.0;
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
inline float umbrage_ellipse_hardware32(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                        float2 radius, float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float wide = radius.x > 0.0 ? metal::min(radius.x, 255.9375) : 0.0;
    float high = radius.y > 0.0 ? metal::min(radius.y, 255.9375) : 0.0;
    float2 part = float2(wide, high) * (1.0 / 1024.0) / size;
    float2 x = float2(rotation.x, rotation.z) * part;
    float2 y = float2(rotation.y, rotation.w) * part;
    float n = 0.0;
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
    float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 32.0) : 0.0;
    return compared ? visibility : 1.0;
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
inline float umbrage_disc_hardware8(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                    float radius, float4 rotation) {
    return umbrage_ellipse_hardware8(map, size, coord, receiver, float2(radius, radius), rotation);
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
inline float umbrage_disc_hardware16(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                     float radius, float4 rotation) {
    return umbrage_ellipse_hardware16(map, size, coord, receiver, float2(radius, radius), rotation);
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
inline float umbrage_disc_hardware32(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                     float radius, float4 rotation) {
    return umbrage_ellipse_hardware32(map, size, coord, receiver, float2(radius, radius), rotation);
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
inline float umbrage_bounds_lit(metal::texture2d<float> bounds, float2 size, float2 coord, float receiver,
                                float2 place) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);
    float4 b = umbrage_fetch_clamped(bounds, size, metal::floor((x + place.x) * place.y));
    float all = umbrage_compare(receiver, b.x);
    float some = umbrage_compare(receiver, b.y);
    float known = b.x <= b.y && all == some ? all : -1.0;  // NaN bounds decide nothing
    return compared ? known : 1.0;
}
` };

export const distance_code = { language, name: "distance_code", summary: "distance of a depth from the near plane, 16 bits",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_distance_code: distance of a depth from the near plane, an integer from 0.0 to 65535.0
// Returns 0.0 at the near plane, also where depth is reversed
inline float umbrage_distance_code(float depth) {
    float v = depth * 65536.0;
    float forward = v < 65535.0 ? metal::floor(metal::max(v, 0.0)) : 65535.0;
    float reversed = v > 0.0 ? metal::floor(metal::min(v, 65535.0)) : 0.0;
    return umbrage_cleared_depth() > 0.5 ? forward : 65535.0 - reversed;
}
` };

export const penumbra = { language, name: "penumbra", summary: "radius of a penumbra from the distance to the blocker",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_penumbra: radius of a penumbra along x and y in 1/16 texel, integers
//   apart      umbrage_distance_code of the receiver minus that of the blocker
//   softness   (1/16 texel per distance code along x and y, min_radius, max_radius), from make_penumbra_params
inline float2 umbrage_penumbra(float apart, float4 softness) {
    float2 radius = metal::floor(float2(softness.x, softness.y) * apart);
    return metal::min(metal::max(radius, float2(softness.z, softness.z)), float2(softness.w, softness.w));
}
` };

export const blocker = { language, name: "blocker", summary: "count and distance code of one possible blocker",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [fetch_depth, compare, distance_code], text: `
// umbrage_blocker: (1.0, umbrage_distance_code) of a texel nearer to the light than the receiver, else (0.0, 0.0)
inline float2 umbrage_blocker(metal::texture2d<float> map, float2 size, float2 texel, float receiver) {
    float stored = umbrage_fetch_depth(map, size, texel);
    float code = umbrage_distance_code(stored);
    return umbrage_compare(receiver, stored) > 0.5 ? float2(0.0, 0.0) : float2(1.0, code);
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
inline float2 umbrage_blockers8(metal::texture2d<float> map, float2 size, float2 position, float receiver,
                                float2 radius, float4 rotation) {
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(3.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-4.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-12.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, -7.0), rotation, radius), receiver);
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
inline float2 umbrage_blockers16(metal::texture2d<float> map, float2 size, float2 position, float receiver,
                                 float2 radius, float4 rotation) {
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(8.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-12.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-9.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(14.0, -2.0), rotation, radius), receiver);
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
inline float2 umbrage_blockers32(metal::texture2d<float> map, float2 size, float2 position, float receiver,
                                 float2 radius, float4 rotation) {
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-2.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(3.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-4.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-5.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, -2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-8.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(8.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(5.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -9.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(6.0, -7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-8.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-3.0, -10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-6.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(5.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(13.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(10.0, -10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(14.0, -2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-11.0, 9.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(3.0, 14.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, -6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(12.0, 8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-4.0, 14.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-7.0, -13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, -15.0), rotation, radius), receiver);
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
inline float umbrage_pcss8(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float4 softness,
                           float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float2 search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, metal::max(found.x, 1.0));
    float2 radius = umbrage_penumbra(z - mean, softness);
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
inline float umbrage_pcss16(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float4 softness,
                            float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float2 search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, metal::max(found.x, 1.0));
    float2 radius = umbrage_penumbra(z - mean, softness);
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
inline float umbrage_pcss32(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float4 softness,
                            float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float2 search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers32(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, metal::max(found.x, 1.0));
    float2 radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is that of the search, whose points are all lit
    return umbrage_ellipse32(map, size, coord, receiver, radius, rotation);
}
` };

export const blocker_at = { language, name: "blocker_at", summary: "count and depth of one possible blocker",
    exactness: "c", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [depth_at, compare], text: `
// umbrage_blocker_at: (1.0, depth) of the texel at a point if it is nearer to the light, else (0.0, 0.0)
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
inline float2 umbrage_blocker_at(metal::texture2d<float> map, float2 size, float2 uv, float receiver) {
    float stored = umbrage_depth_at(map, size, uv);
    return umbrage_compare(receiver, stored) > 0.5 ? float2(0.0, 0.0) : float2(1.0, stored);
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
inline float2 umbrage_pcss_radius(float2 found, float receiver, float4 softness) {
    bool forward = umbrage_cleared_depth() > 0.5;
    float mean = found.x > 0.5 ? found.y / found.x : (forward ? 0.0 : 1.0);
    float apart = forward ? receiver - mean : mean - receiver;
    float2 radius = float2(softness.x, softness.y) * 4096.0 * apart;
    float min_radius = softness.z * 0.0625;
    float max_radius = softness.w * 0.0625;
    return float2(radius.x > min_radius ? metal::min(radius.x, max_radius) : min_radius,
                  radius.y > min_radius ? metal::min(radius.y, max_radius) : min_radius);
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
inline float2 umbrage_blockers_hardware8(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                         float2 radius, float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float wide = radius.x > 0.0 ? metal::min(radius.x, 255.9375) : 0.0;
    float high = radius.y > 0.0 ? metal::min(radius.y, 255.9375) : 0.0;
    float2 part = float2(wide, high) * (1.0 / 1024.0) / size;
    float2 x = float2(rotation.x, rotation.z) * part;
    float2 y = float2(rotation.y, rotation.w) * part;
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 3.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 - y * 7.0, receiver);
    return compared ? n : float2(0.0, 0.0);
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
inline float2 umbrage_blockers_hardware16(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                          float2 radius, float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float wide = radius.x > 0.0 ? metal::min(radius.x, 255.9375) : 0.0;
    float high = radius.y > 0.0 ? metal::min(radius.y, 255.9375) : 0.0;
    float2 part = float2(wide, high) * (1.0 / 1024.0) / size;
    float2 x = float2(rotation.x, rotation.z) * part;
    float2 y = float2(rotation.y, rotation.w) * part;
    float2 n = float2(0.0, 0.0);
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
    return compared ? n : float2(0.0, 0.0);
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
inline float2 umbrage_blockers_hardware32(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                          float2 radius, float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float wide = radius.x > 0.0 ? metal::min(radius.x, 255.9375) : 0.0;
    float high = radius.y > 0.0 ? metal::min(radius.y, 255.9375) : 0.0;
    float2 part = float2(wide, high) * (1.0 / 1024.0) / size;
    float2 x = float2(rotation.x, rotation.z) * part;
    float2 y = float2(rotation.y, rotation.w) * part;
    float2 n = float2(0.0, 0.0);
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
    return compared ? n : float2(0.0, 0.0);
}
` };

export const hardened_kernel8 = { language, name: "hardened_kernel8", summary: "fraction of a disc in shadow, steepened",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_hardened_kernel8: fraction of 8 points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
inline float umbrage_hardened_kernel8(float blocked, float ratio) {
    float u = blocked * 2.0 - 8.0;
    float d = metal::max(8.0 - metal::abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    float steep = 512.0 - d * d * d;
    float hard = u < 0.0 ? 512.0 - steep : 512.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 128.0) * (1.0 / 262144.0);
}
` };

export const hardened_kernel16 = { language, name: "hardened_kernel16", summary: "fraction of a disc in shadow, steepened",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_hardened_kernel16: fraction of 16 points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
inline float umbrage_hardened_kernel16(float blocked, float ratio) {
    float u = blocked * 2.0 - 16.0;
    float d = metal::max(16.0 - metal::abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    float steep = 4096.0 - d * d * d;
    float hard = u < 0.0 ? 4096.0 - steep : 4096.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 512.0) * (1.0 / 2097152.0);
}
` };

export const hardened_kernel32 = { language, name: "hardened_kernel32", summary: "fraction of a disc in shadow, steepened",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_hardened_kernel32: fraction of 32 points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
inline float umbrage_hardened_kernel32(float blocked, float ratio) {
    float u = blocked * 2.0 - 32.0;
    float d = metal::max(32.0 - metal::abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    float steep = 32768.0 - d * d * d;
    float hard = u < 0.0 ? 32768.0 - steep : 32768.0 + steep;
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
inline float umbrage_dpcf8(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float4 softness,
                           float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float2 search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, metal::max(found.x, 1.0));
    float2 radius = umbrage_penumbra(z - mean, softness);
    float searched = metal::max(search_radius.x + search_radius.y, 1.0);
    float ratio = umbrage_floor_divide((radius.x + radius.y) * 256.0, searched);
    float dark = umbrage_hardened_kernel8(found.x, ratio);
    return compared ? metal::clamp(1.0 - dark, 0.0, 1.0) : 1.0;
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
inline float umbrage_dpcf16(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float4 softness,
                            float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float2 search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, metal::max(found.x, 1.0));
    float2 radius = umbrage_penumbra(z - mean, softness);
    float searched = metal::max(search_radius.x + search_radius.y, 1.0);
    float ratio = umbrage_floor_divide((radius.x + radius.y) * 256.0, searched);
    float dark = umbrage_hardened_kernel16(found.x, ratio);
    return compared ? metal::clamp(1.0 - dark, 0.0, 1.0) : 1.0;
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
inline float umbrage_dpcf32(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float4 softness,
                            float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float2 search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers32(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, metal::max(found.x, 1.0));
    float2 radius = umbrage_penumbra(z - mean, softness);
    float searched = metal::max(search_radius.x + search_radius.y, 1.0);
    float ratio = umbrage_floor_divide((radius.x + radius.y) * 256.0, searched);
    float dark = umbrage_hardened_kernel32(found.x, ratio);
    return compared ? metal::clamp(1.0 - dark, 0.0, 1.0) : 1.0;
}
` };

export const box_moments = { language, name: "box_moments", summary: "mean and squared distances over a box, from a SAT",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [texel, floor_divide], text: `
// umbrage_box_moments: (mean, rest, high, low) of the quantized depths in a box of n texels, integers
//   The sum of the depths is n mean + rest. The sum of their squared distances from mean is 4096 high + low
//   map, size    table from make_variance_table and its size
//   first, end   lowest texel of the box, and one past its highest. first < end
inline float4 umbrage_box_moments(metal::texture2d<float> map, float2 size, float2 first, float2 end) {
    float4 a = umbrage_texel(map, size, end);
    float4 b = umbrage_texel(map, size, float2(first.x, end.y));
    float4 c = umbrage_texel(map, size, float2(end.x, first.y));
    float4 d = umbrage_texel(map, size, first);
    float4 part = (a - b) - (c - d);
    float2 low = float2(part.x, part.z);
    float2 carry = metal::floor(low * (1.0 / 65536.0));
    float2 above = float2(part.y, part.w) + carry;
    // nothing below is negative. The maxima keep compilers from regrouping sums across them
    low = metal::max(low - carry * 65536.0, float2(0.0, 0.0));
    above = metal::max(above - metal::floor(above * (1.0 / 65536.0)) * 65536.0, float2(0.0, 0.0));
    float sum = above.x * 65536.0 + low.x;
    float2 sides = metal::max(end - first, float2(1.0, 1.0));
    float n = sides.x * sides.y;
    float mean = umbrage_floor_divide(sum, n);
    float rest = metal::max(sum - mean * n, 0.0);
    float2 digits = float2(sum + rest, low.y);
    float2 high = metal::floor(digits * (1.0 / 4096.0));
    digits = metal::max(digits - high * 4096.0, float2(0.0, 0.0));
    float below = digits.y - mean * digits.x;
    float borrow = metal::floor(below * (1.0 / 4096.0));
    float wide = above.y * 16.0 + high.y - mean * high.x + borrow;
    wide = wide - metal::floor(wide * (1.0 / 1048576.0)) * 1048576.0;
    return float4(mean, rest, wide, below - borrow * 4096.0);
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
inline float umbrage_summed_variance(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                     float radius, float codes) {
    float2 last = size - 1.0;
    bool compared = umbrage_map_covers(last, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float2 texel = compared ? metal::clamp(metal::floor(coord), float2(0.0, 0.0), last - 1.0) : float2(0.0, 0.0);
    float2 first = metal::max(texel - radius, float2(0.0, 0.0));
    float2 end = metal::min(texel + radius + 1.0, last);
    float4 m = umbrage_box_moments(map, size, first, end);
    float2 sides = end - first;
    float n = sides.x * sides.y;
    float share = m.y / n;
    float variance = (m.z * 4096.0 + (m.w - m.y)) / n + share * (1.0 - share);
    float scaled = receiver * codes;
    float t = umbrage_cleared_depth() > 0.5 ? scaled : codes - scaled;
    float d = (t - 1.0 - m.x) - share;
    float behind = d > 0.0 ? variance / (variance + d * d) : 0.0;
    return compared ? (d <= 0.0 ? 1.0 : behind) : 1.0;
}
` };

export const box_mean = { language, name: "box_mean", summary: "mean of four integers over a box, from a SAT in two halves",
    exactness: "c", operations: 19, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [texel], text: `
// umbrage_box_mean: mean over a box of four integers below 65536.0
//   map, size    table from make_moment_table and its size
//   first, end   lowest texel of the box, and one past its highest. first < end
inline float4 umbrage_box_mean(metal::texture2d<float> map, float2 size, float2 first, float2 end) {
    float right = size.x * 0.5;
    float4 a = umbrage_texel(map, size, end);
    float4 b = umbrage_texel(map, size, float2(first.x, end.y));
    float4 c = umbrage_texel(map, size, float2(end.x, first.y));
    float4 d = umbrage_texel(map, size, first);
    float4 low = (a - b) - (c - d);
    float4 carry = metal::floor(low * (1.0 / 65536.0));
    a = umbrage_texel(map, size, float2(right + end.x, end.y));
    b = umbrage_texel(map, size, float2(right + first.x, end.y));
    c = umbrage_texel(map, size, float2(right + end.x, first.y));
    d = umbrage_texel(map, size, float2(right + first.x, first.y));
    float4 above = (a - b) - (c - d) + carry;
    float4 high = above - metal::floor(above * (1.0 / 65536.0)) * 65536.0;
    float4 sum = high * 65536.0 + (low - carry * 65536.0);
    float2 sides = end - first;
    return sum / (sides.x * sides.y);
}
` };

export const from_optimized_moments = { language, name: "from_optimized_moments", summary: "four 16-bit channels to four moments (MSM)",
    exactness: "b", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_from_optimized_moments: four moments from the result of umbrage_to_optimized_moments
inline float4 umbrage_from_optimized_moments(float4 o) {
    float x = o.x - 0.5;
    float z = o.z - 0.5;
    float eighth = o.y * 0.125;
    float b1 = z * 1.73205078 - x * 0.333333343;
    float b2 = o.w + eighth;
    float b3 = z * 1.29903817 - x * 0.75;
    float b4 = o.w - eighth;
    return float4(b1, b2, b3, b4);
}
` };

export const bias_moments = { language, name: "bias_moments", summary: "four moments (MSM) with a bias against rounding",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
inline float4 umbrage_bias_moments(float4 b, float2 bias) {
    float x = b.x - b.x * bias.x;
    float y = b.y + (bias.y - b.y) * bias.x;
    float z = b.z - b.z * bias.x;
    float w = b.w + (bias.y - b.w) * bias.x;
    return float4(x, y, z, w);
}
` };

export const to_forward_depth = { language, name: "to_forward_depth", summary: "depth that grows with the distance from the light",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
inline float umbrage_to_forward_depth(float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
` };

export const moment_atoms = { language, name: "moment_atoms", summary: "two depths that have the moments with the receiver's",
    exactness: "c", operations: 0, within: 0.015625, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_moment_atoms: the two depths that have the same moments with the receiver's, minus b.x, and their shares
//   b   moments, biased
//   x   the receiver's depth on -1.0 to 1.0 minus b.x
inline float4 umbrage_moment_atoms(float4 b, float x) {
    float d = b.y - b.x * b.x;
    float third = b.z - b.x * b.y;
    float l = third / d;
    float e = (b.w - b.y * b.y) - third * l;
    float h = b.x * 2.0 - l;
    float a = d * ((x + h) * x - d);
    float m = x * e + h * a;
    float c = d * (e - a);
    float square = m * m - 4.0 * a * c;
    float root = metal::sqrt(square > 0.0 ? square : 0.0);
    float w = (m < 0.0 ? root - m : -(m + root)) * 0.5;
    float2 t = float2(w / a, c / w);
    float2 q = (t + h) * t - d;
    float least = d * e;
    float2 sum = least + (t * t * e + q * q * d);
    return float4(t.x, t.y, least / sum.x, least / sum.y);
}
` };

export const decode_msm = { language, name: "decode_msm", summary: "mean of MSM texels to visibility",
    exactness: "c", operations: 0, within: 0.015625, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [bias_moments, to_forward_depth, moment_atoms], text: `
// umbrage_decode_msm: visibility of a receiver, at least its lit fraction minus bias.x. 1.0 = lit
//   b: mean of texels. receiver: depth in [0, 1], bias applied
//   bias: (3e-6, 0.375) for 32-bit floats, (6e-5, 0.628) for 16-bit channels
inline float umbrage_decode_msm(float4 b, float receiver, float2 bias) {
    float d = umbrage_to_forward_depth(receiver);
    float4 m = umbrage_bias_moments(b, bias);
    float x = ((d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0) - m.x;
    float4 atoms = umbrage_moment_atoms(m, x);
    float first = atoms.x < x ? atoms.z : 0.0;
    float second = atoms.y < x ? atoms.w : 0.0;
    float lit = 1.0 - (first + second);
    bool known = metal::abs(atoms.z + atoms.w) <= 4294967296.0;  // false for NaN
    lit = known ? (lit > 0.0 ? (lit < 1.0 ? lit : 1.0) : 0.0) : (x <= 0.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
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
inline float umbrage_summed_moments(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                    float radius, float2 bias) {
    float2 last = float2(size.x * 0.5, size.y) - 1.0;
    bool compared = umbrage_map_covers(last, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float2 texel = compared ? metal::clamp(metal::floor(coord), float2(0.0, 0.0), last - 1.0) : float2(0.0, 0.0);
    float2 first = metal::max(texel - radius, float2(0.0, 0.0));
    float2 end = metal::min(texel + radius + 1.0, last);
    float4 turned = umbrage_box_mean(map, size, first, end) * (1.0 / 65535.0);
    float lit = umbrage_decode_msm(umbrage_from_optimized_moments(turned), receiver, bias);
    return compared ? lit : 1.0;
}
` };

export const power_of_two = { language, name: "power_of_two", summary: "2^n of integers n from -64 to 63",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
inline float umbrage_power_of_two(float n) {
    uint exponent = uint(n + 127.0);
    return as_type<float>(exponent << 23);
}
` };

export const exp2_polynomial = { language, name: "exp2_polynomial", summary: "2^y, off by at most 1.8e-7 of itself",
    exactness: "b", operations: 16, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [power_of_two], text: `
// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of itself
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
inline float umbrage_exp2_polynomial(float y) {
    float x = y > -64.0 ? metal::min(y, 63.0) : -64.0;
    float n = metal::floor(x);
    float f = x - n;
    float p = 0.00187931862 * f + 0.00899099465;
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
inline float umbrage_exp2_steps(float y) {
    float x = metal::floor((y > -64.0 ? metal::min(y, 63.0) : -64.0) * 2048.0);
    float n = metal::floor(x * (1.0 / 2048.0));
    float f = metal::max(x - n * 2048.0, 0.0);  // not negative already: no sum is regrouped across the max
    float g = metal::floor(f * (2048.0 - f) * (1.0 / 256.0));
    float r = 1251.0 + metal::floor(f * 314.0 * (1.0 / 2048.0));
    float m = 2048.0 + f - metal::floor((g * r + 16384.0) * (1.0 / 32768.0));
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
inline float umbrage_chebyshev(float2 m, float receiver, float min_variance) {
    float difference = m.y - m.x * m.x;
    float variance = difference > min_variance ? difference : min_variance;
    float distance = receiver - m.x;
    float sum = variance + distance * distance;
    float p = variance / sum;
    return receiver <= m.x ? 1.0 : (p > 0.0 ? metal::min(p, 1.0) : 0.0);  // a GPU's v / v may be more than 1.0
}
` };

export const reduce_light_bleeding = { language, name: "reduce_light_bleeding", summary: "visibility above a threshold, stretched to [0, 1]",
    exactness: "c", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_reduce_light_bleeding: visibility from amount to 1.0, stretched to 0.0 to 1.0
inline float umbrage_reduce_light_bleeding(float visibility, float amount) {
    float stretched = (visibility - amount) / (1.0 - amount);
    return visibility > amount ? stretched : 0.0;
}
` };

export const encode_vsm = { language, name: "encode_vsm", summary: "depth to a texel of a variance shadow map (VSM)",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, to_forward_depth], text: `
// umbrage_encode_vsm: texel of a variance shadow map, depth and its square. NaN counts as far
inline float2 umbrage_encode_vsm(float depth) {
    float d = umbrage_to_forward_depth(umbrage_saturate(depth));
    return float2(d, d * d);
}
` };

export const decode_vsm = { language, name: "decode_vsm", summary: "mean of VSM texels to visibility",
    exactness: "c", operations: 13, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [chebyshev, to_forward_depth], text: `
// umbrage_decode_vsm: visibility of a receiver from a variance shadow map, at least its lit fraction. 1.0 = lit
//   m              mean of texels
//   receiver       receiver depth, bias applied
//   min_variance   0.0 or more
inline float umbrage_decode_vsm(float2 m, float receiver, float min_variance) {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}
` };

export const encode_deviation = { language, name: "encode_deviation", summary: "two moments of depth (VSM) to mean and deviation",
    exactness: "c", operations: 7, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_encode_deviation: mean and mean square of depths to mean and twice the standard deviation, each 0.0 to 1.0
inline float2 umbrage_encode_deviation(float2 m) {
    float variance = m.y - m.x * m.x;
    return float2(m.x, 2.0 * metal::sqrt(variance > 0.0 ? variance : 0.0));
}
` };

export const decode_deviation = { language, name: "decode_deviation", summary: "mean and deviation to two moments of depth (VSM)",
    exactness: "b", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
inline float2 umbrage_decode_deviation(float2 held) {
    float half_of_it = held.y * 0.5;
    float square = held.x * held.x + half_of_it * half_of_it;
    return float2(held.x, square);
}
` };

export const decode_deviation_rgba8 = { language, name: "decode_deviation_rgba8", summary: "mean and deviation in RGBA8 to two moments (VSM)",
    exactness: "b", operations: 21, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [decode_deviation, decode_rg16], text: `
// umbrage_decode_deviation_rgba8: RGBA8 mean and deviation to mean and mean square of depths
//   c   as sampled, mean in xy and deviation in zw
inline float2 umbrage_decode_deviation_rgba8(float4 c) {
    float mean = umbrage_decode_rg16(float2(c.x, c.y), 1.0);
    float deviation = umbrage_decode_rg16(float2(c.z, c.w), 1.0);
    return umbrage_decode_deviation(float2(mean, deviation));
}
` };

export const exponential_warp = { language, name: "exponential_warp", summary: "depth on the scale of exponential shadow maps",
    exactness: "b", operations: 31, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [exp2_polynomial], text: `
// umbrage_exponential_warp: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
inline float umbrage_exponential_warp(float depth, float exponent) {
    float y = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
` };

export const encode_esm = { language, name: "encode_esm", summary: "depth to a texel of an exponential shadow map (ESM)",
    exactness: "b", operations: 36, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, to_forward_depth, exponential_warp], text: `
// umbrage_encode_esm: texel of an exponential shadow map, from depth in [0, 1]. NaN counts as far
inline float umbrage_encode_esm(float depth, float exponent) {
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
inline float umbrage_decode_esm(float m, float receiver, float exponent) {
    float d = umbrage_to_forward_depth(receiver);
    float p = m * umbrage_exponential_warp(d, -exponent);
    float lit = p > 0.0 && p < 1.0 ? p : (p >= 1.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
` };

export const encode_evsm2 = { language, name: "encode_evsm2", summary: "depth to an EVSM texel of two components",
    exactness: "b", operations: 73, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, to_forward_depth, exponential_warp], text: `
// umbrage_encode_evsm2: texel of two components, a power of depth and its square. NaN counts as far
inline float2 umbrage_encode_evsm2(float depth, float exponent) {
    float w = umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
    return float2(w, w * w);
}
` };

export const encode_evsm4 = { language, name: "encode_evsm4", summary: "depth to an EVSM texel of four components",
    exactness: "b", operations: 73, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, to_forward_depth, exponential_warp], text: `
// umbrage_encode_evsm4: texel of four components, a growing power, its square, a negative falling power, its square
// NaN counts as far
inline float4 umbrage_encode_evsm4(float depth, float2 exponents) {
    float d = umbrage_to_forward_depth(umbrage_saturate(depth));
    float w = umbrage_exponential_warp(d, exponents.x);
    float n = -umbrage_exponential_warp(d, -exponents.y);
    return float4(w, w * w, n, n * n);
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
inline float umbrage_decode_evsm2(float2 m, float receiver, float exponent, float deviation) {
    float d = umbrage_to_forward_depth(umbrage_saturate(receiver));
    float w = umbrage_exponential_warp(d, exponent);
    float least = deviation * w;
    float least_variance = least * least;
    float lit = umbrage_chebyshev(m, w, least_variance);
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
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
inline float umbrage_decode_evsm4(float4 m, float receiver, float2 exponents, float2 deviations) {
    float d = umbrage_to_forward_depth(umbrage_saturate(receiver));
    float w = umbrage_exponential_warp(d, exponents.x);
    float n = -umbrage_exponential_warp(d, -exponents.y);
    float2 least = deviations * float2(w, n);
    float2 least_variance = least * least;
    float a = umbrage_chebyshev(float2(m.x, m.y), w, least_variance.x);
    float b = umbrage_chebyshev(float2(m.z, m.w), n, least_variance.y);
    float lit = a < b ? a : b;
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
` };

export const encode_msm = { language, name: "encode_msm", summary: "depth to a texel of a moment shadow map (MSM)",
    exactness: "b", operations: 15, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate, to_forward_depth], text: `
// umbrage_encode_msm: first four powers of depth on -1.0 to 1.0, the texel of a moment shadow map. NaN counts as far
inline float4 umbrage_encode_msm(float depth) {
    float z = umbrage_to_forward_depth(umbrage_saturate(depth)) * 2.0 - 1.0;
    float square = z * z;
    return float4(z, square, square * z, square * square);
}
` };

export const to_optimized_moments = { language, name: "to_optimized_moments", summary: "four moments (MSM) to four 16-bit channels",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_to_optimized_moments: four moments for four 16-bit channels, each over all of 0.0 to 1.0
inline float4 umbrage_to_optimized_moments(float4 b) {
    float x = (b.x * 0.75 - b.z) * 2.0 + 0.5;
    float y = (b.y - b.w) * 4.0;
    float z = (b.x * 2.25 - b.z) * 0.384900182 + 0.5;
    float w = (b.y + b.w) * 0.5;
    return float4(x, y, z, w);
}
` };

export const hausdorff_share = { language, name: "hausdorff_share", summary: "smallest fraction of nearer depths, for depths on [-1, 1]",
    exactness: "c", operations: 0, within: 9.5367431640625e-07, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_hausdorff_share: smallest fraction of depths nearer than the receiver, from four moments of depths on [-1, 1]
// Returns a negative number where umbrage_moment_atoms gives the fraction
//   b   moments, biased
//   z   the receiver's depth on -1.0 to 1.0
inline float umbrage_hausdorff_share(float4 b, float z) {
    float variance = b.y - b.x * b.x;
    float third = b.z - b.x * b.y;
    float fourth = b.w - b.y * b.y;
    float rest = 1.0 - b.y;
    float x = z - b.x;
    float d = third + rest * x;
    float g = (fourth - variance * rest) - (z + b.x) * third;
    float p = d * (1.0 + b.x) + g;
    float q = d * (1.0 - b.x) - g;
    float k = rest * g + third * d;
    float first = (1.0 + z) * (d * variance + g * (1.0 - b.x)) - k;
    float last = (1.0 - z) * (d * variance - g * (1.0 + b.x)) + k;
    float square = d * d;
    float between = p * (q * (x * d - g));
    float end = first / (2.0 * ((1.0 + z) * p));
    float other = square * square / between;
    float share = end + (d > 0.0 ? other : 0.0);
    bool four = first * p > 0.0 && last * q > 0.0 && p * q > 0.0 && share >= 0.0;
    return z <= -1.0 ? 0.0 : (four ? (share < 1.0 ? share : 1.0) : -1.0);
}
` };

export const decode_msm_hausdorff = { language, name: "decode_msm_hausdorff", summary: "mean of MSM texels to visibility, for depths on [-1, 1]",
    exactness: "c", operations: 0, within: 0.015625, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [bias_moments, decode_msm, to_forward_depth, hausdorff_share], text: `
// umbrage_decode_msm_hausdorff: visibility of a receiver, at least its lit fraction minus bias.x. 1.0 = lit
//   b          mean of texels
//   receiver   receiver depth in [0, 1], bias applied
//   bias       (3e-6, 0.375)
inline float umbrage_decode_msm_hausdorff(float4 b, float receiver, float2 bias) {
    float plain = umbrage_decode_msm(b, receiver, bias);
    float d = umbrage_to_forward_depth(receiver);
    float z = (d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0;
    float share = umbrage_hausdorff_share(umbrage_bias_moments(b, bias), z);
    float lit = share >= 0.0 ? 1.0 - share : plain;
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
` };

export const fetch_bilinear = { language, name: "fetch_bilinear", summary: "bilinear mean of the four texels around a point",
    exactness: "b", operations: 19, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [fetch_clamped], text: `
// umbrage_fetch_bilinear: bilinear mean of the four texels around a point, weights in steps of 1/256
//   coord   in texels. (0.5, 0.5) is the center of the first texel
inline float4 umbrage_fetch_bilinear(metal::texture2d<float> map, float2 size, float2 coord) {
    float2 x = metal::floor(coord * 256.0) - 128.0;
    float2 texel = metal::floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already. The clamp keeps compilers from regrouping sums across it
    float2 hi = metal::clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 lo = 256.0 - hi;  // 1.0 - hi would become an interpolation, which rounds differently
    float4 a = umbrage_fetch_clamped(map, size, texel);
    float4 b = umbrage_fetch_clamped(map, size, texel + float2(1.0, 0.0));
    float4 c = umbrage_fetch_clamped(map, size, texel + float2(0.0, 1.0));
    float4 d = umbrage_fetch_clamped(map, size, texel + float2(1.0, 1.0));
    float4 low = a * lo.x + b * hi.x;
    float4 high = c * lo.x + d * hi.x;
    float4 sum = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
` };

const write_vsm = { language, name: "write", summary: "texel of a depth, as a color",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, encode_vsm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
inline float4 umbrage_write(float depth) {
    float2 texel = umbrage_encode_vsm(depth);
    return float4(texel.x, texel.y, 0.0, 0.0);
}
` };

export const vsm = { language, name: "vsm", summary: "visibility from a blurred variance shadow map (VSM)",
    exactness: "c", operations: 165, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, fetch_bilinear, decode_vsm], filter: { reads: "moments", reach: 1, arguments: [{ name: "min_variance", type: "float", value: 1e-06 }], in_shadow: true, format: "RG32F", cleared: [1, 1, 0, 0], cleared_reversed: [1, 1, 0, 0], write: write_vsm }, text: `
// umbrage_vsm: visibility from a blurred map of encode_vsm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. min_variance: 0.0 or more
inline float umbrage_vsm(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float min_variance) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_vsm(float2(m.x, m.y), receiver, min_variance);
    return compared ? lit : 1.0;
}
` };

const write_esm = { language, name: "write", summary: "texel of a depth, as a color",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, encode_esm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
inline float4 umbrage_write(float depth, float4 filter_terms) {
    float texel = umbrage_encode_esm(depth, filter_terms.x);
    return float4(texel, 0.0, 0.0, 0.0);
}
` };

export const esm = { language, name: "esm", summary: "visibility from a blurred exponential shadow map (ESM)",
    exactness: "b", operations: 56, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, fetch_bilinear, decode_esm], filter: { reads: "moments", reach: 1, arguments: [{ name: "exponent", type: "float", value: 40 }], in_shadow: true, format: "R32F", cleared: [1099511627776, 0, 0, 0], cleared_reversed: [1099511627776, 0, 0, 0], write: write_esm }, text: `
// umbrage_esm: visibility from a blurred map of encode_esm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. exponent: same as for the texels
inline float umbrage_esm(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float exponent) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_esm(m.x, receiver, exponent);
    return compared ? lit : 1.0;
}
` };

const write_evsm2 = { language, name: "write", summary: "texel of a depth, as a color",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, encode_evsm2], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
inline float4 umbrage_write(float depth, float4 filter_terms) {
    float2 texel = umbrage_encode_evsm2(depth, filter_terms.x);
    return float4(texel.x, texel.y, 0.0, 0.0);
}
` };

export const evsm2 = { language, name: "evsm2", summary: "visibility from a blurred EVSM of two components",
    exactness: "c", operations: 267, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, fetch_bilinear, decode_evsm2], filter: { reads: "moments", reach: 1, arguments: [{ name: "exponent", type: "float", value: 40 }, { name: "deviation", type: "float", value: 0.0055451775 }], in_shadow: true, format: "RG32F", cleared: [1099511627776, 1.2089258e+24, 0, 0], cleared_reversed: [1099511627776, 1.2089258e+24, 0, 0], write: write_evsm2 }, text: `
// umbrage_evsm2: visibility from a blurred map of encode_evsm2's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. exponent, deviation: as for decode_evsm2
inline float umbrage_evsm2(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float exponent,
                           float deviation) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_evsm2(float2(m.x, m.y), receiver, exponent, deviation);
    return compared ? lit : 1.0;
}
` };

const write_evsm4 = { language, name: "write", summary: "texel of a depth, as a color",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, encode_evsm4], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
inline float4 umbrage_write(float depth, float4 filter_terms) {
    float4 texel = umbrage_encode_evsm4(depth, float2(filter_terms.x, filter_terms.y));
    return float4(texel.x, texel.y, texel.z, texel.w);
}
` };

export const evsm4 = { language, name: "evsm4", summary: "visibility from a blurred EVSM of four components",
    exactness: "c", operations: 267, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, fetch_bilinear, decode_evsm4], filter: { reads: "moments", reach: 1, arguments: [{ name: "exponents", type: "vec2", value: [40, 8] }, { name: "deviations", type: "vec2", value: [0.0055451775, 0.0011090355] }], in_shadow: true, format: "RGBA32F", cleared: [1099511627776, 1.2089258e+24, -0.00390625, 1.5258789e-05], cleared_reversed: [1099511627776, 1.2089258e+24, -0.00390625, 1.5258789e-05], write: write_evsm4 }, text: `
// umbrage_evsm4: visibility from a blurred map of encode_evsm4's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. exponents, deviations: as for decode_evsm4
inline float umbrage_evsm4(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float2 exponents,
                           float2 deviations) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_evsm4(m, receiver, exponents, deviations);
    return compared ? lit : 1.0;
}
` };

const write_msm = { language, name: "write", summary: "texel of a depth, as a color",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, encode_msm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
inline float4 umbrage_write(float depth) {
    float4 texel = umbrage_encode_msm(depth);
    return float4(texel.x, texel.y, texel.z, texel.w);
}
` };

export const msm = { language, name: "msm", summary: "visibility from a blurred moment shadow map (MSM)",
    exactness: "c", operations: 0, within: 0.015625, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, fetch_bilinear, decode_msm], filter: { reads: "moments", reach: 1, arguments: [{ name: "bias", type: "vec2", value: [3e-06, 0.375] }], in_shadow: true, format: "RGBA32F", cleared: [1, 1, 1, 1], cleared_reversed: [1, 1, 1, 1], write: write_msm }, text: `
// umbrage_msm: visibility from a blurred map of encode_msm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
inline float umbrage_msm(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_msm(m, receiver, bias);
    return compared ? lit : 1.0;
}
` };

const write_msm_unorm16 = { language, name: "write", summary: "texel of a depth, as a color",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, encode_msm, to_optimized_moments], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
inline float4 umbrage_write(float depth) {
    float4 texel = umbrage_to_optimized_moments(umbrage_encode_msm(depth));
    return float4(texel.x, texel.y, texel.z, texel.w);
}
` };

export const msm_unorm16 = { language, name: "msm_unorm16", summary: "visibility from a blurred MSM of optimized moments",
    exactness: "c", operations: 0, within: 0.015625, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, fetch_bilinear, decode_msm, from_optimized_moments], filter: { reads: "moments", reach: 1, arguments: [{ name: "bias", type: "vec2", value: [6e-05, 0.628] }], in_shadow: true, format: "RGBA16", cleared: [0, 0, 0.98112524, 1], cleared_reversed: [0, 0, 0.98112524, 1], write: write_msm_unorm16 }, text: `
// umbrage_msm_unorm16: visibility from a blurred map of optimized moments, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
inline float umbrage_msm_unorm16(metal::texture2d<float> map, float2 size, float2 coord, float receiver, float2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_msm(umbrage_from_optimized_moments(m), receiver, bias);
    return compared ? lit : 1.0;
}
` };

const write_msm_hausdorff = { language, name: "write", summary: "texel of a depth, as a color",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth, encode_msm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
inline float4 umbrage_write(float depth) {
    float4 texel = umbrage_encode_msm(depth);
    return float4(texel.x, texel.y, texel.z, texel.w);
}
` };

export const msm_hausdorff = { language, name: "msm_hausdorff", summary: "visibility from a blurred MSM, for depths on [-1, 1]",
    exactness: "c", operations: 0, within: 0.015625, as_written: true, lowest: "100", role: "none", scaled: false,
    needs: [in_filter_domain, map_covers, fetch_bilinear, decode_msm_hausdorff], filter: { reads: "moments", reach: 1, arguments: [{ name: "bias", type: "vec2", value: [3e-06, 0.375] }], in_shadow: true, format: "RGBA32F", cleared: [1, 1, 1, 1], cleared_reversed: [1, 1, 1, 1], write: write_msm_hausdorff }, text: `
// umbrage_msm_hausdorff: visibility from a blurred map of encode_msm's texels, for depths on [-1, 1]. 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
inline float umbrage_msm_hausdorff(metal::texture2d<float> map, float2 size, float2 coord, float receiver,
                                   float2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_msm_hausdorff(m, receiver, bias);
    return compared ? lit : 1.0;
}
` };

export const chebyshev_hardware = { language, name: "chebyshev_hardware", summary: "Chebyshev bound with light bleeding reduced",
    exactness: "c", operations: 0, within: 1.9073486328125e-06, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_chebyshev_hardware: upper bound on visibility with light bleeding reduced
//   variance   above 0.0
//   distance   from the mean to the receiver, no NaN
//   amount     visibility that becomes 0.0, 0.0 to 0.5
inline float umbrage_chebyshev_hardware(float variance, float distance, float amount) {
    float beyond = metal::max(distance, 0.0);
    float p = variance / (variance + beyond * beyond);
    return metal::clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
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
inline float umbrage_decode_vsm_hardware(float2 held, float receiver, float min_variance, float amount) {
    float variance = metal::max(held.y * held.y * 0.25, min_variance);
    float distance = umbrage_to_forward_depth(receiver) - held.x;
    float lit = umbrage_chebyshev_hardware(variance, distance, amount);
    return metal::abs(receiver) < 1048576.0 ? lit : 0.0;
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
inline float umbrage_decode_evsm2_hardware(float2 m, float receiver, float exponent, float deviation, float amount) {
    float d = umbrage_to_forward_depth(metal::clamp(receiver, 0.0, 1.0));
    float w = metal::exp2(exponent * (d * 2.0 - 1.0));
    float least = deviation * w;
    float variance = metal::max(m.y - m.x * m.x, least * least);
    float lit = umbrage_chebyshev_hardware(variance, w - m.x, amount);
    return metal::abs(receiver) < 1048576.0 ? lit : 0.0;
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
inline float umbrage_decode_evsm4_hardware(float4 m, float receiver, float2 exponents, float2 deviations,
                                           float amount) {
    float d = umbrage_to_forward_depth(metal::clamp(receiver, 0.0, 1.0)) * 2.0 - 1.0;
    float w = metal::exp2(exponents.x * d);
    float n = 0.0 - metal::exp2((0.0 - exponents.y) * d);
    float2 least = deviations * float2(w, n);
    float growing = metal::max(m.y - m.x * m.x, least.x * least.x);
    float falling = metal::max(m.w - m.z * m.z, least.y * least.y);
    float a = umbrage_chebyshev_hardware(growing, w - m.x, amount);
    float b = umbrage_chebyshev_hardware(falling, n - m.z, amount);
    return metal::abs(receiver) < 1048576.0 ? metal::min(a, b) : 0.0;
}
` };

export const blur_row3 = { language, name: "blur_row3", summary: "binomial mean of texels in a row, for blurs",
    exactness: "b", operations: 7, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [fetch_clamped], text: `
// umbrage_blur_row3: mean of 3 texels in a row, with the weights of a row of Pascal's triangle
//   map, size   map that is read, and its size in texels
//   texel       index of the texel, integers. (0, 0) is the first
//   along       (1.0, 0.0) or (0.0, 1.0)
inline float4 umbrage_blur_row3(metal::texture2d<float> map, float2 size, float2 texel, float2 along) {
    float4 sum = umbrage_fetch_clamped(map, size, texel) * (2.0 / 4.0);
    float4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    float4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
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
inline float4 umbrage_blur_row5(metal::texture2d<float> map, float2 size, float2 texel, float2 along) {
    float4 sum = umbrage_fetch_clamped(map, size, texel) * (6.0 / 16.0);
    float4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    float4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (4.0 / 16.0);
    float4 before2 = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    float4 after2 = umbrage_fetch_clamped(map, size, texel + along * 2.0);
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
inline float4 umbrage_blur_row7(metal::texture2d<float> map, float2 size, float2 texel, float2 along) {
    float4 sum = umbrage_fetch_clamped(map, size, texel) * (20.0 / 64.0);
    float4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    float4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (15.0 / 64.0);
    float4 before2 = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    float4 after2 = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (6.0 / 64.0);
    float4 before3 = umbrage_fetch_clamped(map, size, texel - along * 3.0);
    float4 after3 = umbrage_fetch_clamped(map, size, texel + along * 3.0);
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
inline float4 umbrage_halve_texels(metal::texture2d<float> map, float2 size, float2 texel) {
    float2 at = texel * 2.0;
    float4 a = umbrage_fetch_clamped(map, size, at);
    float4 b = umbrage_fetch_clamped(map, size, at + float2(1.0, 0.0));
    float4 c = umbrage_fetch_clamped(map, size, at + float2(0.0, 1.0));
    float4 d = umbrage_fetch_clamped(map, size, at + float2(1.0, 1.0));
    float4 sum = (a + b) + (c + d);
    return sum * 0.25;
}
` };

export const texels_to_world = { language, name: "texels_to_world", summary: "texels across a light to world units",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_texels_to_world: texels across a light as world units; 0.0 for w <= 0.0
//   units  (edge of a texel, depth per world unit) at w = 1.0
//   w      w of the point's shadow coordinate
inline float umbrage_texels_to_world(float texels, float2 units, float w) {
    float world = texels * units.x * w;
    return world >= (1.0 / 18446744073709551616.0) && world < 18446744073709551616.0 ? world : 0.0;
}
` };

export const clamp_bias = { language, name: "clamp_bias", summary: "clamp of a bias to [0, 1]; NaN becomes 1",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_clamp_bias: bias in depth clamped to [0, 1]; 0.0 below 2^-64, and 1.0 (no shadows) for NaN
inline float umbrage_clamp_bias(float bias) {
    float least = (1.0 / 18446744073709551616.0);
    return bias < 1.0 ? (bias >= least ? bias : 0.0) : 1.0;
}
` };

export const world_to_depth = { language, name: "world_to_depth", summary: "world units along a light to depth",
    exactness: "c", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [clamp_bias], text: `
// umbrage_world_to_depth: world units along a light as depth, 0.0 to 1.0
//   units  (edge of a texel, depth per world unit) at w = 1.0
//   w      w of the point's shadow coordinate, above 0.0
inline float umbrage_world_to_depth(float world, float2 units, float w) {
    float along = world * units.y;
    float square = w * w;
    return umbrage_clamp_bias(along / square);
}
` };

export const biased = { language, name: "biased", summary: "receiver moved towards the light",
    exactness: "b", operations: 1, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_biased: receiver moved towards the light by bias, in depth; no move for NaN, or magnitudes of 2^64 or more
inline float umbrage_biased(float receiver, float bias) {
    float by = metal::abs(bias) < 18446744073709551616.0 ? bias : 0.0;
    return umbrage_cleared_depth() > 0.5 ? receiver - by : receiver + by;
}
` };

export const clamp_slope = { language, name: "clamp_slope", summary: "clamp of a slope to [-2, 2]; NaN becomes 2",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_clamp_slope: change of depth per texel clamped to [-2, 2]; NaN becomes 2.0
inline float umbrage_clamp_slope(float slope) {
    return metal::abs(slope) < 2.0 ? slope : (slope <= -2.0 ? -2.0 : 2.0);
}
` };

export const plane_in_map = { language, name: "plane_in_map", summary: "normal of a plane in a map",
    exactness: "b", operations: 12, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_plane_in_map: normal, in texels, texels and depth, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse
//   normal        normal of the plane, any length
//   world         point on the plane
inline float3 umbrage_plane_in_map(metal::float4x4 plane_matrix, float3 normal, float3 world) {
    float d = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    float4 q = plane_matrix[3] * d + plane_matrix[0] * normal.x + plane_matrix[1] * normal.y + plane_matrix[2] *
        normal.z;
    return float3(q.x, q.y, q.z);
}
` };

export const plane_slope = { language, name: "plane_slope", summary: "change of a plane's depth per texel",
    exactness: "c", operations: 27, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [clamp_slope, plane_in_map], text: `
// umbrage_plane_slope: change of depth per texel, in x and y, of the plane through a point
//   plane_matrix, normal, world   as for umbrage_plane_in_map
inline float2 umbrage_plane_slope(metal::float4x4 plane_matrix, float3 normal, float3 world) {
    float3 q = umbrage_plane_in_map(plane_matrix, normal, world);
    return float2(umbrage_clamp_slope(-q.x / q.z), umbrage_clamp_slope(-q.y / q.z));
}
` };

export const receiver_slope = { language, name: "receiver_slope", summary: "change of a receiver's depth per texel",
    exactness: "c", operations: 27, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [plane_in_map], text: `
// umbrage_receiver_slope: umbrage_plane_slope without its clamps; (0.0, 0.0) for a normal of zero (the caller has none)
inline float2 umbrage_receiver_slope(metal::float4x4 plane_matrix, float3 normal, float3 world) {
    float3 q = umbrage_plane_in_map(plane_matrix, normal, world);
    float depth = q.z == 0.0 ? 1.0e-30 : q.z;  // q is zero without a normal, and not where edge-on
    return float2(-q.x / depth, -q.y / depth);
}
` };

export const cascade_slope = { language, name: "cascade_slope", summary: "change of a plane's depth per texel in a cascade",
    exactness: "c", operations: 6, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_cascade_slope: change of depth per texel; (0.0, 0.0) for a normal of zero
//   normal  surface normal, rotated into the light's axes
//   scale   scale of the cascade
inline float2 umbrage_cascade_slope(float3 normal, float4 scale) {
    float2 up = float2(normal.x, normal.y) * -scale.z;
    float z = normal.z == 0.0 ? 1.0e-18 : normal.z;  // up is zero without a normal, and not where edge-on
    float2 across = float2(scale.x, scale.y) * z;
    return float2(up.x / across.x, up.y / across.y);
}
` };

export const slope_bias = { language, name: "slope_bias", summary: "slope-scaled bias, as rasterizers compute it",
    exactness: "b", operations: 2, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [clamp_bias], text: `
// umbrage_slope_bias: factor times the larger slope, plus a base, 0.0 to 1.0
//   slope   change of depth per texel
//   factor  factor of the slope, in texels
//   base    constant bias, in depth
inline float umbrage_slope_bias(float2 slope, float factor, float base) {
    float2 bias = metal::abs(slope) * factor + base;
    float x = umbrage_clamp_bias(bias.x);  // clamp first: GPUs differ in the maximum of a NaN
    float y = umbrage_clamp_bias(bias.y);
    return x > y ? x : y;
}
` };

export const dual_paraboloid_slope = { language, name: "dual_paraboloid_slope", summary: "change of distance per texel in a dual paraboloid map",
    exactness: "c", operations: 41, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [clamp_slope], text: `
// umbrage_dual_paraboloid_slope: change of distance per texel, the same in x and y; 0.0 without a normal
//   way        from the light to the receiver
//   normal     surface normal
//   per_texel  2.0 / (range * (size - 2.0 * border))
inline float2 umbrage_dual_paraboloid_slope(float3 way, float3 normal, float per_texel) {
    float square = way.x * way.x + way.y * way.y + way.z * way.z;
    float x = normal.y * way.z - normal.z * way.y;
    float y = normal.z * way.x - normal.x * way.z;
    float z = normal.x * way.y - normal.y * way.x;
    float across = x * x + y * y + z * z;
    float along = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    float wide = (metal::sqrt(square) + metal::abs(way.z)) * (per_texel * 0.707106781);
    float slope = umbrage_clamp_slope(wide * metal::sqrt(across) / metal::abs(along));
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return none ? float2(0.0, 0.0) : float2(slope, slope);
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
inline float3 umbrage_normal_offset(float3 normal, float3 direction, float3 way, float width, float error_world) {
    float x = normal.y * direction.z + normal.z * -direction.y;
    float y = normal.z * direction.x + normal.x * -direction.z;
    float z = normal.x * direction.y + normal.y * -direction.x;
    float straight = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    float square = x * x + y * y + z * z;
    float along = width * metal::sqrt(square) + error_world * metal::abs(straight);
    float3 offset = normal * along;
    return metal::abs(offset.x) + metal::abs(offset.y) +
        metal::abs(offset.z) < 18446744073709551616.0 ? offset : float3(0.0, 0.0, 0.0);
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
inline float umbrage_kernel_bias(float3 normal, float3 direction, float3 way, float width, float greatest) {
    float x = normal.y * direction.z + normal.z * -direction.y;
    float y = normal.z * direction.x + normal.x * -direction.z;
    float z = normal.x * direction.y + normal.y * -direction.x;
    float square = x * x + y * y + z * z;
    float sine = metal::sqrt(square);
    float cosine = -(normal.x * way.x + normal.y * way.y + normal.z * way.z);
    float edge = cosine * greatest;
    float tangent = edge > sine ? sine / cosine : greatest;
    float bias = width * tangent;
    return bias >= (1.0 / 18446744073709551616.0) && bias < 18446744073709551616.0 ? bias : 0.0;
}
` };

export const receiver_plane_slope = { language, name: "receiver_plane_slope", summary: "slope of a receiver's plane from derivatives, and its error",
    exactness: "c", operations: 31, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [clamp_slope], text: `
// umbrage_receiver_plane_slope: change of a receiver's depth per texel in x and y, and the largest error of their sum
//   dx, dy  dFdx and dFdy of (x and y in texels, depth); the result is zero where they do not give the plane
inline float3 umbrage_receiver_plane_slope(float3 dx, float3 dy) {
    float determinant = dx.x * dy.y + dx.y * -dy.x;
    float sum = metal::abs(dx.x) + metal::abs(dx.y) + metal::abs(dy.x) + metal::abs(dy.y);
    float along_x = dy.y * dx.z + dx.y * -dy.z;
    float along_y = dx.x * dy.z + dy.x * -dx.z;
    float a = umbrage_clamp_slope(along_x / determinant);
    float b = umbrage_clamp_slope(along_y / determinant);
    float off = ((1.0 / 33554432.0) + (metal::abs(a) + metal::abs(b)) * (1.0 / 8192.0)) * 3.3;
    float error = off * (sum / metal::abs(determinant));
    float least = sum * (1.0 / 1024.0);
    bool known = metal::abs(determinant) > least && sum < 18446744073709551616.0;
    return known ? float3(a, b, umbrage_clamp_slope(error)) : float3(0.0, 0.0, 0.0);
}
` };

export const plane_reference = { language, name: "plane_reference", summary: "depth that a texel is compared with, by the receiver's plane",
    exactness: "b", operations: 8, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_plane_reference: depth of the receiver, or of its plane at a texel where that is nearer to the light
//   slope   slope of the receiver's plane, per texel, no NaN
//   at      receiver position in texels, and its depth, bias applied
//   texel   index of the texel
inline float umbrage_plane_reference(float2 slope, float3 at, float2 texel) {
    float2 way = texel - (float2(at.x, at.y) - 0.5);
    float plane = (at.z + slope.x * way.x) + slope.y * way.y;
    return umbrage_cleared_depth() > 0.5 ? metal::min(plane, at.z) : metal::max(plane, at.z);
}
` };

export const bordered_plane_reference = { language, name: "bordered_plane_reference", summary: "plane_reference in a map whose border is lit",
    exactness: "b", operations: 8, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_bordered_plane_reference: umbrage_plane_reference, but before every stored depth outside the map
//   slope, at, texel   as for umbrage_plane_reference
//   inside             texel if the map has it, otherwise any other
inline float umbrage_bordered_plane_reference(float2 slope, float3 at, float2 texel, float2 inside) {
    float lights = umbrage_cleared_depth() > 0.5 ? -16777216.0 : 16777216.0;
    float2 moves = slope * (texel - (float2(at.x, at.y) - 0.5));
    float x = inside.x == texel.x ? moves.x : lights;  // the same for all texels of a column
    float y = inside.y == texel.y ? moves.y : lights;
    float plane = (at.z + x) + y;
    return umbrage_cleared_depth() > 0.5 ? metal::min(plane, at.z) : metal::max(plane, at.z);
}
` };

export const corner_reference = { language, name: "corner_reference", summary: "depth that four texels are compared with, by the receiver's plane",
    exactness: "c", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cleared_depth], text: `
// umbrage_corner_reference: depth of the receiver, or of its plane where four texels meet, the nearer to the light
//   slope      slope of the receiver's plane, per texel, no NaN
//   way        from the receiver to where the texels meet, in texels
//   receiver   depth, bias applied
inline float umbrage_corner_reference(float2 slope, float2 way, float receiver) {
    float plane = (receiver + slope.x * way.x) + slope.y * way.y;
    return umbrage_cleared_depth() > 0.5 ? metal::min(plane, receiver) : metal::max(plane, receiver);
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
inline float umbrage_apply_receiver_plane(float stored, float2 slope, float3 at, float2 texel) {
    float lit = umbrage_compare(umbrage_plane_reference(slope, at, texel), stored);
    return lit > 0.5 ? umbrage_cleared_depth() : stored;
}
` };

export const acne_free_bias = { language, name: "acne_free_bias", summary: "bias without acne, from slope, reach and error",
    exactness: "b", operations: 4, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [clamp_bias], text: `
// umbrage_acne_free_bias: bias in depth without shadow acne, 0.0 to 1.0
//   slope  change of depth per texel, in x and y
//   reach  filter radius, in texels
//   error  largest error of a decoded depth towards the light
inline float umbrage_acne_free_bias(float2 slope, float reach, float error) {
    float bias = reach * (metal::abs(slope.x) + metal::abs(slope.y)) + (error + (1.0 / 8388608.0));
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
inline float umbrage_acne_free_disc_bias(float2 slope, float radius, float error) {
    float square = slope.x * slope.x + slope.y * slope.y;
    float beside = (metal::abs(slope.x) + metal::abs(slope.y)) * 0.5078125 + (error + (1.0 / 8388608.0));
    float bias = radius * metal::sqrt(square) + beside;
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
inline float umbrage_peter_panning_distance(float bias, float2 caster_slope, float reach) {
    return umbrage_acne_free_bias(caster_slope, reach, bias);
}
` };

export const spot_cone = { language, name: "spot_cone", summary: "1 inside a spot light's cone, else 0",
    exactness: "b", operations: 11, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_spot_cone: 1.0 inside the cone of a spot light, else 0.0
//   direction  of the light, unit length;   to_point  from the light, any length;   cos_outer  in [0, 1)
inline float umbrage_spot_cone(float3 direction, float3 to_point, float cos_outer) {
    float d = direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    float length2 = to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    float edge2 = cos_outer * cos_outer * length2;
    float d2 = d * d;
    return d > 0.0 && d2 > edge2 ? 1.0 : 0.0;
}
` };

export const diffuse_ambient = { language, name: "diffuse_ambient", summary: "diffuse plus ambient light of a surface",
    exactness: "b", operations: 5, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_diffuse_ambient: albedo * (visibility * n_dot_l * (1 - ambient) + ambient)
//   for n_dot_l <= 0.0 and NaN: albedo * ambient
inline float3 umbrage_diffuse_ambient(float3 albedo, float3 ambient, float n_dot_l, float visibility) {
    float3 light = visibility * n_dot_l * (1.0 - ambient) + ambient;
    return albedo * (n_dot_l > 0.0 ? light : ambient);  // max gives NaN for a signalling NaN on Mesa
}
` };

export const false_color = { language, name: "false_color", summary: "depth 0..1 as a color from blue over green to red",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [saturate], text: `
// umbrage_false_color: blue for 0.0, through green, to red for 1.0
inline float3 umbrage_false_color(float v) {
    float x = umbrage_saturate(v) * 4.0;
    float3 ramp = 1.5 - metal::abs(float3(x - 3.0, x - 2.0, x - 1.0));
    return float3(umbrage_saturate(ramp.x), umbrage_saturate(ramp.y), umbrage_saturate(ramp.z));
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
inline float umbrage_overlay_texel(float coord, float size, float map_size, float texels_per_pixel) {
    float texel = metal::floor(coord * texels_per_pixel - 0.5);
    texel += (texel + 1.0) * size <= coord * map_size ? 1.0 : 0.0;
    return coord >= 0.0 && coord < size ? texel : -1.0;
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
inline float3 umbrage_probe_color(float3 at, float2 size, float bias, float number) {
    float limit = 18446744073709551616.0;
    // limits differ on purpose: Mesa makes max(x, y) < limit of equal ones, which loses a NaN
    bool usable = metal::abs(at.x) < limit && metal::abs(at.y) * 2.0 < limit * 2.0 && metal::abs(at.z) * 4.0 < limit *
        4.0;
    bool inside = at.x >= 0.0 && at.y >= 0.0 && at.x <= size.x && at.y <= size.y;
    bool forward = umbrage_cleared_depth() > 0.5;
    bool past_far = forward ? at.z > 1.0 : at.z < 0.0;
    bool past_near = forward ? at.z < 0.0 : at.z > 1.0;
    float2 place = metal::clamp(float2(at.x, at.y), float2(0.0, 0.0), float2(65536.0, 65536.0));
    float square = metal::floor(place.x) + metal::floor(place.y);
    float shade = square - 2.0 * metal::floor(square * 0.5) > 0.5 ? 0.75 : 1.0;
    float3 bits = metal::floor(float3(number, number * 0.5, number * 0.25));
    bits = bits - 2.0 * metal::floor(bits * 0.5);
    float3 color = (bits * 0.5 + 0.375) * shade;
    color = bias < 1.0 ? color : float3(1.0, 0.0, 0.0);
    color = past_near ? float3(0.0, 0.0, 1.0) : color;
    color = past_far ? float3(0.0, 1.0, 1.0) : color;
    color = inside ? color : float3(1.0, 1.0, 1.0);
    color = at.x < 65536.0 ? color : float3(0.0, 0.0, 0.0);
    return usable ? color : float3(1.0, 0.0, 1.0);
}
` };

export const probe_inputs = { language, name: "probe_inputs", summary: "debug color, unless position or normal is wrong",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_probe_inputs: color, unless the receiver is wrong
//   magenta  position or normal is not a number
//   yellow   a normal of zero
inline float3 umbrage_probe_inputs(float3 color, float3 world, float3 normal) {
    float limit = 18446744073709551616.0;
    // limits differ on purpose: Mesa makes max(x, y) < limit of equal ones, which loses a NaN
    bool usable = metal::abs(world.x) < limit && metal::abs(world.y) * 2.0 < limit * 2.0 && metal::abs(world.z) *
        4.0 < limit * 4.0;
    usable = usable && metal::abs(normal.x) * 8.0 < limit * 8.0;
    usable = usable && metal::abs(normal.y) * 16.0 < limit * 16.0 && metal::abs(normal.z) * 32.0 < limit * 32.0;
    bool zero = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    float3 given = zero ? float3(1.0, 1.0, 0.0) : color;
    return usable ? given : float3(1.0, 0.0, 1.0);
}
` };

export const map_tile = { language, name: "map_tile", summary: "first texel of a map in an atlas of equal maps",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_map_tile: first texel of a map in an atlas of maps of size texels, row by row
//   number    number of the map, a whole number
//   columns   maps per row, and 1.0 / their number
inline float2 umbrage_map_tile(float number, float2 columns, float2 size) {
    float row = metal::floor((number + 0.5) * columns.y);
    return float2(number - row * columns.x, row) * size;
}
` };

export const anchored_vertex = { language, name: "anchored_vertex", summary: "vertex of a depth pass in clip space, far from the origin too",
    exactness: "b", operations: 20, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [shadow_coordinate], text: `
// umbrage_anchored_vertex: clip space position of a vertex of a depth pass
//   to_clip, anchor   of a depth_view: anchor.xyz is subtracted from world, and anchor.w times w is added to z
inline float4 umbrage_anchored_vertex(metal::float4x4 to_clip, float3 world, float4 anchor) {
    float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 c = umbrage_shadow_coordinate(to_clip, way);
    float depth = c.z + anchor.w * c.w;
    return float4(c.x, c.y, depth, c.w);
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
inline metal::float4x4 umbrage_anchored_place(metal::float4x4 to_texels, metal::float4x4 planes, float4 rounding,
                                              float4 slack, float3 way, float3 normal) {
    float4 none = float4(0.0, 0.0, 0.0, 0.0);
    float4 c = to_texels[3] + to_texels[0] * way.x + to_texels[1] * way.y + to_texels[2] * way.z;
    float2 slope = umbrage_receiver_slope(planes, normal, way);
    bool before = c.w > 0.0;
    float i = before ? 1.0 / c.w : 0.0;
    float3 at = float3(c.x, c.y, c.z) * i;
    float steep = metal::abs(slope.x) + metal::abs(slope.y);
    float moves = rounding.x + rounding.y * i;
    float off = moves * (rounding.w + metal::abs(at.z)) + (metal::abs(at.z) * slack.y + slack.z);
    float all = (moves * rounding.z + slack.x) * steep + off;
    return metal::float4x4(float4(before ? at.x : 65536.0, at.y, at.z + slack.w, 0.0), float4(slope, 1.0, all), none,
                           none);
}
` };

export const single_map_places = { language, name: "single_map_places", summary: "place of a point of the world in a light's one map",
    exactness: "c", operations: 121, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [anchored_place], text: `
// umbrage_single_map_places: place of a point of the world in a light's one map
//   to_texels, planes, rounding, slack   of umbrage_anchored_place, which has what it returns
//   anchor                               position that is subtracted from world
inline metal::float4x4 umbrage_single_map_places(metal::float4x4 to_texels, metal::float4x4 planes, float4 anchor,
                                                 float4 rounding, float4 slack, float4 terms, float3 world,
                                                 float3 normal) {
    float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    return umbrage_anchored_place(to_texels, planes, rounding, slack, way, normal);
}
` };

export const parallel_map_places = { language, name: "parallel_map_places", summary: "place of a point of the world in the one map of a light with parallel rays",
    exactness: "c", operations: 121, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_slope], text: `
// umbrage_parallel_map_places: umbrage_single_map_places under parallel rays, where w is 1
inline metal::float4x4 umbrage_parallel_map_places(metal::float4x4 to_texels, metal::float4x4 planes, float4 anchor,
                                                   float4 rounding, float4 slack, float4 terms, float3 world,
                                                   float3 normal) {
    float4 none = float4(0.0, 0.0, 0.0, 0.0);
    float4 one = float4(1.0, 1.0, 1.0, 1.0);
    float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 c = to_texels[3] + to_texels[0] * way.x + to_texels[1] * way.y + to_texels[2] * way.z;
    float4 q = planes[0] * normal.x + planes[1] * normal.y + planes[2] * normal.z;
    float2 slope = umbrage_cascade_slope(float3(q.x, q.y, q.z), one);
    float steep = metal::abs(slope.x) + metal::abs(slope.y);
    float off = metal::abs(c.z) * slack.y + slack.z;
    return metal::float4x4(float4(c.x, c.y, c.z + slack.w, 0.0), float4(slope, 1.0, slack.x * steep + off), none, none);
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
inline float umbrage_cascade_edge(float3 light, float4 scale, float4 offset, float2 size, float reach) {
    float3 at = light * float3(scale.x, scale.y, scale.z) + float3(offset.x, offset.y, offset.z);
    float2 half_size = size * 0.5;
    float2 beyond = metal::abs(float2(at.x, at.y) - half_size) - (half_size - reach);
    return metal::abs(at.z - 0.5) <= 0.5 ? metal::max(beyond.x, beyond.y) : 65536.0;
}
` };

export const cascade_edges = { language, name: "cascade_edges", summary: "cascade_edge of four cascades",
    exactness: "c", operations: 13, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_edge], text: `
// umbrage_cascade_edges: umbrage_cascade_edge of four cascades
//   scales, offsets   one column per cascade
inline float4 umbrage_cascade_edges(float3 light, metal::float4x4 scales, metal::float4x4 offsets, float2 size,
                                    float reach) {
    return float4(umbrage_cascade_edge(light, scales[0], offsets[0], size, reach),
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
inline float3 umbrage_first_cascade(float4 edges) {
    float3 found = edges.w <= 0.0 ? float3(3.0, edges.w, 65536.0) : float3(4.0, 65536.0, 65536.0);
    found = edges.z <= 0.0 ? float3(2.0, edges.z, edges.w) : found;
    found = edges.y <= 0.0 ? float3(1.0, edges.y, edges.z) : found;
    return edges.x <= 0.0 ? float3(0.0, edges.x, edges.y) : found;
}
` };

export const next_cascade_weight = { language, name: "next_cascade_weight", summary: "weight of the next cascade, by both edges",
    exactness: "b", operations: 3, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_weight], text: `
// umbrage_next_cascade_weight: weight of the next cascade, which grows towards the border of a cascade's map
//   found      of umbrage_first_cascade
//   blending   1.0 / width of the band in texels, or 0.0; number of the last cascade, after which comes light
inline float umbrage_next_cascade_weight(float3 found, float4 blending) {
    float2 v = float2(found.y, found.z) * blending.x + 1.0;
    float leaves = umbrage_cascade_weight(v.x);
    float held = found.z <= 0.0 ? 1.0 - umbrage_cascade_weight(v.y) : 0.0;
    float weight = found.x >= blending.y ? leaves : metal::min(leaves, held);
    return blending.x > 0.0 && found.x <= blending.y ? weight : 0.0;
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
inline float2 umbrage_cascaded_maps_choice(metal::float4x4 rotation, metal::float4x4 scales, metal::float4x4 offsets,
                                           float4 anchor, float4 blending, float4 terms, float3 world) {
    float2 size = float2(terms.x, terms.y);
    float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 turned = rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    float3 light = float3(turned.x, turned.y, turned.z);
    float3 found = umbrage_first_cascade(umbrage_cascade_edges(light, scales, offsets, size, terms.z));
    return float2(found.x, umbrage_next_cascade_weight(found, blending));
}
` };

export const cascaded_maps_choice_8 = { language, name: "cascaded_maps_choice_8", summary: "those of up to eight cascades that hold a point of the world",
    exactness: "c", operations: 38, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_edges, first_cascade, next_cascade_weight], text: `
// umbrage_cascaded_maps_choice_8: umbrage_cascaded_maps_choice for up to eight cascades
//   farther_scales, farther_offsets   those of the fifth cascade and of those after it
inline float2 umbrage_cascaded_maps_choice_8(metal::float4x4 rotation, metal::float4x4 scales, metal::float4x4 offsets,
                                             metal::float4x4 farther_scales, metal::float4x4 farther_offsets,
                                             float4 anchor, float4 blending, float4 terms, float3 world) {
    float2 size = float2(terms.x, terms.y);
    float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 turned = rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    float3 light = float3(turned.x, turned.y, turned.z);
    float4 nearer = umbrage_cascade_edges(light, scales, offsets, size, terms.z);
    float4 farther = umbrage_cascade_edges(light, farther_scales, farther_offsets, size, terms.z);
    float3 found = umbrage_first_cascade(nearer);
    float3 after = umbrage_first_cascade(farther);
    float next = found.x == 3.0 ? farther.x : found.z;
    found = found.x < 3.5 ? float3(found.x, found.y, next) : float3(after.x + 4.0, after.y, after.z);
    return float2(found.x, umbrage_next_cascade_weight(found, blending));
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
inline metal::float4x4 umbrage_cascade_place(float3 light, float3 across, float4 scale, float4 offset, float number,
                                             float last) {
    float4 none = float4(0.0, 0.0, 0.0, 0.0);
    float3 at = light * float3(scale.x, scale.y, scale.z) + float3(offset.x, offset.y, offset.z);
    float x = number <= last ? at.x : -65536.0;
    float2 slope = umbrage_cascade_slope(across, scale);
    float slack = (metal::abs(slope.x) + metal::abs(slope.y)) * scale.w + offset.w;
    return metal::float4x4(float4(x, at.y, at.z, metal::min(number, last)), float4(slope, 1.0, slack), none, none);
}
` };

export const cascaded_maps_place = { language, name: "cascaded_maps_place", summary: "place of a point of the world in one of up to four cascades",
    exactness: "c", operations: 38, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_column, cascade_place], text: `
// umbrage_cascaded_maps_place: umbrage_cascade_place of a point of the world, in one of up to four cascades
//   number   number of the cascade
//   the others as for umbrage_cascaded_maps_choice
inline metal::float4x4 umbrage_cascaded_maps_place(metal::float4x4 rotation, metal::float4x4 scales,
                                                   metal::float4x4 offsets, float4 anchor, float4 blending,
                                                   float4 terms, float3 world, float3 normal, float number) {
    float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 light = rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    float4 across = rotation[3] + rotation[0] * normal.x + rotation[1] * normal.y + rotation[2] * normal.z;
    float own = metal::min(number, blending.y);
    return umbrage_cascade_place(float3(light.x, light.y, light.z), float3(across.x, across.y, across.z),
                                 umbrage_cascade_column(scales, own), umbrage_cascade_column(offsets, own), number,
                                 blending.y);
}
` };

export const cascaded_maps_place_8 = { language, name: "cascaded_maps_place_8", summary: "place of a point of the world in one of up to eight cascades",
    exactness: "c", operations: 38, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_column_8, cascade_place], text: `
// umbrage_cascaded_maps_place_8: umbrage_cascaded_maps_place for up to eight cascades
//   farther_scales, farther_offsets   those of the fifth cascade and of those after it
inline metal::float4x4 umbrage_cascaded_maps_place_8(metal::float4x4 rotation, metal::float4x4 scales,
                                                     metal::float4x4 offsets, metal::float4x4 farther_scales,
                                                     metal::float4x4 farther_offsets, float4 anchor, float4 blending,
                                                     float4 terms, float3 world, float3 normal, float number) {
    float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 light = rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    float4 across = rotation[3] + rotation[0] * normal.x + rotation[1] * normal.y + rotation[2] * normal.z;
    float own = metal::min(number, blending.y);
    return umbrage_cascade_place(float3(light.x, light.y, light.z), float3(across.x, across.y, across.z),
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
inline metal::float4x4 umbrage_cube_maps_places(float4 face, float4 anchor, float4 rounding, float4 slack, float4 terms,
                                                float3 world, float3 normal) {
    float4 none = float4(0.0, 0.0, 0.0, 0.0);
    float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float3 m = metal::abs(way);
    bool on_x = m.x >= m.y ? m.x >= m.z : false;
    bool on_y = on_x ? false : m.y >= m.z;
    float along = on_x ? way.x : (on_y ? way.y : way.z);
    float flip = along < 0.0 ? -1.0 : 1.0;
    float number = (on_x ? 0.5 : (on_y ? 2.5 : 4.5)) - 0.5 * flip;
    float2 signs = float2(on_x ? -flip : (on_y ? 1.0 : flip), on_y ? flip : -1.0);
    float2 there = float2(on_x ? way.z : way.x, on_y ? way.z : way.y) * signs;
    float2 across = float2(on_x ? normal.z : normal.x, on_y ? normal.z : normal.y) * signs;
    float off_plane = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    float rise = face.w / (off_plane == 0.0 ? 1.0e-30 : off_plane);  // as umbrage_receiver_slope
    float2 slope = across * rise;
    float i = 1.0 / metal::max(metal::abs(along), 1.0e-30);
    float z = face.z * i;
    float2 at = there * (face.x * i) + face.y;
    float steep = metal::abs(slope.x) + metal::abs(slope.y);
    float moves = rounding.x + rounding.y * i;
    float off = metal::abs(z) * (moves + slack.y) + slack.z;  // a lens has no rounding.w
    float all = (moves * rounding.z + slack.x) * steep + off;
    return metal::float4x4(float4(at, z + slack.w, number), float4(slope, 1.0, all), none, none);
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
inline metal::float4x4 umbrage_tetrahedron_map_places(metal::float4x4 to_texels, metal::float4x4 planes, float4 anchor,
                                                      float4 rounding, float4 slack, float4 center, float4 terms,
                                                      float3 world, float3 normal) {
    float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float face = umbrage_tetrahedron_face(way);
    metal::float4x4 place =
        umbrage_anchored_place(to_texels, planes, rounding, slack, umbrage_tetrahedron_face_point(face, way),
                               umbrage_tetrahedron_face_point(face, normal));
    float2 at = umbrage_tetrahedron_turned(face, float2(place[0].x, place[0].y)) + center.x;
    float2 slope = umbrage_tetrahedron_turned(face, float2(place[1].x, place[1].y));
    return metal::float4x4(float4(at, place[0].z, 0.0), float4(slope, place[1].z, place[1].w), place[2], place[3]);
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
inline float3 umbrage_tetrahedron_shape(float4 center, float number, float2 at) {
    bool beside = metal::abs(at.x - center.x) > metal::abs(at.y - center.x);
    return beside ? float3(0.577350269, 1.73205081, 0.0) : float3(1.0, 1.0, 0.0);
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
inline metal::float4x4 umbrage_paraboloid_maps_places(float4 position, float4 halves, float4 rounding, float4 terms,
                                                      float3 world, float3 normal) {
    float4 none = float4(0.0, 0.0, 0.0, 0.0);
    float3 way = world - float3(position.x, position.y, position.z);
    float3 found = umbrage_dual_paraboloid_coordinate(way);
    float2 at = float2(found.x, found.y) * halves.x + halves.y;
    float depth = umbrage_distance_depth(way, position.w) + halves.w;
    float2 slope = umbrage_dual_paraboloid_slope(way, normal, halves.z);
    return metal::float4x4(float4(at, depth, found.z), float4(slope, 1.0, rounding.x), none, none);
}
` };

export const paraboloid_vertex = { language, name: "paraboloid_vertex", summary: "clip space position of a vertex in a paraboloid map",
    exactness: "c", operations: 51, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [dual_paraboloid_position], text: `
// umbrage_paraboloid_vertex: clip space position of a vertex in a paraboloid map
//   to_clip    the light's projection
//   anchor     position of the light
//   number     0.0 or 1.0, the map
inline float4 umbrage_paraboloid_vertex(metal::float4x4 to_clip, float3 world, float4 anchor, float number) {
    float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 p = umbrage_dual_paraboloid_position(way, number);
    float4 place = to_clip[3] * p.w + to_clip[0] * p.x + to_clip[1] * p.y + to_clip[2] * p.z;
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
inline float2 umbrage_warped_maps_choice(metal::float4x4 fades, float4 anchor, float4 ahead, float4 ends,
                                         float3 world) {
    float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float depth = ahead.x * way.x + ahead.y * way.y + ahead.z * way.z + ahead.w;
    float number = umbrage_cascade_by_depth(depth, float3(ends.x, ends.y, ends.z));
    float4 own = umbrage_cascade_column(fades, number);
    return float2(number, umbrage_cascade_fade(depth, own.x, own.y));
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
inline metal::float4x4 umbrage_warped_maps_place(metal::float4x4 to_texels_0, metal::float4x4 to_texels_1,
                                                 metal::float4x4 to_texels_2, metal::float4x4 to_texels_3,
                                                 metal::float4x4 planes_0, metal::float4x4 planes_1,
                                                 metal::float4x4 planes_2, metal::float4x4 planes_3,
                                                 metal::float4x4 rounding, metal::float4x4 slack, metal::float4x4 fades,
                                                 float4 anchor, float4 ahead, float4 ends, float4 terms, float3 world,
                                                 float3 normal, float number) {
    float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float own = metal::min(number, ends.w);
    metal::float4x4 to_texels = to_texels_0;
    metal::float4x4 planes = planes_0;
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
    metal::float4x4 at =
        umbrage_anchored_place(to_texels, planes, umbrage_cascade_column(rounding, own),
                               umbrage_cascade_column(slack, own), way, normal);
    float x = number <= ends.w ? at[0].x : -65536.0;
    return metal::float4x4(float4(x, at[0].y, at[0].z, own), at[1], at[2], at[3]);
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
inline metal::float4x4 umbrage_adaptive_maps_places(metal::float4x4 to_root, metal::float4x4 planes,
                                                    metal::float4x4 cells_0, metal::float4x4 cells_1,
                                                    metal::float4x4 cells_2, metal::float4x4 cells_3,
                                                    metal::float4x4 cells_4, metal::float4x4 cells_5,
                                                    metal::float4x4 cells_6, metal::float4x4 cells_7, float4 anchor,
                                                    float4 pages, float4 slack, float4 terms, float3 world,
                                                    float3 normal) {
    float4 none = float4(0.0, 0.0, 0.0, 0.0);
    float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 in_root = umbrage_shadow_coordinate(to_root, way);
    bool inside = in_root.x >= 1.0 && in_root.x < 2.0 && in_root.y >= 1.0 && in_root.y < 2.0;
    float2 coord = inside ? float2(in_root.x, in_root.y) : float2(1.0, 1.0);
    float2 cell = metal::floor(coord * 16.0 - 16.0);
    float right = metal::floor(cell.x * 0.125);
    float column = cell.y * 2.0 + right;
    float4 a = umbrage_cascade_column_8(cells_0, cells_1, column);
    float4 b = umbrage_cascade_column_8(cells_2, cells_3, column - 8.0);
    float4 c = umbrage_cascade_column_8(cells_4, cells_5, column - 16.0);
    float4 d = umbrage_cascade_column_8(cells_6, cells_7, column - 24.0);
    float4 low = column < 7.5 ? a : b;
    float4 high = column < 23.5 ? c : d;
    float4 eight = column < 15.5 ? low : high;
    float along = cell.x - right * 8.0;
    float pair = metal::floor(along * 0.5);
    float left_two = pair < 0.5 ? eight.x : eight.y;
    float right_two = pair < 2.5 ? eight.z : eight.w;
    float two = pair < 1.5 ? left_two : right_two;
    float second = metal::floor(two * (1.0 / 1024.0));
    float code = along - pair * 2.0 < 0.5 ? two - second * 1024.0 : second;
    float before = metal::floor(code * (1.0 / 64.0));
    float across = before + 1.0;
    float2 place = coord * across;
    float2 within = (place - metal::floor(place)) * pages.x + pages.y;
    float2 at = inside ? within : float2(32768.0, 32768.0);
    float2 deepest = umbrage_receiver_slope(planes, normal, way);
    float larger = 16.0 / across;
    float steep = metal::abs(deepest.x) + metal::abs(deepest.y);
    float off = (slack.x * larger + slack.y) * steep + (slack.w * larger + slack.z);
    return metal::float4x4(float4(at, in_root.z, code - before * 64.0), float4(deepest * larger, 1.0, off), none, none);
}
` };

export const map_softness = { language, name: "map_softness", summary: "one of eight pairs of a matrix, without dynamic indexing",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [cascade_column], text: `
// umbrage_map_softness: one of eight pairs of a matrix, two a column, by its index, 0.0 to 7.0
inline float2 umbrage_map_softness(metal::float4x4 eight, float number) {
    float column = metal::floor(number * 0.5);
    float4 two = umbrage_cascade_column(eight, column);
    return number - 2.0 * column < 0.5 ? float2(two.x, two.y) : float2(two.z, two.w);
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
inline float3 umbrage_warp_shape(metal::float4x4 warps, float number, float2 at) {
    float4 own = umbrage_cascade_column(warps, number);
    float2 a = float2(1.0 - at.x * own.x, own.z - at.x * own.y);
    float2 b = float2(-at.y * own.w * own.x, 1.0 - at.y * own.w * own.y);
    float area = metal::abs(a.x * b.y - a.y * b.x);
    float rows = metal::length(b);
    return float3(area / rows, rows, metal::clamp(metal::dot(a, b) / area, -8.0, 8.0));
}
` };

export const shaped_softness = { language, name: "shaped_softness", summary: "softness of a place, by its shape",
    exactness: "c", operations: 9, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [], text: `
// umbrage_shaped_softness: softness of a place
//   softness   that of its map: (1/16 texel per distance code along x and y, min_radius, max_radius)
//   shape      factors in x and y, shear
inline float4 umbrage_shaped_softness(float4 softness, float3 shape) {
    float max_radius = softness.w / metal::sqrt(1.0 + shape.z * shape.z);
    return float4(softness.x * shape.x, softness.y * shape.y, softness.z, max_radius);
}
` };
