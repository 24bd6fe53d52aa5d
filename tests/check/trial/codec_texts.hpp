// SPDX-License-Identifier: MIT
//
// Packing and unpacking functions as people write them, with places for slips.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "languages.hpp"

namespace check {

/// What stands at the places of a text: `depth` and `stored` of one that packs, `returned` of one that unpacks. `order`
/// is a swizzle of its channels.
struct codec_parts {
    std::string depth = "z", stored = "v", returned = "d", order = "rgba";
};

struct written_packer {
    std::string_view name;
    int channels;
    std::string_view body, in_wgsl;  ///< of the depth d, in [0, 1]: channels v
};

inline constexpr written_packer written_packers[]{
    {"rgb24", 3, R"(float k = min(floor(d * 16777216.0), 16777215.0), h = floor(k / 256.0), t = floor(h / 256.0);
    vec4 v = vec4(t, h - t * 256.0, k - h * 256.0, 0.0) / 255.0;)",
     R"(let k = min(floor(d * 16777216.0), 16777215.0); let h = floor(k / 256.0); let t = floor(h / 256.0);
    let v = vec4f(t, h - t * 256.0, k - h * 256.0, 0.0) / 255.0;)"},
    {"rg11", 2, R"(float k = min(floor(d * 2048.0), 2047.0), h = floor(k / 256.0);
    vec4 v = vec4(h * 32.0, k - h * 256.0, 0.0, 0.0).grba / 255.0;)",
     R"(let k = min(floor(d * 2048.0), 2047.0); let h = floor(k / 256.0);
    let v = vec4f(k - h * 256.0, h * 32.0, 0.0, 0.0) / 255.0;)"},
    {"base255", 4, R"(vec4 e = vec4(1.0, 255.0, 65025.0, 16581375.0) * d;
    e = e - floor(e);
    vec4 v = e - vec4(e.yzw, 0.0) * (1.0 / 255.0);)",
     R"(let m = vec4f(1.0, 255.0, 65025.0, 16581375.0) * d; let e = m - floor(m);
    let v = e - vec4f(e.yzw, 0.0) * (1.0 / 255.0);)"},
    {"r16", 1, "vec4 v = vec4(min(floor(d * 65536.0), 65535.0) / 65535.0, 0.0, 0.0, 0.0);",
     "let v = vec4f(min(floor(d * 65536.0), 65535.0) / 65535.0, 0.0, 0.0, 0.0);"},
};

/// Text whose function pack(z) it is.
[[nodiscard]] inline std::string pack_text(const language& in, const written_packer& p, const codec_parts& parts) {
    const std::string depth = "clamp(" + parts.depth + ", 0.0, 1.0)", ends = "\n    return " + parts.stored + ";\n}\n";
    if (in.is_wgsl())
        return "fn pack(z: f32) -> vec4f {\n    let d = " + depth + ";\n    " + std::string(p.in_wgsl) + ends;
    return std::string(in.preamble) + "vec4 pack(float z) {\n    float d = " + depth + ";\n    " + std::string(p.body) +
           ends;
}

struct written_unpacker {
    std::string_view name;
    int channels;
    std::string_view depth;  ///< of channels c, in every language
};

inline constexpr written_unpacker written_unpackers[]{
    {"rgb24 lower edge", 3, "dot(floor(c.xyz * 255.0 + 0.5), vec3(65536.0, 256.0, 1.0)) / 16777216.0"},
    {"base255", 4, "dot(c, vec4(1.0, 1.0 / 255.0, 1.0 / 65025.0, 1.0 / 16581375.0))"},
    {"threejs_rgba", 4, "dot(c, vec4(255.0, 255.0 / 256.0, 255.0 / 65536.0, 1.0 / 65536.0) / 256.0)"},
    {"r16 lower edge", 1, "floor(c.x * 65535.0 + 0.5) / 65536.0"},
};

/// Text whose function unpack(c) it is.
[[nodiscard]] inline std::string unpack_text(const language& in, const written_unpacker& u, const codec_parts& parts) {
    const std::string depth(u.depth);
    if (in.is_wgsl())
        return "fn unpack(c: vec4f) -> f32 {\n    let d = " + depth + ";\n    return " + parts.returned + ";\n}\n";
    return std::string(in.preamble) + "float unpack(vec4 c) {\n    float d = " + depth + ";\n    return " +
           parts.returned + ";\n}\n";
}

/// A slip at one of those places, and the word by which it is to be named.
struct codec_slip {
    std::string codec_parts::*where;
    std::string_view text, kind;
    int channels = 1;             ///< that a codec must have for it
    std::string_view of_codec{};  ///< not empty: of this one alone
};

inline const std::vector<codec_slip> pack_slips{
    {&codec_parts::depth, "z * 2.0 - 1.0", "z_range"},
    {&codec_parts::depth, "z * 0.5 + 0.5", "z_range"},
    {&codec_parts::depth, "1.0 - z", "direction"},
    {&codec_parts::depth, "z * (255.0 / 256.0)", "base"},
    {&codec_parts::depth, "z * (256.0 / 255.0)", "base"},
    {&codec_parts::stored, "floor(v * 255.0) / 255.0", "truncation", 4, "base255"},  // others store integers
    {&codec_parts::order, "grba", "channels", 2},
    {&codec_parts::order, "bgra", "channels", 3},
    {&codec_parts::order, "abgr", "channels", 4},
};

inline const std::vector<codec_slip> unpack_slips{
    {&codec_parts::returned, "d * 2.0 - 1.0", "z_range"},
    {&codec_parts::returned, "d * 0.5 + 0.5", "z_range"},
    {&codec_parts::returned, "1.0 - d", "direction"},
    {&codec_parts::returned, "d * (255.0 / 256.0)", "base"},
    {&codec_parts::returned, "d * (256.0 / 255.0)", "base"},
    {&codec_parts::order, "grba", "channels", 2},
    {&codec_parts::order, "bgra", "channels", 3},
    {&codec_parts::order, "abgr", "channels", 4},
};

}  // namespace check
