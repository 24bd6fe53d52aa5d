import { language } from './language.mjs';
import * as snippets from './snippets.mjs';

const cleared_depth_reversed = { name: "cleared_depth", role: "chosen", needs: [],
    text: `
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 0.0;
}
` };
const map_covers_clamped = { name: "map_covers", role: "chosen", needs: [],
    text: `
// umbrage_map_covers: always true, as the nearest texel inside is used outside the map
inline bool umbrage_map_covers(float2 size, float2 coord) {
    return true;
}
` };
const beyond_far_plane_reversed = { name: "beyond_far_plane", role: "chosen", needs: [],
    text: `
// umbrage_beyond_far_plane: true when a receiver is beyond the far plane
inline bool umbrage_beyond_far_plane(float receiver) {
    return receiver < 0.0;
}
` };
const beyond_far_plane_without = { name: "beyond_far_plane", role: "chosen", needs: [],
    text: `
// umbrage_beyond_far_plane: always false for this map. Receivers beyond the far plane have a value that every texel
// lights
inline bool umbrage_beyond_far_plane(float receiver) {
    return false;
}
` };
const within_far_plane_reversed = { name: "within_far_plane", role: "chosen", needs: [],
    text: `
// umbrage_within_far_plane: true when a receiver is a number and not beyond the far plane
inline bool umbrage_within_far_plane(float receiver) {
    return receiver >= 0.0;
}
` };
const within_far_plane_without = { name: "within_far_plane", role: "chosen", needs: [],
    text: `
// umbrage_within_far_plane: true when a receiver is a number, as no receiver of this map is beyond the far plane
inline bool umbrage_within_far_plane(float receiver) {
    // a sum of choices: compilers take an or of the comparisons for true
    float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return number > 0.5;
}
` };
const compare_reversed = { name: "compare", role: "chosen", needs: [],
    text: `
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth. Near is 1.0
inline float umbrage_compare(float receiver, float stored) {
    return receiver >= stored ? 1.0 : 0.0;
}
` };
const compare_own = { name: "compare", role: "chosen", needs: [],
    text: `
// umbrage_compare: visibility of one comparison, by the map's own comparison
inline float umbrage_compare(float receiver, float stored) {
    return UMBRAGE_COMPARE;
}
` };
const decode = { name: "decode", role: "chosen", needs: [],
    text: `
// umbrage_decode: depth of a value that the sampler returned
inline float umbrage_decode(float4 value) {
    return UMBRAGE_DEPTH;
}
` };
const fetch_depth_clamped = { name: "fetch_depth", role: "chosen", needs: [snippets.fetch_clamped],
    text: `
// umbrage_fetch_depth: stored depth of a texel, that of the nearest texel inside when outside the map
inline float umbrage_fetch_depth(UMBRAGE_MAP map, float2 size, float2 texel) {
    float4 value = umbrage_fetch_clamped(map, size, texel);
    return UMBRAGE_DEPTH;
}
` };
const lit_texel = { name: "lit_texel", role: "chosen", needs: [],
    text: `
// umbrage_lit_texel: the sampler's comparison with a texel inside the map. NaN is in shadow
inline float umbrage_lit_texel(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 at = texel + UMBRAGE_ORIGIN;
    float lit = UMBRAGE_LIT_TEXEL;
    return (receiver > 0.0 ? lit : 0.0) + (receiver <= 0.0 ? lit : 0.0);
}
` };
const lit_clamped = { name: "lit", role: "chosen", needs: [lit_texel],
    text: `
// umbrage_lit: visibility of one comparison with a texel, with the nearest texel inside when outside the map
inline float umbrage_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    return umbrage_lit_texel(map, size, metal::clamp(texel, float2(0.0, 0.0), size - 1.0), receiver);
}
` };
const lit_bordered = { name: "lit", role: "chosen", needs: [lit_texel, snippets.compare],
    text: `
// umbrage_lit: visibility of one comparison with a texel, with the far plane when outside the map
inline float umbrage_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 inside = metal::clamp(texel, float2(0.0, 0.0), size - 1.0);
    float lit = umbrage_lit_texel(map, size, inside, receiver);
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    return inside.x == texel.x && inside.y == texel.y ? lit : outside;
}
` };
const gather_lit_compared = { name: "gather_lit", role: "gather_lit", needs: [],
    text: `
// umbrage_gather_lit: the sampler's comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1). NaN is in shadow
inline float4 umbrage_gather_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 at = texel + UMBRAGE_ORIGIN;
    float4 lit = UMBRAGE_GATHER_LIT;
    float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return float4(lit.w, lit.z, lit.x, lit.y) * number;
}
` };
const gather_lit_one_channel = { name: "gather_lit", role: "chosen", needs: [decode, snippets.compare],
    text: `
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
inline float4 umbrage_gather_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 at = texel + UMBRAGE_ORIGIN;
    float4 r = UMBRAGE_GATHER_RED;
    float a = umbrage_compare(receiver, umbrage_decode(float4(r.w, 0.0, 0.0, 0.0)));
    float b = umbrage_compare(receiver, umbrage_decode(float4(r.z, 0.0, 0.0, 0.0)));
    float c = umbrage_compare(receiver, umbrage_decode(float4(r.x, 0.0, 0.0, 0.0)));
    float d = umbrage_compare(receiver, umbrage_decode(float4(r.y, 0.0, 0.0, 0.0)));
    return float4(a, b, c, d);
}
` };
const gather_lit_two_channels = { name: "gather_lit", role: "chosen", needs: [decode, snippets.compare],
    text: `
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
inline float4 umbrage_gather_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 at = texel + UMBRAGE_ORIGIN;
    float4 r = UMBRAGE_GATHER_RED;
    float4 g = UMBRAGE_GATHER_GREEN;
    float a = umbrage_compare(receiver, umbrage_decode(float4(r.w, g.w, 0.0, 0.0)));
    float b = umbrage_compare(receiver, umbrage_decode(float4(r.z, g.z, 0.0, 0.0)));
    float c = umbrage_compare(receiver, umbrage_decode(float4(r.x, g.x, 0.0, 0.0)));
    float d = umbrage_compare(receiver, umbrage_decode(float4(r.y, g.y, 0.0, 0.0)));
    return float4(a, b, c, d);
}
` };
const lit_2x2_gathered = { name: "lit_2x2", role: "chosen", needs: [gather_lit_compared],
    text: `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1). The sampler clamps
inline float4 umbrage_lit_2x2(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    return umbrage_gather_lit(map, size, texel, receiver);
}
` };
const lit_2x2_gathered_in_a_region = { name: "lit_2x2", role: "chosen", needs: [gather_lit_compared],
    text: `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
// Outside the map the nearest texel inside is compared. The gather stays inside, and each comparison is taken from its
// row and column
inline float4 umbrage_lit_2x2(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 first = metal::clamp(texel, float2(0.0, 0.0), metal::max(size - 2.0, float2(0.0, 0.0)));
    float2 low = metal::clamp(texel, float2(0.0, 0.0), size - 1.0) - first;
    float2 high = metal::clamp(texel + 1.0, float2(0.0, 0.0), size - 1.0) - first;
    float4 lit = umbrage_gather_lit(map, size, first, receiver);
    float2 left = low.x > 0.5 ? float2(lit.y, lit.w) : float2(lit.x, lit.z);
    float2 right = high.x > 0.5 ? float2(lit.y, lit.w) : float2(lit.x, lit.z);
    float2 bottom = low.y > 0.5 ? float2(left.y, right.y) : float2(left.x, right.x);
    float2 top = high.y > 0.5 ? float2(left.y, right.y) : float2(left.x, right.x);
    return float4(bottom.x, bottom.y, top.x, top.y);
}
` };
const lit_2x2_gathered_and_bordered = { name: "lit_2x2", role: "chosen", needs: [gather_lit_compared, snippets.inside_map, snippets.compare],
    text: `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
// Outside the map the far plane is compared. The sampler's border color does not matter
inline float4 umbrage_lit_2x2(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float4 lit = umbrage_gather_lit(map, size, texel, receiver);
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    float a = umbrage_inside_map(size, texel) ? lit.x : outside;
    float b = umbrage_inside_map(size, texel + float2(1.0, 0.0)) ? lit.y : outside;
    float c = umbrage_inside_map(size, texel + float2(0.0, 1.0)) ? lit.z : outside;
    float d = umbrage_inside_map(size, texel + float2(1.0, 1.0)) ? lit.w : outside;
    return float4(a, b, c, d);
}
` };
const lit_2x2_gathered_in_a_bordered_region = { name: "lit_2x2", role: "chosen", needs: [gather_lit_compared, snippets.inside_map, snippets.compare],
    text: `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
// Outside the map the far plane is compared. The gather stays inside
inline float4 umbrage_lit_2x2(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 first = metal::clamp(texel, float2(0.0, 0.0), metal::max(size - 2.0, float2(0.0, 0.0)));
    float2 low = texel - first;
    float4 lit = umbrage_gather_lit(map, size, first, receiver);
    float2 left = low.x > 0.5 ? float2(lit.y, lit.w) : float2(lit.x, lit.z);
    float2 right = low.x < -0.5 ? float2(lit.x, lit.z) : float2(lit.y, lit.w);
    float2 bottom = low.y > 0.5 ? float2(left.y, right.y) : float2(left.x, right.x);
    float2 top = low.y < -0.5 ? float2(left.x, right.x) : float2(left.y, right.y);
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    float a = umbrage_inside_map(size, texel) ? bottom.x : outside;
    float b = umbrage_inside_map(size, texel + float2(1.0, 0.0)) ? bottom.y : outside;
    float c = umbrage_inside_map(size, texel + float2(0.0, 1.0)) ? top.x : outside;
    float d = umbrage_inside_map(size, texel + float2(1.0, 1.0)) ? top.y : outside;
    return float4(a, b, c, d);
}
` };
const lit_filtered_clamped = { name: "lit_filtered", role: "chosen", exactness: "c", operations: 0, within: 0.0078125, as_written: false, needs: [snippets.within_far_plane],
    text: `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler. NaN is in shadow
//   coord   in texels, no NaN
inline float umbrage_lit_filtered(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float2 texel = metal::clamp(coord, float2(0.5, 0.5), size - 0.5);
    float2 at = texel + UMBRAGE_ORIGIN;
    float2 uv = UMBRAGE_UV;
    float lit = UMBRAGE_LIT_FILTERED;
    return umbrage_within_far_plane(receiver) ? lit : 0.0;
}
` };
const lit_filtered_bordered = { name: "lit_filtered", role: "chosen", exactness: "c", operations: 0, within: 0.0078125, as_written: false, needs: [snippets.within_far_plane, snippets.compare],
    text: `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler. NaN is in shadow
// Outside the map the far plane is compared
//   coord   in texels, no NaN
inline float umbrage_lit_filtered(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float2 texel = metal::clamp(coord, float2(0.5, 0.5), size - 0.5);
    float2 at = texel + UMBRAGE_ORIGIN;
    float2 uv = UMBRAGE_UV;
    float lit = UMBRAGE_LIT_FILTERED;
    float2 inside = metal::clamp(metal::min(coord, size - coord) + 0.5, float2(0.0, 0.0), float2(1.0, 1.0));
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    return umbrage_within_far_plane(receiver) ? outside + inside.x * inside.y * (lit - outside) : 0.0;
}
` };
const lit_at_sampled = { name: "lit_at", role: "chosen", exactness: "c", operations: 0, within: 0.0078125, as_written: false, needs: [],
    text: `
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler
//   uv         over the map, (0.0, 0.0) to (1.0, 1.0)
//   receiver   no NaN
inline float umbrage_lit_at(UMBRAGE_MAP map, float2 size, float2 uv, float receiver) {
    return UMBRAGE_LIT_FILTERED;
}
` };
const lit_at_sampled_and_bordered = { name: "lit_at", role: "chosen", exactness: "c", operations: 0, within: 0.0078125, as_written: false, needs: [snippets.compare],
    text: `
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler, with the far plane outside the map
//   uv         over the map, (0.0, 0.0) to (1.0, 1.0)
//   receiver   no NaN
inline float umbrage_lit_at(UMBRAGE_MAP map, float2 size, float2 uv, float receiver) {
    float lit = UMBRAGE_LIT_FILTERED;
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    float2 inside = metal::clamp((0.5 - metal::abs(uv - 0.5)) * size + 0.5, float2(0.0, 0.0), float2(1.0, 1.0));
    return outside + inside.x * inside.y * (lit - outside);
}
` };
const depth_at_sampled = { name: "depth_at", role: "chosen", exactness: "c", operations: 4, within: 0, as_written: false, needs: [decode],
    text: `
// umbrage_depth_at: stored depth of the texel at a point, by the sampler
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
inline float umbrage_depth_at(UMBRAGE_MAP map, float2 size, float2 uv) {
    return umbrage_decode(UMBRAGE_SAMPLED);
}
` };
const depth_at_sampled_and_bordered = { name: "depth_at", role: "chosen", exactness: "c", operations: 4, within: 0, as_written: false, needs: [decode],
    text: `
// umbrage_depth_at: stored depth of the texel at a point, by the sampler, that of the far plane outside the map
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
inline float umbrage_depth_at(UMBRAGE_MAP map, float2 size, float2 uv) {
    float depth = umbrage_decode(UMBRAGE_SAMPLED);
    return metal::abs(uv.x - 0.5) <= 0.5 && metal::abs(uv.y - 0.5) <= 0.5 ? depth : UMBRAGE_BORDER;
}
` };

