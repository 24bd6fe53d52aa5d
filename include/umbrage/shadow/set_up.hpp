// SPDX-License-Identifier: MIT
//
// What a light's set-up is to a shadow: how many maps it has, how they are drawn, and where a point of the world is
// looked up. single_map.hpp is the shortest. Any type like these works; no list names them.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/shader/interface.hpp>

namespace umbrage {

/// What every shadow's block ends with.
struct shadow_terms {
    glm::vec2 map_size{1};      ///< of one map, texels
    float reach = 0;            ///< of the filter, as its bias counts it, texels
    float error = 0;            ///< by how much depth in the map, or a receiver's, may be off
    glm::vec4 filter_terms{0};  ///< the filter's own numbers: a radius, or (per_code, min_radius, max_radius)

    static constexpr uniform_field fields[]{{"terms", false}, {"filter_terms", false}};
};

/// A receiver's place in a light's maps.
struct map_place {
    int number = 0;      ///< of the map
    glm::vec3 at{0};     ///< texels, texels, depth
    glm::vec2 slope{0};  ///< change of depth of the receiver's plane, from one texel to the next
};

namespace glsl {

/// How a shader's text chooses one of several maps: a layer of an array, or a tile of an atlas.
struct map_choice {
    bool atlas = false;
    std::string_view tile{};                 ///< snippet that gives a tile's first texel, of its number
    std::string_view tile_size = "terms.x";  ///< and size

    /// The statement that chooses the map of a number, in a set-up's text: the first one, or another.
    [[nodiscard]] std::string first(std::string_view number) const {
        return std::string("    UMBRAGE_HIGHP ").append(atlas ? "vec2 " : "float ").append(again(number).substr(4));
    }
    [[nodiscard]] std::string again(std::string_view number) const {
        if (!atlas) return std::string("    layer = ").append(number).append(";\n");
        return std::string("    origin = umbrage_")
            .append(tile)
            .append("(")
            .append(number)
            .append(", ")
            .append(tile_size)
            .append(");\n");
    }
};

/// Body of the depth pass' vertex function, for setups whose vertices are no plain product of a matrix: GLSL statements
/// that use `to_clip`, `world` and the parameters.
struct vertex_place {
    std::string_view parameters, statements;
    const glsl::snippet* needs;
};

}  // namespace glsl

/// Maps of one size, row by row.
struct map_grid {
    int columns = 1, rows = 1;
};

/// How a light's maps are set up. `uniforms` holds mat4s and vec4s alone, in the order of `fields`, so that C++,
/// std140, cbuffers, WGSL and Metal lay it out alike. `visibility` and `text` are twins: C++ calls look(place) where
/// GLSL calls umbrage_look(map, terms, filter_terms, at, slope), in the map that `choice` chose. One whose lights do
/// not draw each into a map of its own has draw(depths, mesh, parallel); one that bends lines, bent_lines `bends` and
/// vertex_place `vertex`.
template <class SetUp>
concept shadow_set_up = std::copyable<SetUp> &&
    requires(const SetUp& s, const typename SetUp::uniforms& u, const shadow_terms& terms, glm::vec3 v,
             float (*look)(const map_place&), const glsl::map_choice& choice) {
    { s.clip() } -> std::same_as<clip_space>;
    { s.lights() } -> std::same_as<std::vector<light_space<double>>>;  // of the maps, each with its depth pass
    { SetUp::grid } -> std::convertible_to<map_grid>;                  // of the maps in one image
    { SetUp::outside } -> std::convertible_to<outside_map>;            // what texels outside a map count as
    { SetUp::tiles } -> std::convertible_to<glsl::map_choice>;         // of an atlas; of one map nothing
    { s.make_uniforms(glm::ivec2(1), glm::dvec3(0)) } -> std::same_as<typename SetUp::uniforms>;
    {std::span<const uniform_field>(SetUp::fields)};
    { SetUp::visibility(u, terms, v, v, look) } -> std::same_as<float>;
    { SetUp::text(choice) } -> std::same_as<std::string>;
    {std::span<const glsl::snippet* const>(SetUp::needs)};
};

/// Maps that bend straight lines and planes: contact hardening, which compares along planes, does not go with them.
struct bent_lines {
    float reach = 0;  ///< texels that places are off by
    float error = 0;  ///< and depths
};

/// The set-up that a light is given to a shadow as: itself, unless its header says otherwise.
template <class Light>
struct set_up_for {
    using type = Light;
};

namespace detail {

/// Holds a set-up's `uniforms` to its `fields`.
template <class SetUp>
consteval bool has_fields() {
    std::size_t vectors = 0;
    for (const uniform_field& f : SetUp::fields) vectors += f.vectors();
    return vectors * sizeof(glm::vec4) == sizeof(typename SetUp::uniforms);
}

template <class SetUp>
[[nodiscard]] constexpr bent_lines bends_of() {
    if constexpr (requires { SetUp::bends; }) return SetUp::bends;
    else return {};
}

/// A map's first texel in the image of all.
[[nodiscard]] inline glm::ivec2 first_texel(int number, map_grid grid, glm::ivec2 map_size) {
    return {number % grid.columns * map_size.x, number / grid.columns * map_size.y};
}

/// A light whose world is relative to an origin.
[[nodiscard]] inline light_space<double> relative_to(glm::dvec3 origin, light_space<double> light) {
    light.view[3] += light.view[0] * origin.x + light.view[1] * origin.y + light.view[2] * origin.z;
    return light;
}

template <real T>
[[nodiscard]] light_space<double> in_double(const light_space<T>& light) {
    return {glm::dmat4(light.view), glm::dmat4(light.projection), light.clip};
}

}  // namespace detail
}  // namespace umbrage
