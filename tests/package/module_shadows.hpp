// SPDX-License-Identifier: MIT
//
// Shadows in JavaScript: what each kind of light looks up, and how a filter looks at one map. shadow.mjs joins them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <umbrage/shadow/adaptive_maps.hpp>
#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/depth_pass.hpp>
#include <umbrage/shadow/in_shader.hpp>
#include <umbrage/shadow/paraboloid_maps.hpp>
#include <umbrage/shadow/single_map.hpp>
#include <umbrage/shadow/tetrahedron_map.hpp>
#include <umbrage/shadow/warped_maps.hpp>

#include "module_filters.hpp"
#include "module_words.hpp"

namespace package {

/// One of a shadow's own texts, 0 the filter's look at a map, 1 the shadow's function, in a language.
template <class SetUp>
[[nodiscard]] std::string own_text(const shader_language& l, const auto& filter, const glsl::map_choice& choice,
                                   int which, bool debug = false) {
    const auto texts = glsl::detail::shadow_texts<SetUp>(filter, umbrage::depth32f{}, choice, debug);
    const glsl::detail::own_snippets own(texts);
    return l.words->translate(*(own.begin() + which));
}

/// A filter's look at a map, of which other filters that take the same arguments have the same but for the name.
inline std::string look_of_module(const shader_language& l, const auto& filter) {
    using type = std::decay_t<decltype(filter)>;
    const std::string name = "umbrage_" + std::string(filter.snippet->name);
    const std::string text = glsl::detail::replace_words(
        own_text<umbrage::single_map>(l, filter, {}, 0),
        [&](std::string_view word, bool) { return word == name ? "umbrage_FILTER" : std::string(word); });
    const bool disc = umbrage::detail::disc_filter<type>, turns = umbrage::detail::turning<type>;
    std::string key;
    for (const std::string& argument : names_of_arguments(filter)) key += (key.empty() ? "" : ", ") + argument;
    return "    " + literal(key) + ": {\n        needs: filter => [snippets." +
           (disc ? "acne_free_disc_bias" : "acne_free_bias") + ", snippets.biased, filter" +
           (turns ? ", snippets.disc_rotation" : "") + "],\n        text: " + template_literal(text) + ",\n    },\n";
}

inline std::string looks_module(const shader_language& l) {
    namespace filters = umbrage::filters;
    namespace prefilters = umbrage::prefilters;
    return "import * as snippets from './snippets.mjs';\n\nexport const looks = {\n" +
           look_of_module(l, filters::hard{}) + look_of_module(l, filters::box{}) + look_of_module(l, filters::disc{}) +
           look_of_module(l, filters::pcss{}) + look_of_module(l, prefilters::vsm{}) +
           look_of_module(l, prefilters::esm{}) + look_of_module(l, prefilters::evsm2{}) +
           look_of_module(l, prefilters::evsm4{}) + look_of_module(l, prefilters::msm{}) + "};\n";
}

/// Lookup in a kind's maps. The texts take the pixel, for filters with a rotated disc; others leave it out.
template <class SetUp>
[[nodiscard]] std::string maps_of_module(const shader_language& l, std::string_view name) {
    constexpr umbrage::map_grid grid = SetUp::grid;
    const auto text = [&](const glsl::map_choice& choice) {
        return template_literal(own_text<SetUp>(l, umbrage::filters::disc{}, choice, 1));
    };
    const bool several = grid.columns * grid.rows > 1;
    std::string fields;
    for (const umbrage::uniform_field& f : SetUp::fields)
        fields += (fields.empty() ? "" : ", ") + std::string("{ name: ") + literal(f.name) +
                  ", matrix: " + (f.matrix ? "true" : "false") + " }";
    return "const " + std::string(name) + " = {\n    name: " + literal(name) + ", grid: [" +
           std::to_string(grid.columns) + ", " + std::to_string(grid.rows) +
           "], outside: " + literal(SetUp::outside == umbrage::outside_map::bordered ? "bordered" : "clamped") +
           ", bends: " + (umbrage::detail::bends_of<SetUp>().reach > 0.0f ? "true" : "false") + ",\n    fields: [" +
           fields + "],\n    needs: " + snippets(SetUp::needs) + ",\n    text: " + text(SetUp::tiles) +
           (several ? ",\n    of_layers: " + text({}) : "") + ",\n};\n";
}

/// Function that a depth pass calls for its vertices, in a language.
inline std::string vertex_of_module(const shader_language& l, const glsl::own_text& own) {
    const std::vector<glsl::own_text> texts{own};
    const glsl::detail::own_snippets made(texts);
    return "{ needs: " + snippets(own.needs) + ", text: " + template_literal(l.words->translate(*made.begin())) +
           " };\n";
}

inline std::string kinds_module(const shader_language& l) {
    std::string out = "import { language } from './language.mjs';\nimport * as snippets from './snippets.mjs';\n\n";
    out += maps_of_module<umbrage::single_map>(l, "one_map");
    out += maps_of_module<umbrage::cascaded_maps<1>>(l, "cascaded_maps");
    out += maps_of_module<umbrage::cascaded_maps<2>>(l, "cascaded_maps_8");
    out += maps_of_module<umbrage::warped_maps>(l, "warped_maps");
    out += maps_of_module<umbrage::adaptive_maps>(l, "adaptive_maps");
    out += maps_of_module<umbrage::cube_maps>(l, "cube_maps");
    out += maps_of_module<umbrage::tetrahedron_map>(l, "tetrahedron_map");
    out += maps_of_module<umbrage::paraboloid_maps>(l, "paraboloid_maps") + '\n';
    constexpr auto at_near = "99.0";  // a number in its place: shadow.mjs puts the near plane's depth there
    const auto of_lights = [&](bool pancakes) {
        return vertex_of_module(l, glsl::detail::vertex_text_of_lights(pancakes, at_near));
    };
    out += "const projected = " + of_lights(false) + "const pancaked = " + with_word(of_lights(true), at_near, "NEAR") +
           "const bent = " + vertex_of_module(l, glsl::detail::vertex_text_of<umbrage::paraboloid_maps>()) + '\n';
    for (const kind_of_light& kind : kinds)
        out += "export const " + std::string(kind.name) + " = { language, name: " + literal(kind.name) +
               ", maps: " + std::string(kind.maps) + ", vertex: " + std::string(kind.vertex) + " };\n";
    return out;
}

}  // namespace package
