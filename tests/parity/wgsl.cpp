// SPDX-License-Identifier: MIT
//
// An entry's fragment shader in WGSL.
#include <umbrage/shader/wgsl.hpp>

#include "shader.hpp"

namespace parity {

std::string make_wgsl(const entry& e) {
    const call_snippet call(e, dialect::wgsl);
    const auto given = uniforms(e, dialect::wgsl);
    std::string text = umbrage::wgsl::text(call.items()) + '\n', values;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const auto& [type, name] = given[i];
        if (name.empty()) continue;
        text += "@group(0) @binding(" + std::to_string(i) + ") var " + name + ": " + type + ";\n";
        if (i < max_inputs) values += "    let x" + std::to_string(i) + " = textureLoad(" + name + ", at, 0);\n";
    }
    if (e.visitor) text += e.visitor->text;
    if (!e.maps.empty())
        values += "    let map_size = vec2f(textureDimensions(" + given[map_unit(0)].name + "))" +
                  from_texture(e, dialect::wgsl) + ";\n";
    return text +
           "\n@fragment fn main(@builtin(position) pixel: vec4f) -> @location(0) vec4f {\n"
           "    let at = vec2i(pixel.xy);\n" +
           values + "    return " + call.result() + ";\n}\n";
}

}  // namespace parity
