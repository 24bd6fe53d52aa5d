import { wgsl as language } from '../languages.mjs';
import * as snippets from './snippets.mjs';

const cleared_depth_reversed = { name: "cleared_depth", role: "chosen", needs: [],
    text: `
// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 0.0;
}
` };
const map_covers_clamped = { name: "map_covers", role: "chosen", needs: [],
    text: `
// umbrage_map_covers: always true, as the nearest texel inside is used outside the map
fn umbrage_map_covers(size: vec2f, coord: vec2f) -> bool {
    return true;
}
` };
const texel_inside_clamped = { name: "texel_inside", role: "chosen", needs: [],
    text: `
// umbrage_texel_inside: texel of the map, or the nearest one for coordinates outside
fn umbrage_texel_inside(size: vec2f, texel: vec2f) -> vec2f {
    return clamp(texel, vec2f(0.0, 0.0), size - 1.0);
}
` };
const beyond_far_plane_reversed = { name: "beyond_far_plane", role: "chosen", needs: [],
    text: `
// umbrage_beyond_far_plane: true when a receiver is beyond the far plane
fn umbrage_beyond_far_plane(receiver: f32) -> bool {
    return receiver < 0.0;
}
` };
const beyond_far_plane_without = { name: "beyond_far_plane", role: "chosen", needs: [],
    text: `
// umbrage_beyond_far_plane: always false for this map. Receivers beyond the far plane have a value that every texel
// lights
fn umbrage_beyond_far_plane(receiver: f32) -> bool {
    return false;
}
` };
const within_far_plane_reversed = { name: "within_far_plane", role: "chosen", needs: [],
    text: `
// umbrage_within_far_plane: true when a receiver is a number and not beyond the far plane
fn umbrage_within_far_plane(receiver: f32) -> bool {
    return receiver >= 0.0;
}
` };
const within_far_plane_without = { name: "within_far_plane", role: "chosen", needs: [],
    text: `
// umbrage_within_far_plane: true when a receiver is a number, as no receiver of this map is beyond the far plane
fn umbrage_within_far_plane(receiver: f32) -> bool {
    // a sum of choices: compilers take an or of the comparisons for true
    let number: f32 = select(0.0, 1.0, receiver > 0.0) + select(0.0, 1.0, receiver <= 0.0);
    return number > 0.5;
}
` };
const compare_reversed = { name: "compare", role: "chosen", needs: [],
    text: `
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth. Near is 1.0
fn umbrage_compare(receiver: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, receiver >= stored);
}
` };
const compare_own = { name: "compare", role: "chosen", needs: [],
    text: `
// umbrage_compare: visibility of one comparison, by the map's own comparison
fn umbrage_compare(receiver: f32, stored: f32) -> f32 {
    return UMBRAGE_COMPARE;
}
` };
const decode = { name: "decode", role: "chosen", needs: [],
    text: `
// umbrage_decode: depth of a value that the sampler returned
fn umbrage_decode(value: vec4f) -> f32 {
    return UMBRAGE_STORED;
}
` };
const fetch_depth_clamped = { name: "fetch_depth", role: "chosen", needs: [snippets.fetch_clamped],
    text: `
// umbrage_fetch_depth: stored depth of a texel, that of the nearest texel inside when outside the map
fn umbrage_fetch_depth(UMBRAGE_MAP map, size: vec2f, texel: vec2f) -> f32 {
    let value: vec4f = umbrage_fetch_clamped(map, size, texel);
    return UMBRAGE_DEPTH;
}
` };
const lit_texel = { name: "lit_texel", role: "chosen", needs: [],
    text: `
// umbrage_lit_texel: the sampler's comparison with a texel inside the map. NaN is in shadow
fn umbrage_lit_texel(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    let lit: f32 = UMBRAGE_LIT_TEXEL;
    return select(0.0, lit, receiver > 0.0) + select(0.0, lit, receiver <= 0.0);
}
` };
const lit_clamped = { name: "lit", role: "chosen", needs: [lit_texel],
    text: `
// umbrage_lit: visibility of one comparison with a texel, with the nearest texel inside when outside the map
fn umbrage_lit(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    return umbrage_lit_texel(map, size, clamp(texel, vec2f(0.0, 0.0), size - 1.0), receiver);
}
` };
const lit_bordered = { name: "lit", role: "chosen", needs: [snippets.texel_inside, lit_texel, snippets.compare],
    text: `
// umbrage_lit: compares the receiver with one texel. Outside the map it compares with the far plane
fn umbrage_lit(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    let inside: vec2f = umbrage_texel_inside(size, texel);
    let lit: f32 = umbrage_lit_texel(map, size, inside, receiver);
    let outside: f32 = umbrage_compare(receiver, UMBRAGE_BORDER);
    return select(outside, lit, inside.x == texel.x && inside.y == texel.y);
}
` };
const lit_along_a_plane = { name: "lit", role: "chosen", needs: [snippets.texel, snippets.texel_inside, snippets.compare],
    text: `
// umbrage_lit: visibility from one comparison with a texel, along the receiver's plane
fn umbrage_lit(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    let inside: vec2f = umbrage_texel_inside(size, texel);
    let value: vec4f = umbrage_texel(map, size, inside);
    return umbrage_compare(UMBRAGE_REFERENCE, UMBRAGE_STORED);
}
` };
const lit_texel_along_a_plane = { name: "lit_texel", role: "chosen", needs: [],
    text: `
// umbrage_lit_texel: the sampler's comparison with a texel inside the map
//   receiver   no NaN
fn umbrage_lit_texel(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    return UMBRAGE_LIT_TEXEL;
}
` };
const lit_compared_along_a_plane = { name: "lit", role: "chosen", needs: [snippets.texel_inside, lit_texel_along_a_plane],
    text: `
// umbrage_lit: visibility of one comparison with a texel, along the receiver's plane. NaN is in shadow
fn umbrage_lit(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    let inside: vec2f = umbrage_texel_inside(size, texel);
    let lit: f32 = umbrage_lit_texel(map, size, inside, UMBRAGE_REFERENCE);
    let number: f32 = select(0.0, 1.0, receiver > 0.0) + select(0.0, 1.0, receiver <= 0.0);
    return lit * number;
}
` };
const gather_compared = { name: "gather", role: "gather", needs: [],
    text: `
// umbrage_gather: the sampler's comparisons with four texels. NaN is in shadow
fn umbrage_gather(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    let lit: vec4f = UMBRAGE_GATHER_LIT;
    let number: f32 = select(0.0, 1.0, receiver > 0.0) + select(0.0, 1.0, receiver <= 0.0);
    return vec4f(lit.w, lit.z, lit.x, lit.y) * number;
}
` };
const gather_one_channel = { name: "gather", role: "chosen", needs: [decode],
    text: `
// umbrage_gather: depths of four texels
fn umbrage_gather(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    let r: vec4f = UMBRAGE_GATHER_RED;
    let a: f32 = umbrage_decode(vec4f(r.w, 0.0, 0.0, 0.0));
    let b: f32 = umbrage_decode(vec4f(r.z, 0.0, 0.0, 0.0));
    let c: f32 = umbrage_decode(vec4f(r.x, 0.0, 0.0, 0.0));
    let d: f32 = umbrage_decode(vec4f(r.y, 0.0, 0.0, 0.0));
    return vec4f(a, b, c, d);
}
` };
const gather_two_channels = { name: "gather", role: "chosen", needs: [decode],
    text: `
// umbrage_gather: depths of four texels
fn umbrage_gather(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    let r: vec4f = UMBRAGE_GATHER_RED;
    let g: vec4f = UMBRAGE_GATHER_GREEN;
    let a: f32 = umbrage_decode(vec4f(r.w, g.w, 0.0, 0.0));
    let b: f32 = umbrage_decode(vec4f(r.z, g.z, 0.0, 0.0));
    let c: f32 = umbrage_decode(vec4f(r.x, g.x, 0.0, 0.0));
    let d: f32 = umbrage_decode(vec4f(r.y, g.y, 0.0, 0.0));
    return vec4f(a, b, c, d);
}
` };
const gather_clamped_by_the_sampler = { name: "gather_clamped", role: "gather_clamped", needs: [gather_compared],
    text: `
// umbrage_gather_clamped: umbrage_gather. The sampler clamps to the edge
fn umbrage_gather_clamped(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    return umbrage_gather(map, size, texel, receiver);
}
` };
const gather_clamped_in_a_region = { name: "gather_clamped", role: "chosen", needs: [gather_compared],
    text: `
// umbrage_gather_clamped: umbrage_gather of the nearest texels inside the region. It gathers inside, and takes each
// value from its row and column
fn umbrage_gather_clamped(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let first: vec2f = clamp(texel, vec2f(0.0, 0.0), max(size - 2.0, vec2f(0.0, 0.0)));
    let low: vec2f = clamp(texel, vec2f(0.0, 0.0), size - 1.0) - first;
    let high: vec2f = clamp(texel + 1.0, vec2f(0.0, 0.0), size - 1.0) - first;
    let four: vec4f = umbrage_gather(map, size, first, receiver);
    let left: vec2f = select(vec2f(four.x, four.z), vec2f(four.y, four.w), low.x > 0.5);
    let right: vec2f = select(vec2f(four.x, four.z), vec2f(four.y, four.w), high.x > 0.5);
    let bottom: vec2f = select(vec2f(left.x, right.x), vec2f(left.y, right.y), low.y > 0.5);
    let top: vec2f = select(vec2f(left.x, right.x), vec2f(left.y, right.y), high.y > 0.5);
    return vec4f(bottom.x, bottom.y, top.x, top.y);
}
` };
const gather_lit_compared_by_the_sampler = { name: "gather_lit", role: "gather_lit", needs: [gather_clamped_by_the_sampler],
    text: `
// umbrage_gather_lit: visibility of four comparisons, with the nearest texel inside where one is outside
fn umbrage_gather_lit(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    return umbrage_gather_clamped(map, size, texel, receiver);
}
` };
const gather_lit_of_depths = { name: "gather_lit", role: "chosen", needs: [gather_clamped_by_the_sampler, snippets.compare],
    text: `
// umbrage_gather_lit: visibility of four comparisons, with the nearest texel inside where one is outside
fn umbrage_gather_lit(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let stored: vec4f = umbrage_gather_clamped(map, size, texel, receiver);
    let a: f32 = umbrage_compare(receiver, stored.x);
    let b: f32 = umbrage_compare(receiver, stored.y);
    let c: f32 = umbrage_compare(receiver, stored.z);
    let d: f32 = umbrage_compare(receiver, stored.w);
    return vec4f(a, b, c, d);
}
` };
const compare_along_along_a_plane = { name: "compare_along", role: "chosen", needs: [snippets.texel_inside, snippets.compare],
    text: `
// umbrage_compare_along: visibility of one comparison with a texel's depth, along the receiver's plane
fn umbrage_compare_along(UMBRAGE_MAP map, size: vec2f, texel: vec2f, stored: f32) -> f32 {
    let inside: vec2f = umbrage_texel_inside(size, texel);
    return umbrage_compare(UMBRAGE_REFERENCE, stored);
}
` };
const gather_lit_along_a_plane = { name: "gather_lit", role: "chosen", needs: [gather_clamped_by_the_sampler, compare_along_along_a_plane],
    text: `
// umbrage_gather_lit: visibility of four comparisons, along the receiver's plane
fn umbrage_gather_lit(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let stored: vec4f = umbrage_gather_clamped(map, size, texel, receiver);
    let a: f32 = umbrage_compare_along(map, size, texel, stored.x);
    let b: f32 = umbrage_compare_along(map, size, texel + vec2f(1.0, 0.0), stored.y);
    let c: f32 = umbrage_compare_along(map, size, texel + vec2f(0.0, 1.0), stored.z);
    let d: f32 = umbrage_compare_along(map, size, texel + vec2f(1.0, 1.0), stored.w);
    return vec4f(a, b, c, d);
}
` };
const lit_2x2_gathered = { name: "lit_2x2", role: "chosen", needs: [gather_lit_compared_by_the_sampler],
    text: `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
fn umbrage_lit_2x2(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    return umbrage_gather_lit(map, size, texel, receiver);
}
` };
const lit_2x2_gathered_and_bordered = { name: "lit_2x2", role: "chosen", needs: [gather_lit_compared_by_the_sampler, snippets.inside_map, snippets.compare],
    text: `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
// Outside the map the far plane is compared. The sampler's border color does not matter
fn umbrage_lit_2x2(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let lit: vec4f = umbrage_gather_lit(map, size, texel, receiver);
    let outside: f32 = umbrage_compare(receiver, UMBRAGE_BORDER);
    let a: f32 = select(outside, lit.x, umbrage_inside_map(size, texel));
    let b: f32 = select(outside, lit.y, umbrage_inside_map(size, texel + vec2f(1.0, 0.0)));
    let c: f32 = select(outside, lit.z, umbrage_inside_map(size, texel + vec2f(0.0, 1.0)));
    let d: f32 = select(outside, lit.w, umbrage_inside_map(size, texel + vec2f(1.0, 1.0)));
    return vec4f(a, b, c, d);
}
` };
const lit_filtered_clamped = { name: "lit_filtered", role: "chosen", exactness: "c", operations: 0, within: 0.0078125, as_written: false, needs: [snippets.within_far_plane],
    text: `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler. NaN is in shadow
//   coord   in texels, no NaN
fn umbrage_lit_filtered(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let texel: vec2f = clamp(coord, vec2f(0.5, 0.5), size - 0.5);
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    let uv: vec2f = UMBRAGE_UV;
    let lit: f32 = UMBRAGE_LIT_FILTERED;
    return select(0.0, lit, umbrage_within_far_plane(receiver));
}
` };
const lit_filtered_bordered = { name: "lit_filtered", role: "chosen", exactness: "c", operations: 0, within: 0.0078125, as_written: false, needs: [snippets.within_far_plane, snippets.compare],
    text: `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler. NaN is in shadow
// Outside the map the far plane is compared
//   coord   in texels, no NaN
fn umbrage_lit_filtered(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let texel: vec2f = clamp(coord, vec2f(0.5, 0.5), size - 0.5);
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    let uv: vec2f = UMBRAGE_UV;
    let lit: f32 = UMBRAGE_LIT_FILTERED;
    let inside: vec2f = clamp(min(coord, size - coord) + 0.5, vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    let outside: f32 = umbrage_compare(receiver, UMBRAGE_BORDER);
    return select(0.0, outside + inside.x * inside.y * (lit - outside), umbrage_within_far_plane(receiver));
}
` };
const covered_bordered = { name: "covered", role: "chosen", exactness: "c", operations: 6, within: 0, as_written: false, needs: [],
    text: `
// umbrage_covered: share of the texels around a point that lie in the map, along each axis
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
fn umbrage_covered(size: vec2f, uv: vec2f) -> vec2f {
    return clamp((0.5 + size * 0.5) - abs(uv - 0.5) * size, vec2f(0.0, 0.0), vec2f(1.0, 1.0));
}
` };
const lit_between_sampled = { name: "lit_between", role: "chosen", exactness: "c", operations: 0, within: 0.0078125, as_written: false, needs: [],
    text: `
// umbrage_lit_between: 2x2 comparisons around a point, weighted by the sampler
//   uv         over the map, (0.0, 0.0) to (1.0, 1.0)
//   receiver   no NaN
fn umbrage_lit_between(UMBRAGE_MAP map, size: vec2f, uv: vec2f, way: vec2f, receiver: f32) -> f32 {
    return UMBRAGE_LIT_FILTERED;
}
` };
const lit_sampled_along_a_plane = { name: "lit_sampled", role: "chosen", needs: [],
    text: `
// umbrage_lit_sampled: 2x2 comparisons of the sampler around a point
fn umbrage_lit_sampled(UMBRAGE_MAP map, size: vec2f, uv: vec2f, receiver: f32) -> f32 {
    return UMBRAGE_LIT_FILTERED;
}
` };
const lit_between_along_a_plane = { name: "lit_between", role: "chosen", exactness: "c", operations: 0, within: 0.0078125, as_written: false, needs: [snippets.corner_reference, lit_sampled_along_a_plane],
    text: `
// umbrage_lit_between: 2x2 comparisons around a point, weighted by the sampler, with the plane's depth where the four
// texels meet
//   uv    over the map, (0.0, 0.0) to (1.0, 1.0)
//   way   from the receiver to where the four texels meet, in texels
fn umbrage_lit_between(UMBRAGE_MAP map, size: vec2f, uv: vec2f, way: vec2f, receiver: f32) -> f32 {
    return umbrage_lit_sampled(map, size, uv, UMBRAGE_CORNER);
}
` };
const depth_at_sampled = { name: "depth_at", role: "chosen", exactness: "c", operations: 4, within: 0, as_written: false, needs: [decode],
    text: `
// umbrage_depth_at: stored depth of the texel at a point, by the sampler
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
fn umbrage_depth_at(UMBRAGE_MAP map, size: vec2f, uv: vec2f) -> f32 {
    return umbrage_decode(UMBRAGE_SAMPLED);
}
` };
const depth_at_sampled_and_bordered = { name: "depth_at", role: "chosen", exactness: "c", operations: 4, within: 0, as_written: false, needs: [decode],
    text: `
// umbrage_depth_at: stored depth of the texel at a point, by the sampler, that of the far plane outside the map
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
fn umbrage_depth_at(UMBRAGE_MAP map, size: vec2f, uv: vec2f) -> f32 {
    let depth: f32 = umbrage_decode(UMBRAGE_SAMPLED);
    return select(UMBRAGE_BORDER, depth, abs(uv.x - 0.5) <= 0.5 && abs(uv.y - 0.5) <= 0.5);
}
` };

