// SPDX-License-Identifier: MIT
//
// The languages in which these tests write functions. Bodies of HLSL and Metal are GLSL's, as macros name their types.
// vec2(x, y) is one in all of them.
#pragma once

#include <string>
#include <string_view>

#include "entry.hpp"

namespace check {

struct language {
    parity::dialect in;
    std::string_view file, preamble;

    [[nodiscard]] bool is_msl() const { return in == parity::dialect::msl; }
    [[nodiscard]] bool is_wgsl() const { return in == parity::dialect::wgsl; }
    /// 1 where the condition holds, else 0.
    [[nodiscard]] std::string one_if(std::string_view condition) const {
        return is_wgsl() ? "select(0.0, 1.0, " + std::string(condition) + ")" : std::string(condition) + " ? 1.0 : 0.0";
    }
};

inline const language glsl{parity::version::v330, "guest.frag", "#version 330\n"};
inline const language hlsl{parity::dialect::hlsl, "guest.hlsl",
                           "#define vec2 float2\n#define vec3 float3\n#define vec4 float4\n#define ivec2 int2\n"};
inline const language msl{parity::dialect::msl, "guest.metal",
                          "#include <metal_stdlib>\nusing namespace metal;\n"
                          "#define vec2 float2\n#define vec3 float3\n#define vec4 float4\n#define ivec2 int2\n"};
inline const language wgsl{parity::dialect::wgsl, "guest.wgsl", ""};

}  // namespace check
