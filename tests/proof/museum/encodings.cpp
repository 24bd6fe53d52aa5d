// SPDX-License-Identifier: MIT
//
// Exhibits: depth in 8-bit channels.
#include "old_encodings.hpp"

namespace museum {
namespace {

const exhibit all[] = {
    {"The far plane decodes to 0, in base 256", "old bgfx, Godot and Mapbox GL packers: mapbox/mapbox-gl-js#12005",
     "The cleared far plane comes back as the nearest depth, so receivers without a caster are in shadow.",
     "e_i = fract(256^i v), each less e_(i+1) / 256", "depth 1, decoded more than 2^-20 off", "depth",
     "`encode_rgb24` clamps the integer, not the fraction. Depth 1 becomes 2^24 - 1, whose upper edge is 1",
     [] { return at_one(base_256); }, [] { return at_one(three_bytes); }},
    {"The far plane decodes to 0, in base 255",
     "Aras Pranckevicius' formula of 2009 as used by Cesium, Babylon.js, bgfx", "The most copied packer does the same.",
     "e_i = fract(255^i v), each less e_(i+1) / 255", "depth 1, decoded more than 2^-20 off", "depth",
     "`encode_base255_repaired` writes digits instead of fractions, for the same reader",
     [] { return at_one(base255); }, [] { return at_one(base255_repaired); }},
    {"The far plane comes back as 255/256", "three.js r73 to r166, lygia",
     "The top channel would need 256/255. The target clamps it, so the far plane comes back nearer than other depths.",
     "fract packing scaled by 256/255, read with 255/256", "depth 1, decoded more than 2^-20 off", "depth",
     "`encode_threejs_legacy_repaired` writes all ones for 1, for the same reader", [] { return at_one(legacy); },
     [] { return at_one(legacy_repaired); }},
    {"A farther depth comes back nearer", "old bgfx, Godot and Mapbox GL packers: mapbox/mapbox-gl-js#12005",
     "The channels are no multiples of 1/255, so the store rounds them. A farther depth comes back nearer.",
     "e_i = fract(256^i v), each less e_(i+1) / 256", "2^24 pairs of neighbors k / 2^24, decoded in the wrong order",
     "depth", "`encode_rgb24` writes integer channels, which keep the order", [] { return inversions(base_256); },
     [] { return inversions(three_bytes); }},
    {"Four channels hold nine bits of depth", "old bgfx, Godot and Mapbox GL packers: mapbox/mapbox-gl-js#12005",
     "Fractions scaled for base 256 meet channels in steps of 1/255.", "e_i = fract(256^i v), each less e_(i+1) / 256",
     "depths k / 2^20, decoded more than 2^-23 off", "depth",
     "`encode_rgb24` has three integer channels, with steps of 2^-24", [] { return errors(base_256, 0x1p-23); },
     [] { return errors(three_bytes, 0x1p-23); }},
    {"Depths lose a step of the top channel",
     "Cesium, Babylon.js, bgfx. mrdoob/three.js#28692 says that rounding is not mandated",
     "Base 255 needs a render target that rounds to nearest. A target that truncates loses a step of the top channel.",
     "e_i = fract(255^i v), each less e_(i+1) / 255, into a truncating target",
     "depths k / 2^20, decoded more than 2^-22 off", "depth",
     "`to_unorm` aims a quarter of a step above the channel, so that rounding and truncating agree",
     [] { return errors([](float d) { return decode_base255(stored(write_base255(d), truncates)); }, 0x1p-22); },
     [] {
         return errors([](float d) { return decode_base255(stored(encode_base255_repaired(d), truncates)); }, 0x1p-22);
     }},
    {"Moments lose half of their bits", "bgfx's VSM sample and three.js' pack2Half",
     "A target that truncates loses half of the 16 bits in two channels.", "(v - g / 255, g), g = fract(255 v)",
     "depths k / 2^20, decoded more than 2^-16 off", "depth", "`encode_rg<16>` and `to_unorm` keep all 16",
     [] {
         return errors(
             [](float d) {
                 const float g = fraction(255.0f * d);
                 const vec2 c = stored(vec2(d - g / 255.0f, g), truncates);
                 return c.x + c.y / 255.0f;
             },
             0x1p-16);
     },
     [] {
         return errors([](float d) { return decode_rg<16>(stored(encode_rg<16>(d), truncates), upper_edge<float>); },
                       0x1p-16);
     }},
    {"Nearly every byte reads one too low",
     "PlayCanvas float-as-uint. dolphin-emu/dolphin#280 met it on an Intel HD 4000",
     "A driver whose k / 255 is an ulp low turns nearly every byte into the one below.", "uint(c * 255.0)",
     "256 bytes, read an ulp low", "bytes",
     "`from_unorm` is floor(255 c + 1/2), right even if c is thousands of ulp off",
     [] { return bytes_an_ulp_low([](float c) { return std::floor(c * 255.0f); }); },
     [] { return bytes_an_ulp_low([](float c) { return from_unorm(c); }); }},
    {"Small depths lose eight bits", "older Cesium builds, gists, dataset pages: a digit too many in 255^3 = 16581375",
     "The fourth channel holds noise. Small depths lose its eight bits.", "w = fract(160581375 v)",
     "depths below 1/256 in steps of 2^-28, decoded more than 2^-30 off", "depth",
     "tests run every code. `encode_base255_repaired` multiplies by 255 four times",
     [] { return small_depths([](float d) { return decode_base255(stored(encode_base255_typo(d))); }); },
     [] { return small_depths(base255_repaired); }},
    {"Depths are not a number on a phone", "mrdoob/three.js#9092 on an iPad Air 2, mapbox/mapbox-gl-js#10979",
     "65536 and 16581375 exceed 65504, the largest half. The factors are infinite, so the channels are NaN.",
     "fract(v * vec4(1, 255, 65025, 16581375)) in mediump",
     "every half in [0, 1], decoded as NaN or more than 2^-11 off", "depth",
     "snippets put highp on every value. `encode_rg11` is right in mediump too, as its own GLSL text shows here",
     [] { return half_depths(base255_in_half); }, [] { return half_depths(rg11_in_half); }},
    {"Depth is noise: the wrong two bytes",
     "three.js' first RG variant, mrdoob/three.js#28692, repaired in mrdoob/three.js#28789",
     "The 16 bits come from the two least significant of four channels.", "(R, G) of a texel whose top channel is A",
     "depths k / 2^20, decoded more than 2^-15 off", "depth", "`encode_rg<16>` splits a 16-bit code",
     [] {
         return errors(
             [](float d) {
                 const vec4 c = write_threejs_legacy(d);
                 const vec2 kept = stored(vec2(c.y, c.x));
                 return (kept.x + kept.y / 256.0f) * (255.0f / 256.0f);
             },
             0x1p-15);
     },
     [] { return errors(two_bytes<16>, 0x1p-15); }},
    {"Depth is noise: channels in another order",
     "three.js r167 reversed the order. Readers for r166 and before kept the old one",
     "A map written R first and read A first is noise.", "written by the format of r167, read by that of r166",
     "depths k / 2^20, decoded more than 2^-20 off", "depth",
     "each format has its own name: `write_threejs_rgba` with `decode_threejs_rgba`",
     [] { return errors([](float d) { return decode_threejs_legacy(stored(write_threejs_rgba(d))); }, 0x1p-20); },
     [] { return errors([](float d) { return decode_threejs_rgba(stored(write_threejs_rgba(d))); }, 0x1p-20); }},
    {"Depths jump where the low byte wraps", "lookup tables like that of the Radeon 8500 sample",
     "The low byte falls from 255 to 0 where the high one rises by 32. The sampler interpolates both and rounds "
     "them to bytes. Half a step of the high byte is 4 codes.",
     "texture2D(table, depth) with GL_LINEAR", "depths k / 2^18, decoded more than a code off", "codes",
     "`encode_rg_table` fetches one whole texel", [] { return through_table(fetch_linear); },
     [] { return through_table(fetch_nearest); }},
    {"One depth of 2048 is 255 codes off", "the article on self-shadowing with pixel shader 1.x",
     "The article's text has (255, 32), but its formula gives 256 & 255 = 0. One texel out of 2048 is off by 255 "
     "codes.",
     "table[256] = (255, 32)", "2048 texels of the table", "codes",
     "`make_rg_table` is computed, and compared with the encoder",
     [] { return table_texels([](int x) { return x == 256 ? glm::u8vec2(255, 32) : table[std::size_t(x)]; }); },
     [] { return table_texels([](int x) { return table[std::size_t(x)]; }); }},
    {"Shadows begin up to 8 codes too late", "ports of the Radeon 8500 sample",
     "r / 8 + g is x / 2040, not x / 2048. Compared with an unscaled depth, shadows begin up to 8 codes too late.",
     "depth <= r / 8 + g", "2048^2 pairs of receiver and stored code, the wrong side of the test", "codes",
     "`decode_rg<11>` gives x / 2048. `receiver_ps14` has the scale of the literal form",
     [] { return self_shadowing([](vec2 c) { return decode_ps14(c); }); },
     [] { return self_shadowing([](vec2 c) { return decode_rg<11>(c, upper_edge<float>); }); }},
    {"A blurred map has depths of neither texel", "any blur, mip level or multisample resolve of a packed map",
     "The mean of the high bytes rounds to a byte. The low byte then belongs to another high byte.",
     "mean of the channels, stored, decoded", "2^16 pairs of texels, mean more than 2^-15 off", "depth",
     "filters take a fetch of decoded depths, so nothing averages channels", [] { return means(mean_of_channels); },
     [] { return means(mean_of_depths); }},
    {"One texel, two depths on two drivers", "every decoder that multiplies sampled channels, here three.js' RG format",
     "k / 255 and k (1/255) differ by an ulp for 126 of 256 bytes. The depths differ too.",
     "255/256 R + G/256 on channels as sampled", "2^16 texels, read by a division and by a product", "depth",
     "`decode_rg<16>` first turns channels into integer bytes", [] { return two_drivers(decode_threejs_rg<float>); },
     [] { return two_drivers([](vec2 c) { return decode_rg<16>(c, upper_edge<float>); }); }},
    {"Depth codes change with the compiler's flags", "24-bit packers that scale by 2^24 - 1",
     "v (2^24 - 1) + 1/2 is not representable. With contraction, on by default in GCC, the code differs.",
     "floor(v * 16777215.0 + 0.5)", "depths from 2^-8 to 1, the code with fma unlike that without", "codes",
     "`to_code<24>` scales by 2^24, so nothing is rounded",
     [] {
         return fused_or_not([](float v, bool fused) { return std::floor(product_plus(v, 16777215.0f, 0.5f, fused)); });
     },
     [] { return fused_or_not([](float v, bool fused) { return to_code<24>(product_plus(v, 1.0f, 0.0f, fused)); }); }},
    {"Depths are hundreds of codes off", "packed maps in textures that the engine takes for color",
     "The sampler converts every channel before the decoder reads it.", "decode(sRGB to linear(c))",
     "2048 codes, decoded more than a code off", "codes",
     "pages name linear formats, so `from_unorm` gets bytes as they are stored", [] { return sampled(decode_srgb); },
     [] { return sampled([](float c) { return c; }); }},
    {"The high byte is gone", "three.js' layout before r167, mrdoob/three.js#28692",
     "The most significant byte is in alpha. A target without alpha gives 1 there.",
     "A most significant, opaque target", "depths k / 2^20, decoded more than 2^-22 off", "depth",
     "`encode_rgb24` and `encode_rg` leave alpha alone", [] { return errors(legacy_through<opaque>, 0x1p-22); },
     [] { return errors(three_bytes_through<opaque>, 0x1p-22); }},
    {"The low bytes shrink with the high one", "three.js' layout before r167, mrdoob/three.js#28692",
     "A canvas or blend that multiplies color by alpha scales the low bytes by the high one.",
     "A most significant, premultiplied target", "depths k / 2^20, decoded more than 2^-22 off", "depth",
     "`encode_rgb24` and `encode_rg` leave alpha alone", [] { return errors(legacy_through<premultiplied>, 0x1p-22); },
     [] { return errors(three_bytes_through<premultiplied>, 0x1p-22); }},
    {"One broken triangle shadows all behind it",
     "clamps written as comparisons. playcanvas/engine#9124 met NaN depths in its maps",
     "One degenerate triangle writes NaN. Its texel shadows everything.", "v > 0 ? min(v, 1) : 0",
     "NaN of either sign, stored as less than 1", "depth", "`saturate` makes NaN of either sign 1, the cleared depth",
     [] { return nans([](float v) { return v > 0.0f ? (v < 1.0f ? v : 1.0f) : 0.0f; }); },
     [] { return nans([](float v) { return saturate(v); }); }},
    {"Nothing is dark: z/w against distance", "cocos/cocos-engine#8397, packed against linear depth",
     "The map holds perspective depth, but the reader compares linear depth. Half of the range is the first 0.2 units.",
     "store z/w; compare z / z_far", "10000 points, the two depths unlike", "depth",
     "each kind of depth has a name: `linear_depth` on both sides",
     [] { return writer_and_reader([](float z) { return depth_from_view_z(z, 0.1f, 100.0f); }); },
     [] { return writer_and_reader([](float z) { return linear_depth(z, 0.01f); }); }},
};

}  // namespace
}  // namespace museum

std::span<const exhibit> encodings() { return museum::all; }
