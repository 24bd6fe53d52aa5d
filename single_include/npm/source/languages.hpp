// SPDX-License-Identifier: MIT
//
// The languages of shaders, what the package calls things, names in the order in which values.hpp counts, and clip
// spaces.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/filter/prefiltered/prefilters.hpp>
#include <umbrage/registry.hpp>
#include <umbrage/shader/glsl.hpp>
#include <umbrage/shader/hlsl.hpp>
#include <umbrage/shader/msl.hpp>
#include <umbrage/shader/wgsl.hpp>
#include <umbrage/shadow/lookup.hpp>

namespace package {

namespace glsl = umbrage::glsl;

struct shader_language {
    std::string_view name, title, extension;
    bool of_headers;  ///< its users include a header; those of the others paste functions
    const glsl::detail::language* words;
    std::string (*text)(const std::vector<glsl::bound>& items);
};

inline const std::array languages{
    shader_language{"glsl", "GLSL", ".glsl", false, &glsl::detail::glsl_language<>,
                    [](const std::vector<glsl::bound>& items) { return glsl::text(items); }},
    shader_language{"hlsl", "HLSL", ".hlsl", true, &umbrage::hlsl::detail::language<>, umbrage::hlsl::text<>},
    shader_language{"msl", "MSL", ".metal", true, &umbrage::msl::detail::language<>, umbrage::msl::text<>},
    shader_language{"wgsl", "WGSL", ".wgsl", false, &umbrage::wgsl::detail::language<>, umbrage::wgsl::text<>},
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

/// A light of a shadow: what the package calls it, its maps, and whether casters are clamped to its near plane.
struct kind_of_light {
    std::string_view name, maps;
    bool pancakes;
    std::string_view summary;
};
inline constexpr std::array kinds{
    kind_of_light{"spot_light", "one_map", false, "One map of a spot light."},
    kind_of_light{"directional_light", "parallel_map", true, "One map of a directional light."},
    kind_of_light{"cascades", "cascaded_maps", true, "One to four cascades of a directional light."},
    kind_of_light{"cascades_8", "cascaded_maps_8", true, "Five to eight cascades of a directional light."},
    kind_of_light{"point_light", "cube_maps", false, "Six maps around a point light."},
    kind_of_light{"tetrahedron_light", "tetrahedron_map", false, "Four maps around a point light in one square."},
    kind_of_light{"dual_paraboloid_light", "paraboloid_maps", false, "Two maps around a point light."},
    kind_of_light{"warped_cascades", "warped_maps", true,
                  "One to four cascades of a directional light, warped along the view (LiSPSM)."},
    kind_of_light{"adaptive_pages", "adaptive_maps", true,
                  "Up to 64 pages of a directional light's virtual shadow map (adaptive shadow map)."}};

/// A channel of a cleared map, value / most to a color attachment.
struct cleared_channel {
    long value = 0, most = 1;
};

/// Four channels of a cleared map.
template <umbrage::known_encoding Encoding>
[[nodiscard]] std::array<cleared_channel, 4> cleared_channels(const Encoding& encoding) {
    std::array<cleared_channel, 4> channels{};
    using target = typename Encoding::target;
    const glm::vec4 values = target::load(encoding.cleared());
    for (int c = 0; c < target::channels; ++c) {
        long most = 1;
        if constexpr (Encoding::writes != umbrage::store_format::depth) most = (1 << target::bits) - 1;
        channels[static_cast<std::size_t>(c)] = {std::lround(values[c] * static_cast<float>(most)), most};
    }
    return channels;
}

/// The render target of a prefiltered map.
template <class Prefilter>
[[nodiscard]] std::string format_of_moments() {
    constexpr std::string_view channels[]{"R", "RG", "RGB", "RGBA"};
    int count = 1;
    if constexpr (!std::is_same_v<typename Prefilter::texel, float>) count = Prefilter::texel::length();
    return std::string(channels[count - 1]) + (Prefilter::name == std::string_view("msm_unorm16") ? "16" : "32F");
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

inline std::string names_module() {
    std::string filters, encodings, of_kinds;
    const auto add = [](std::string& list, std::string_view name) {
        list += (list.empty() ? "" : ", ") + literal(name);
    };
    const auto filter = [&](const auto& f) {
        if constexpr (umbrage::shadow_filter<std::decay_t<decltype(f)>>) add(filters, f.snippet->name);
    };
    umbrage::filters::all::for_each(filter);
    umbrage::filters::soft::for_each(filter);
    umbrage::prefilters::all::for_each(filter);
    umbrage::for_each_encoding([&](const auto& e) { add(encodings, e.name); });
    for (const kind_of_light& kind : kinds) add(of_kinds, kind.name);
    return "export const kinds = [" + of_kinds + "];\nexport const filters = [" + filters +
           "];\nexport const encodings = [" + encodings + "];\n";
}

/// Calls use(name, value) for each clip space.
template <class Use>
void for_each_clip_space(const Use& use) {
    for (const umbrage::named_clip_space& each : umbrage::clip_spaces) use(each.name, each.value);
    use("cpu_clip_space", umbrage::cpu_clip_space);
}

inline std::string clip_spaces_module() {
    std::string out;
    for_each_clip_space([&](std::string_view name, const umbrage::clip_space& clip) {
        using namespace umbrage;
        out += "export const " + std::string(name) +
               " = { hand: " + literal(clip.hand == handedness::left ? "left" : "right") +
               ", range: " + literal(clip.range == depth_range::zero_to_one ? "zero_to_one" : "minus_one_to_one") +
               ", direction: " + literal(clip.direction == depth_direction::forward ? "forward" : "reversed") +
               ", origin: " + literal(clip.origin == texture_origin::top ? "top" : "bottom") +
               ", subpixel_bits: " + std::to_string(clip.subpixel_bits) + " };\n";
    });
    return out;
}

inline std::string types_of_clip_spaces() {
    std::string out;
    for_each_clip_space([&](std::string_view name, const umbrage::clip_space&) {
        out += "export const " + std::string(name) + ": ClipSpace;\n";
    });
    return out;
}

}  // namespace package
