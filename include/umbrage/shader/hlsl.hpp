// SPDX-License-Identifier: MIT
//
// HLSL text of snippets, printed from their GLSL.
//
//     std::string shader = umbrage::hlsl::text({umbrage::glsl::pcf_2x2}) + my_main;
//     // float umbrage_pcf_2x2(Texture2D<float4> map, float2 size, float2 coord, float receiver)
//
// `precise` forbids fused and reordered sums within one function, so each function has its own. FXC honors it in shader
// model 5, DXC in all of its models, from 6.0 on. Older models of FXC need the option /Gis, for the whole shader.
//
#pragma once

#include <string>
#include <vector>

#include <umbrage/core/config.hpp>
#include <umbrage/light/point/cube_atlas.hpp>
#include <umbrage/shader/compose.hpp>
#include <umbrage/shader/translate/word_by_word.hpp>

namespace umbrage::hlsl {

namespace detail {

inline constexpr glsl::detail::near_language akin{.name = "hlsl",
                                                  .own = &glsl::detail::word::hlsl,
                                                  .precise = "precise",
                                                  .function = "",
                                                  .condition = "precise ",  // FXC turns a <= b into !(a > b) elsewhere
                                                  .matrices_have_rows = true,
                                                  .vectors_of_one_are_cast = true,
                                                  .reserved = " line linear matrix pass point sample triangle vector "};

[[nodiscard]] constexpr glsl::detail::texture_words reads(glsl::texture kind) {
    using enum glsl::texture;
    switch (kind) {
        case texture_2d:
            return {.parameters = "Texture2D<float4> map",
                    .arguments = "map",
                    .texel = "map.Load(int3(int2(at), 0))",
                    .sampled = "map.SampleLevel(map_sampler, uv, 0.0)",
                    .gather_red = "map.GatherRed(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)",
                    .gather_green = "map.GatherGreen(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)"};
        case depth:
            return {.parameters = "Texture2D<float> map",
                    .arguments = "map",
                    .texel = "(float4)map.Load(int3(int2(at), 0))",
                    .sampled = "(float4)map.SampleLevel(map_sampler, uv, 0.0)",
                    .gather_red = "map.Gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)"};
        case atlas:
            return {.parameters = "Texture2D<float4> map, float2 origin",
                    .arguments = "map, origin",
                    .texel = "map.Load(int3(int2(at), 0))",
                    .sampled = "map.SampleLevel(map_sampler, uv, 0.0)",
                    .gather_red = "map.GatherRed(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)",
                    .gather_green = "map.GatherGreen(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)"};
        case array:
            return {.parameters = "Texture2DArray<float4> map, float layer",
                    .arguments = "map, layer",
                    .texel = "map.Load(int4(int2(at), int(layer), 0))",
                    .sampled = "map.SampleLevel(map_sampler, float3(uv, layer), 0.0)",
                    .gather_red = "map.GatherRed(map_sampler, float3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer))",
                    .gather_green = "map.GatherGreen(map_sampler, float3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer))"};
        case depth_array:
            return {.parameters = "Texture2DArray<float> map, float layer",
                    .arguments = "map, layer",
                    .texel = "(float4)map.Load(int4(int2(at), int(layer), 0))",
                    .sampled = "(float4)map.SampleLevel(map_sampler, float3(uv, layer), 0.0)",
                    .gather_red = "map.Gather(map_sampler, float3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer))"};
        case cube:
            return {.parameters = "TextureCube<float4> map, SamplerState map_sampler, float face",
                    .arguments = "map, map_sampler, face",
                    .texel =
                        "map.SampleLevel(map_sampler, umbrage_cube_direction(face, (at + 0.5) / "
                        "UMBRAGE_TEXTURE_SIZE), 0.0)",
                    .needs = glsl::list<&glsl::cube_direction>};
        case cube_faces:
            return {.parameters = "TextureCube<float4> map, SamplerState map_sampler",
                    .arguments = "map, map_sampler",
                    .texel = "map.SampleLevel(map_sampler, umbrage_cube_atlas_direction(at, size.y * 0.5), 0.0)",
                    .needs = glsl::list<&glsl::cube_atlas_direction>};
        case integer:
            return {.parameters = "Texture2D<uint4> map",
                    .arguments = "map",
                    .texel = "float4(map.Load(int3(int2(at), 0)))"};
        case shadow:
            return {.parameters = "Texture2D<float> map, SamplerComparisonState map_sampler",
                    .arguments = "map, map_sampler",
                    .lit = "map.SampleCmpLevelZero(map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver)",
                    .gather_lit = "map.GatherCmp(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)",
                    .lit_filtered = "map.SampleCmpLevelZero(map_sampler, uv, receiver)"};
        case shadow_array:
            return {
                .parameters = "Texture2DArray<float> map, SamplerComparisonState map_sampler, float layer",
                .arguments = "map, map_sampler, layer",
                .lit =
                    "map.SampleCmpLevelZero(map_sampler, float3((at + 0.5) / UMBRAGE_TEXTURE_SIZE, layer), "
                    "receiver)",
                .gather_lit = "map.GatherCmp(map_sampler, float3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), receiver)",
                .lit_filtered = "map.SampleCmpLevelZero(map_sampler, float3(uv, layer), receiver)"};
    }
    return {};
}

[[nodiscard]] constexpr glsl::detail::texture_words texture(glsl::texture kind) {
    glsl::detail::texture_words words = reads(kind);
    if (words.gather_red.empty()) return words;
    words.sampler = ", SamplerState map_sampler";
    words.sampler_argument = ", map_sampler";
    return words;
}

template <class Use = umbrage::detail::on_use>
inline constexpr glsl::detail::language language{
    .prelude = "",
    .texture = texture,
    .translate =
        [](const glsl::snippet& s) {
            return glsl::detail::laid_out(glsl::detail::word_by_word<Use>(akin, s.source.str()).print());
        },
    .receiver_plane = "float2 receiver_slope, float3 receiver_at",
    .function = "hlsl::text",
    .declare = glsl::detail::hlsl_interface};

}  // namespace detail

/// Text to paste into any shader: the snippets, or results of bind(), and all they need, each once and guarded.
///
/// HLSL has no expression for the size of a texture. A map that is a region of one, and is gathered from or compared by
/// its sampler, needs the binding's texture_size.
///
/// @throws std::invalid_argument   a snippet or map that HLSL cannot express
template <class Use = umbrage::detail::on_use>
[[nodiscard]] std::string text(const std::vector<glsl::bound>& items) {
    return glsl::detail::compose<Use>(detail::language<Use>, items);
}

}  // namespace umbrage::hlsl
