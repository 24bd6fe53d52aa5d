// SPDX-License-Identifier: MIT
//
// GLSL text of snippets: functions to paste, or the beginning of a shader.
//
//     std::string shader = umbrage::glsl::source(umbrage::glsl::version::v330, {umbrage::glsl::pcf_2x2}) + my_main;
//
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/light/point/cube_atlas.hpp>
#include <umbrage/shader/compose.hpp>

namespace umbrage::glsl {

/// Macros that every text relies on. A shader can define each of them before.
inline constexpr std::string_view prelude = R"GLSL(
#ifndef UMBRAGE_HIGHP
#ifdef GL_ES
#define UMBRAGE_HIGHP highp
#else
#define UMBRAGE_HIGHP
#endif
#endif
#ifndef UMBRAGE_PRECISE
#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)
#define UMBRAGE_PRECISE precise
#else
#define UMBRAGE_PRECISE
#endif
#endif
)GLSL";

namespace detail {

[[nodiscard]] constexpr texture_words glsl_reads(texture kind) {
    switch (kind) {
        case texture::texture_2d:
        case texture::depth:
        case texture::atlas:
            return {.parameters = kind == texture::atlas ? "UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 origin"
                                                         : "UMBRAGE_HIGHP sampler2D map",
                    .arguments = kind == texture::atlas ? "map, origin" : "map",
                    .texel = R"GLSL(#if __VERSION__ >= 130
    return texelFetch(map, ivec2(at), 0);
#else
    return texture2D(map, (at + 0.5) / UMBRAGE_TEXTURE_SIZE);
#endif
)GLSL",
                    .sampled = "textureLod(map, uv, 0.0)",
                    .gather_red = "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 0)",
                    .gather_green = "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 1)"};
        case texture::array:
        case texture::depth_array:
            return {.parameters = "UMBRAGE_HIGHP sampler2DArray map, UMBRAGE_HIGHP float layer",
                    .arguments = "map, layer",
                    .texel = "texelFetch(map, ivec3(ivec2(at), int(layer)), 0)",
                    .sampled = "textureLod(map, vec3(uv, layer), 0.0)",
                    .gather_red = "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), 0)",
                    .gather_green = "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), 1)"};
        case texture::cube:
            return {.parameters = "UMBRAGE_HIGHP samplerCube map, UMBRAGE_HIGHP float face",
                    .arguments = "map, face",
                    .texel = R"GLSL(#if __VERSION__ >= 130
    return textureLod(map, umbrage_cube_direction(face, (at + 0.5) / UMBRAGE_TEXTURE_SIZE), 0.0);
#else
    return textureCube(map, umbrage_cube_direction(face, (at + 0.5) / UMBRAGE_TEXTURE_SIZE));
#endif
)GLSL",
                    .needs = list<&cube_direction>};
        case texture::cube_faces:
            return {.parameters = "UMBRAGE_HIGHP samplerCube map",
                    .arguments = "map",
                    .texel = R"GLSL(#if __VERSION__ >= 130
    return textureLod(map, umbrage_cube_atlas_direction(at, size.y * 0.5), 0.0);
#else
    return textureCube(map, umbrage_cube_atlas_direction(at, size.y * 0.5));
#endif
)GLSL",
                    .needs = list<&cube_atlas_direction>};
        case texture::integer:
            return {.parameters = "UMBRAGE_HIGHP usampler2D map",
                    .arguments = "map",
                    .texel = "vec4(texelFetch(map, ivec2(at), 0))"};
        case texture::shadow:
            return {.parameters = "UMBRAGE_HIGHP sampler2DShadow map",
                    .arguments = "map",
                    .lit = "textureLod(map, vec3((at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver), 0.0)",
                    .gather_lit = "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)",
                    .lit_filtered = "textureLod(map, vec3(uv, receiver), 0.0)"};
        case texture::shadow_array:
            return {.parameters = "UMBRAGE_HIGHP sampler2DArrayShadow map, UMBRAGE_HIGHP float layer",
                    .arguments = "map, layer",
                    .lit =
                        "textureGrad(map, vec4((at + 0.5) / UMBRAGE_TEXTURE_SIZE, layer, receiver), vec2(0.0, 0.0), "
                        "vec2(0.0, 0.0))",
                    .gather_lit = "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), receiver)",
                    .lit_filtered = "textureGrad(map, vec4(uv, layer, receiver), vec2(0.0, 0.0), vec2(0.0, 0.0))"};
    }
    return {};
}

[[nodiscard]] constexpr texture_words glsl_texture(texture kind) {
    texture_words words = glsl_reads(kind);
    words.size = "vec2(textureSize(map, 0))";
    return words;
}

template <class = umbrage::detail::on_use>
inline constexpr language glsl_language{
    .prelude = prelude,
    .texture = glsl_texture,
    .translate = [](const snippet& s) { return s.source.str(); },
    .receiver_plane = "UMBRAGE_HIGHP vec2 receiver_slope, UMBRAGE_HIGHP vec3 receiver_at",
    .may_reorder = "GLSL below 400 and 320 es"};

[[nodiscard]] constexpr bool is_es(version v) {
    return v == version::v100 || v == version::v300_es || v == version::v310_es || v == version::v320_es;
}

/// Value of __VERSION__.
[[nodiscard]] constexpr int number(version v) {
    int n = 0;
    for (const char c : directive(v).substr(0, 3)) n = n * 10 + (c - '0');
    return n;
}

