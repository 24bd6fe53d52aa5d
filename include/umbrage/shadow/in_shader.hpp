// SPDX-License-Identifier: MIT
//
// A shadow in a shader: its block, its map and one function, in any language.
//
//     using namespace umbrage::glsl;
//     std::string shader = source(version::v330, {bind(sun, "sun"), bind(lamp, "lamp", {.block = 1, .texture = 3})});
//     // ... float visibility = umbrage_sun(world, normal) * umbrage_lamp(world, normal);
//     auto bytes = sun.uniforms();  // what the block holds: copy sizeof bytes into its buffer
//
// hlsl::text, wgsl::text and msl::text take the same; in Metal block, map and sampler come first.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <umbrage/shader/bind.hpp>
#include <umbrage/shader/interface.hpp>
#include <umbrage/shadow/shadow.hpp>

namespace umbrage::glsl {

/// How a shader holds a shadow's maps.
struct shadow_slots {
    int block = 0, texture = 1, sampler = 2, set = 0;  ///< see shader_slots
    std::optional<glsl::texture> map{};  ///< none: texture_2d for one map, atlas for several. Or depth, shadow for one;
                                         ///< array, depth_array, shadow_array for several
};

namespace detail {

/// umbrage_look and umbrage_shadow, of one shadow's map alone.
template <class SetUp, class Filter>
[[nodiscard]] std::vector<own_text> shadow_texts(const Filter& filter, const map_choice& choice) {
    constexpr bool turns = umbrage::detail::turning<Filter>;
    const std::string terms = "UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, ";
    const std::string pixel = turns ? ", UMBRAGE_HIGHP vec2 pixel" : "";
    own_text look = umbrage::detail::look_text(filter, terms, pixel);

    std::string parameters, body = SetUp::text(choice);
    for (const uniform_field& f : SetUp::fields)
        parameters += std::string("UMBRAGE_HIGHP ") + (f.matrix ? "mat4 " : "vec4 ") + std::string(f.name) + ", ";
    if (turns)
        for (auto i = body.find("umbrage_look("); i != body.npos; i = body.find("umbrage_look(", i)) {
            i = body.find(";\n", i) - 1;
            body.insert(i, ", pixel");
        }
    own_text door{"shadow",
                  "\n// umbrage_shadow: visibility of a point of the world, 1.0 is lit\n"
                  "UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, " +
                      parameters + terms + "UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal" + pixel + ") {" +
                      body + "}\n"};
    door.needs.assign(std::begin(SetUp::needs), std::end(SetUp::needs));
    return {std::move(look), std::move(door)};
}

}  // namespace detail

/// A shadow as functions of a shader: umbrage_<name>(world, normal), and what it declares. Filters that turn from pixel
/// to pixel take the position in pixels as a third argument: gl_FragCoord.xy.
/// @param name    letters, digits, single underscores between them; another for each shadow of a shader
/// @param slots   what it is bound to, and the kind of texture
/// @throws std::invalid_argument   another name, a kind of texture that does not hold its maps, a filter that needs
///                                 depths under a comparison sampler
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
    binding map = umbrage::detail::binding_of<Filter>(of.encoding());
    map.texture = kind;
    map.outside = SetUp::outside;
    if (kind == texture::atlas)  // of GLSL before 130, which cannot ask a texture for its size
        map.texture_size = "vec2(" + std::to_string(of.size().x) + ".0, " + std::to_string(of.size().y) + ".0)";
    bound item(snippet{.name = "shadow", .source = ""}, name, map);
    item.texts = detail::shadow_texts<SetUp>(of.filter(), layers ? map_choice{} : SetUp::tiles);
    const detail::own_snippets own(item.texts);
    for (const snippet& text : own) detail::check(text, name, map);
    shader_interface declared{std::string(name),
                              {},
                              {slots.block, slots.texture, slots.sampler, slots.set},
                              umbrage::detail::turning<Filter>};
    for (const uniform_field& f : SetUp::fields) declared.fields.push_back(f);
    for (const uniform_field& f : shadow_terms::fields) declared.fields.push_back(f);
    item.declared = std::move(declared);
    return item;
}

}  // namespace umbrage::glsl
