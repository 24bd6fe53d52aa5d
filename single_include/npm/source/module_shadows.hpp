// SPDX-License-Identifier: MIT
//
// Shadows in JavaScript: what each kind of light looks up, how a filter looks at one map, and debug functions.
// shadow.mjs joins them.
#pragma once

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <umbrage/depth/encodings.hpp>
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
[[nodiscard]] std::string own_text(const shader_language& l, const auto& filter, bool layers, int which,
                                   bool debug = false) {
    const auto texts = glsl::detail::shadow_texts<SetUp>(filter, umbrage::depth32f{}, layers, debug);
    const glsl::detail::own_snippets own(texts);
    return l.words->translate(*(own.begin() + which));
}

/// A filter's look at a map, of which other filters that take the same arguments have the same but for the name. `bent`
/// is that of maps that bend planes, where it differs.
inline std::string look_of_module(const shader_language& l, const auto& filter) {
    using type = std::decay_t<decltype(filter)>;
    const std::string name = "umbrage_" + std::string(filter.snippet->name);
    const bool turns = umbrage::detail::turning<type>;
    const auto look = [&]<class SetUp>(std::type_identity<SetUp>) {
        const std::string text = glsl::detail::replace_words(
            own_text<SetUp>(l, filter, false, 0),
            [&](std::string_view word, bool) { return word == name ? "umbrage_FILTER" : std::string(word); });
        return "needs: filter => [snippets." + std::string(umbrage::detail::bias_snippet<SetUp, type>().name) +
               ", snippets.biased, snippets.beyond_far_plane, filter" + (turns ? ", snippets.disc_rotation" : "") +
               "],\n        text: " + template_literal(text) + ",\n";
    };
    std::string key, bent;
    for (const std::string& argument : names_of_arguments(filter)) key += (key.empty() ? "" : ", ") + argument;
    if constexpr (umbrage::detail::along_plane<umbrage::single_map, type> && !umbrage::detail::contact_hardening<type>)
        bent = "        bent: { " + look(std::type_identity<umbrage::paraboloid_maps>()) + "    },\n";
    return "    " + literal(key) + ": {\n        " + look(std::type_identity<umbrage::single_map>()) + bent +
           "    },\n";
}

inline std::string looks_in_module(const shader_language& l) {
    namespace filters = umbrage::filters;
    namespace prefilters = umbrage::prefilters;
    return "\nexport const looks = {\n" + look_of_module(l, filters::hard{}) + look_of_module(l, filters::box{}) +
           look_of_module(l, filters::disc{}) + look_of_module(l, filters::pcss{}) +
           look_of_module(l, prefilters::vsm{}) + look_of_module(l, prefilters::esm{}) +
           look_of_module(l, prefilters::evsm2{}) + look_of_module(l, prefilters::evsm4{}) +
           look_of_module(l, prefilters::msm{}) + "};\n";
}

/// Uniforms as JavaScript lists them.
inline std::string fields_of(std::span<const umbrage::uniform_field> all) {
    std::string fields;
    for (const umbrage::uniform_field& f : all)
        fields += (fields.empty() ? "" : ", ") + std::string("{ name: ") + literal(f.name) +
                  ", matrix: " + (f.matrix ? "true" : "false") + " }";
    return "fields: [" + fields + ']';
}

/// Texts of a lookup in a kind's maps. They take the pixel, for filters with a rotated disc; others leave it out.
template <class SetUp>
[[nodiscard]] std::string lookup_of(const shader_language& l, const auto& filter) {
    const auto text = [&](bool layers) { return template_literal(own_text<SetUp>(l, filter, layers, 1)); };
    return "text: " + text(false) +
           (SetUp::grid.columns * SetUp::grid.rows > 1 ? ",\n    of_layers: " + text(true) : "");
}

/// Lookup in a kind's maps; `softened`: that of contact hardening, where each map has a softness of its own.
template <class SetUp>
[[nodiscard]] std::string maps_of_module(const shader_language& l, std::string_view name) {
    using soft = umbrage::filters::pcss;
    constexpr umbrage::map_grid grid = SetUp::grid;
    constexpr int matrices = umbrage::detail::softness_matrices<SetUp, soft>;
    const auto words = umbrage::detail::frame_words_of<SetUp>(false, false);
    std::string softened;
    if constexpr (matrices > 0 && !umbrage::has_bent_lines<SetUp>)
        softened = "    softened: { " +
                   fields_of(std::span(umbrage::detail::softness_fields).first(std::size_t(matrices))) +
                   ", needs: [snippets.map_softness], " + lookup_of<SetUp>(l, soft{}) + " },\n";
    return "const " + std::string(name) + " = {\n    name: " + literal(name) + ", grid: [" +
           std::to_string(grid.columns) + ", " + std::to_string(grid.rows) +
           "], outside: " + literal(SetUp::outside == umbrage::outside_map::bordered ? "bordered" : "clamped") +
           ", bends: " + (umbrage::has_bent_lines<SetUp> ? "true" : "false") + ",\n    " + fields_of(SetUp::fields) +
           ",\n    needs: " + snippets(words.needs()) + ", chooses: " + snippets(words.chooses) + ",\n    " +
           lookup_of<SetUp>(l, umbrage::filters::disc{}) + ",\n" + softened + "};\n";
}