export const hooks = {
    language,
    receiver_plane: "receiver_slope: vec2f, receiver_at: vec3f", plane_reference: snippets.plane_reference,
    bordered_plane_reference: snippets.bordered_plane_reference, apply_receiver_plane: snippets.apply_receiver_plane,
    textures: {
        texture_2d: { parameters: "map: texture_2d<f32>", arguments: "map", texel: "textureLoad(map, vec2i(at), 0)", sampled: "textureSampleLevel(map, map_sampler, uv, 0.0)", gather_red: "textureGather(0, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_green: "textureGather(1, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", size: "vec2f(textureDimensions(map))", sampler: ", map_sampler: sampler", sampler_argument: ", map_sampler", needs: [] },
        atlas: { parameters: "map: texture_2d<f32>, origin: vec2f", arguments: "map, origin", texel: "textureLoad(map, vec2i(at), 0)", sampled: "textureSampleLevel(map, map_sampler, uv, 0.0)", gather_red: "textureGather(0, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_green: "textureGather(1, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", size: "vec2f(textureDimensions(map))", sampler: ", map_sampler: sampler", sampler_argument: ", map_sampler", needs: [] },
        array: { parameters: "map: texture_2d_array<f32>, layer: f32", arguments: "map, layer", texel: "textureLoad(map, vec2i(at), i32(layer), 0)", sampled: "textureSampleLevel(map, map_sampler, uv, i32(layer), 0.0)", gather_red: "textureGather(0, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer))", gather_green: "textureGather(1, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer))", size: "vec2f(textureDimensions(map))", sampler: ", map_sampler: sampler", sampler_argument: ", map_sampler", needs: [] },
        cube: { parameters: "map: texture_cube<f32>, map_sampler: sampler, face: f32", arguments: "map, map_sampler, face", texel: "textureSampleLevel(map, map_sampler, umbrage_cube_direction(face, (at + 0.5) / UMBRAGE_TEXTURE_SIZE), 0.0)", size: "vec2f(textureDimensions(map))", needs: [snippets.cube_direction] },
        cube_faces: { parameters: "map: texture_cube<f32>, map_sampler: sampler", arguments: "map, map_sampler", texel: "textureSampleLevel(map, map_sampler, umbrage_cube_atlas_direction(at, size.y * 0.5), 0.0)", size: "vec2f(textureDimensions(map))", needs: [snippets.cube_atlas_direction] },
        integer: { parameters: "map: texture_2d<u32>", arguments: "map", texel: "vec4f(textureLoad(map, vec2i(at), 0))", size: "vec2f(textureDimensions(map))", needs: [] },
        depth: { parameters: "map: texture_depth_2d", arguments: "map", texel: "vec4f(textureLoad(map, vec2i(at), 0))", sampled: "vec4f(textureSampleLevel(map, map_sampler, uv, 0))", gather_red: "textureGather(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", size: "vec2f(textureDimensions(map))", sampler: ", map_sampler: sampler", sampler_argument: ", map_sampler", needs: [] },
        depth_array: { parameters: "map: texture_depth_2d_array, layer: f32", arguments: "map, layer", texel: "vec4f(textureLoad(map, vec2i(at), i32(layer), 0))", sampled: "vec4f(textureSampleLevel(map, map_sampler, uv, i32(layer), 0))", gather_red: "textureGather(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer))", size: "vec2f(textureDimensions(map))", sampler: ", map_sampler: sampler", sampler_argument: ", map_sampler", needs: [] },
        shadow: { parameters: "map: texture_depth_2d, map_sampler: sampler_comparison", arguments: "map, map_sampler", lit: "textureSampleCompareLevel(map, map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver)", gather_lit: "textureGatherCompare(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)", lit_filtered: "textureSampleCompareLevel(map, map_sampler, uv, receiver)", size: "vec2f(textureDimensions(map))", needs: [] },
        shadow_array: { parameters: "map: texture_depth_2d_array, map_sampler: sampler_comparison, layer: f32", arguments: "map, map_sampler, layer", lit: "textureSampleCompareLevel(map, map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, i32(layer), receiver)", gather_lit: "textureGatherCompare(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer), receiver)", lit_filtered: "textureSampleCompareLevel(map, map_sampler, uv, i32(layer), receiver)", size: "vec2f(textureDimensions(map))", needs: [] },
    },
    unfilled: {
        texel: `
// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
fn umbrage_texel(UMBRAGE_MAP map, size: vec2f, texel: vec2f) -> vec4f {
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    return UMBRAGE_TEXEL;
}
`,
        fetch_depth: `
// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
fn umbrage_fetch_depth(UMBRAGE_MAP map, size: vec2f, texel: vec2f) -> f32 {
    let inside: vec2f = umbrage_texel_inside(size, texel);
    let value: vec4f = umbrage_texel(map, size, inside);
    let depth: f32 = UMBRAGE_DEPTH;
    return select(UMBRAGE_BORDER, depth, inside.x == texel.x && inside.y == texel.y);
}
`,
    },
    chosen: {
        "cleared_depth, reversed": cleared_depth_reversed,
        "map_covers, clamped": map_covers_clamped,
        "texel_inside, clamped": texel_inside_clamped,
        "beyond_far_plane, reversed": beyond_far_plane_reversed,
        "beyond_far_plane, without": beyond_far_plane_without,
        "within_far_plane, reversed": within_far_plane_reversed,
        "within_far_plane, without": within_far_plane_without,
        "compare, reversed": compare_reversed,
        "compare, own": compare_own,
        "decode": decode,
        "fetch_depth, clamped": fetch_depth_clamped,
        "lit_texel": lit_texel,
        "lit, clamped": lit_clamped,
        "lit, bordered": lit_bordered,
        "lit, along a plane": lit_along_a_plane,
        "lit_texel, along a plane": lit_texel_along_a_plane,
        "lit, compared along a plane": lit_compared_along_a_plane,
        "gather, compared": gather_compared,
        "gather, one channel": gather_one_channel,
        "gather, two channels": gather_two_channels,
        "gather_clamped, by the sampler": gather_clamped_by_the_sampler,
        "gather_clamped, in a region": gather_clamped_in_a_region,
        "gather_lit, compared by the sampler": gather_lit_compared_by_the_sampler,
        "gather_lit, of depths": gather_lit_of_depths,
        "compare_along, along a plane": compare_along_along_a_plane,
        "gather_lit, along a plane": gather_lit_along_a_plane,
        "lit_2x2, gathered": lit_2x2_gathered,
        "lit_2x2, gathered and bordered": lit_2x2_gathered_and_bordered,
        "lit_filtered, clamped": lit_filtered_clamped,
        "lit_filtered, bordered": lit_filtered_bordered,
        "covered, bordered": covered_bordered,
        "lit_between, sampled": lit_between_sampled,
        "lit_sampled, along a plane": lit_sampled_along_a_plane,
        "lit_between, along a plane": lit_between_along_a_plane,
        "depth_at, sampled": depth_at_sampled,
        "depth_at, sampled and bordered": depth_at_sampled_and_bordered,
    },
};

export const calls = {
    acne_free_bias: snippets.acne_free_bias,
    acne_free_disc_bias: snippets.acne_free_disc_bias,
    beyond_far_plane: snippets.beyond_far_plane,
    disc_rotation: snippets.disc_rotation,
    blend_cascades: snippets.blend_cascades,
    map_tile: snippets.map_tile,
    map_softness: snippets.map_softness,
    shaped_softness: snippets.shaped_softness,
    sheared_rotation: snippets.sheared_rotation,
    cleared_depth: snippets.cleared_depth,
    anchored_vertex: snippets.anchored_vertex,
    pancake: snippets.pancake,
};

const one_map = {
    grid: [1, 1], outside: "bordered", bends: false, softness: 0, warps: true,
    fields: [{ name: "to_texels", matrix: true }, { name: "planes", matrix: true }, { name: "anchor", matrix: false }, { name: "rounding", matrix: false }, { name: "slack", matrix: false }],
    placing: snippets.single_map_places,
};
const parallel_map = {
    grid: [1, 1], outside: "bordered", bends: false, softness: 0, warps: true,
    fields: [{ name: "to_texels", matrix: true }, { name: "planes", matrix: true }, { name: "anchor", matrix: false }, { name: "rounding", matrix: false }, { name: "slack", matrix: false }],
    placing: snippets.parallel_map_places,
};
const cascaded_maps = {
    grid: [2, 2], outside: "bordered", bends: false, softness: 1, warps: false,
    fields: [{ name: "rotation", matrix: true }, { name: "scales", matrix: true }, { name: "offsets", matrix: true }, { name: "anchor", matrix: false }, { name: "blending", matrix: false }],
    placing: snippets.cascaded_maps_place, choosing: { calls: snippets.cascaded_maps_choice, arguments: "rotation, scales, offsets, anchor, blending, terms, " },
};
const cascaded_maps_8 = {
    grid: [2, 4], outside: "bordered", bends: false, softness: 1, warps: false,
    fields: [{ name: "rotation", matrix: true }, { name: "scales", matrix: true }, { name: "offsets", matrix: true }, { name: "farther_scales", matrix: true }, { name: "farther_offsets", matrix: true }, { name: "anchor", matrix: false }, { name: "blending", matrix: false }],
    placing: snippets.cascaded_maps_place_8, choosing: { calls: snippets.cascaded_maps_choice_8, arguments: "rotation, scales, offsets, farther_scales, farther_offsets, anchor, blending, terms, " },
};
const warped_maps = {
    grid: [2, 2], outside: "bordered", bends: false, softness: 1, warps: true,
    fields: [{ name: "to_texels_0", matrix: true }, { name: "to_texels_1", matrix: true }, { name: "to_texels_2", matrix: true }, { name: "to_texels_3", matrix: true }, { name: "planes_0", matrix: true }, { name: "planes_1", matrix: true }, { name: "planes_2", matrix: true }, { name: "planes_3", matrix: true }, { name: "rounding", matrix: true }, { name: "slack", matrix: true }, { name: "fades", matrix: true }, { name: "anchor", matrix: false }, { name: "ahead", matrix: false }, { name: "ends", matrix: false }],
    placing: snippets.warped_maps_place, choosing: { calls: snippets.warped_maps_choice, arguments: "fades, anchor, ahead, ends, " }, shape: { calls: snippets.warp_shape, argument: "warps" },
};
const adaptive_maps = {
    grid: [8, 8], outside: "clamped", bends: false, softness: 8, warps: false,
    fields: [{ name: "to_root", matrix: true }, { name: "planes", matrix: true }, { name: "cells_0", matrix: true }, { name: "cells_1", matrix: true }, { name: "cells_2", matrix: true }, { name: "cells_3", matrix: true }, { name: "cells_4", matrix: true }, { name: "cells_5", matrix: true }, { name: "cells_6", matrix: true }, { name: "cells_7", matrix: true }, { name: "anchor", matrix: false }, { name: "pages", matrix: false }, { name: "slack", matrix: false }],
    placing: snippets.adaptive_maps_places,
};
const cube_maps = {
    grid: [3, 2], outside: "clamped", bends: false, softness: 0, warps: false,
    fields: [{ name: "face", matrix: false }, { name: "anchor", matrix: false }, { name: "rounding", matrix: false }, { name: "slack", matrix: false }],
    placing: snippets.cube_maps_places,
};
const tetrahedron_map = {
    grid: [1, 1], outside: "clamped", bends: false, softness: 0, warps: false,
    fields: [{ name: "to_texels", matrix: true }, { name: "planes", matrix: true }, { name: "anchor", matrix: false }, { name: "rounding", matrix: false }, { name: "slack", matrix: false }, { name: "center", matrix: false }],
    placing: snippets.tetrahedron_map_places, shape: { calls: snippets.tetrahedron_shape, argument: "center" },
};
const paraboloid_maps = {
    grid: [2, 1], outside: "clamped", bends: true, softness: 0, warps: false,
    fields: [{ name: "position", matrix: false }, { name: "halves", matrix: false }, { name: "rounding", matrix: false }],
    placing: snippets.paraboloid_maps_places,
    vertex: { calls: snippets.paraboloid_vertex, arguments: [['vec4', 'anchor'], ['float', 'number']] },
};

export const spot_light = { language, name: "spot_light", maps: one_map, pancakes: false };
export const directional_light = { language, name: "directional_light", maps: parallel_map, pancakes: true };
export const cascades = { language, name: "cascades", maps: cascaded_maps, pancakes: true };
export const cascades_8 = { language, name: "cascades_8", maps: cascaded_maps_8, pancakes: true };
export const point_light = { language, name: "point_light", maps: cube_maps, pancakes: false };
export const tetrahedron_light = { language, name: "tetrahedron_light", maps: tetrahedron_map, pancakes: false };
export const dual_paraboloid_light = { language, name: "dual_paraboloid_light", maps: paraboloid_maps, pancakes: false };
export const warped_cascades = { language, name: "warped_cascades", maps: warped_maps, pancakes: true };
export const adaptive_pages = { language, name: "adaptive_pages", maps: adaptive_maps, pancakes: true };

export const debug = {
    language, probe_color: snippets.probe_color, probe_inputs: snippets.probe_inputs,
    read_map: `
// umbrage_read_map: what one map of known depths is read as, within a tolerance of depth
fn umbrage_read_map(UMBRAGE_MAP map, terms: vec4f, filter_terms: vec4f, number: f32, tolerance: f32) -> f32 {
    let coarse: f32 = 1.0 / 72.0;
    let own: f32 = number - 8.0 * floor(number * 0.125) + 1.0;
    var met: vec4f = vec4f(0.0, 0.0, 0.0, 0.0);
    var seen: vec3f = vec3f(0.0, 0.0, 0.0);
    for (var block: i32 = 0; block < 4; block++) {
        let row: f32 = select(1.0, 0.0, block < 2);
        let column: f32 = f32(block) - 2.0 * row;
        let side: vec2f = vec2f(2.0 * column - 1.0, 2.0 * row - 1.0);
        let aside: vec2f = min(vec2f(terms.z + 2.0, terms.z + 2.0), vec2f(terms.x, terms.y) * 0.25);
        let coord: vec2f = vec2f(terms.x, terms.y) * 0.5 + side * aside;
        var found: f32 = 0.0;
        var step_size: f32 = 0.5;
        for (var i: i32 = 0; i < 20; i++) {
            found += umbrage_lit_at_distance(map, terms, filter_terms, coord, found + step_size) * step_size;
            step_size *= 0.5;
        }
        let first: f32 = 8.0 * f32(block);
        let turned: f32 = 8.0 * (column + 2.0 - 2.0 * row);
        let here: f32 = abs(found - (first + own) * (1.0 / 34.0));
        let there: f32 = abs(found - (turned + own) * (1.0 / 34.0));
        let nearest: f32 = clamp(floor(found * 34.0 + 0.5), first + 1.0, first + 8.0);
        let other: f32 = abs(found - nearest * (1.0 / 34.0));
        met +=
            vec4f(select(0.0, 1.0, here <= tolerance), select(0.0, 1.0, here <= coarse),
                  select(0.0, 1.0, there <= coarse), select(0.0, 1.0, other <= coarse));
        let front: f32 = umbrage_lit_at_distance(map, terms, filter_terms, coord, 0.0);
        let back: f32 = umbrage_lit_at_distance(map, terms, filter_terms, coord, 1.0);
        seen += vec3f(select(0.0, 1.0, found > 0.9999), select(0.0, 1.0, found < 0.0001), (1.0 - front) * back);
    }
    var reading: f32 = 7.0;
    reading = select(reading, 4.0, met.w > 3.5);
    reading = select(reading, 3.0, met.z > 3.5);
    reading = select(reading, 6.0, met.y > 3.5);
    reading = select(reading, 2.0, seen.y > 3.5);
    reading = select(reading, 1.0, seen.x > 3.5);
    reading = select(reading, 5.0, seen.z > 3.5);
    return select(reading, 0.0, met.x > 3.5);
}
`,
    parts: { moments: 72, depth32f: 262144, depth24: 262144, depth16: 16384, rg9: 128, rg10: 256, rg11: 512, rg12: 1024, rg13: 2048, rg14: 4096, rg15: 8192, rg16: 16384, rgb24: 262144, rgb10: 262144, r16: 16384, float_bits: 262144, threejs_rgba: 262144, threejs_rgb: 262144, threejs_rg: 16384, threejs_legacy: 262144, threejs_legacy_repaired: 262144, base255: 262144, base255_repaired: 262144 },
    parts_of_bent: { moments: 72, depth32f: 1024, depth24: 1024, depth16: 1024, rg9: 128, rg10: 256, rg11: 512, rg12: 512, rg13: 1024, rg14: 1024, rg15: 1024, rg16: 1024, rgb24: 1024, rgb10: 1024, r16: 1024, float_bits: 1024, threejs_rgba: 1024, threejs_rgb: 1024, threejs_rg: 1024, threejs_legacy: 1024, threejs_legacy_repaired: 1024, base255: 1024, base255_repaired: 1024 },
};