export const hooks = {
    language,
    receiver_plane: "float2 receiver_slope, float2 receiver_coord", apply_receiver_plane: snippets.apply_receiver_plane,
    textures: {
        texture_2d: { parameters: "metal::texture2d<float> map", arguments: "map", texel: "map.read(uint2(at))", sampled: "map.sample(map_sampler, uv, metal::level(0.0))", gather_red: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_green: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, int2(0), metal::component::y)", size: "float2(map.get_width(), map.get_height())", sampler: ", metal::sampler map_sampler", sampler_argument: ", map_sampler", needs: [] },
        atlas: { parameters: "metal::texture2d<float> map, float2 origin", arguments: "map, origin", texel: "map.read(uint2(at))", sampled: "map.sample(map_sampler, uv, metal::level(0.0))", gather_red: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_green: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, int2(0), metal::component::y)", size: "float2(map.get_width(), map.get_height())", sampler: ", metal::sampler map_sampler", sampler_argument: ", map_sampler", needs: [] },
        array: { parameters: "metal::texture2d_array<float> map, float layer", arguments: "map, layer", texel: "map.read(uint2(at), uint(layer))", sampled: "map.sample(map_sampler, uv, uint(layer), metal::level(0.0))", gather_red: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer))", gather_green: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer), int2(0), metal::component::y)", size: "float2(map.get_width(), map.get_height())", sampler: ", metal::sampler map_sampler", sampler_argument: ", map_sampler", needs: [] },
        cube: { parameters: "metal::texturecube<float> map, float face", arguments: "map, face", texel: "map.read(uint2(at), uint(face))", size: "float2(map.get_width(), map.get_height())", needs: [] },
        cube_faces: { parameters: "metal::texturecube<float> map", arguments: "map", texel: "map.read(uint2(umbrage_cube_atlas_texel(at, size.y * 0.5).x, umbrage_cube_atlas_texel(at, size.y * 0.5).y), uint(umbrage_cube_atlas_texel(at, size.y * 0.5).z))", size: "float2(map.get_width(), map.get_height())", needs: [snippets.cube_atlas_texel] },
        integer: { parameters: "metal::texture2d<uint> map", arguments: "map", texel: "float4(map.read(uint2(at)))", size: "float2(map.get_width(), map.get_height())", needs: [] },
        depth: { parameters: "metal::depth2d<float> map", arguments: "map", texel: "float4(map.read(uint2(at)))", sampled: "float4(map.sample(map_sampler, uv, metal::level(0.0)))", gather_red: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", size: "float2(map.get_width(), map.get_height())", sampler: ", metal::sampler map_sampler", sampler_argument: ", map_sampler", needs: [] },
        depth_array: { parameters: "metal::depth2d_array<float> map, float layer", arguments: "map, layer", texel: "float4(map.read(uint2(at), uint(layer)))", sampled: "float4(map.sample(map_sampler, uv, uint(layer), metal::level(0.0)))", gather_red: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer))", size: "float2(map.get_width(), map.get_height())", sampler: ", metal::sampler map_sampler", sampler_argument: ", map_sampler", needs: [] },
        shadow: { parameters: "metal::depth2d<float> map, metal::sampler map_sampler", arguments: "map, map_sampler", lit: "map.sample_compare(map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver, metal::level(0.0))", gather_lit: "map.gather_compare(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)", lit_filtered: "map.sample_compare(map_sampler, uv, receiver, metal::level(0.0))", size: "float2(map.get_width(), map.get_height())", needs: [] },
        shadow_array: { parameters: "metal::depth2d_array<float> map, metal::sampler map_sampler, float layer", arguments: "map, map_sampler, layer", lit: "map.sample_compare(map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, uint(layer), receiver, metal::level(0.0))", gather_lit: "map.gather_compare(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer), receiver)", lit_filtered: "map.sample_compare(map_sampler, uv, uint(layer), receiver, metal::level(0.0))", size: "float2(map.get_width(), map.get_height())", needs: [] },
    },
    unfilled: {
        texel: `
// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
inline float4 umbrage_texel(UMBRAGE_MAP map, float2 size, float2 texel) {
    float2 at = texel + UMBRAGE_ORIGIN;
    return UMBRAGE_TEXEL;
}
`,
        fetch_depth: `
// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
inline float umbrage_fetch_depth(UMBRAGE_MAP map, float2 size, float2 texel) {
    float2 inside = metal::clamp(texel, float2(0.0, 0.0), size - 1.0);
    float4 value = umbrage_texel(map, size, inside);
    float depth = UMBRAGE_DEPTH;
    return inside.x == texel.x && inside.y == texel.y ? depth : UMBRAGE_BORDER;
}
`,
    },
    chosen: {
        "cleared_depth, reversed": cleared_depth_reversed,
        "map_covers, clamped": map_covers_clamped,
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
        "gather_lit, compared": gather_lit_compared,
        "gather_lit, one channel": gather_lit_one_channel,
        "gather_lit, two channels": gather_lit_two_channels,
        "lit_2x2, gathered": lit_2x2_gathered,
        "lit_2x2, gathered in a region": lit_2x2_gathered_in_a_region,
        "lit_2x2, gathered and bordered": lit_2x2_gathered_and_bordered,
        "lit_2x2, gathered in a bordered region": lit_2x2_gathered_in_a_bordered_region,
        "lit_filtered, clamped": lit_filtered_clamped,
        "lit_filtered, bordered": lit_filtered_bordered,
        "lit_at, sampled": lit_at_sampled,
        "lit_at, sampled and bordered": lit_at_sampled_and_bordered,
        "depth_at, sampled": depth_at_sampled,
        "depth_at, sampled and bordered": depth_at_sampled_and_bordered,
    },
};
