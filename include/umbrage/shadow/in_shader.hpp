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
// bind(sun, "sun", {.debug = true}) adds two functions for a shadow that is missing. The colors of
// umbrage_probe_sun(world, normal) show the reason (probe.hpp). umbrage_calibrate_sun(number) reports how the host
// reads its map (calibration.hpp).
// See also: depth_pass.hpp, for the functions of the depth pass.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <umbrage/shader/bind.hpp>
#include <umbrage/shader/interface.hpp>
#include <umbrage/shadow/calibration.hpp>
#include <umbrage/shadow/probe.hpp>
#include <umbrage/shadow/shadow.hpp>

namespace umbrage::glsl {

/// Bindings of a shadow in a shader, and the type of its texture. Each shadow of a text has its own, where the language
/// and version write them.
struct shadow_slots {
    int block = 0, texture = 1, sampler = 2, set = 0;  ///< each 0 or above, see shader_slots
    std::optional<glsl::texture> map{};  ///< for one map texture_2d (default), depth or shadow. For several maps atlas
                                         ///< (default), array, depth_array or shadow_array
    bool debug = false;                  ///< adds umbrage_probe_<name> and umbrage_calibrate_<name>
};

namespace detail {

/// Texts of umbrage_look and umbrage_shadow for one shadow's map, and of its debug functions.
template <class SetUp, class Filter, class Encoding>
[[nodiscard]] std::vector<own_text> shadow_texts(const Filter& filter, const Encoding& encoding,
                                                 const map_choice& choice, bool debug) {
    constexpr bool turns = umbrage::detail::turning<Filter>;
    const std::string terms = "UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, ";
    const std::string pixel = turns ? ", UMBRAGE_HIGHP vec2 pixel" : "";
    std::string fields, arguments;
    for (const uniform_field& f : SetUp::fields) {
        fields += std::string("UMBRAGE_HIGHP ") + (f.matrix ? "mat4 " : "vec4 ") + std::string(f.name) + ", ";
        arguments += std::string(f.name) + ", ";
    }
    own_text door{"shadow",
                  "\n// umbrage_shadow: visibility of a point of the world, 1.0 is lit\n"
                  "UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, " +
                      fields + terms + "UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal" + pixel + ") {" +
                      (turns ? umbrage::detail::with_argument(SetUp::text(choice), "pixel") : SetUp::text(choice)) +
                      "}\n"};
    door.needs.assign(std::begin(SetUp::needs), std::end(SetUp::needs));
    std::vector<own_text> all{umbrage::detail::look_text(filter, terms, pixel), std::move(door)};
    if (!debug) return all;
    for (own_text& text : umbrage::detail::probe_texts<SetUp, Filter>(terms, fields, arguments))
        all.push_back(std::move(text));
    const bool several = SetUp::grid.columns * SetUp::grid.rows > 1;
    for (own_text& text : umbrage::detail::calibration_texts<SetUp, Filter>(
             encoding, terms, turns ? ", vec2(0.5, 0.5)" : "", several ? choice.first("number") : std::string()))
        all.push_back(std::move(text));
    return all;
}

}  // namespace detail

/// Shadow as functions of a shader: umbrage_<name>(world, normal), and its declarations. Filters with a rotated disc
/// take the position in pixels as a third argument: gl_FragCoord.xy.
/// @param of      the shadow
/// @param name    letters, digits, single underscores between them; a different one for each shadow of a shader
/// @param slots   bindings, and the type of the texture
/// @throws std::invalid_argument   a name of other characters; a slot below 0; a texture type that does not hold
///                                 the maps; a filter that reads depths, with a comparison sampler
template <class SetUp, class Filter, class Encoding>
[[nodiscard]] bound bind(const shadow<SetUp, Filter, Encoding>& of, std::string_view name, shadow_slots slots = {}) {
    constexpr bool several = SetUp::grid.columns * SetUp::grid.rows > 1;
    const texture kind = slots.map.value_or(several ? texture::atlas : texture::texture_2d);
    const bool layers = kind == texture::array || kind == texture::depth_array || kind == texture::shadow_array;
    const bool plain = kind == texture::texture_2d || kind == texture::depth || kind == texture::shadow;
    umbrage::detail::require(several ? layers || kind == texture::atlas : plain, "glsl::bind", "slots.map",
                             several ? "atlas, array, depth_array or shadow_array, as the shadow has several maps"
                                     : "texture_2d, depth or shadow, as the shadow has one map",
                             static_cast<int>(kind));
    umbrage::detail::require(!name.empty(), "glsl::bind", "name", "given", name);
    const auto slot = [](int number, const char* argument) {
        umbrage::detail::require(number >= 0, "glsl::bind", argument, "0 or above", number);
    };
    slot(slots.block, "slots.block");
    slot(slots.texture, "slots.texture");
    slot(slots.sampler, "slots.sampler");
    slot(slots.set, "slots.set");
    binding map = umbrage::detail::binding_of<Filter>(of.encoding());
    map.texture = kind;
    map.outside = SetUp::outside;
    if (kind == texture::atlas)  // for GLSL before 130, which has no textureSize
        map.texture_size = "vec2(" + std::to_string(of.size().x) + ".0, " + std::to_string(of.size().y) + ".0)";
    bound item(snippet{.name = "shadow", .source = ""}, name, map);
    item.texts =
        detail::shadow_texts<SetUp>(of.filter(), of.encoding(), layers ? map_choice{} : SetUp::tiles, slots.debug);
    const detail::own_snippets own(item.texts);
    for (const snippet& text : own) detail::check(text, name, map);
    shader_interface declared{std::string(name), {}, {slots.block, slots.texture, slots.sampler, slots.set}, {}};
    declared.functions = {{.calls = "shadow",
                           .says = "visibility of a point of the world, 1.0 is lit; a normal of zero is none",
                           .arguments = {{"world"}, {"normal"}}}};
    if (umbrage::detail::turning<Filter>) declared.functions[0].arguments.push_back({"pixel", 2});
    if (slots.debug) {
        declared.functions.push_back({.name = "probe",
                                      .calls = "point_color",
                                      .says = "debug color of a point of the world, as umbrage_probe_color says",
                                      .components = 3,
                                      .reads_map = false,
                                      .arguments = {{"world"}, {"normal"}}});
        declared.functions.push_back(
            {.name = "calibrate",
             .calls = "reading",
             .says = "what a calibration map is read as: 0.0 right, 1.0 empty, 2.0 dark, 3.0 upside down,\n"
                     "//   4.0 another map, 5.0 compared the wrong way round, 6.0 too coarse, 7.0 other depths",
             .reads_fields = false,
             .arguments = {{"number", 1}}});
    }
    for (const uniform_field& f : SetUp::fields) declared.fields.push_back(f);
    for (const uniform_field& f : shadow_terms::fields) declared.fields.push_back(f);
    item.declared = std::move(declared);
    return item;
}

}  // namespace umbrage::glsl
