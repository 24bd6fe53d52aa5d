import { hlsl as language } from '../languages.mjs';
import * as snippets from './snippets.mjs';

const write_depth32f = { language, name: "write", summary: "color of a depth, for a target of depth32f",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.saturate], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float texel = umbrage_saturate(depth);
    return float4(texel, 0.0, 0.0, 0.0);
}
` };
export const depth32f = { name: "depth32f", direction: "forward", depth: "", channels: 1, needs: [],
    cleared: [1, 0, 0, 0], format: "R32F", depth_format: "DEPTH_COMPONENT32F", write: write_depth32f,
    reversed: { name: "depth32f", direction: "reversed", depth: "", channels: 1, needs: [],
    cleared: [0, 0, 0, 0], format: "R32F", depth_format: "DEPTH_COMPONENT32F", write: write_depth32f } };

const write_depth24 = { language, name: "write", summary: "color of a depth, for a target of depth24",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.saturate], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float texel = umbrage_saturate(depth);
    return float4(texel, 0.0, 0.0, 0.0);
}
` };
export const depth24 = { name: "depth24", direction: "forward", depth: "", channels: 1, needs: [],
    cleared: [1, 0, 0, 0], format: "DEPTH_COMPONENT24", depth_format: "DEPTH_COMPONENT24", write: write_depth24,
    reversed: { name: "depth24", direction: "reversed", depth: "", channels: 1, needs: [],
    cleared: [0, 0, 0, 0], format: "DEPTH_COMPONENT24", depth_format: "DEPTH_COMPONENT24", write: write_depth24 } };

const write_depth16 = { language, name: "write", summary: "color of a depth, for a target of depth16",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.saturate], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float texel = umbrage_saturate(depth);
    return float4(texel, 0.0, 0.0, 0.0);
}
` };
export const depth16 = { name: "depth16", direction: "forward", depth: "", channels: 1, needs: [],
    cleared: [1, 0, 0, 0], format: "DEPTH_COMPONENT16", depth_format: "DEPTH_COMPONENT16", write: write_depth16,
    reversed: { name: "depth16", direction: "reversed", depth: "", channels: 1, needs: [],
    cleared: [0, 0, 0, 0], format: "DEPTH_COMPONENT16", depth_format: "DEPTH_COMPONENT16", write: write_depth16 } };

const write_rg9 = { language, name: "write", summary: "color of a depth, for a target of rg9",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.encode_rg9, snippets.to_unorm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float2 texel = umbrage_to_unorm(umbrage_encode_rg9(depth));
    return float4(texel.x, texel.y, 0.0, 0.0);
}
` };
export const rg9 = { name: "rg9", direction: "forward", depth: "umbrage_decode_rg9(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg9],
    cleared: [1, 0.50196078431372548, 0, 0], format: "RG8", depth_format: "", write: write_rg9,
    reversed: { name: "rg9", direction: "reversed", depth: "umbrage_decode_rg9(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg9],
    cleared: [0, 0, 0, 0], format: "RG8", depth_format: "", write: write_rg9 } };

const write_rg10 = { language, name: "write", summary: "color of a depth, for a target of rg10",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.encode_rg10, snippets.to_unorm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float2 texel = umbrage_to_unorm(umbrage_encode_rg10(depth));
    return float4(texel.x, texel.y, 0.0, 0.0);
}
` };
export const rg10 = { name: "rg10", direction: "forward", depth: "umbrage_decode_rg10(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg10],
    cleared: [1, 0.75294117647058822, 0, 0], format: "RG8", depth_format: "", write: write_rg10,
    reversed: { name: "rg10", direction: "reversed", depth: "umbrage_decode_rg10(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg10],
    cleared: [0, 0, 0, 0], format: "RG8", depth_format: "", write: write_rg10 } };

const write_rg11 = { language, name: "write", summary: "color of a depth, for a target of rg11",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.encode_rg11, snippets.to_unorm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float2 texel = umbrage_to_unorm(umbrage_encode_rg11(depth));
    return float4(texel.x, texel.y, 0.0, 0.0);
}
` };
export const rg11 = { name: "rg11", direction: "forward", depth: "umbrage_decode_rg11(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg11],
    cleared: [1, 0.8784313725490196, 0, 0], format: "RG8", depth_format: "", write: write_rg11,
    reversed: { name: "rg11", direction: "reversed", depth: "umbrage_decode_rg11(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg11],
    cleared: [0, 0, 0, 0], format: "RG8", depth_format: "", write: write_rg11 } };

