import * as snippets from './snippets.mjs';

export const depth32f = { direction: "forward", depth: "", channels: 1, needs: [],
    writer: snippets.saturate, writes: "depth", format: "R32F", cleared: [1, 0, 0, 0],
    reversed: { direction: "reversed", depth: "", channels: 1, needs: [],
    writer: snippets.saturate, writes: "depth", format: "R32F", cleared: [0, 0, 0, 0] } };

export const rg9 = { direction: "forward", depth: "umbrage_decode_rg9(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg9],
    writer: snippets.encode_rg9, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [1, 0.50196078431372548, 0, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_rg9(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg9],
    writer: snippets.encode_rg9, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0, 0, 0, 0] } };

export const rg10 = { direction: "forward", depth: "umbrage_decode_rg10(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg10],
    writer: snippets.encode_rg10, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [1, 0.75294117647058822, 0, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_rg10(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg10],
    writer: snippets.encode_rg10, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0, 0, 0, 0] } };

export const rg11 = { direction: "forward", depth: "umbrage_decode_rg11(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg11],
    writer: snippets.encode_rg11, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [1, 0.8784313725490196, 0, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_rg11(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg11],
    writer: snippets.encode_rg11, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0, 0, 0, 0] } };

export const rg12 = { direction: "forward", depth: "umbrage_decode_rg12(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg12],
    writer: snippets.encode_rg12, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [1, 0.94117647058823528, 0, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_rg12(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg12],
    writer: snippets.encode_rg12, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0, 0, 0, 0] } };

export const rg13 = { direction: "forward", depth: "umbrage_decode_rg13(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg13],
    writer: snippets.encode_rg13, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [1, 0.97254901960784312, 0, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_rg13(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg13],
    writer: snippets.encode_rg13, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0, 0, 0, 0] } };

export const rg14 = { direction: "forward", depth: "umbrage_decode_rg14(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg14],
    writer: snippets.encode_rg14, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [1, 0.9882352941176471, 0, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_rg14(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg14],
    writer: snippets.encode_rg14, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0, 0, 0, 0] } };

export const rg15 = { direction: "forward", depth: "umbrage_decode_rg15(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg15],
    writer: snippets.encode_rg15, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [1, 0.99607843137254903, 0, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_rg15(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg15],
    writer: snippets.encode_rg15, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0, 0, 0, 0] } };

export const rg16 = { direction: "forward", depth: "umbrage_decode_rg16(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg16],
    writer: snippets.encode_rg16, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [1, 1, 0, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_rg16(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg16],
    writer: snippets.encode_rg16, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0, 0, 0, 0] } };

export const rgb24 = { direction: "forward", depth: "umbrage_decode_rgb24(value.xyz, 1.0)", channels: 3, needs: [snippets.decode_rgb24],
    writer: snippets.encode_rgb24, writes: "integers", format: "RGB8", to_unorm: snippets.to_unorm, cleared: [1, 1, 1, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_rgb24(value.xyz, 0.0)", channels: 3, needs: [snippets.decode_rgb24],
    writer: snippets.encode_rgb24, writes: "integers", format: "RGB8", to_unorm: snippets.to_unorm, cleared: [0, 0, 0, 0] } };

export const rgb10 = { direction: "forward", depth: "umbrage_decode_rgb10(value.xyz, 1.0)", channels: 3, needs: [snippets.decode_rgb10],
    writer: snippets.encode_rgb10, writes: "integers", format: "RGB10_A2", to_unorm: snippets.to_unorm10, cleared: [1, 1, 0.93841642228739008, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_rgb10(value.xyz, 0.0)", channels: 3, needs: [snippets.decode_rgb10],
    writer: snippets.encode_rgb10, writes: "integers", format: "RGB10_A2", to_unorm: snippets.to_unorm10, cleared: [0, 0, 0, 0] } };

export const r16 = { direction: "forward", depth: "umbrage_decode_r16(value.x, 1.0)", channels: 1, needs: [snippets.decode_r16],
    writer: snippets.encode_r16, writes: "integers", format: "R16", to_unorm: snippets.to_unorm16, cleared: [1, 0, 0, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_r16(value.x, 0.0)", channels: 1, needs: [snippets.decode_r16],
    writer: snippets.encode_r16, writes: "integers", format: "R16", to_unorm: snippets.to_unorm16, cleared: [0, 0, 0, 0] } };

