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

/// Each entry's text has its own functions, under the same guards.
std::string without_guards(const std::string& text) {
    std::string undefined;
    const std::string define = "#define UMBRAGE_HAS_";
    for (auto at = text.find(define); at != text.npos; at = text.find(define, at + 1))
        undefined += "#undef " + text.substr(at + 8, text.find('\n', at) - at - 7);
    return text + undefined;
}

std::string function(const entry& e) {
    const call_snippet call(e, dialect::msl);
    const auto given = uniforms(e, dialect::msl);
    std::string body;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const std::string number = std::to_string(i);
        const auto& [type, name] = given[i];
        if (name.empty()) continue;
        body += i < max_inputs ? "    const float4 x" + number + "(x[" + number + "][0], x[" + number + "][1], x[" +
                                     number + "][2], x[" + number + "][3]);\n"
                               : "    const " + type + " " + name + "(units[" + number + "]);\n";
    }
    if (!e.maps.empty()) {
        const std::string& map = given[map_unit(0)].name;
        body += "    const float2 map_size = float2(" + map + ".get_width(), " + map + ".get_height())" +
                from_texture(e, dialect::msl) + ";\n";
    }
    return without_guards(with_mistake(umbrage::msl::text(call.items()))) +
           "void call(const float (*x)[4], const memory* units, float* result) {\n" + body +
           "    const float4 all = " + call.result() + ";\n    for (int i = 0; i < 4; ++i) result[i] = all[i];\n}\n";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    std::ofstream file(argv[1]);
    file << "#include <metal_stdlib>\n\n#include \"metal_text.hpp\"\n\nnamespace parity::metal_text {\nnamespace {\n";
    std::string list, mistakes;
    const auto write = [&](const entry& e, const std::string& name) {
        file << "\nnamespace " << name << " {\n" << function(e) << "}\n";
        return name + "::call";
    };
    for (const entry& e : entries()) {
        const std::string number = std::to_string(&e - entries().data());
        list += (e.runs_in(dialect::msl) ? write(e, "entry_" + number) : std::string("nullptr")) + ", ";
        for (const auto& [m, in] : {std::pair{mistake{"metal::floor", "metal::ceil"}, "encode_rg11"},
                                    {mistake{"as_type<uint>", "uint"}, "encode_float_bits"},
                                    {mistake{"metal::component::y", "metal::component::x"}, "pcf_2x2 (rg11, gathered)"},
                                    {mistake{"uint(face)", "0"}, "pcf_2x2 (cube)"}}) {
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
