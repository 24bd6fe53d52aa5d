// SPDX-License-Identifier: MIT
//
// Metal Shading Language text of snippets, printed from their GLSL.
//
//     std::string shader = umbrage::msl::text({umbrage::glsl::pcf_2x2}) + my_main;
//     // inline float umbrage_pcf_2x2(metal::texture2d<float> map, float2 size, float2 coord, float receiver)
//
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <umbrage/core/config.hpp>
#include <umbrage/light/point/cube_atlas.hpp>
#include <umbrage/shader/compose.hpp>
#include <umbrage/shader/translate/word_by_word.hpp>

namespace umbrage::msl {

/// First lines of every text. They turn off Metal's fast math, which is its default, to the end of the file. Safe math
/// still fuses a * b + c within a statement, which the second pragma forbids.
///
/// Both pragmas need the compiler of Metal 3.2: Xcode 16, macOS 15, iOS 18. Older ones need options for the whole
/// library: -fno-fast-math and -ffp-contract=off offline, fastMathEnabled = NO at run time. The last may still fuse.
inline constexpr std::string_view prelude =
    "\n#include <metal_stdlib>\n"  // not on its own line, which the single header would take for C++'s
    "#pragma METAL fp math_mode(safe)\n"
    "#pragma METAL fp contract(off)\n";

namespace detail {

inline constexpr glsl::detail::near_language akin{.name = "msl",
                                                  .own = &glsl::detail::word::msl,
                                                  .precise = "",
                                                  .function = "inline ",
                                                  .condition = "",
                                                  .matrices_have_rows = false,
                                                  .vectors_of_one_are_cast = false,
                                                  .reserved =
                                                      " as_type char constant device fragment half kernel long metal "
                                                      "object sampler short thread uchar ushort vertex "};

[[nodiscard]] constexpr glsl::detail::texture_words reads(glsl::texture kind) {
    using enum glsl::texture;
    switch (kind) {
        case texture_2d:
            return {.parameters = "metal::texture2d<float> map",
                    .arguments = "map",
                    .texel = "map.read(uint2(at))",
                    .sampled = "map.sample(map_sampler, uv, metal::level(0.0))",
                    .gather_red = "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)",
                    .gather_green =
                        "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, int2(0), metal::component::y)"};
        case depth:
            return {.parameters = "metal::depth2d<float> map",
                    .arguments = "map",
                    .texel = "float4(map.read(uint2(at)))",
                    .sampled = "float4(map.sample(map_sampler, uv, metal::level(0.0)))",
                    .gather_red = "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)"};
        case atlas:
            return {.parameters = "metal::texture2d<float> map, float2 origin",
                    .arguments = "map, origin",
                    .texel = "map.read(uint2(at))",
                    .sampled = "map.sample(map_sampler, uv, metal::level(0.0))",
                    .gather_red = "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)",
                    .gather_green =
                        "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, int2(0), metal::component::y)"};
        case array:
            return {.parameters = "metal::texture2d_array<float> map, float layer",
                    .arguments = "map, layer",
                    .texel = "map.read(uint2(at), uint(layer))",
                    .sampled = "map.sample(map_sampler, uv, uint(layer), metal::level(0.0))",
                    .gather_red = "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer))",
                    .gather_green =
                        "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer), int2(0), "
                        "metal::component::y)"};
        case depth_array:
            return {.parameters = "metal::depth2d_array<float> map, float layer",
                    .arguments = "map, layer",
                    .texel = "float4(map.read(uint2(at), uint(layer)))",
                    .sampled = "float4(map.sample(map_sampler, uv, uint(layer), metal::level(0.0)))",
                    .gather_red = "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer))"};
        case cube:
            return {.parameters = "metal::texturecube<float> map, float face",
                    .arguments = "map, face",
                    .texel = "map.read(uint2(at), uint(face))"};
        case cube_faces:
            return {.parameters = "metal::texturecube<float> map",
                    .arguments = "map",
                    .texel =
                        "map.read(uint2(umbrage_cube_atlas_texel(at, size.y * 0.5).x, "
                        "umbrage_cube_atlas_texel(at, size.y * 0.5).y), "
                        "uint(umbrage_cube_atlas_texel(at, size.y * 0.5).z))",
                    .needs = glsl::list<&glsl::cube_atlas_texel>};
        case integer:
            return {
                .parameters = "metal::texture2d<uint> map", .arguments = "map", .texel = "float4(map.read(uint2(at)))"};
        case shadow:
            return {
                .parameters = "metal::depth2d<float> map, metal::sampler map_sampler",
                .arguments = "map, map_sampler",
                .lit =
                    "map.sample_compare(map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver, metal::level(0.0))",
                .gather_lit = "map.gather_compare(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)",
                .lit_filtered = "map.sample_compare(map_sampler, uv, receiver, metal::level(0.0))"};
        case shadow_array:
            return {.parameters = "metal::depth2d_array<float> map, metal::sampler map_sampler, float layer",
                    .arguments = "map, map_sampler, layer",
                    .lit =
                        "map.sample_compare(map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, uint(layer), receiver, "
                        "metal::level(0.0))",
                    .gather_lit =
                        "map.gather_compare(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer), receiver)",
                    .lit_filtered = "map.sample_compare(map_sampler, uv, uint(layer), receiver, metal::level(0.0))"};
    }
    return {};
}

[[nodiscard]] constexpr glsl::detail::texture_words texture(glsl::texture kind) {
    glsl::detail::texture_words words = reads(kind);
    words.size = "float2(map.get_width(), map.get_height())";
    if (words.gather_red.empty()) return words;
    words.sampler = ", metal::sampler map_sampler";
    words.sampler_argument = ", map_sampler";
    return words;
}

template <class Use = umbrage::detail::on_use>
inline constexpr glsl::detail::language language{
    .prelude = prelude,
    .texture = texture,
    .translate =
        [](const glsl::snippet& s) {
            return glsl::detail::laid_out(glsl::detail::word_by_word<Use>(akin, s.source.str()).print());
        },
    .receiver_plane = "float2 receiver_slope, float3 receiver_at",
    .function = "msl::text",
    .declare = glsl::detail::msl_interface};

}  // namespace detail

/// Text to paste into any shader: the snippets, or results of bind(), and all they need, each once and guarded.
/// @throws std::invalid_argument   a snippet or map that Metal cannot express
template <class Use = umbrage::detail::on_use>
[[nodiscard]] std::string text(const std::vector<glsl::bound>& items) {
    return glsl::detail::compose<Use>(detail::language<Use>, items);
}

}  // namespace umbrage::msl
