// SPDX-License-Identifier: MIT
//
// An entry's fragment shader in WGSL.
#include <umbrage/shader/wgsl.hpp>

#include "shader.hpp"

namespace parity {

std::string make_wgsl(const entry& e) {
    const call_snippet call(e);
    const auto names = samplers(e);
    std::string text = umbrage::wgsl::text(call.items()) + '\n', values;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string& name = names[i].name;
        if (name.empty()) continue;
        text += "@group(0) @binding(" + std::to_string(i) + ") var " + name + ": texture_2d<f32>;\n";
        if (i < max_inputs) values += "    let x" + std::to_string(i) + " = textureLoad(" + name + ", at, 0);\n";
    }
    if (!e.maps.empty()) values += "    let map_size = vec2f(textureDimensions(map));\n";
    return text +
           "\n@fragment fn main(@builtin(position) pixel: vec4f) -> @location(0) vec4f {\n"
           "    let at = vec2i(pixel.xy);\n" +
           values + "    return umbrage_call(" + call.arguments() + ");\n}\n";
}

}  // namespace parity
