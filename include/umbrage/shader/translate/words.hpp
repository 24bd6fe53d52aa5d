// SPDX-License-Identifier: MIT
//
// Vocabulary of snippets: the part of GLSL in which they are written, and its words in the other languages. Any other
// word of a text is a name that the text declares, or an error.
//
#pragma once

#include <string>
#include <string_view>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>

namespace umbrage::glsl::detail {

enum class word_kind { type, function, keyword };

struct word {
    word_kind kind;
    std::string_view glsl, hlsl, msl, wgsl;
};

/// Word that a map fills in, and the GLSL type of its value. Printers keep it, and for_map has its value for each map.
struct map_word {
    std::string_view word, type;
};
inline constexpr map_word map_words[]{
    {"UMBRAGE_TEXEL", "vec4"},      {"UMBRAGE_LIT_TEXEL", "float"},   {"UMBRAGE_LIT_FILTERED", "float"},
    {"UMBRAGE_GATHER_RED", "vec4"}, {"UMBRAGE_GATHER_GREEN", "vec4"}, {"UMBRAGE_GATHER_LIT", "vec4"},
    {"UMBRAGE_ORIGIN", "vec2"},     {"UMBRAGE_DEPTH", "float"},       {"UMBRAGE_REFERENCE", "float"},
    {"UMBRAGE_UV", "vec2"},         {"UMBRAGE_SAMPLED", "vec4"},      {"UMBRAGE_BORDER", "float"},
    {"UMBRAGE_COMPARE", "float"},   {"UMBRAGE_STORED", "float"},      {"UMBRAGE_CORNER", "float"}};

/// The word that a map fills in; nullptr for other words.
[[nodiscard]] constexpr const map_word* find_map_word(std::string_view text) {
    for (const map_word& w : map_words)
        if (w.word == text) return &w;
    return nullptr;
}

// clang-format off
inline constexpr word vocabulary[]{
    {word_kind::type, "float", "float", "float", "f32"},
    {word_kind::type, "int", "int", "int", "i32"},
    {word_kind::type, "uint", "uint", "uint", "u32"},
    {word_kind::type, "bool", "bool", "bool", "bool"},
    {word_kind::type, "vec2", "float2", "float2", "vec2f"},
    {word_kind::type, "vec3", "float3", "float3", "vec3f"},
    {word_kind::type, "vec4", "float4", "float4", "vec4f"},
    {word_kind::type, "ivec2", "int2", "int2", "vec2i"},
    {word_kind::type, "ivec3", "int3", "int3", "vec3i"},
    {word_kind::type, "ivec4", "int4", "int4", "vec4i"},
    {word_kind::type, "uvec2", "uint2", "uint2", "vec2u"},
    {word_kind::type, "uvec3", "uint3", "uint3", "vec3u"},
    {word_kind::type, "uvec4", "uint4", "uint4", "vec4u"},
    {word_kind::type, "mat3", "float3x3", "metal::float3x3", "mat3x3f"},
    {word_kind::type, "mat4", "float4x4", "metal::float4x4", "mat4x4f"},

    {word_kind::function, "abs", "abs", "metal::abs", "abs"},
    {word_kind::function, "ceil", "ceil", "metal::ceil", "ceil"},
    {word_kind::function, "clamp", "clamp", "metal::clamp", "clamp"},
    {word_kind::function, "cos", "cos", "metal::cos", "cos"},
    {word_kind::function, "cross", "cross", "metal::cross", "cross"},
    {word_kind::function, "dot", "dot", "metal::dot", "dot"},
    {word_kind::function, "exp", "exp", "metal::exp", "exp"},
    {word_kind::function, "exp2", "exp2", "metal::exp2", "exp2"},
    {word_kind::function, "floatBitsToInt", "asint", "as_type<int>", "bitcast<i32>"},
    {word_kind::function, "floatBitsToUint", "asuint", "as_type<uint>", "bitcast<u32>"},
    {word_kind::function, "floor", "floor", "metal::floor", "floor"},
    {word_kind::function, "fract", "frac", "metal::fract", "fract"},
    {word_kind::function, "intBitsToFloat", "asfloat", "as_type<float>", "bitcast<f32>"},
    {word_kind::function, "inversesqrt", "rsqrt", "metal::rsqrt", "inverseSqrt"},
    {word_kind::function, "length", "length", "metal::length", "length"},
    {word_kind::function, "log", "log", "metal::log", "log"},
    {word_kind::function, "log2", "log2", "metal::log2", "log2"},
    {word_kind::function, "max", "max", "metal::max", "max"},
    {word_kind::function, "min", "min", "metal::min", "min"},
    {word_kind::function, "mix", "lerp", "metal::mix", "mix"},
    {word_kind::function, "normalize", "normalize", "metal::normalize", "normalize"},
    {word_kind::function, "pow", "pow", "metal::pow", "pow"},
    {word_kind::function, "sign", "sign", "metal::sign", "sign"},
    {word_kind::function, "sin", "sin", "metal::sin", "sin"},
    {word_kind::function, "sqrt", "sqrt", "metal::sqrt", "sqrt"},
    {word_kind::function, "step", "step", "metal::step", "step"},
    {word_kind::function, "tan", "tan", "metal::tan", "tan"},
    {word_kind::function, "uintBitsToFloat", "asfloat", "as_type<float>", "bitcast<f32>"},

    {word_kind::keyword, "break", "break", "break", "break"},
    {word_kind::keyword, "continue", "continue", "continue", "continue"},
    {word_kind::keyword, "else", "else", "else", "else"},
    {word_kind::keyword, "false", "false", "false", "false"},
    {word_kind::keyword, "for", "for", "for", "for"},
    {word_kind::keyword, "if", "if", "if", "if"},
    {word_kind::keyword, "return", "return", "return", "return"},
    {word_kind::keyword, "true", "true", "true", "true"},
};
// clang-format on

/// Row of a GLSL word. nullptr if it is no such word, or none that snippets may use.
[[nodiscard]] inline const word* find_word(std::string_view glsl) {
    for (const word& w : vocabulary)
        if (w.glsl == glsl) return &w;
    return nullptr;
}

[[nodiscard]] inline bool is_type(std::string_view glsl) {
    const word* w = find_word(glsl);
    return w && w->kind == word_kind::type;
}

/// True for qualifiers of the snippets. A printer keeps or drops them.
[[nodiscard]] constexpr bool is_qualifier(std::string_view glsl) {
    return glsl == "UMBRAGE_HIGHP" || glsl == "UMBRAGE_PRECISE";
}

/// Refuses an unknown word.
/// @throws std::invalid_argument   always, with the word in its message
[[noreturn]] inline void unknown(std::string_view language, std::string_view word) {
    umbrage::detail::refuse(std::string(language) + "::text", "source", "of words that the language has", word);
}

}  // namespace umbrage::glsl::detail
