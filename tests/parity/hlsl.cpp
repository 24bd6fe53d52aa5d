// SPDX-License-Identifier: MIT
//
// An entry's fragment or compute shader in HLSL.
#include <umbrage/shader/hlsl.hpp>

#include "shader.hpp"

namespace parity {

std::string make_hlsl(const entry& e, shader_stage of) {
    const call_snippet call(e, dialect::hlsl);
    const auto given = uniforms(e, dialect::hlsl);
    std::string text = umbrage::hlsl::text(call.items()) + '\n', values;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const auto& [type, name] = given[i];
        if (name.empty()) continue;
        const std::string kind = i < max_textures ? "t" : "s";
        text += type + " " + name + " : register(" + kind + std::to_string(i) + ");\n";
        if (i < max_inputs) values += "    float4 x" + std::to_string(i) + " = " + name + ".Load(at);\n";
    }
    if (e.visitor) text += e.visitor->text;
    if (!e.maps.empty()) {
        const uniform& map = given[map_unit(0)];
        const bool layers = map.type.find("Array") != map.type.npos;
        values += "    float3 size;\n    " + map.name + ".GetDimensions(size.x, size.y" + (layers ? ", size.z" : "") +
                  ");\n    float2 map_size = size.xy" + from_texture(e, dialect::hlsl) + ";\n";
    }
    if (of == shader_stage::compute)
        return text + "[[vk::image_format(\"" + format_of(e.output) + "\")]] RWTexture2D<float4> target : register(u" +
               std::to_string(target_binding) + ");\n\n[numthreads(" + std::to_string(group_width) +
               ", 1, 1)] void main(uint3 pixel : SV_DispatchThreadID) {\n    int3 at = int3(int2(pixel.xy), 0);\n" +
               values + "    target[pixel.xy] = " + call.result() + ";\n}\n";
    return text +
           "\nfloat4 main(float4 pixel : SV_Position) : SV_Target0 {\n"
           "    int3 at = int3(int2(pixel.xy), 0);\n" +
           values + "    return " + call.result() + ";\n}\n";
}

}  // namespace parity