export const float_bits = { direction: "forward", depth: "umbrage_decode_float_bits(value.xyzw)", channels: 4, needs: [snippets.decode_float_bits],
    writer: snippets.encode_float_bits, writes: "integers", format: "RGBA8", to_unorm: snippets.to_unorm, cleared: [0, 0, 0.50196078431372548, 0.24705882352941178],
    reversed: { direction: "reversed", depth: "umbrage_decode_float_bits(value.xyzw)", channels: 4, needs: [snippets.decode_float_bits],
    writer: snippets.encode_float_bits, writes: "integers", format: "RGBA8", to_unorm: snippets.to_unorm, cleared: [0, 0, 0, 0] } };

export const threejs_rgba = { direction: "forward", depth: "umbrage_decode_threejs_rgba(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_rgba],
    writer: snippets.write_threejs_rgba, writes: "values", format: "RGBA8", cleared: [1, 1, 1, 1],
    reversed: { direction: "reversed", depth: "umbrage_decode_threejs_rgba(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_rgba],
    writer: snippets.write_threejs_rgba, writes: "values", format: "RGBA8", cleared: [0, 0, 0, 0] } };

export const threejs_rgb = { direction: "forward", depth: "umbrage_decode_threejs_rgb(value.xyz)", channels: 3, needs: [snippets.decode_threejs_rgb],
    writer: snippets.write_threejs_rgb, writes: "values", format: "RGB8", cleared: [1, 1, 1, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_threejs_rgb(value.xyz)", channels: 3, needs: [snippets.decode_threejs_rgb],
    writer: snippets.write_threejs_rgb, writes: "values", format: "RGB8", cleared: [0, 0, 0, 0] } };

export const threejs_rg = { direction: "forward", depth: "umbrage_decode_threejs_rg(value.xy)", channels: 2, needs: [snippets.decode_threejs_rg],
    writer: snippets.write_threejs_rg, writes: "values", format: "RG8", cleared: [1, 1, 0, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_threejs_rg(value.xy)", channels: 2, needs: [snippets.decode_threejs_rg],
    writer: snippets.write_threejs_rg, writes: "values", format: "RG8", cleared: [0, 0, 0, 0] } };

export const threejs_legacy = { direction: "forward", depth: "umbrage_decode_threejs_legacy(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_legacy],
    writer: snippets.write_threejs_legacy, writes: "values", format: "RGBA8", cleared: [1, 1, 1, 1],
    reversed: { direction: "reversed", depth: "umbrage_decode_threejs_legacy(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_legacy],
    writer: snippets.write_threejs_legacy, writes: "values", format: "RGBA8", cleared: [0, 0, 0, 0] } };

export const threejs_legacy_repaired = { direction: "forward", depth: "umbrage_decode_threejs_legacy(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_legacy],
    writer: snippets.encode_threejs_legacy_repaired, writes: "integers", format: "RGBA8", to_unorm: snippets.to_unorm, cleared: [1, 1, 1, 1],
    reversed: { direction: "reversed", depth: "umbrage_decode_threejs_legacy(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_legacy],
    writer: snippets.encode_threejs_legacy_repaired, writes: "integers", format: "RGBA8", to_unorm: snippets.to_unorm, cleared: [0, 0, 0, 0] } };

export const base255 = { direction: "forward", depth: "umbrage_decode_base255(value.xyzw)", channels: 4, needs: [snippets.decode_base255],
    writer: snippets.write_base255, writes: "values", format: "RGBA8", cleared: [1, 0, 0, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_base255(value.xyzw)", channels: 4, needs: [snippets.decode_base255],
    writer: snippets.write_base255, writes: "values", format: "RGBA8", cleared: [0, 0, 0, 0] } };

export const base255_repaired = { direction: "forward", depth: "umbrage_decode_base255(value.xyzw)", channels: 4, needs: [snippets.decode_base255],
    writer: snippets.encode_base255_repaired, writes: "integers", format: "RGBA8", to_unorm: snippets.to_unorm, cleared: [1, 0, 0, 0],
    reversed: { direction: "reversed", depth: "umbrage_decode_base255(value.xyzw)", channels: 4, needs: [snippets.decode_base255],
    writer: snippets.encode_base255_repaired, writes: "integers", format: "RGBA8", to_unorm: snippets.to_unorm, cleared: [0, 0, 0, 0] } };
