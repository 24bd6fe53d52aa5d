// SPDX-License-Identifier: MIT
//
// Writes the text of every entry, snippets and call, as C++:  write_cpp FILE
//
// A float becomes a `glsl_float`, which cpp_text.hpp chooses. __VERSION__ and `precise` are GLSL's own, as are the
// swizzles of what stored_as() makes. All else is for cpp_text.hpp.
#include <algorithm>
#include <cctype>
#include <fstream>
#include <iostream>
#include <set>

#include "shader.hpp"

namespace {

bool word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; }

/// A number with a point or an exponent; 0x1E3 has neither.
bool is_float(const std::string& token) {
    const bool number = std::isdigit(static_cast<unsigned char>(token[0])) ||
                        (token[0] == '.' && token.size() > 1 && std::isdigit(static_cast<unsigned char>(token[1])));
    const bool hexadecimal = token.size() > 1 && std::tolower(static_cast<unsigned char>(token[1])) == 'x';
    return number && !hexadecimal && token.find_first_of(".eE") != std::string::npos;
}

std::string as_cpp(const std::string& glsl) {
    std::string out;
    for (std::size_t i = 0; i < glsl.size();) {
        if (glsl.compare(i, 2, "//") == 0) {
            i = std::min(glsl.find('\n', i), glsl.size());
            continue;
        }
        if (!word(glsl[i])) {
            out += glsl[i++];
            continue;
        }
        std::string token;
        const bool number = std::isdigit(static_cast<unsigned char>(glsl[i])) || glsl[i] == '.';
        while (i < glsl.size() && (word(glsl[i]) || (number && (glsl[i] == '+' || glsl[i] == '-') &&
                                                     (token.back() == 'e' || token.back() == 'E'))))
            token += glsl[i++];
        if (token == "value.xy" || token == "value.xyz") token = "vec" + std::to_string(token.size() - 6) + "(value)";
        out += token == "__VERSION__" ? "460"
               : token == "precise"   ? ""
               : token == "float"     ? "glsl_float"
               : is_float(token)      ? "glsl_float(" + token + "f)"
                                      : token;
    }
    return out;
}

std::set<std::string> macros(const std::string& text) {
    std::set<std::string> names;
    const std::string define = "#define ";
    for (std::size_t at = text.find(define); at != std::string::npos; at = text.find(define, at)) {
        at += define.size();
        std::size_t end = at;
        while (word(text[end])) ++end;
        names.insert(text.substr(at, end - at));
    }
    return names;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    std::ofstream file(argv[1]);
    file << "#include \"backends/cpp_text.hpp\"\n\nnamespace parity::PARITY_TEXT {\nnamespace {\n";
    std::size_t count = 0;
    for (const parity::entry& e : parity::entries()) {
        const parity::call_snippet call(e, parity::dialect::glsl);
        const std::string text = e.preamble + umbrage::glsl::text(call.items());
        file << "\nnamespace entry_" << count++ << " {\n"
             << as_cpp(text) << "\nvec4 call(const sample& s, const filled_texture* const* t) {\n";
        for (int i = 0; i < parity::max_inputs; ++i)
            if (e.uses(i)) file << "    const vec4 x" << i << " = given(s.x[" << i << "]);\n";
        const auto uniforms = parity::uniforms(e);
        for (std::size_t unit = parity::max_inputs; unit < uniforms.size(); ++unit)
            if (!uniforms[unit].name.empty())
                file << "    const " << uniforms[unit].type << ' ' << uniforms[unit].name << "{t[" << unit << "]};\n";
        if (!e.maps.empty()) file << "    const vec2 map_size = " << as_cpp(parity::map_size(e)) << ";\n";
        file << "    return " << as_cpp(call.result()) << ";\n}\n";
        for (const std::string& name : macros(text)) file << "#undef " << name << '\n';
        file << "}\n";
    }
    file << "\n}\n\nconst std::vector<function> functions{";
    for (std::size_t i = 0; i < count; ++i) file << (i ? ", " : "") << "entry_" << i << "::call";
    file << "};\n\n}\n";
    if (!file) {
        std::cerr << "write_cpp: cannot write " << argv[1] << '\n';
        return 1;
    }
}