const write_rg12 = { language, name: "write", summary: "color of a depth, for a target of rg12",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.encode_rg12, snippets.to_unorm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float2 texel = umbrage_to_unorm(umbrage_encode_rg12(depth));
    return float4(texel.x, texel.y, 0.0, 0.0);
}
` };
export const rg12 = { name: "rg12", direction: "forward", depth: "umbrage_decode_rg12(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg12],
    cleared: [1, 0.94117647058823528, 0, 0], format: "RG8", depth_format: "", write: write_rg12,
    reversed: { name: "rg12", direction: "reversed", depth: "umbrage_decode_rg12(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg12],
    cleared: [0, 0, 0, 0], format: "RG8", depth_format: "", write: write_rg12 } };

const write_rg13 = { language, name: "write", summary: "color of a depth, for a target of rg13",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.encode_rg13, snippets.to_unorm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float2 texel = umbrage_to_unorm(umbrage_encode_rg13(depth));
    return float4(texel.x, texel.y, 0.0, 0.0);
}
` };
export const rg13 = { name: "rg13", direction: "forward", depth: "umbrage_decode_rg13(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg13],
    cleared: [1, 0.97254901960784312, 0, 0], format: "RG8", depth_format: "", write: write_rg13,
    reversed: { name: "rg13", direction: "reversed", depth: "umbrage_decode_rg13(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg13],
    cleared: [0, 0, 0, 0], format: "RG8", depth_format: "", write: write_rg13 } };

const write_rg14 = { language, name: "write", summary: "color of a depth, for a target of rg14",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.encode_rg14, snippets.to_unorm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float2 texel = umbrage_to_unorm(umbrage_encode_rg14(depth));
    return float4(texel.x, texel.y, 0.0, 0.0);
}
` };
export const rg14 = { name: "rg14", direction: "forward", depth: "umbrage_decode_rg14(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg14],
    cleared: [1, 0.9882352941176471, 0, 0], format: "RG8", depth_format: "", write: write_rg14,
    reversed: { name: "rg14", direction: "reversed", depth: "umbrage_decode_rg14(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg14],
    cleared: [0, 0, 0, 0], format: "RG8", depth_format: "", write: write_rg14 } };

const write_rg15 = { language, name: "write", summary: "color of a depth, for a target of rg15",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.encode_rg15, snippets.to_unorm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float2 texel = umbrage_to_unorm(umbrage_encode_rg15(depth));
    return float4(texel.x, texel.y, 0.0, 0.0);
}
` };
export const rg15 = { name: "rg15", direction: "forward", depth: "umbrage_decode_rg15(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg15],
    cleared: [1, 0.99607843137254903, 0, 0], format: "RG8", depth_format: "", write: write_rg15,
    reversed: { name: "rg15", direction: "reversed", depth: "umbrage_decode_rg15(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg15],
    cleared: [0, 0, 0, 0], format: "RG8", depth_format: "", write: write_rg15 } };

const write_rg16 = { language, name: "write", summary: "color of a depth, for a target of rg16",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.encode_rg16, snippets.to_unorm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float2 texel = umbrage_to_unorm(umbrage_encode_rg16(depth));
    return float4(texel.x, texel.y, 0.0, 0.0);
}
` };
export const rg16 = { name: "rg16", direction: "forward", depth: "umbrage_decode_rg16(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg16],
    cleared: [1, 1, 0, 0], format: "RG8", depth_format: "", write: write_rg16,
    reversed: { name: "rg16", direction: "reversed", depth: "umbrage_decode_rg16(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg16],
    cleared: [0, 0, 0, 0], format: "RG8", depth_format: "", write: write_rg16 } };

const write_rgb24 = { language, name: "write", summary: "color of a depth, for a target of rgb24",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.encode_rgb24, snippets.to_unorm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float3 texel = umbrage_to_unorm(umbrage_encode_rgb24(depth));
    return float4(texel.x, texel.y, texel.z, 0.0);
}
` };
export const rgb24 = { name: "rgb24", direction: "forward", depth: "umbrage_decode_rgb24(value.xyz, 1.0)", channels: 3, needs: [snippets.decode_rgb24],
    cleared: [1, 1, 1, 0], format: "RGB8", depth_format: "", write: write_rgb24,
    reversed: { name: "rgb24", direction: "reversed", depth: "umbrage_decode_rgb24(value.xyz, 0.0)", channels: 3, needs: [snippets.decode_rgb24],
    cleared: [0, 0, 0, 0], format: "RGB8", depth_format: "", write: write_rgb24 } };

