// SPDX-License-Identifier: MIT
//
// Writers and readers of depth to compare, the ways of running them, and the shaders for that.
#pragma once

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/registry.hpp>
#include <umbrage/shader/glsl.hpp>

namespace packing {

inline constexpr int width = 4096, height = 1024;  // of the targets
inline constexpr int depths = 1 << 24;

struct codec {
    std::string name, writer, reader;  ///< whose each is
    std::string text;                  ///< GLSL functions
    std::string encode, decode;        ///< vec4 expression of `depth`; float expression of `c`
};

inline std::string read(const std::string& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    if (!file || text.str().empty()) throw std::runtime_error("cannot read " + path);
    return text.str();
}

inline std::vector<codec> codecs(const std::string& folder) {
    namespace glsl = umbrage::glsl;
    const auto peer = [&](const std::string& name) { return read(folder + '/' + name + ".glsl"); };
    const auto version = [&](const std::string& name) { return name + ' ' + read(folder + '/' + name + ".version"); };
    const std::string three = version("three"), babylon = version("babylon"), playcanvas = version("playcanvas");
    const std::string us = "umbrage";
    const auto ours = [](const std::vector<glsl::bound>& items) { return glsl::text(items); };
    return {
        {"RGBA", three, three, peer("three"), "packDepthToRGBA(depth)", "unpackRGBAToDepth(c)"},
        {"RGB", three, three, peer("three"), "vec4(packDepthToRGB(depth), 1.0)", "unpackRGBToDepth(c.xyz)"},
        {"RG", three, three, peer("three"), "vec4(packDepthToRG(depth), 0.0, 1.0)", "unpackRGToDepth(c.xy)"},
        {"two halves", three, three, peer("three"), "pack2HalfToRGBA(vec2(depth))", "unpackRGBATo2Half(c).x"},
        {"base 255", babylon, babylon, peer("babylon"), "pack(depth)", "unpack(c)"},
        {"float bits", playcanvas, playcanvas, peer("playcanvas"), "float2uint(depth)", "uint2float(c)"},
        {"rg11", us, us, ours({glsl::to_unorm, glsl::encode_rg<11>, glsl::decode_rg<11>}),
         "vec4(umbrage_to_unorm(umbrage_encode_rg11(depth)), 0.0, 1.0)", "umbrage_decode_rg11(c.xy, 1.0)"},
        {"rg16", us, us, ours({glsl::to_unorm, glsl::encode_rg<16>, glsl::decode_rg<16>}),
         "vec4(umbrage_to_unorm(umbrage_encode_rg16(depth)), 0.0, 1.0)", "umbrage_decode_rg16(c.xy, 1.0)"},
        {"rg16, centre", us, us, ours({glsl::to_unorm, glsl::encode_rg<16>, glsl::decode_rg<16>}),
         "vec4(umbrage_to_unorm(umbrage_encode_rg16(depth)), 0.0, 1.0)", "umbrage_decode_rg16(c.xy, 0.5)"},
        {"rgb24", us, us, ours({glsl::to_unorm, glsl::encode_rgb24, glsl::decode_rgb24}),
         "vec4(umbrage_to_unorm(umbrage_encode_rgb24(depth)), 1.0)", "umbrage_decode_rgb24(c.xyz, 1.0)"},
        {"float bits", us, us, ours({glsl::to_unorm, glsl::encode_float_bits, glsl::decode_float_bits}),
         "umbrage_to_unorm(umbrage_encode_float_bits(depth))", "umbrage_decode_float_bits(c)"},
        {"RGBA", us, three, ours({glsl::write_threejs_rgba}) + peer("three"), "umbrage_write_threejs_rgba(depth)",
         "unpackRGBAToDepth(c)"},
        {"RGBA before r167, repaired", us, us,
         ours({glsl::to_unorm, glsl::encode_threejs_legacy_repaired, glsl::decode_threejs_legacy}),
         "umbrage_to_unorm(umbrage_encode_threejs_legacy_repaired(depth))", "umbrage_decode_threejs_legacy(c)"},
        {"base 255, repaired", us, babylon, ours({glsl::to_unorm, glsl::encode_base255_repaired}) + peer("babylon"),
         "umbrage_to_unorm(umbrage_encode_base255_repaired(depth)).wzyx", "unpack(c)"},
        {"base 255, repaired", us, us, ours({glsl::to_unorm, glsl::encode_base255_repaired, glsl::decode_base255}),
         "umbrage_to_unorm(umbrage_encode_base255_repaired(depth))", "umbrage_decode_base255(c)"},
        {"float bits", us, playcanvas, ours({glsl::to_unorm, glsl::encode_float_bits}) + peer("playcanvas"),
         "umbrage_to_unorm(umbrage_encode_float_bits(depth)).wzyx", "uint2float(c)"},
    };
}

/// Decoded depths of all inputs, in order.
struct result {
    double worst = 0.0;  ///< error of a depth below 1
    int breaks = 0;      ///< depths that decode below their predecessor
    float last = -INFINITY;
    int count = 0;

    void add(float decoded) {
        const double error = std::abs(decoded - double(count) / depths);
        if (count < depths && !(error <= worst)) worst = std::isnan(error) ? INFINITY : error;
        if (!(decoded >= last)) ++breaks;
        last = decoded;
        ++count;
    }
    [[nodiscard]] std::string bits() const {
        char text[32];
        std::snprintf(text, sizeof text, "%.2f", -std::log2(worst));
        return worst == 0.0 ? "exact" : worst >= 0.5 ? "lost" : text;
    }
    [[nodiscard]] std::string one() const {
        char text[32];
        std::snprintf(text, sizeof text, "%.9g", double(last));
        return text;
    }
};

/// The ways a codec is run: the host shader's precision, and the store.
struct way {
    std::string name, precision;
    bool truncates;
};
inline const way ways[] = {{"rounds", "highp", false}, {"truncates", "highp", true}, {"mediump", "mediump", false}};

inline const std::string vertex_shader = R"GLSL(#version 300 es
void main() {
    gl_Position = vec4(float(gl_VertexID / 2) * 4.0 - 1.0, float(gl_VertexID % 2) * 4.0 - 1.0, 0.0, 1.0);
}
)GLSL";

/// Writes a vec4 expression of `depth`, or of `c`, the texel in the same place.
inline std::string fragment_shader(const std::string& precision, const std::string& text,
                                   const std::string& expression) {
    return "#version 300 es\nprecision " + precision + " float;\nprecision " + precision + " int;\n" + text + R"GLSL(
uniform highp int first;
uniform highp sampler2D texels;
out highp vec4 result;
void main() {
    highp ivec2 at = ivec2(gl_FragCoord.xy);
    highp vec4 c = texelFetch(texels, at, 0);
    highp float depth = float(first + at.y * 4096 + at.x) * (1.0 / 16777216.0);
    result = )GLSL" +
           expression + ";\n}\n";
}
inline std::string encoder(const codec& c, const way& w) { return fragment_shader(w.precision, c.text, c.encode); }
inline std::string decoder(const codec& c, const way& w) {
    return fragment_shader(w.precision, c.text, "vec4(" + c.decode + ')');
}
inline const std::string truncating = fragment_shader("highp", "", "floor(clamp(c, 0.0, 1.0) * 255.0) / 255.0");

}  // namespace packing
