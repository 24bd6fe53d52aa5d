// SPDX-License-Identifier: MIT
//
// Shadow in a shader, in any language: its uniform block, its map and one function.
//
//     using namespace umbrage::glsl;
//     std::string shader = source(version::v330, {bind(sun, "sun"), bind(lamp, "lamp", {.block = 3, .texture = 4})});
//     // ... float visibility = umbrage_sun(world, normal) * umbrage_lamp(world, normal);
//     auto bytes = sun.uniforms();  // what the block holds: copy sizeof bytes into its buffer
//
// hlsl::text, wgsl::text and msl::text take the same items. In Metal the function's first arguments are the block, the
// map and the sampler.
//
// `bind(sun, "sun", {.map = texture::shadow, .linear = true})` takes a comparison sampler that filters linearly, and
// fewer fetches: 4 for a `tent<3>`. It is tier C. Each fetch compares four texels with the plane's depth where they
// meet. Its bias has half a texel more of slope. Without `linear` the sampler may filter either way.
//
// `bind(sun, "sun", {.gather = true})` reads four texels at once, with the same bits. The 16 texels of `tent<3>` take 4
// gathers. GLSL has gathers from 430 and 310 es on. HLSL, WGSL and Metal then declare a sampler too.
//
// `bind(sun, "sun", {.derivatives = true})` takes no normal: `umbrage_sun(world)` has the triangle's own from the
// derivatives of world on the screen. Call it in a fragment shader, outside all branches. WGSL refuses it elsewhere;
// other languages leave the derivatives undefined there. GLSL 100 needs GL_OES_standard_derivatives.
//
// `bind(sun, "sun", {.debug = true})` adds two functions for a shadow that is missing. The colors of
// `umbrage_probe_sun(world, normal)` show the reason (probe.hpp). `umbrage_calibrate_sun(number)` reports how the host
// reads its map (calibration.hpp).
//
// See also: depth_pass.hpp, for the functions of the depth pass.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/shader/bind.hpp>
#include <umbrage/shader/interface.hpp>
#include <umbrage/shadow/calibration.hpp>
#include <umbrage/shadow/frame.hpp>
#include <umbrage/shadow/probe.hpp>
#include <umbrage/shadow/shadow.hpp>

