// SPDX-License-Identifier: MIT
//
// WGSL text of snippets, printed from their GLSL.
//
//     std::string shader = umbrage::wgsl::text({umbrage::glsl::pcf_2x2}) + my_main;
//     // fn umbrage_pcf_2x2(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32
//
// GLSL's overloads, except the float's, have their type in the name: `umbrage_to_unorm_vec2f`.
//
#pragma once

#include <string>
#include <vector>

#include <umbrage/core/config.hpp>
#include <umbrage/light/point/cube_atlas.hpp>
#include <umbrage/shader/compose.hpp>
#include <umbrage/shader/translate/layout.hpp>
#include <umbrage/shader/translate/wgsl_function.hpp>

namespace umbrage::wgsl {

namespace detail {

[[nodiscard]] constexpr glsl::detail::texture_words reads(glsl::texture kind) {
    using glsl::texture;
    switch (kind) {
        case texture::texture_2d:
            return {.parameters = "map: texture_2d<f32>",
                    .arguments = "map",
                    .texel = "textureLoad(map, vec2i(at), 0)",
                    .sampled = "textureSampleLevel(map, map_sampler, uv, 0.0)",
                    .gather_red = "textureGather(0, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)",
                    .gather_green = "textureGather(1, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)"};
        case texture::depth:
            return {.parameters = "map: texture_depth_2d",
                    .arguments = "map",
                    .texel = "vec4f(textureLoad(map, vec2i(at), 0))",
                    .sampled = "vec4f(textureSampleLevel(map, map_sampler, uv, 0))",
                    .gather_red = "textureGather(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)"};
        case texture::atlas:
            return {.parameters = "map: texture_2d<f32>, origin: vec2f",
                    .arguments = "map, origin",
                    .texel = "textureLoad(map, vec2i(at), 0)",
                    .sampled = "textureSampleLevel(map, map_sampler, uv, 0.0)",
                    .gather_red = "textureGather(0, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)",
                    .gather_green = "textureGather(1, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)"};
        case texture::array:
            return {
                .parameters = "map: texture_2d_array<f32>, layer: f32",
                .arguments = "map, layer",
                .texel = "textureLoad(map, vec2i(at), i32(layer), 0)",
                .sampled = "textureSampleLevel(map, map_sampler, uv, i32(layer), 0.0)",
                .gather_red = "textureGather(0, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer))",
                .gather_green = "textureGather(1, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer))"};
        case texture::depth_array:
            return {.parameters = "map: texture_depth_2d_array, layer: f32",
                    .arguments = "map, layer",
                    .texel = "vec4f(textureLoad(map, vec2i(at), i32(layer), 0))",
                    .sampled = "vec4f(textureSampleLevel(map, map_sampler, uv, i32(layer), 0))",
                    .gather_red = "textureGather(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer))"};
        case texture::cube:
            return {.parameters = "map: texture_cube<f32>, map_sampler: sampler, face: f32",
                    .arguments = "map, map_sampler, face",
                    .texel =
                        "textureSampleLevel(map, map_sampler, umbrage_cube_direction(face, (at + 0.5) / "
                        "UMBRAGE_TEXTURE_SIZE), 0.0)",
                    .needs = glsl::list<&glsl::cube_direction>};
        case texture::cube_faces:
            return {
                .parameters = "map: texture_cube<f32>, map_sampler: sampler",
                .arguments = "map, map_sampler",
                .texel = "textureSampleLevel(map, map_sampler, umbrage_cube_atlas_direction(at, size.y * 0.5), 0.0)",
                .needs = glsl::list<&glsl::cube_atlas_direction>};
        case texture::integer:
            return {.parameters = "map: texture_2d<u32>",
                    .arguments = "map",
                    .texel = "vec4f(textureLoad(map, vec2i(at), 0))"};
        case texture::shadow:
            return {.parameters = "map: texture_depth_2d, map_sampler: sampler_comparison",
                    .arguments = "map, map_sampler",
                    .lit = "textureSampleCompareLevel(map, map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver)",
                    .gather_lit = "textureGatherCompare(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)",
                    .lit_filtered = "textureSampleCompareLevel(map, map_sampler, uv, receiver)"};
        case texture::shadow_array:
            return {.parameters = "map: texture_depth_2d_array, map_sampler: sampler_comparison, layer: f32",
                    .arguments = "map, map_sampler, layer",
                    .lit =
                        "textureSampleCompareLevel(map, map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, i32(layer), "
                        "receiver)",
                    .gather_lit =
                        "textureGatherCompare(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer), "
                        "receiver)",
                    .lit_filtered = "textureSampleCompareLevel(map, map_sampler, uv, i32(layer), receiver)"};
    }
    return {};
}

[[nodiscard]] constexpr glsl::detail::texture_words textures(glsl::texture kind) {
    glsl::detail::texture_words words = reads(kind);
    words.size = "vec2f(textureDimensions(map))";
    if (words.gather_red.empty()) return words;
    words.sampler = ", map_sampler: sampler";
    words.sampler_argument = ", map_sampler";
    return words;
}

template <class Use = umbrage::detail::on_use>
void declare(const glsl::snippet& s, signatures& functions) {
    for (const glsl::snippet* need : s.needs) declare(*need, functions);
    printer<Use>(s.source.str(), functions).declare();
}

template <class Use = umbrage::detail::on_use>
[[nodiscard]] std::string translate(const glsl::snippet& s) {
    signatures functions;
    declare<Use>(s, functions);
    return glsl::detail::laid_out(printer<Use>(s.source.str(), functions).print());
}

template <class Use = umbrage::detail::on_use>
inline constexpr glsl::detail::language language{.prelude = "",
                                                 .texture = textures,
                                                 .translate = translate<Use>,
                                                 .receiver_plane = "receiver_slope: vec2f, receiver_at: vec3f",
                                                 .may_reorder = "WGSL",
                                                 .preprocessor = false,
                                                 .function = "wgsl::text",
                                                 .declare = glsl::detail::wgsl_interface};

}  // namespace detail

/// Text to paste into any shader: the snippets, or results of bind(), and all they need, each function once.
/// @throws std::invalid_argument   a snippet or map that WGSL cannot express
template <class Use = umbrage::detail::on_use>
[[nodiscard]] std::string text(const std::vector<glsl::bound>& items) {
    return glsl::detail::compose<Use>(detail::language<Use>, items);
}

}  // namespace umbrage::wgsl
