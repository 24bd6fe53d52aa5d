// SPDX-License-Identifier: MIT
//
// Frame of every shadow, in C++ and in GLSL. It gets a receiver's places from the setup, looks up the map of each
// place, and blends the results. Setups and filters only state what they are.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/shadow/map_tile.hpp>
#include <umbrage/shadow/setup.hpp>
#include <umbrage/shadow/softness.hpp>

namespace umbrage::detail {

/// Blends each place after the first over those before, by its weight.
/// @param look   (place) -> visibility there, or a color
template <class Look>
[[nodiscard]] auto blended(std::span<const map_place> places, const Look& look) {
    auto sum = look(places[0]);
    for (const map_place& place : places.subspan(1)) {
        if (!(place.weight > 0.0f)) continue;
        const auto next = look(place);
        sum = place.weight < 1.0f ? sum + (next - sum) * place.weight : next;  // as blend_cascades does, for colors too
    }
    return sum;
}

/// A shadow in the frame's text: declarations and names that its function passes on.
struct frame_words {
    const glsl::snippet* placing = nullptr;       ///< the setup's
    choice_function choosing{};                   ///< the setup's; none where a receiver has one place
    std::string fields{}, names{};                ///< all uniforms but the terms, as parameters and as arguments
    std::string of_setup{};                       ///< the setup's own, as arguments
    std::string pixel{}, of_pixel{};              ///< the pixel of filters with a rotated disc, in the same two forms
    std::vector<std::string> chooses_map{};       ///< statement that chooses the map of `number`
    std::vector<const glsl::snippet*> chooses{};  ///< what the statement calls

    /// Snippets that the text calls, but for those of the choice.
    [[nodiscard]] std::vector<const glsl::snippet*> needs() const {
        if (choosing.calls == nullptr) return {placing};
        return {choosing.calls, placing, &glsl::blend_cascades};
    }
};

/// Words of a setup.
/// @param setup    the shadow's; its light may choose the snippet of its places
/// @param layers   true for maps in an array, false for an atlas
/// @param turns    true for filters with a rotated disc
/// @param soft     softness of each map
template <class Setup>
[[nodiscard]] frame_words frame_words_of(const Setup& setup, bool layers, bool turns, const softness_words& soft = {}) {
    frame_words w{.placing = setup.placing, .choosing = choosing_of<Setup>()};
    for (const uniform_field& f : Setup::fields) {
        w.fields.append("UMBRAGE_HIGHP ").append(f.matrix ? "mat4 " : "vec4 ").append(f.name).append(", ");
        w.of_setup.append(f.name).append(", ");
    }
    w.fields += soft.fields;
    w.names = w.of_setup + soft.names;
    if (turns) w.pixel = ", UMBRAGE_HIGHP vec2 pixel", w.of_pixel = ", pixel";
    constexpr map_grid grid = Setup::grid;
    if (grid.columns * grid.rows == 1) return w;
    const std::string columns = std::to_string(grid.columns) + ".0";
    if (layers) w.chooses_map = {"UMBRAGE_HIGHP float layer = number;"};
    else {
        w.chooses_map = {"UMBRAGE_HIGHP vec2 origin = umbrage_map_tile(number, vec2(" + columns + ", 1.0 / " + columns +
                         "), vec2(terms.x, terms.y));"};
        w.chooses = {&glsl::map_tile};
    }
    return w;
}

/// Result of the frame's text: a visibility, or a color.
struct frame_result {
    std::string_view head;   ///< comment, type and name of the function, up to its first parameters
    std::string_view type;   ///< float or vec3
    std::string_view lit;    ///< value of the type before any map is looked up
    std::string look;        ///< result at `at` and `slope`
    std::string_view blend;  ///< blend of `sum` and `next` by `weight`
};

/// GLSL version of blended: the one text of all shadows.
/// @param statements     statements of the map's words, if the result depends on a map
[[nodiscard]] inline std::string frame_text(const frame_result& of, const frame_words& w,
                                            const std::vector<std::string>& statements) {
    const std::string type = "UMBRAGE_HIGHP " + std::string(of.type) + ' ';
    std::string text = std::string(of.head) + w.fields +
                       "UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, "
                       "UMBRAGE_HIGHP vec3 normal" +
                       w.pixel + ") {\n";
    const auto add = [&](const char* margin, std::string_view line) { text.append(margin).append(line) += '\n'; };
    const auto look_up = [&](const char* margin, const char* of_map, const char* name) {
        add(margin, "UMBRAGE_HIGHP mat4 place = umbrage_" + std::string(w.placing->name) + '(' + w.of_setup +
                        "terms, world, normal" + of_map + ");");
        for (const char* line : {"UMBRAGE_HIGHP vec4 at = place[0];", "UMBRAGE_HIGHP vec4 slope = place[1];",
                                 "UMBRAGE_HIGHP float number = at.w;"})
            add(margin, line);
        for (const std::string& line : statements) add(margin, line);
        add(margin, type + name + " = " + of.look + ';');
    };
    if (w.choosing.calls == nullptr) look_up("    ", "", "sum");
    else {
        // Compilers do not know how often the loop turns, so that the instructions of a lookup stand once.
        add("    ", "UMBRAGE_HIGHP vec2 choice = umbrage_" + std::string(w.choosing.calls->name) + '(' +
                        std::string(w.choosing.arguments) + "world);");
        add("", "#if __VERSION__ >= 130");
        add("    ", "int count = choice.y > 0.0 ? 2 : 1;");
        add("", "#else");
        add("    ", "const int count = 2;");
        add("", "#endif");
        add("    ", type + "sum = " + std::string(of.lit) + ';');
        add("    ", "UMBRAGE_HIGHP float chosen = choice.x;");
        add("    ", "UMBRAGE_HIGHP float weight = 1.0;");
        add("    ", "for (int i = 0; i < count; ++i) {");
        add("        ", "if (weight > 0.0) {");
        look_up("            ", ", chosen", "next");
        add("            ", "sum = " + std::string(of.blend) + ';');
        add("        ", "}");
        add("        ", "chosen = choice.x + 1.0;");
        add("        ", "weight = choice.y;");
        add("    ", "}");
    }
    return text + "    return sum;\n}\n";
}

}  // namespace umbrage::detail