namespace umbrage::glsl {

/// Bindings of a shadow in a shader, and the type of its texture. Each shadow of a text has its own, where the language
/// and version write them.
struct shadow_slots {
    int block = 0, texture = 1, sampler = 2, set = 0;  ///< each 0 or above, see shader_slots
    std::optional<glsl::texture> map{};  ///< for one map texture_2d (default), depth or shadow. For several maps atlas
                                         ///< (default), array, depth_array or shadow_array
    bool gather = false;                 ///< reads 2x2 texels at once, with a sampler that clamps to the edge
    bool linear = false;                 ///< the comparison sampler filters linearly: it weights four texels a fetch
    bool derivatives = false;            ///< takes the triangle's normal from derivatives: umbrage_<name>(world)
    bool debug = false;                  ///< adds umbrage_probe_<name> and umbrage_calibrate_<name>
};

namespace detail {

/// Refuses comparison samplers where depths are needed, and depth textures for moments and for several channels.
template <class Filter, class Encoding>
void require_texture(const binding& map, const Filter& filter) {
    const bool of_depth = map.texture == texture::depth || map.texture == texture::depth_array;
    if constexpr (prefilter<Filter>) {
        umbrage::detail::require(!of_depth && !compares(map.texture), "glsl::bind", "slots.map",
                                 "a color texture, as the filter reads moments", name_of(map.texture));
    } else {
        umbrage::detail::require(!umbrage::detail::contact_hardening<Filter> || !compares(map.texture), "glsl::bind",
                                 "of.filter()", "one that needs no depths, as slots.map is a comparison sampler",
                                 filter.name);
        umbrage::detail::require(!compares(map.texture) || map.depth.empty(), "glsl::bind", "of.encoding()",
                                 "depth32f, depth24 or depth16, as slots.map is a comparison sampler", Encoding::name);
        umbrage::detail::require(!of_depth || map.channels == 1, "glsl::bind", "of.encoding()",
                                 "of one channel, as slots.map is a depth texture", Encoding::name);
    }
}

/// Texts of umbrage_look and umbrage_shadow for one shadow's map, and of its debug functions.
/// @param setup    the shadow's
/// @param layers   true for maps in an array, false for an atlas
/// @param linear   form of the filter for a linear comparison sampler; none: the filter itself
template <class Setup, class Filter, class Encoding>
[[nodiscard]] std::vector<own_text> shadow_texts(const Setup& setup, const Filter& filter, const Encoding& encoding,
                                                 bool layers, bool debug, const linear_form& linear = {}) {
    const std::string terms = "UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, ";
    const auto soft = umbrage::detail::softness_words_of<Setup, Filter>(setup);
    const auto words = umbrage::detail::frame_words_of(setup, layers, umbrage::detail::turning<Filter>, soft);
    const umbrage::detail::frame_result visibility{
        .head =
            "\n// umbrage_shadow: visibility of a point of the world, 1.0 is lit\n"
            "UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, ",
        .type = "float",
        .lit = "1.0",
        .look = "umbrage_look(map, terms, " + soft.terms + ", vec3(at.x, at.y, at.z), vec3(slope.x, slope.y, slope.w)" +
                words.of_pixel + (soft.has_shape ? ", shape.z)" : ")"),
        .blend = "umbrage_blend_cascades(sum, next, weight)"};
    std::vector<std::string> statements = words.chooses_map;
    statements.insert(statements.end(), soft.statements.begin(), soft.statements.end());
    own_text door{"shadow", umbrage::detail::frame_text(visibility, words, statements), words.needs()};
    door.needs.insert(door.needs.end(), words.chooses.begin(), words.chooses.end());
    door.needs.insert(door.needs.end(), soft.needs.begin(), soft.needs.end());
    std::vector<own_text> all{umbrage::detail::look_text<Setup>(filter, terms, words.pixel, soft.has_shape, linear),
                              std::move(door)};
    if (!debug) return all;
    for (own_text& text : umbrage::detail::probe_texts<Setup, Filter>(words)) all.push_back(std::move(text));
    std::string pixel = words.pixel.empty() ? "" : ", vec2(0.5, 0.5)";
    if (soft.has_shape) pixel += ", 0.0";
    std::string choice;
    for (const std::string& line : words.chooses_map) choice += "    " + line + '\n';
    for (own_text& text : umbrage::detail::calibration_texts<Setup, Filter>(encoding, terms, pixel, choice))
        all.push_back(std::move(text));
    return all;
}

}  // namespace detail

/// Shadow as functions of a shader: umbrage_<name>(world, normal), and its declarations. Filters with a rotated disc
/// take the position in pixels as a third argument: gl_FragCoord.xy.
/// @param of      the shadow. The text of a light that is `parallel` takes no uniforms of a light with perspective
/// @param name    letters, digits, single underscores between them; a different one for each shadow of a shader
/// @param slots   bindings, and the type of the texture
/// @throws std::invalid_argument   a name of other characters; a slot below 0; a texture type that does not hold
///                                 the maps; a filter that reads depths, with a comparison sampler
template <class Setup, class Filter, class Encoding>
[[nodiscard]] bound bind(const shadow<Setup, Filter, Encoding>& of, std::string_view name, shadow_slots slots = {}) {
    constexpr bool several = Setup::grid.columns * Setup::grid.rows > 1;
    const texture kind = slots.map.value_or(several ? texture::atlas : texture::texture_2d);
    const bool layers = kind == texture::array || kind == texture::depth_array || kind == texture::shadow_array;
    const bool plain = kind == texture::texture_2d || kind == texture::depth || kind == texture::shadow;
    umbrage::detail::require(several ? layers || kind == texture::atlas : plain, "glsl::bind", "slots.map",
                             several ? "atlas, array, depth_array or shadow_array, as the shadow has several maps"
                                     : "texture_2d, depth or shadow, as the shadow has one map",
                             detail::name_of(kind));
    umbrage::detail::require(!name.empty(), "glsl::bind", "name", "given", name);
    const auto slot = [](int number, const char* argument) {
        umbrage::detail::require(number >= 0, "glsl::bind", argument, "0 or above", number);
    };
    slot(slots.block, "slots.block");
    slot(slots.texture, "slots.texture");
    slot(slots.sampler, "slots.sampler");
    slot(slots.set, "slots.set");
    binding map = umbrage::detail::binding_of<Setup, Filter>(of.encoding());
    map.texture = kind;
    detail::require_texture<Filter, Encoding>(map, of.filter());
    map.outside = Setup::outside;
    if (kind == texture::atlas)  // for GLSL before 130, which has no textureSize
        map.texture_size = "vec2(" + std::to_string(of.size().x) + ".0, " + std::to_string(of.size().y) + ".0)";
    if (slots.gather) {
        umbrage::detail::require(!detail::compares(kind), "glsl::bind", "slots.gather",
                                 "false where slots.map is a comparison sampler", slots.gather);
        umbrage::detail::require(detail::calls(*of.filter().snippet, hook::lit_2x2, hook::lit_2x2), "glsl::bind",
                                 "of.filter()", "pcf_2x2 or a kernel, as slots.gather is true",
                                 of.filter().snippet->name);
        map.gather = true;
    }
    bound item(snippet{.name = "shadow", .source = ""}, name, map);
    linear_form linear;
    if (slots.linear) {
        linear = linear_form_of(of.filter());
        umbrage::detail::require(detail::compares(kind) && map.receiver_plane, "glsl::bind", "slots.linear",
                                 "false where slots.map is no comparison sampler, and for paraboloids", slots.linear);
        umbrage::detail::require(linear.what != nullptr, "glsl::bind", "of.filter()",
                                 "pcf_2x2, a disc, or a kernel of 3, 5 or 7 weights, as slots.linear is true",
                                 of.filter().name);
    }
    item.texts = detail::shadow_texts(of.setup(), of.filter(), of.encoding(), layers, slots.debug, linear);
    const detail::own_snippets own(item.texts);
    for (const snippet& text : own) detail::check(text, name, map);
    shader_interface declared{std::string(name), {}, {slots.block, slots.texture, slots.sampler, slots.set}, {}};
    const interface_function::argument normal{"normal", 3, slots.derivatives};
    declared.functions = {{.calls = "shadow",
                           .says = slots.derivatives
                                       ? "visibility of a point of the world, 1.0 is lit; outside branches"
                                       : "visibility of a point of the world, 1.0 is lit; a normal of zero is none",
                           .arguments = {{"world"}, normal}}};
    if (umbrage::detail::turning<Filter>) declared.functions[0].arguments.push_back({"pixel", 2});
    if (slots.debug) {
        declared.functions.push_back({.name = "probe",
                                      .calls = "point_color",
                                      .says = "debug color of a point of the world, as umbrage_probe_color says",
                                      .components = 3,
                                      .reads_map = false,
                                      .arguments = {{"world"}, normal}});
        declared.functions.push_back(
            {.name = "calibrate",
             .calls = "reading",
             .says = "what a calibration map is read as: 0.0 right, 1.0 empty, 2.0 dark, 3.0 upside down,\n"
                     "//   4.0 another map, 5.0 compared the wrong way round, 6.0 too coarse, 7.0 other depths",
             .reads_fields = false,
             .arguments = {{"number", 1}}});
    }
    for (const uniform_field& f : Setup::fields) declared.fields.push_back(f);
    for (const uniform_field& f : umbrage::detail::softness_fields_of<Setup, Filter>()) declared.fields.push_back(f);
    for (const uniform_field& f : shadow_terms::fields) declared.fields.push_back(f);
    item.declared = std::move(declared);
    return item;
}

}  // namespace umbrage::glsl
