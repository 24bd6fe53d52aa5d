const { language } = require('./language.cjs');
const snippets = require('./snippets.cjs');

const cleared_depth_reversed = { name: "cleared_depth", role: "chosen", needs: [],
    text: `
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 0.0;
}
` };
const map_covers_clamped = { name: "map_covers", role: "chosen", needs: [],
    text: `
// umbrage_map_covers: always true, as the nearest texel inside is used outside the map
bool umbrage_map_covers(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord) {
    return true;
}
` };
const beyond_far_plane_reversed = { name: "beyond_far_plane", role: "chosen", needs: [],
    text: `
// umbrage_beyond_far_plane: true when a receiver is beyond the far plane
bool umbrage_beyond_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver < 0.0;
}
` };
const beyond_far_plane_without = { name: "beyond_far_plane", role: "chosen", needs: [],
    text: `
// umbrage_beyond_far_plane: always false for this map. Receivers beyond the far plane have a value that every texel
// lights
bool umbrage_beyond_far_plane(UMBRAGE_HIGHP float receiver) {
    return false;
}
` };
const within_far_plane_reversed = { name: "within_far_plane", role: "chosen", needs: [],
    text: `
// umbrage_within_far_plane: true when a receiver is a number and not beyond the far plane
bool umbrage_within_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver >= 0.0;
}
` };
const within_far_plane_without = { name: "within_far_plane", role: "chosen", needs: [],
    text: `
// umbrage_within_far_plane: true when a receiver is a number, as no receiver of this map is beyond the far plane
bool umbrage_within_far_plane(UMBRAGE_HIGHP float receiver) {
    // a sum of choices: compilers take an or of the comparisons for true
    UMBRAGE_HIGHP float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return number > 0.5;
}
` };
const compare_reversed = { name: "compare", role: "chosen", needs: [],
    text: `
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth. Near is 1.0
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return receiver >= stored ? 1.0 : 0.0;
}
` };
const compare_own = { name: "compare", role: "chosen", needs: [],
    text: `
// umbrage_compare: visibility of one comparison, by the map's own comparison
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return UMBRAGE_COMPARE;
}
` };
const decode = { name: "decode", role: "chosen", needs: [],
    text: `
// umbrage_decode: depth of a value that the sampler returned
UMBRAGE_HIGHP float umbrage_decode(UMBRAGE_HIGHP vec4 value) {
    return UMBRAGE_DEPTH;
}
` };
const fetch_depth_clamped = { name: "fetch_depth", role: "chosen", needs: [snippets.fetch_clamped],
    text: `
// umbrage_fetch_depth: stored depth of a texel, that of the nearest texel inside when outside the map
UMBRAGE_HIGHP float umbrage_fetch_depth(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec4 value = umbrage_fetch_clamped(map, size, texel);
    return UMBRAGE_DEPTH;
}
` };
const lit_texel = { name: "lit_texel", role: "chosen", needs: [],
    text: `
// umbrage_lit_texel: the sampler's comparison with a texel inside the map. NaN is in shadow
UMBRAGE_HIGHP float umbrage_lit_texel(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_TEXEL;
    return (receiver > 0.0 ? lit : 0.0) + (receiver <= 0.0 ? lit : 0.0);
}
` };
const lit_clamped = { name: "lit", role: "chosen", needs: [lit_texel],
    text: `
// umbrage_lit: visibility of one comparison with a texel, with the nearest texel inside when outside the map
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    return umbrage_lit_texel(map, size, clamp(texel, vec2(0.0, 0.0), size - 1.0), receiver);
}
` };
const lit_bordered = { name: "lit", role: "chosen", needs: [lit_texel, snippets.compare],
    text: `
// umbrage_lit: visibility of one comparison with a texel, with the far plane when outside the map
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 inside = clamp(texel, vec2(0.0, 0.0), size - 1.0);
    UMBRAGE_HIGHP float lit = umbrage_lit_texel(map, size, inside, receiver);
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    return inside.x == texel.x && inside.y == texel.y ? lit : outside;
}
` };
const gather_lit_compared = { name: "gather_lit", role: "gather_lit", needs: [],
    text: `
// umbrage_gather_lit: the sampler's comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1). NaN is in shadow
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 lit = UMBRAGE_GATHER_LIT;
    UMBRAGE_HIGHP float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return vec4(lit.w, lit.z, lit.x, lit.y) * number;
}
` };
const gather_lit_one_channel = { name: "gather_lit", role: "chosen", needs: [decode, snippets.compare],
    text: `
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 r = UMBRAGE_GATHER_RED;
    UMBRAGE_HIGHP float a = umbrage_compare(receiver, umbrage_decode(vec4(r.w, 0.0, 0.0, 0.0)));
    UMBRAGE_HIGHP float b = umbrage_compare(receiver, umbrage_decode(vec4(r.z, 0.0, 0.0, 0.0)));
    UMBRAGE_HIGHP float c = umbrage_compare(receiver, umbrage_decode(vec4(r.x, 0.0, 0.0, 0.0)));
    UMBRAGE_HIGHP float d = umbrage_compare(receiver, umbrage_decode(vec4(r.y, 0.0, 0.0, 0.0)));
    return vec4(a, b, c, d);
}
` };
const gather_lit_two_channels = { name: "gather_lit", role: "chosen", needs: [decode, snippets.compare],
    text: `
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 r = UMBRAGE_GATHER_RED;
    UMBRAGE_HIGHP vec4 g = UMBRAGE_GATHER_GREEN;
    UMBRAGE_HIGHP float a = umbrage_compare(receiver, umbrage_decode(vec4(r.w, g.w, 0.0, 0.0)));
    UMBRAGE_HIGHP float b = umbrage_compare(receiver, umbrage_decode(vec4(r.z, g.z, 0.0, 0.0)));
    UMBRAGE_HIGHP float c = umbrage_compare(receiver, umbrage_decode(vec4(r.x, g.x, 0.0, 0.0)));
    UMBRAGE_HIGHP float d = umbrage_compare(receiver, umbrage_decode(vec4(r.y, g.y, 0.0, 0.0)));
    return vec4(a, b, c, d);
}
` };
const lit_2x2_gathered = { name: "lit_2x2", role: "chosen", needs: [gather_lit_compared],
    text: `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1). The sampler clamps
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    return umbrage_gather_lit(map, size, texel, receiver);
}
` };
const lit_2x2_gathered_in_a_region = { name: "lit_2x2", role: "chosen", needs: [gather_lit_compared],
    text: `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
// Outside the map the nearest texel inside is compared. The gather stays inside, and each comparison is taken from its
// row and column
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 first = clamp(texel, vec2(0.0, 0.0), max(size - 2.0, vec2(0.0, 0.0)));
    UMBRAGE_HIGHP vec2 low = clamp(texel, vec2(0.0, 0.0), size - 1.0) - first;
    UMBRAGE_HIGHP vec2 high = clamp(texel + 1.0, vec2(0.0, 0.0), size - 1.0) - first;
    UMBRAGE_HIGHP vec4 lit = umbrage_gather_lit(map, size, first, receiver);
    UMBRAGE_HIGHP vec2 left = low.x > 0.5 ? vec2(lit.y, lit.w) : vec2(lit.x, lit.z);
    UMBRAGE_HIGHP vec2 right = high.x > 0.5 ? vec2(lit.y, lit.w) : vec2(lit.x, lit.z);
    UMBRAGE_HIGHP vec2 bottom = low.y > 0.5 ? vec2(left.y, right.y) : vec2(left.x, right.x);
    UMBRAGE_HIGHP vec2 top = high.y > 0.5 ? vec2(left.y, right.y) : vec2(left.x, right.x);
    return vec4(bottom.x, bottom.y, top.x, top.y);
}
` };
const lit_2x2_gathered_and_bordered = { name: "lit_2x2", role: "chosen", needs: [gather_lit_compared, snippets.inside_map, snippets.compare],
    text: `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
// Outside the map the far plane is compared. The sampler's border color does not matter
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec4 lit = umbrage_gather_lit(map, size, texel, receiver);
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    UMBRAGE_HIGHP float a = umbrage_inside_map(size, texel) ? lit.x : outside;
    UMBRAGE_HIGHP float b = umbrage_inside_map(size, texel + vec2(1.0, 0.0)) ? lit.y : outside;
    UMBRAGE_HIGHP float c = umbrage_inside_map(size, texel + vec2(0.0, 1.0)) ? lit.z : outside;
    UMBRAGE_HIGHP float d = umbrage_inside_map(size, texel + vec2(1.0, 1.0)) ? lit.w : outside;
    return vec4(a, b, c, d);
}
` };
const lit_2x2_gathered_in_a_bordered_region = { name: "lit_2x2", role: "chosen", needs: [gather_lit_compared, snippets.inside_map, snippets.compare],
    text: `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
// Outside the map the far plane is compared. The gather stays inside
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 first = clamp(texel, vec2(0.0, 0.0), max(size - 2.0, vec2(0.0, 0.0)));
    UMBRAGE_HIGHP vec2 low = texel - first;
    UMBRAGE_HIGHP vec4 lit = umbrage_gather_lit(map, size, first, receiver);
    UMBRAGE_HIGHP vec2 left = low.x > 0.5 ? vec2(lit.y, lit.w) : vec2(lit.x, lit.z);
    UMBRAGE_HIGHP vec2 right = low.x < -0.5 ? vec2(lit.x, lit.z) : vec2(lit.y, lit.w);
    UMBRAGE_HIGHP vec2 bottom = low.y > 0.5 ? vec2(left.y, right.y) : vec2(left.x, right.x);
    UMBRAGE_HIGHP vec2 top = low.y < -0.5 ? vec2(left.x, right.x) : vec2(left.y, right.y);
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    UMBRAGE_HIGHP float a = umbrage_inside_map(size, texel) ? bottom.x : outside;
    UMBRAGE_HIGHP float b = umbrage_inside_map(size, texel + vec2(1.0, 0.0)) ? bottom.y : outside;
    UMBRAGE_HIGHP float c = umbrage_inside_map(size, texel + vec2(0.0, 1.0)) ? top.x : outside;
    UMBRAGE_HIGHP float d = umbrage_inside_map(size, texel + vec2(1.0, 1.0)) ? top.y : outside;
    return vec4(a, b, c, d);
}
` };
const lit_filtered_clamped = { name: "lit_filtered", role: "chosen", exactness: "c", operations: 0, within: 0.0078125, as_written: false, needs: [snippets.within_far_plane],
    text: `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler. NaN is in shadow
//   coord   in texels, no NaN
UMBRAGE_HIGHP float umbrage_lit_filtered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                         UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 texel = clamp(coord, vec2(0.5, 0.5), size - 0.5);
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec2 uv = UMBRAGE_UV;
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_FILTERED;
    return umbrage_within_far_plane(receiver) ? lit : 0.0;
}
` };
const lit_filtered_bordered = { name: "lit_filtered", role: "chosen", exactness: "c", operations: 0, within: 0.0078125, as_written: false, needs: [snippets.within_far_plane, snippets.compare],
    text: `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler. NaN is in shadow
// Outside the map the far plane is compared
//   coord   in texels, no NaN
UMBRAGE_HIGHP float umbrage_lit_filtered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                         UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 texel = clamp(coord, vec2(0.5, 0.5), size - 0.5);
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec2 uv = UMBRAGE_UV;
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_FILTERED;
    UMBRAGE_HIGHP vec2 inside = clamp(min(coord, size - coord) + 0.5, vec2(0.0, 0.0), vec2(1.0, 1.0));
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    return umbrage_within_far_plane(receiver) ? outside + inside.x * inside.y * (lit - outside) : 0.0;
}
` };
const lit_at_sampled = { name: "lit_at", role: "chosen", exactness: "c", operations: 0, within: 0.0078125, as_written: false, needs: [],
    text: `
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler
//   uv         over the map, (0.0, 0.0) to (1.0, 1.0)
//   receiver   no NaN
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP float receiver) {
    return UMBRAGE_LIT_FILTERED;
}
` };
const lit_at_sampled_and_bordered = { name: "lit_at", role: "chosen", exactness: "c", operations: 0, within: 0.0078125, as_written: false, needs: [snippets.compare],
    text: `
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler, with the far plane outside the map
//   uv         over the map, (0.0, 0.0) to (1.0, 1.0)
//   receiver   no NaN
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_FILTERED;
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    UMBRAGE_HIGHP vec2 inside = clamp((0.5 - abs(uv - 0.5)) * size + 0.5, vec2(0.0, 0.0), vec2(1.0, 1.0));
    return outside + inside.x * inside.y * (lit - outside);
}
` };
const depth_at_sampled = { name: "depth_at", role: "chosen", exactness: "c", operations: 4, within: 0, as_written: false, needs: [decode],
    text: `
// umbrage_depth_at: stored depth of the texel at a point, by the sampler
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP float umbrage_depth_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    return umbrage_decode(UMBRAGE_SAMPLED);
}
` };
const depth_at_sampled_and_bordered = { name: "depth_at", role: "chosen", exactness: "c", operations: 4, within: 0, as_written: false, needs: [decode],
    text: `
// umbrage_depth_at: stored depth of the texel at a point, by the sampler, that of the far plane outside the map
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP float umbrage_depth_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    UMBRAGE_HIGHP float depth = umbrage_decode(UMBRAGE_SAMPLED);
    return abs(uv.x - 0.5) <= 0.5 && abs(uv.y - 0.5) <= 0.5 ? depth : UMBRAGE_BORDER;
}
` };

