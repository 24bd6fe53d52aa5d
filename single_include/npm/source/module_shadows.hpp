// SPDX-License-Identifier: MIT
//
// Shadows in JavaScript: what each kind of light states of its maps, and what debug functions need. frame.mjs makes
// texts of them.
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

/// Calls use(name, type, snippet of its place) for each setup of the kinds' maps.
template <class Use>
void for_each_maps(const Use& use) {
    use("one_map", std::type_identity<umbrage::single_map>(), glsl::single_map_places);
    use("parallel_map", std::type_identity<umbrage::single_map>(), glsl::parallel_map_places);
    const auto use_own = [&]<class Setup>(std::string_view name, std::type_identity<Setup> setup) {
        use(name, setup, *Setup::placing);
    };
    use_own("cascaded_maps", std::type_identity<umbrage::cascaded_maps<1>>());
    use_own("cascaded_maps_8", std::type_identity<umbrage::cascaded_maps<2>>());
    use_own("warped_maps", std::type_identity<umbrage::warped_maps>());
    use_own("adaptive_maps", std::type_identity<umbrage::adaptive_maps>());
    use_own("cube_maps", std::type_identity<umbrage::cube_maps>());
    use_own("tetrahedron_map", std::type_identity<umbrage::tetrahedron_map>());
    use_own("paraboloid_maps", std::type_identity<umbrage::paraboloid_maps>());
}

/// Uniforms as JavaScript lists them.
inline std::string fields_of(std::span<const umbrage::uniform_field> all) {
    std::string fields;
    for (const umbrage::uniform_field& f : all)
        fields += (fields.empty() ? "" : ", ") + std::string("{ name: ") + literal(f.name) +
                  ", matrix: " + (f.matrix ? "true" : "false") + " }";
    return "fields: [" + fields + ']';
}

/// Own function of a setup's depth pass for its vertices; others have none.
inline std::string vertex_of(const umbrage::vertex_function* vertex) {
    if (vertex == nullptr) return "";
    std::string arguments;
    for (const auto& a : vertex->arguments)
        arguments += (arguments.empty() ? "['" : ", ['") +
                     (a.components == 1 ? std::string("float") : "vec" + std::to_string(a.components)) + "', '" +
                     std::string(a.name) + "']";
    return ",\n    vertex: { calls: snippets." + std::string(vertex->calls->name) + ", arguments: [" + arguments +
           "] }";
}

/// A setup's choice of maps; others have none.
inline std::string choosing_of_module(const umbrage::choice_function& choosing) {
    if (choosing.calls == nullptr) return "";
    return ", choosing: { calls: snippets." + std::string(choosing.calls->name) +
           ", arguments: " + literal(choosing.arguments) + " }";
}

/// Shape of penumbras in a setup's maps; others have none. No light of one map is warped here.
template <class Setup>
[[nodiscard]] std::string shape_of_module() {
    constexpr umbrage::shape_function shaping = umbrage::detail::shaping_of<Setup>();
    if (shaping.calls == nullptr || std::is_same_v<Setup, umbrage::single_map>) return "";
    return ", shape: { calls: snippets." + std::string(shaping.calls->name) +
           ", argument: " + literal(shaping.argument) + " }";
}

/// A setup of maps as it states itself. `softness`: matrices that hold that of each map; `warps`: one more of warps.
template <class Setup>
[[nodiscard]] std::string maps_of_module(std::string_view name, const snippet& placing) {
    constexpr umbrage::map_grid grid = Setup::grid;
    constexpr bool bends = umbrage::has_bent_lines<Setup>;
    constexpr int matrices = bends ? 0 : umbrage::detail::matrices_of_maps<Setup>;
    return "const " + std::string(name) + " = {\n    grid: [" + std::to_string(grid.columns) + ", " +
           std::to_string(grid.rows) +
           "], outside: " + literal(Setup::outside == umbrage::outside_map::bordered ? "bordered" : "clamped") +
           ", bends: " + (bends ? "true" : "false") + ", softness: " + std::to_string(matrices) +
           ", warps: " + (umbrage::has_warps<Setup> ? "true" : "false") + ",\n    " + fields_of(Setup::fields) +
           ",\n    placing: snippets." + std::string(placing.name) +
           choosing_of_module(umbrage::detail::choosing_of<Setup>()) + shape_of_module<Setup>() +
           vertex_of(umbrage::bends_of<Setup>.vertex) + ",\n};\n";
}

/// Snippets that texts of shadows call, by name.
inline std::string calls_in_module() {
    std::string out = "\nexport const calls = {";
    for (const snippet* s :
         {&glsl::acne_free_bias, &glsl::acne_free_disc_bias, &glsl::beyond_far_plane, &glsl::disc_rotation,
          &glsl::blend_cascades, &glsl::map_tile, &glsl::map_softness, &glsl::shaped_softness, &glsl::sheared_rotation,
          &glsl::cleared_depth, &glsl::anchored_vertex, &glsl::pancake})
        out += "\n    " + std::string(s->name) + ": snippets." + std::string(s->name) + ',';
    return out + "\n};\n";
}

inline std::string kinds_in_module() {
    std::string out = "\n";
    for_each_maps([&]<class Setup>(std::string_view name, std::type_identity<Setup>, const snippet& placing) {
        out += maps_of_module<Setup>(name, placing);
    });
    out += '\n';
    for (const kind_of_light& kind : kinds)
        out += "export const " + std::string(kind.name) + " = { language, name: " + literal(kind.name) +
               ", maps: " + std::string(kind.maps) + ", pancakes: " + (kind.pancakes ? "true" : "false") + " };\n";
    return out;
}

/// 1 / tolerance of a reading, for every encoding; `moments` stands for all prefilters.
template <class Setup>
[[nodiscard]] std::string parts_of_readings() {
    using filter = umbrage::filters::hard;
    const auto parts = [](float tolerance) { return std::to_string(static_cast<int>(1.0f / tolerance + 0.5f)); };
    std::string all = "{ moments: " + parts(umbrage::detail::coarse_tolerance);
    umbrage::for_each_encoding([&](auto encoding) {
        const auto in = [&](umbrage::depth_direction direction) {
            encoding = {.direction = direction};
            return parts(umbrage::detail::calibration_tolerance<Setup, filter>(encoding));
        };
        const std::string forward = in(umbrage::depth_direction::forward);
        if (in(umbrage::depth_direction::reversed) != forward)
            throw std::runtime_error("a tolerance for each direction: " + std::string(encoding.name));
        all += ", " + std::string(encoding.name) + ": " + forward;
    });
    return all + " }";
}

inline std::string debug_in_module(const shader_language& l) {
    // WGSL and Metal know what a text calls, so it is printed among those of a shadow.
    const umbrage::single_map map(umbrage::light_space<double>{.clip = umbrage::opengl_clip_space});
    const auto texts = glsl::detail::shadow_texts(map, umbrage::filters::hard{}, umbrage::depth32f{}, false, true);
    const glsl::detail::own_snippets all(texts);
    const auto read_map = std::ranges::find(all, std::string_view("read_map"), &snippet::name);
    return "\nexport const debug = {\n    language, probe_color: snippets.probe_color, probe_inputs: "
           "snippets.probe_inputs,\n    read_map: " +
           template_literal(l.words->translate(*read_map)) +
           ",\n    parts: " + parts_of_readings<umbrage::single_map>() +
           ",\n    parts_of_bent: " + parts_of_readings<umbrage::paraboloid_maps>() + ",\n};\n";
}

}  // namespace package
