// SPDX-License-Identifier: MIT
//
// Types of GLSL expressions, by GLSL's names: "vec3", "uint", "mat4". "float[4]" is an array.
//
#pragma once

#include <string>
#include <string_view>

#include <umbrage/core/config.hpp>
#include <umbrage/shader/translate/words.hpp>

namespace umbrage::glsl::detail {

/// Number of components of a vector, or of a matrix's column; 1 for scalars.
[[nodiscard]] constexpr int width_of(std::string_view type) {
    const char last = type.back();
    return last >= '2' && last <= '4' ? last - '0' : 1;
}

[[nodiscard]] constexpr bool is_matrix(std::string_view type) { return type.starts_with("mat"); }

[[nodiscard]] constexpr std::string_view component_of(std::string_view type) {
    if (width_of(type) == 1) return type;
    return type[0] == 'i' ? "int" : type[0] == 'u' ? "uint" : "float";
}

[[nodiscard]] inline std::string vector_of(std::string_view component, int width) {
    if (width == 1) return std::string(component);
    const std::string prefix = component == "int" ? "i" : component == "uint" ? "u" : "";
    return prefix + "vec" + std::to_string(width);
}

/// Type of `all[i]`: an array's element, a matrix's column, a vector's component.
[[nodiscard]] inline std::string element_of(std::string_view type) {
    if (type.ends_with(']')) return std::string(type.substr(0, type.find('[')));
    if (is_matrix(type)) return vector_of("float", width_of(type));
    return std::string(component_of(type));
}

/// Type of `a op b` with an arithmetic or bitwise sign. Empty where GLSL has none, or only by an implicit conversion.
[[nodiscard]] inline std::string type_of_product(std::string_view a, std::string_view op, std::string_view b) {
    if (op == "<<" || op == ">>") return std::string(a);
    if (op == "*" && is_matrix(a) && !is_matrix(b) && width_of(a) == width_of(b)) return std::string(b);
    if (op == "*" && is_matrix(b) && !is_matrix(a) && width_of(a) == width_of(b)) return std::string(a);
    if (a == b) return std::string(a);
    if (b == element_of(a) && !is_matrix(a)) return std::string(a);
    if (a == element_of(b) && !is_matrix(b)) return std::string(b);
    if (op == "*" && is_matrix(a) && b == "float") return std::string(a);
    if (op == "*" && is_matrix(b) && a == "float") return std::string(b);
    return {};
}

[[nodiscard]] inline std::string type_of_number(std::string_view digits) {
    const bool hexadecimal = digits.starts_with("0x");
    if (digits.ends_with('u')) return "uint";
    return !hexadecimal && digits.find_first_of(".eEf") != digits.npos ? "float" : "int";
}

}  // namespace umbrage::glsl::detail