const write_rgb10 = { language, name: "write", summary: "color of a depth, for a target of rgb10",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.encode_rgb10, snippets.to_unorm10], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float3 texel = umbrage_to_unorm10(umbrage_encode_rgb10(depth));
    return float4(texel.x, texel.y, texel.z, 0.0);
}
` };
export const rgb10 = { name: "rgb10", direction: "forward", depth: "umbrage_decode_rgb10(value.xyz, 1.0)", channels: 3, needs: [snippets.decode_rgb10],
    cleared: [1, 1, 0.93841642228739008, 0], format: "RGB10_A2", depth_format: "", write: write_rgb10,
    reversed: { name: "rgb10", direction: "reversed", depth: "umbrage_decode_rgb10(value.xyz, 0.0)", channels: 3, needs: [snippets.decode_rgb10],
    cleared: [0, 0, 0, 0], format: "RGB10_A2", depth_format: "", write: write_rgb10 } };

const write_r16 = { language, name: "write", summary: "color of a depth, for a target of r16",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.encode_r16, snippets.to_unorm16], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float texel = umbrage_to_unorm16(umbrage_encode_r16(depth));
    return float4(texel, 0.0, 0.0, 0.0);
}
` };
export const r16 = { name: "r16", direction: "forward", depth: "umbrage_decode_r16(value.x, 1.0)", channels: 1, needs: [snippets.decode_r16],
    cleared: [1, 0, 0, 0], format: "R16", depth_format: "DEPTH_COMPONENT16", write: write_r16,
    reversed: { name: "r16", direction: "reversed", depth: "umbrage_decode_r16(value.x, 0.0)", channels: 1, needs: [snippets.decode_r16],
    cleared: [0, 0, 0, 0], format: "R16", depth_format: "DEPTH_COMPONENT16", write: write_r16 } };

const write_float_bits = { language, name: "write", summary: "color of a depth, for a target of float_bits",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "300 es", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.encode_float_bits, snippets.to_unorm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float4 texel = umbrage_to_unorm(umbrage_encode_float_bits(depth));
    return float4(texel.x, texel.y, texel.z, texel.w);
}
` };
export const float_bits = { name: "float_bits", direction: "forward", depth: "umbrage_decode_float_bits(value.xyzw)", channels: 4, needs: [snippets.decode_float_bits],
    cleared: [0, 0, 0.50196078431372548, 0.24705882352941178], format: "RGBA8", depth_format: "", write: write_float_bits,
    reversed: { name: "float_bits", direction: "reversed", depth: "umbrage_decode_float_bits(value.xyzw)", channels: 4, needs: [snippets.decode_float_bits],
    cleared: [0, 0, 0, 0], format: "RGBA8", depth_format: "", write: write_float_bits } };

const write_threejs_rgba = { language, name: "write", summary: "color of a depth, for a target of threejs_rgba",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.write_threejs_rgba], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float4 texel = umbrage_write_threejs_rgba(depth);
    return float4(texel.x, texel.y, texel.z, texel.w);
}
` };
export const threejs_rgba = { name: "threejs_rgba", direction: "forward", depth: "umbrage_decode_threejs_rgba(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_rgba],
    cleared: [1, 1, 1, 1], format: "RGBA8", depth_format: "", write: write_threejs_rgba,
    reversed: { name: "threejs_rgba", direction: "reversed", depth: "umbrage_decode_threejs_rgba(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_rgba],
    cleared: [0, 0, 0, 0], format: "RGBA8", depth_format: "", write: write_threejs_rgba } };

const write_threejs_rgb = { language, name: "write", summary: "color of a depth, for a target of threejs_rgb",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.write_threejs_rgb], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float3 texel = umbrage_write_threejs_rgb(depth);
    return float4(texel.x, texel.y, texel.z, 0.0);
}
` };
export const threejs_rgb = { name: "threejs_rgb", direction: "forward", depth: "umbrage_decode_threejs_rgb(value.xyz)", channels: 3, needs: [snippets.decode_threejs_rgb],
    cleared: [1, 1, 1, 0], format: "RGB8", depth_format: "", write: write_threejs_rgb,
    reversed: { name: "threejs_rgb", direction: "reversed", depth: "umbrage_decode_threejs_rgb(value.xyz)", channels: 3, needs: [snippets.decode_threejs_rgb],
    cleared: [0, 0, 0, 0], format: "RGB8", depth_format: "", write: write_threejs_rgb } };

const write_threejs_rg = { language, name: "write", summary: "color of a depth, for a target of threejs_rg",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.write_threejs_rg], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float2 texel = umbrage_write_threejs_rg(depth);
    return float4(texel.x, texel.y, 0.0, 0.0);
}
` };
export const threejs_rg = { name: "threejs_rg", direction: "forward", depth: "umbrage_decode_threejs_rg(value.xy)", channels: 2, needs: [snippets.decode_threejs_rg],
    cleared: [1, 1, 0, 0], format: "RG8", depth_format: "", write: write_threejs_rg,
    reversed: { name: "threejs_rg", direction: "reversed", depth: "umbrage_decode_threejs_rg(value.xy)", channels: 2, needs: [snippets.decode_threejs_rg],
    cleared: [0, 0, 0, 0], format: "RG8", depth_format: "", write: write_threejs_rg } };

