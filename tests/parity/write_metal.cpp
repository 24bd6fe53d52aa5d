// SPDX-License-Identifier: MIT
//
// Writes every entry's Metal, snippets and call, to be compiled as C++:  write_metal FILE
#include <fstream>
#include <iostream>
#include <utility>

#include <umbrage/shader/msl.hpp>

#include "shader.hpp"

namespace {

using namespace parity;

/// GLM has no swizzles.
entry without_swizzles(entry e) {
    const std::string swizzle = "value.xy";
    const auto at = e.map_kind.depth.find(swizzle);
    if (at != std::string::npos) e.map_kind.depth.replace(at, swizzle.size(), "float2(value.x, value.y)");
    return e;
}

/// Each entry's text has its own functions, under the same guards.
std::string without_guards(const std::string& text) {
    std::string undefined;
    const std::string define = "#define UMBRAGE_HAS_";
    for (auto at = text.find(define); at != text.npos; at = text.find(define, at + 1))
        undefined += "#undef " + text.substr(at + 8, text.find('\n', at) - at - 7);
    return text + undefined;
}

std::string function(const entry& e) {
    const call_snippet call(e);
    std::string body;
    const auto texture = [](const std::string& name) {
        return "    const metal::texture2d<float> " + name + "{" + name + "_.texels, " + name + "_.width, " + name +
               "_.height};\n";
    };
    for (int i = 0; i < max_inputs; ++i) {
        const std::string number = std::to_string(i);
        if (e.uses(i)) body += "    const float4 x" + number + " = x[" + number + "];\n";
    }
    if (!e.maps.empty()) body += texture("map") + "    const float2 map_size(map.get_width(), map.get_height());\n";
    if (!e.table.empty()) body += texture("table");
    return without_guards(with_mistake(umbrage::msl::text(call.items()))) +
           "float4 call(const float4* x, texture map_, texture table_) {\n" + body + "    return umbrage_call(" +
           call.arguments() + ");\n}\n";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    std::ofstream file(argv[1]);
    file << "#include <metal_stdlib>\n\n#include \"metal_text.hpp\"\n\nnamespace parity::metal_text {\nnamespace {\n";
    std::string list, mistakes;
    const auto write = [&](const entry& e, const std::string& name) {
        file << "\nnamespace " << name << " {\n" << function(without_swizzles(e)) << "}\n";
        return name + "::call";
    };
    for (const entry& e : entries()) {
        const std::string number = std::to_string(&e - entries().data());
        list += (e.runs_in(dialect::msl) ? write(e, "entry_" + number) : std::string("nullptr")) + ", ";
        for (const auto& [m, in] : {std::pair{mistake{"metal::floor", "metal::ceil"}, "encode_rg11"},
                                    {mistake{"as_type<uint>", "uint"}, "encode_float_bits"}}) {
            if (e.name() != in) continue;
            planted = m;
            mistakes += "{\"" + m.from + "\", " + number + ", " + write(e, "mistaken_" + number) + "}, ";
            planted = {};
        }
    }
    file << "\n}\n\nconst function functions[]{" << list << "nullptr};\nconst mistaken mistakes[]{" << mistakes
         << "{}};\n\n}\n";
    if (!file) {
        std::cerr << "write_metal: cannot write " << argv[1] << '\n';
        return 1;
    }
}