[[nodiscard]] constexpr bool has_precise(version v) { return number(v) >= (is_es(v) ? 320 : 400); }

/// Prelude for a known dialect.
template <class = umbrage::detail::on_use>
[[nodiscard]] std::string known_prelude(version v) {
    return std::string("\n#ifndef UMBRAGE_HIGHP\n#define UMBRAGE_HIGHP") + (is_es(v) ? " highp" : "") +
           "\n#endif\n#ifndef UMBRAGE_PRECISE\n#define UMBRAGE_PRECISE" + (has_precise(v) ? " precise" : "") +
           "\n#endif\n";
}

/// Text with its `#if __VERSION__` resolved.
template <class = umbrage::detail::on_use>
[[nodiscard]] std::string resolved(std::string_view text, int number) {
    enum class branch { kept, taken, left_out };  // kept: with its directives
    const std::string_view condition = "#if __VERSION__ >= ";
    std::vector<branch> open;
    std::string out;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n') + 1);
        text.remove_prefix(line.size());
        bool shown = true;
        if (line.starts_with(condition)) {
            int least = 0;
            for (const char c : line.substr(condition.size(), 3)) least = least * 10 + (c - '0');
            open.push_back(number >= least ? branch::taken : branch::left_out);
            shown = false;
        } else if (line.starts_with("#if")) {
            open.push_back(branch::kept);
        } else if (line.starts_with("#else") && open.back() != branch::kept) {
            open.back() = open.back() == branch::taken ? branch::left_out : branch::taken;
            shown = false;
        } else if (line.starts_with("#endif")) {
            shown = open.back() == branch::kept;
            open.pop_back();
        }
        for (const branch b : open) shown = shown && b != branch::left_out;
        if (shown) out += line;
    }
    return out;
}

}  // namespace detail

/// True when the snippet bound to its map compiles in dialect `v`.
[[nodiscard]] inline bool supports(const bound& item, version v) {
    if (!supports(item.what, v)) return false;
    for (const snippet& need : item.map.needs)
        if (!supports(need, v)) return false;
    const bool gathers = v == version::v310_es || v == version::v320_es || v >= version::v430;
    if (item.map.gather) return gathers;
    const texture kind = item.map.texture;
    if (detail::has_region(item.map) && item.map.texture_size.empty() && v < version::v130) return false;
    return kind == texture::texture_2d || kind == texture::depth || kind == texture::atlas || detail::is_cube(kind) ||
           v >= version::v300_es;
}

/// Text to paste into any shader: the snippets and all they need, each once and guarded, without a `#version` line.
/// @param items   snippets, or results of bind(), in braces; {begin, end} for another container
/// @param v       dialect for which `#if __VERSION__` is resolved, for engines' preprocessors; none: text for any
///                dialect
/// @throws std::invalid_argument   a map that does not support what its snippet needs. Two maps of one name. A
///                                 dialect without what a snippet or a map needs
template <class Use = umbrage::detail::on_use>
[[nodiscard]] std::string text(const std::vector<bound>& items, std::optional<version> v = {}) {
    if (!v) return detail::compose<Use>(detail::glsl_language<Use>, items);
    for (const bound& item : items)
        if (!supports(item, *v))
            umbrage::detail::refuse("glsl::text", "version",
                                    "one that has " + std::string(item.what.name) + item.suffix,
                                    std::string(directive(*v)).c_str());
    const std::string known_prelude = detail::known_prelude<Use>(*v), name = "GLSL " + std::string(directive(*v));
    detail::language known = detail::glsl_language<Use>;
    known.prelude = known_prelude;
    known.declare = detail::glsl_interface;
    known.dialect = v;
    known.may_reorder = detail::has_precise(*v) ? std::string_view() : std::string_view(name);
    return detail::resolved<Use>(detail::compose<Use>(known, items), detail::number(*v));
}

/// Weakest tier in a text: of the snippets, all they need, and the hooks of the maps they are bound to. Texts of
/// a binding in the shader's own language have no tier.
/// @throws std::invalid_argument   as text
template <class Use = umbrage::detail::on_use>
[[nodiscard]] tier exactness(const std::vector<bound>& items) {
    return detail::composition<Use>(detail::glsl_language<Use>, items).worst().exactness;
}

/// Beginning of a shader: `#version`, `preamble` (extensions, macros, precision), the snippets and all they need.
///
/// Texts use `precise` from GLSL 400 and 320 es on. A preamble can enable it in older dialects:
///
///     #extension GL_EXT_gpu_shader5 : require
///     #define UMBRAGE_PRECISE precise
///
/// In 310 es the extension is GL_EXT_gpu_shader5 or GL_OES_gpu_shader5, in 150 and 330 GL_ARB_gpu_shader5. No text
/// enables an extension by itself. Some compilers, glslang among them, have GL_ARB_gpu_shader5 and reject `precise`.
///
/// @throws std::invalid_argument   as text
template <class Use = umbrage::detail::on_use>
[[nodiscard]] std::string source(version v, const std::vector<bound>& items, std::string_view preamble = {}) {
    std::string out = "#version ";
    out += directive(v);
    out += '\n';
    out += preamble;
    if (!preamble.empty() && preamble.back() != '\n') out += '\n';
    return out + text<Use>(items, v);
}

}  // namespace umbrage::glsl
