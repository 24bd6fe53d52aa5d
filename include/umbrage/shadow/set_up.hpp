// SPDX-License-Identifier: MIT
//
// Setup of a light's maps for a shadow: their number, their views, and the place of a world position in them.
// Any type that satisfies shadow_set_up works, and no list names them. See also: single_map.hpp, the shortest setup.
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

/// Last members of every shadow's uniform block.
struct shadow_terms {
    glm::vec2 map_size{1};      ///< size of one map, texels
    float reach = 0;            ///< reach of the filter, as its bias counts it, texels
    float error = 0;            ///< largest error of a stored depth and a receiver's together, in depth
    glm::vec4 filter_terms{0};  ///< numbers of the filter: a radius, or (per_code, min_radius, max_radius)

    static constexpr uniform_field fields[]{{"terms", false}, {"filter_terms", false}};
};

/// Place of a receiver in a light's maps.
struct map_place {
    int number = 0;      ///< number of the map, from 0
    glm::vec3 at{0};     ///< x and y in texels, z depth
    glm::vec2 slope{0};  ///< change of depth per texel of the receiver's plane
};

namespace glsl {

/// Choice of one of several maps in a shader's text: a layer of an array, or a tile of an atlas.
struct map_choice {
    bool atlas = false;
    std::string_view tile{};                 ///< name of the snippet tile(number, tile_size): a tile's first texel
    std::string_view tile_size = "terms.x";  ///< size of a tile, texels, in GLSL

    /// Statement of a setup's text that chooses a map by its number. `first` declares a variable, `again` assigns it.
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

/// Body of the depth pass' vertex function, for setups that do more than multiply by a matrix. Its GLSL statements use
/// `to_clip`, `world` and the parameters.
struct vertex_place {
    std::string_view parameters, statements;
    const glsl::snippet* needs;
};

}  // namespace glsl

/// Maps of one size, row by row.
struct map_grid {
    int columns = 1, rows = 1;
};

/// Setup of a light's maps.
///
/// `uniforms` holds only mat4 and vec4, in the order of `fields`. C++, std140, cbuffers, WGSL and Metal then lay it out
/// alike. `visibility` and `text` are the C++ and the GLSL version of one function. C++ calls look(place) where GLSL
/// calls umbrage_look(map, terms, filter_terms, at, slope), in the map that `choice` chose.
///
/// Three kinds of setup have more members. A setup with its own depth pass has draw(depths, mesh, parallel). A setup
/// that bends straight lines has `bends`, a bent_lines, and `vertex`, a vertex_place. A setup whose maps continue
/// beyond their border by a number of texels has require_reach(reach), which refuses filters that read farther.
template <class SetUp>
concept shadow_set_up = std::copyable<SetUp> &&
    requires(const SetUp& s, const typename SetUp::uniforms& u, const shadow_terms& terms, glm::vec3 v,
             float (*look)(const map_place&), const glsl::map_choice& choice) {
    { s.clip() } -> std::same_as<clip_space>;
    { s.lights() } -> std::same_as<std::vector<light_space<double>>>;  // one light per map and depth pass
    { SetUp::grid } -> std::convertible_to<map_grid>;                  // arrangement of the maps in one image
    { SetUp::outside } -> std::convertible_to<outside_map>;            // value of texels outside a map
    { SetUp::tiles } -> std::convertible_to<glsl::map_choice>;         // tiles of an atlas; empty for one map
    { s.make_uniforms(glm::ivec2(1), glm::dvec3(0)) } -> std::same_as<typename SetUp::uniforms>;
    {std::span<const uniform_field>(SetUp::fields)};
    { SetUp::visibility(u, terms, v, v, look) } -> std::same_as<float>;
    { SetUp::text(choice) } -> std::same_as<std::string>;
    {std::span<const glsl::snippet* const>(SetUp::needs)};
};

/// Errors of maps that bend straight lines and planes. Contact hardening compares along planes, so a shadow with such
/// maps does not take it.
struct bent_lines {
    float reach = 0;  ///< largest error of a position, texels
    float error = 0;  ///< largest error of a depth
};

/// Setup that a shadow makes of a light. It is the light itself, unless a setup's header specializes this.
template <class Light>
struct set_up_for {
    using type = Light;
};

namespace detail {

/// True when a setup's `uniforms` have the size of its `fields`.
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

/// First texel of a map in the image of all maps.
[[nodiscard]] inline glm::ivec2 first_texel(int number, map_grid grid, glm::ivec2 map_size) {
    return {number % grid.columns * map_size.x, number / grid.columns * map_size.y};
}

/// Light for world positions relative to an origin.
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