const write_threejs_legacy = { language, name: "write", summary: "color of a depth, for a target of threejs_legacy",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.write_threejs_legacy], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float4 texel = umbrage_write_threejs_legacy(depth);
    return float4(texel.x, texel.y, texel.z, texel.w);
}
` };
export const threejs_legacy = { name: "threejs_legacy", direction: "forward", depth: "umbrage_decode_threejs_legacy(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_legacy],
    cleared: [1, 1, 1, 1], format: "RGBA8", depth_format: "", write: write_threejs_legacy,
    reversed: { name: "threejs_legacy", direction: "reversed", depth: "umbrage_decode_threejs_legacy(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_legacy],
    cleared: [0, 0, 0, 0], format: "RGBA8", depth_format: "", write: write_threejs_legacy } };

const write_threejs_legacy_repaired = { language, name: "write", summary: "color of a depth, for a target of threejs_legacy_repaired",
    exactness: "a", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.encode_threejs_legacy_repaired, snippets.to_unorm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float4 texel = umbrage_to_unorm(umbrage_encode_threejs_legacy_repaired(depth));
    return float4(texel.x, texel.y, texel.z, texel.w);
}
` };
export const threejs_legacy_repaired = { name: "threejs_legacy_repaired", direction: "forward", depth: "umbrage_decode_threejs_legacy(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_legacy],
    cleared: [1, 1, 1, 1], format: "RGBA8", depth_format: "", write: write_threejs_legacy_repaired,
    reversed: { name: "threejs_legacy_repaired", direction: "reversed", depth: "umbrage_decode_threejs_legacy(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_legacy],
    cleared: [0, 0, 0, 0], format: "RGBA8", depth_format: "", write: write_threejs_legacy_repaired } };

const write_base255 = { language, name: "write", summary: "color of a depth, for a target of base255",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.write_base255], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float4 texel = umbrage_write_base255(depth);
    return float4(texel.x, texel.y, texel.z, texel.w);
}
` };
export const base255 = { name: "base255", direction: "forward", depth: "umbrage_decode_base255(value.xyzw)", channels: 4, needs: [snippets.decode_base255],
    cleared: [1, 0, 0, 0], format: "RGBA8", depth_format: "", write: write_base255,
    reversed: { name: "base255", direction: "reversed", depth: "umbrage_decode_base255(value.xyzw)", channels: 4, needs: [snippets.decode_base255],
    cleared: [0, 0, 0, 0], format: "RGBA8", depth_format: "", write: write_base255 } };

const write_base255_repaired = { language, name: "write", summary: "color of a depth, for a target of base255_repaired",
    exactness: "b", operations: 0, within: 0, as_written: false, lowest: "100", role: "none", scaled: false,
    needs: [snippets.cleared_depth, snippets.encode_base255_repaired, snippets.to_unorm], text: `
// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target
float4 umbrage_write(float depth) {
    float4 texel = umbrage_to_unorm(umbrage_encode_base255_repaired(depth));
    return float4(texel.x, texel.y, texel.z, texel.w);
}
` };
export const base255_repaired = { name: "base255_repaired", direction: "forward", depth: "umbrage_decode_base255(value.xyzw)", channels: 4, needs: [snippets.decode_base255],
    cleared: [1, 0, 0, 0], format: "RGBA8", depth_format: "", write: write_base255_repaired,
    reversed: { name: "base255_repaired", direction: "reversed", depth: "umbrage_decode_base255(value.xyzw)", channels: 4, needs: [snippets.decode_base255],
    cleared: [0, 0, 0, 0], format: "RGBA8", depth_format: "", write: write_base255_repaired } };