/// Function that a depth pass calls for its vertices, in a language.
inline std::string vertex_of_module(const shader_language& l, const glsl::own_text& own) {
    const std::vector<glsl::own_text> texts{own};
    const glsl::detail::own_snippets made(texts);
    return "{ needs: " + snippets(own.needs) + ", text: " + template_literal(l.words->translate(*made.begin())) +
           " };\n";
}

inline std::string kinds_in_module(const shader_language& l) {
    std::string out = "\n" + maps_of_module<umbrage::single_map>(l, "one_map");
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

/// Places of the debug texts in those of a shadow.
enum own_texts { place_color = 2, blended_color, point_color, lit_at, reading };

/// 1 / tolerance of a reading, for every encoding; `moments` stands for all prefilters.
template <class SetUp>
[[nodiscard]] std::string parts_of_readings() {
    using filter = umbrage::filters::hard;
    const auto parts = [](float tolerance) { return std::to_string(static_cast<int>(1.0f / tolerance + 0.5f)); };
    std::string all = "{ moments: " + parts(umbrage::detail::coarse_tolerance);
    umbrage::for_each_encoding([&](auto encoding) {
        const auto in = [&](umbrage::depth_direction direction) {
            encoding = {.direction = direction};
            return parts(umbrage::detail::calibration_tolerance<SetUp, filter>(encoding));
        };
        const std::string forward = in(umbrage::depth_direction::forward);
        if (in(umbrage::depth_direction::reversed) != forward)
            throw std::runtime_error("a tolerance for each direction: " + std::string(encoding.name));
        all += ", " + std::string(encoding.name) + ": " + forward;
    });
    return all + " }";
}

/// The statement that chooses the map to read, ahead of the tolerance; a setup of one map lacks it.
template <class SetUp>
[[nodiscard]] std::string choice_of_reading(const shader_language& l, bool layers) {
    const std::string text = own_text<SetUp>(l, umbrage::filters::hard{}, layers, reading, true);
    const auto start = text.find("{\n") + 2;
    return text.substr(start, text.rfind('\n', text.find("tolerance")) + 1 - start);
}

template <class SetUp>
[[nodiscard]] std::string debug_of_maps(const shader_language& l, std::string_view name) {
    using soft = umbrage::filters::pcss;
    const auto colors = [&](const auto& filter) {
        const auto text = [&](int which) { return template_literal(own_text<SetUp>(l, filter, false, which, true)); };
        return "blended_color: " + text(blended_color) + ",\n            point_color: " + text(point_color) + ",\n";
    };
    std::string softened;
    if constexpr (umbrage::detail::softness_matrices < SetUp, soft >> 0 && !umbrage::has_bent_lines<SetUp>)
        softened = "            softened: { " + colors(soft{}) + "            },\n";
    return "        " + std::string(name) +
           ": {\n            choice: " + template_literal(choice_of_reading<SetUp>(l, false)) + ",\n            " +
           colors(umbrage::filters::hard{}) + softened + "        },\n";
}

inline std::string debug_in_module(const shader_language& l) {
    namespace filters = umbrage::filters;
    using umbrage::single_map;
    const auto text = [&](const auto& filter, int which) {
        return template_literal(own_text<single_map>(l, filter, false, which, true));
    };
    const auto place = [&]<class SetUp>(std::type_identity<SetUp>, const auto& filter) {
        const snippet& bias = umbrage::detail::bias_snippet<SetUp, std::decay_t<decltype(filter)>>();
        return "{ bias: snippets." + std::string(bias.name) +
               ", text: " + template_literal(own_text<SetUp>(l, filter, false, place_color, true)) + " },\n";
    };
    const std::type_identity<single_map> flat;
    const std::type_identity<umbrage::paraboloid_maps> bent;
    const std::string plain = own_text<single_map>(l, filters::hard{}, false, reading, true);
    const auto number = plain.find("1.0 / ") + 6;
    return "\nexport const debug = {\n    language,\n    needs: { place: snippets.probe_color, point: "
           "[snippets.cleared_depth, snippets.probe_inputs] },\n    place_color: {\n        plane: " +
           place(flat, filters::hard{}) + "        plain: " + place(bent, filters::hard{}) +
           "        disc: " + place(bent, filters::disc{}) + "    },\n    lit_at: " + text(filters::hard{}, lit_at) +
           ",\n    lit_at_turned: " + text(filters::disc{}, lit_at) + ",\n    reading: " +
           template_literal(with_word(plain, plain.substr(number, plain.find('.', number) - number), "PARTS")) +
           ",\n    layer: " + template_literal(choice_of_reading<umbrage::cascaded_maps<1>>(l, true)) +
           ",\n    parts: " + parts_of_readings<single_map>() +
           ",\n    parts_of_bent: " + parts_of_readings<umbrage::paraboloid_maps>() + ",\n    maps: {\n" +
           debug_of_maps<single_map>(l, "one_map") + debug_of_maps<umbrage::cascaded_maps<1>>(l, "cascaded_maps") +
           debug_of_maps<umbrage::cascaded_maps<2>>(l, "cascaded_maps_8") +
           debug_of_maps<umbrage::warped_maps>(l, "warped_maps") +
           debug_of_maps<umbrage::adaptive_maps>(l, "adaptive_maps") +
           debug_of_maps<umbrage::cube_maps>(l, "cube_maps") +
           debug_of_maps<umbrage::tetrahedron_map>(l, "tetrahedron_map") +
           debug_of_maps<umbrage::paraboloid_maps>(l, "paraboloid_maps") + "    },\n};\n";
}

}  // namespace package
