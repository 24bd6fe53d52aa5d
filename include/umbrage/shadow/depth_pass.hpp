// SPDX-License-Identifier: MIT
//
// Shader functions for a shadow's depth pass: vertices in clip space, and the texels of packed depths or moments.
//
//     std::string vertex = source(version::v330, {bind_vertex_pass(lamp, "lamp")});
//     // gl_Position = umbrage_vertex_lamp(to_clip, world, anchor), with a view of lamp.depth_views()
//     std::string fragment = source(version::v330, {bind_depth_pass(lamp, "lamp")});
//     // color = umbrage_write_lamp(gl_FragCoord.z)
//
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/light/pancake.hpp>
#include <umbrage/shader/bind.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/shadow.hpp>

namespace umbrage::glsl {

namespace detail {

/// Number of a texel's channels.
template <class Texel>
inline constexpr int channels_of = 1;
template <glm::length_t Channels>
inline constexpr int channels_of<glm::vec<Channels, float>> = Channels;

/// Text of umbrage_write: the texel of a depth, as a color.
/// @param stores      to_unorm of the target; nullptr for a writer that returns the values to write
/// @param arguments   arguments of the writer after the depth, in terms of filter_terms
[[nodiscard]] inline own_text write_text(const snippet& writer, const snippet* stores, int channels,
                                         std::string_view arguments) {
    std::string texel = "umbrage_" + std::string(writer.name) + "(depth" + std::string(arguments) + ")";
    if (stores != nullptr) texel = "umbrage_" + std::string(stores->name) + "(" + texel + ")";
    std::string color = channels == 1 ? "texel" : "texel.x, texel.y";
    if (channels > 2) color += channels == 3 ? ", texel.z" : ", texel.z, texel.w";
    for (int c = channels; c < 4; ++c) color += ", 0.0";
    const std::string type = channels == 1 ? "float" : "vec" + std::to_string(channels);
    own_text write{"write",
                   "\n// umbrage_write: what the depth pass writes of a depth, 0.0 to 1.0, into a color target\n"
                   "UMBRAGE_HIGHP vec4 umbrage_write(UMBRAGE_HIGHP float depth" +
                       std::string(arguments.empty() ? "" : ", UMBRAGE_HIGHP vec4 filter_terms") +
                       ") {\n    UMBRAGE_HIGHP " + type + " texel = " + texel + ";\n    return vec4(" + color +
                       ");\n}\n"};
    write.needs = {&cleared_depth, &writer};  // cleared_depth makes the text this map's own
    if (stores != nullptr) write.needs.push_back(stores);
    return write;
}

/// Text of umbrage_write for a prefilter's texel. The writer to_optimized_moments takes the moments of encode_msm.
template <prefilter Prefilter>
[[nodiscard]] own_text write_moments_text() {
    const bool of_moments = Prefilter::writer == &to_optimized_moments;
    return write_text(of_moments ? encode_msm : *Prefilter::writer, of_moments ? Prefilter::writer : nullptr,
                      channels_of<typename Prefilter::texel>,
                      umbrage::detail::numbers_text<Prefilter>(Prefilter::writer_numbers));
}

/// Text of umbrage_vertex: a vertex in clip space.
[[nodiscard]] inline own_text vertex_text(std::string_view parameters, std::string_view statements,
                                          std::vector<const snippet*> needs) {
    std::string source =
        "\n// umbrage_vertex: clip space position of a vertex of the depth pass\n"
        "UMBRAGE_HIGHP vec4 umbrage_vertex(UMBRAGE_HIGHP mat4 to_clip, UMBRAGE_HIGHP vec3 world";
    source.append(parameters).append(") {\n").append(statements).append("}\n");
    needs.push_back(&cleared_depth);  // makes the text this map's own
    return {"vertex", std::move(source), std::move(needs)};
}

/// Vertex function of a setup with a vertex_function of its own.
template <class Setup>
[[nodiscard]] own_text vertex_text_of() {
    std::string parameters, arguments;
    for (const auto& a : bends_of<Setup>.vertex->arguments) {
        const std::string type = a.components == 1 ? "float " : "vec" + std::to_string(a.components) + ' ';
        parameters.append(", UMBRAGE_HIGHP ").append(type).append(a.name);
        arguments.append(", ").append(a.name);
    }
    const snippet& calls = *bends_of<Setup>.vertex->calls;
    return vertex_text(
        parameters, "    return umbrage_" + std::string(calls.name) + "(to_clip, world" + arguments + ");\n", {&calls});
}

/// Vertex function of other setups: a product with the light's matrix.
/// @param pancakes   true for casters clamped to the near plane
/// @param at_near    depth of the near plane in clip space
[[nodiscard]] inline own_text vertex_text_of_lights(bool pancakes, std::string_view at_near) {
    std::string place = "umbrage_anchored_vertex(to_clip, world, anchor)";
    if (pancakes) place = "umbrage_pancake(" + place + ", " + std::string(at_near) + ")";
    return vertex_text(", UMBRAGE_HIGHP vec4 anchor", "    return " + place + ";\n", {&anchored_vertex, &pancake});
}

}  // namespace detail

/// Function for the texel that a depth pass writes into a color target: umbrage_write_<name>(depth), with the depth
/// buffer's depth. ESM and EVSM take exponents from the block: umbrage_write_<name>(depth, filter_terms).
///
/// The target has the encoding's format, without sRGB and without blending. Clear it to cleared(). A depth texture
/// needs no such function.
/// @param of      the shadow
/// @param name    letters, digits, single underscores between them
/// @throws std::invalid_argument   an empty name, or one of other characters
template <class Setup, class Filter, class Encoding>
[[nodiscard]] bound bind_depth_pass(const shadow<Setup, Filter, Encoding>& of, std::string_view name) {
    umbrage::detail::require(!name.empty() && detail::is_part_of_identifier(name), "glsl::bind_depth_pass", "name",
                             "letters, digits and single underscores between them", name);
    bound item(snippet{.name = "write", .source = ""}, name, {.direction = of.encoding().direction});
    if constexpr (prefilter<Filter>) item.texts = {detail::write_moments_text<Filter>()};
    else {
        const snippet* const stores = Encoding::writes == store_format::integers ? Encoding::target::to_unorm : nullptr;
        item.texts = {detail::write_text(*Encoding::writer, stores, Encoding::target::channels, "")};
    }
    return item;
}

/// Function for the vertices of a depth pass in clip space: umbrage_vertex_<name>(to_clip, world, anchor).
///
/// to_clip and anchor are those of one of depth_views(). A receiver's bias covers what this function rounds. A matrix
/// of your own, projection * view in float, loses more: 2^-21 of the light's distance from the origin of positions.
/// Directional lights, warped ones too, clamp casters to the near plane (pancaking), for APIs and hardware without
/// depth clamp. Dual paraboloids also take the number of the half, and need a tessellated mesh.
/// @param of      the shadow
/// @param name    letters, digits, single underscores between them
/// @throws std::invalid_argument   an empty name, or one of other characters
/// @exactness     B, n = 20; dual paraboloids C
template <class Setup, class Filter, class Encoding>
[[nodiscard]] bound bind_vertex_pass(const shadow<Setup, Filter, Encoding>& of, std::string_view name) {
    umbrage::detail::require(!name.empty() && detail::is_part_of_identifier(name), "glsl::bind_vertex_pass", "name",
                             "letters, digits and single underscores between them", name);
    bound item(snippet{.name = "vertex", .source = ""}, name, {.direction = of.encoding().direction});
    if constexpr (has_bent_lines<Setup>) item.texts = {detail::vertex_text_of<Setup>()};
    else {
        const light_space<double> light = of.setup().lights().front();
        const int at_near = static_cast<int>(near_depth(light.clip));
        item.texts = {
            detail::vertex_text_of_lights(umbrage::detail::has_parallel_rays(light), std::to_string(at_near) + ".0")};
    }
    return item;
}

}  // namespace umbrage::glsl