const hooks = {
    language,
    receiver_plane: "UMBRAGE_HIGHP vec2 receiver_slope, UMBRAGE_HIGHP vec2 receiver_coord", apply_receiver_plane: snippets.apply_receiver_plane,
    textures: {
        texture_2d: { parameters: "UMBRAGE_HIGHP sampler2D map", arguments: "map", texel: "#if __VERSION__ >= 130\n    return texelFetch(map, ivec2(at), 0);\n#else\n    return texture2D(map, (at + 0.5) / UMBRAGE_TEXTURE_SIZE);\n#endif\n", sampled: "textureLod(map, uv, 0.0)", gather_red: "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 0)", gather_green: "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 1)", size: "vec2(textureSize(map, 0))", needs: [] },
        atlas: { parameters: "UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 origin", arguments: "map, origin", texel: "#if __VERSION__ >= 130\n    return texelFetch(map, ivec2(at), 0);\n#else\n    return texture2D(map, (at + 0.5) / UMBRAGE_TEXTURE_SIZE);\n#endif\n", sampled: "textureLod(map, uv, 0.0)", gather_red: "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 0)", gather_green: "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 1)", size: "vec2(textureSize(map, 0))", needs: [] },
        array: { parameters: "UMBRAGE_HIGHP sampler2DArray map, UMBRAGE_HIGHP float layer", arguments: "map, layer", texel: "texelFetch(map, ivec3(ivec2(at), int(layer)), 0)", sampled: "textureLod(map, vec3(uv, layer), 0.0)", gather_red: "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), 0)", gather_green: "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), 1)", size: "vec2(textureSize(map, 0))", needs: [] },
        cube: { parameters: "UMBRAGE_HIGHP samplerCube map, UMBRAGE_HIGHP float face", arguments: "map, face", texel: "#if __VERSION__ >= 130\n    return textureLod(map, umbrage_cube_direction(face, (at + 0.5) / UMBRAGE_TEXTURE_SIZE), 0.0);\n#else\n    return textureCube(map, umbrage_cube_direction(face, (at + 0.5) / UMBRAGE_TEXTURE_SIZE));\n#endif\n", size: "vec2(textureSize(map, 0))", needs: [snippets.cube_direction] },
        cube_faces: { parameters: "UMBRAGE_HIGHP samplerCube map", arguments: "map", texel: "#if __VERSION__ >= 130\n    return textureLod(map, umbrage_cube_atlas_direction(at, size.y * 0.5), 0.0);\n#else\n    return textureCube(map, umbrage_cube_atlas_direction(at, size.y * 0.5));\n#endif\n", size: "vec2(textureSize(map, 0))", needs: [snippets.cube_atlas_direction] },
        integer: { parameters: "UMBRAGE_HIGHP usampler2D map", arguments: "map", texel: "vec4(texelFetch(map, ivec2(at), 0))", size: "vec2(textureSize(map, 0))", needs: [] },
        depth: { parameters: "UMBRAGE_HIGHP sampler2D map", arguments: "map", texel: "#if __VERSION__ >= 130\n    return texelFetch(map, ivec2(at), 0);\n#else\n    return texture2D(map, (at + 0.5) / UMBRAGE_TEXTURE_SIZE);\n#endif\n", sampled: "textureLod(map, uv, 0.0)", gather_red: "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 0)", gather_green: "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 1)", size: "vec2(textureSize(map, 0))", needs: [] },
        depth_array: { parameters: "UMBRAGE_HIGHP sampler2DArray map, UMBRAGE_HIGHP float layer", arguments: "map, layer", texel: "texelFetch(map, ivec3(ivec2(at), int(layer)), 0)", sampled: "textureLod(map, vec3(uv, layer), 0.0)", gather_red: "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), 0)", gather_green: "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), 1)", size: "vec2(textureSize(map, 0))", needs: [] },
        shadow: { parameters: "UMBRAGE_HIGHP sampler2DShadow map", arguments: "map", lit: "textureLod(map, vec3((at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver), 0.0)", gather_lit: "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)", lit_filtered: "textureLod(map, vec3(uv, receiver), 0.0)", size: "vec2(textureSize(map, 0))", needs: [] },
        shadow_array: { parameters: "UMBRAGE_HIGHP sampler2DArrayShadow map, UMBRAGE_HIGHP float layer", arguments: "map, layer", lit: "textureGrad(map, vec4((at + 0.5) / UMBRAGE_TEXTURE_SIZE, layer, receiver), vec2(0.0, 0.0), vec2(0.0, 0.0))", gather_lit: "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), receiver)", lit_filtered: "textureGrad(map, vec4(uv, layer, receiver), vec2(0.0, 0.0), vec2(0.0, 0.0))", size: "vec2(textureSize(map, 0))", needs: [] },
    },
    unfilled: {
        texel: `
// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
UMBRAGE_HIGHP vec4 umbrage_texel(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    return UMBRAGE_TEXEL;
}
`,
        fetch_depth: `
// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
UMBRAGE_HIGHP float umbrage_fetch_depth(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 inside = clamp(texel, vec2(0.0, 0.0), size - 1.0);
    UMBRAGE_HIGHP vec4 value = umbrage_texel(map, size, inside);
    UMBRAGE_HIGHP float depth = UMBRAGE_DEPTH;
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

module.exports = {
    hooks,
};
