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

#include <memory>
#include <optional>
#include <string>
#include <string_view>
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

/// The texts of one shadow, and what they need: umbrage_look and umbrage_shadow, for its map alone.
class shadow_texts {
public:
    template <class SetUp, class Filter, class Encoding>
    shadow_texts(const shadow<SetUp, Filter, Encoding>& of, const map_choice& choice) {
        constexpr bool disc = umbrage::detail::reads_disc<Filter>;
        const Filter& filter = of.filter();
        std::string parameters;
        for (const uniform_field& f : SetUp::fields)
            parameters += std::string("UMBRAGE_HIGHP ") + (f.matrix ? "mat4 " : "vec4 ") + std::string(f.name) + ", ";
        const std::string terms = "UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, ";
        const std::string pixel = turns<Filter> ? ", UMBRAGE_HIGHP vec2 pixel" : "";
        const std::string bias = disc ? "acne_free_disc_bias" : "acne_free_bias";
        look_text_ =
            "\n// umbrage_look: visibility of a receiver in one map\n"
            "UMBRAGE_HIGHP float umbrage_look(UMBRAGE_MAP map, " +
            terms + "UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 slope" + pixel +
            ") {\n"
            "    UMBRAGE_HIGHP float bias = umbrage_" +
            bias +
            "(slope, terms.z, terms.w);\n"
            "    UMBRAGE_HIGHP float receiver = umbrage_biased(at.z, bias);\n"
            "    return umbrage_" +
            std::string(filter.snippet->name) + "(map, vec2(terms.x, terms.y), vec2(at.x, at.y), receiver" +
            arguments(filter) + ");\n}\n";
        std::string body = SetUp::text(choice);
        if (turns<Filter>)
            for (auto i = body.find("umbrage_look("); i != body.npos; i = body.find("umbrage_look(", i)) {
                i = body.find(";\n", i) - 1;
                body.insert(i, ", pixel");
            }
        door_text_ =
            "\n// umbrage_shadow: visibility of a point of the world, 1.0 is lit\n"
            "UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, " +
            parameters + terms + "UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal" + pixel + ") {" + body + "}\n";
        look_needs_ = {disc ? &acne_free_disc_bias : &acne_free_bias, &biased, filter.snippet};
        if (turns<Filter>) look_needs_.push_back(&disc_rotation);
        look_.source = look_text_.c_str(), look_.needs = look_needs_;
        door_needs_.assign(std::begin(SetUp::needs), std::end(SetUp::needs));
        door_needs_.push_back(&look_);
        door_.source = door_text_.c_str(), door_.needs = door_needs_;
    }
    shadow_texts(const shadow_texts&) = delete;  // the snippets point into it

    [[nodiscard]] const snippet& door() const { return door_; }

    template <class Filter>
    static constexpr bool turns = requires(const Filter& f, const umbrage::detail::any_fetch& fetch) {
        f(fetch, glm::vec2(), 0.0f, glm::ivec2());
    };

private:
    template <class Filter>
    [[nodiscard]] static std::string arguments(const Filter&) {
        std::string more;
        if constexpr (requires(const Filter& f) { f.softness; })
            more = ", vec3(filter_terms.x, filter_terms.y, filter_terms.z)";
        else if constexpr (requires(const Filter& f) { f.radius_texels; }) more = ", filter_terms.x";
        else if constexpr (requires(const Filter& f) { f.radius; }) more = ", int(filter_terms.x)";
        return more + (turns<Filter> ? ", umbrage_disc_rotation(pixel)" : "");
    }

    std::string look_text_, door_text_;
    std::vector<const snippet*> look_needs_, door_needs_;
    snippet look_{.name = "look", .source = ""}, door_{.name = "shadow", .source = ""};
};

}  // namespace detail

/// A shadow as functions of a shader: umbrage_<name>(world, normal), and what it declares. Filters that turn from pixel
/// to pixel take the position in pixels as a third argument: gl_FragCoord.xy.
/// @param name    letters, digits, single underscores between them; another for each shadow of a shader
/// @param slots   what it is bound to, and the kind of texture
/// @throws std::invalid_argument   another name, a kind of texture that does not hold its maps, a filter that needs
///                                 depths under a comparison sampler
template <class SetUp, class Filter, class Encoding>
[[nodiscard]] bound bind(const shadow<SetUp, Filter, Encoding>& of, std::string_view name, shadow_slots slots = {}) {
    constexpr bool several = SetUp::grid != glm::ivec2(1);
    const texture kind = slots.map.value_or(several ? texture::atlas : texture::texture_2d);
    const bool layers = kind == texture::array || kind == texture::depth_array || kind == texture::shadow_array;
    const bool plain = kind == texture::texture_2d || kind == texture::depth || kind == texture::shadow;
    umbrage::detail::require(several ? layers || kind == texture::atlas : plain, "glsl::bind", "slots.map",
                             several ? "atlas, array, depth_array or shadow_array, as the shadow has several maps"
                                     : "texture_2d, depth or shadow, as the shadow has one map",
                             static_cast<int>(kind));
    umbrage::detail::require(!name.empty(), "glsl::bind", "name", "given", name);
    binding map = stored_as(of.encoding());
    map.texture = kind;
    map.outside = SetUp::outside;
    if (kind == texture::atlas)  // of GLSL before 130, which cannot ask a texture for its size
        map.texture_size = "vec2(" + std::to_string(of.size().x) + ".0, " + std::to_string(of.size().y) + ".0)";
    const auto texts = std::make_shared<const detail::shadow_texts>(of, map_choice{!layers, SetUp::tile});
    bound item = bind(texts->door(), name, map);
    shader_interface declared{std::string(name),
                              {},
                              {slots.block, slots.texture, slots.sampler, slots.set},
                              detail::shadow_texts::turns<Filter>};
    for (const uniform_field& f : SetUp::fields) declared.fields.push_back(f);
    for (const uniform_field& f : shadow_terms::fields) declared.fields.push_back(f);
    item.declared = std::make_shared<const shader_interface>(std::move(declared));
    item.texts = texts;
    return item;
}

}  // namespace umbrage::glsl
