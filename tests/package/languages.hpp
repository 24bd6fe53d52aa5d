// SPDX-License-Identifier: MIT
//
// The languages of shaders, and what the package calls things.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/depth/encodings.hpp>
#include <umbrage/shader/glsl.hpp>
#include <umbrage/shader/hlsl.hpp>
#include <umbrage/shader/msl.hpp>
#include <umbrage/shader/registry.hpp>
#include <umbrage/shader/wgsl.hpp>

namespace package {

namespace glsl = umbrage::glsl;

struct shader_language {
    std::string_view name, extension;
    const glsl::detail::language* words;
    std::string (*text)(const std::vector<glsl::bound>& items);
};

inline const std::array languages{
    shader_language{"glsl", ".glsl", &glsl::detail::glsl_language<>,
                    [](const std::vector<glsl::bound>& items) { return glsl::text(items); }},
    shader_language{"hlsl", ".hlsl", &umbrage::hlsl::detail::language<>, umbrage::hlsl::text<>},
    shader_language{"msl", ".metal", &umbrage::msl::detail::language<>, umbrage::msl::text<>},
    shader_language{"wgsl", ".wgsl", &umbrage::wgsl::detail::language<>, umbrage::wgsl::text<>},
};

struct named_texture {
    std::string_view name;
    glsl::texture kind;
};
inline constexpr std::array textures{
    named_texture{"texture_2d", glsl::texture::texture_2d}, named_texture{"atlas", glsl::texture::atlas},
    named_texture{"array", glsl::texture::array},           named_texture{"cube", glsl::texture::cube},
    named_texture{"cube_faces", glsl::texture::cube_faces}, named_texture{"integer", glsl::texture::integer},
    named_texture{"depth", glsl::texture::depth},           named_texture{"depth_array", glsl::texture::depth_array},
    named_texture{"shadow", glsl::texture::shadow},         named_texture{"shadow_array", glsl::texture::shadow_array}};

/// What a cleared map's channels are to a color attachment, four of them; of UNORM as "k / 255".
template <umbrage::known_encoding Encoding>
[[nodiscard]] std::array<std::string, 4> cleared_channels(const Encoding& encoding) {
    std::array<std::string, 4> channels{"0", "0", "0", "0"};
    using target = typename Encoding::target;
    const glm::vec4 values = target::load(encoding.cleared());
    if constexpr (Encoding::writes == umbrage::store_format::depth) channels[0] = values.x > 0.5f ? "1" : "0";
    else
        for (int c = 0; c < target::channels; ++c) {
            constexpr int most = (1 << target::bits) - 1;
            channels[c] = std::to_string(std::lround(values[c] * most)) + " / " + std::to_string(most);
        }
    return channels;
}

/// What an encoding's writer returns.
template <umbrage::known_encoding Encoding>
[[nodiscard]] constexpr std::string_view writes(const Encoding&) {
    switch (Encoding::writes) {
        case umbrage::store_format::depth: return "depth";
        case umbrage::store_format::integers: return "integers";
        case umbrage::store_format::values: return "values";
    }
    return "";
}

/// A string of JavaScript and of JSON.
[[nodiscard]] inline std::string literal(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (c == '\n') out += "\\n";
        else out += c;
    }
    return out + '"';
}

}  // namespace package
