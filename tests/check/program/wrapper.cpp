// SPDX-License-Identifier: MIT
#include "wrapper.hpp"

#include <iomanip>
#include <sstream>

namespace check {

using parity::dialect;

bool reads_map(subject is) { return is == subject::filter || is == subject::bound; }

std::string begins(const guest_text& g, const std::string& name) {
    if (g.in != dialect::msl) return {};
    std::ostringstream line;
    line << "\n#line 1 " << std::quoted(name) << '\n';
    return line.str();
}

std::string wrapper(const guest_text& g) {
    const bool filter = reads_map(g.is);
    const std::string given = filter ? ", size" : "";
    switch (g.in.in) {
        case dialect::wgsl:
            return "\nfn umbrage_call(c: vec4f" + std::string(filter ? ", size: vec2f" : "") + ") -> vec4f {\n" +
                   (filter ? "    let coord = c.xy;\n    let uv = c.xy / size;\n    let z = c.z;\n"
                           : "    let z = c.x;\n") +
                   "    return vec4f(\n" + g.call + "\n    );\n}\n";
        case dialect::hlsl:
            return "\nfloat4 umbrage_call(float4 c" + std::string(filter ? ", float2 size" : "") + ") {\n" +
                   (filter ? "    float2 coord = c.xy, uv = c.xy / size;\n    float z = c.z;\n"
                           : "    float z = c.x;\n") +
                   "    float4 v = (\n" + g.call + "\n    );\n    return v;\n}\n";
        case dialect::msl:
            return "\nfloat4 umbrage_call(float4 c, const parity::metal_text::memory* maps) {\n" +
                   std::string(filter ? "    const metal::texture2d<float> map(maps[0]), linear_map(maps[1]);\n"
                                        "    const metal::depth2d<float> shadow_map(maps[2]);\n"
                                        "    const metal::sampler map_sampler(maps[0]), linear_map_sampler(maps[1]), "
                                        "shadow_map_sampler(maps[2]);\n"
                                        "    const float2 size(map.get_width(), map.get_height());\n"
                                        "    const float2 coord = c.xy, uv = coord / size;\n    const float z = c.z;\n"
                                      : "    const float z = c.x;\n") +
                   "    return float4(\n" + begins(g, "the call") + g.call + "\n    );\n}\n";
        default:
            return "\nUMBRAGE_HIGHP vec4 umbrage_call(UMBRAGE_HIGHP vec4 c" +
                   std::string(filter ? ", UMBRAGE_HIGHP vec2 size" : "") + ") {\n" +
                   (filter ? "    UMBRAGE_HIGHP vec2 coord = c.xy;\n    UMBRAGE_HIGHP vec2 uv = c.xy / size;\n"
                             "    UMBRAGE_HIGHP float z = c.z;\n"
                           : "    UMBRAGE_HIGHP float z = c.x;\n") +
                   "    return vec4(\n" + g.call + "\n    );\n}\n";
    }
}

}  // namespace check
