// SPDX-License-Identifier: MIT
//
// An entry's fragment shader in HLSL.
#include <umbrage/shader/hlsl.hpp>

#include "shader.hpp"

namespace parity {

std::string make_hlsl(const entry& e) {
    const call_snippet call(e);
    const auto names = samplers(e);
    std::string text = umbrage::hlsl::text(call.items()) + '\n', values;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string& name = names[i].name;
        if (name.empty()) continue;
        text += "Texture2D<float4> " + name + " : register(t" + std::to_string(i) + ");\n";
        if (i < max_inputs) values += "    float4 x" + std::to_string(i) + " = " + name + ".Load(at);\n";
    }
    if (!e.maps.empty()) values += "    float2 map_size;\n    map.GetDimensions(map_size.x, map_size.y);\n";
    return text +
           "\nfloat4 main(float4 pixel : SV_Position) : SV_Target0 {\n"
           "    int3 at = int3(int2(pixel.xy), 0);\n" +
           values + "    return umbrage_call(" + call.arguments() + ");\n}\n";
}

}  // namespace parity
