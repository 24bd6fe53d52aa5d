// SPDX-License-Identifier: MIT
//
// Setup of a light's maps for a shadow: their number, their views, and the place of a world position in them.
// Any type that satisfies `shadow_setup` works, and no list names them. See also: single_map.hpp, the shortest setup.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>
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
    float error = 0;            ///< largest error of a stored depth. Under acne_free_bias less the 2^-23 that it adds
    glm::vec4 filter_terms{0};  ///< numbers of the filter: a radius, or the softness of map 0

    static constexpr uniform_field fields[]{{"terms", false}, {"filter_terms", false}};
};

/// Place of a receiver in one of a light's maps.
struct map_place {
    int number = 0;       ///< number of the map, from 0
    glm::vec3 at{0};      ///< x and y in texels, z depth
    glm::vec2 slope{0};   ///< change of depth per texel of the receiver's plane
    float weight = 1.0f;  ///< share in the blend with the places before it, 0 to 1; the first place has 1
    float slack = 0;      ///< depth by which texels of the receiver's own surface may lie before its plane
};

/// First coordinate of a place outside all maps, in texels. Every filter takes it as lit.
inline constexpr float outside_all_maps = -65536.0f;

/// Maps of one size, row by row.
struct map_grid {
    int columns = 1, rows = 1;
};

/// Setup of a light's maps.
///
/// `uniforms` holds only mat4 and vec4, in the order of `fields`. C++, std140, cbuffers, WGSL and Metal then lay it out
/// alike. `places` is a function of the fields, the terms, a world position and its normal: an array of one or two
/// places. The snippet `placing` is its GLSL version, which returns one place as columns of a mat4:
/// (texels, texels, depth, number), (slope, slope, weight, slack).
///
/// A setup of two places also has `choosing`, a choice_function. Its `placing` takes the number of a map as last
/// argument. In C++ chosen_places joins the two.
///
/// Seven kinds of setup have more. One with anchor(), a position of the world, has the vertices of its depth passes
/// relative to it, as its receivers are. A setup with its own depth pass has draw(depths, mesh, instances, origin,
/// parallel). A setup whose maps meet, each within a border of texels, has require_reach(reach), which refuses filters
/// that read beyond the border. A setup that bends straight lines specializes bends_of, and has bend() for
/// peter_panning_distance. A setup whose maps hold penumbras of several shapes has `shaping`, a shape_function, and
/// shape(u, number, at), its C++ version. A setup whose maps may be warped specializes has_warps, and has is_warped().
/// A setup with place_block() places and biases 64 receivers at once: see place_blocks.hpp.
template <class Setup>
concept shadow_setup = std::copyable<Setup> &&
    requires(const Setup& s, const typename Setup::uniforms& u, const shadow_terms& terms, glm::vec3 v) {
    { s.clip() } -> std::same_as<clip_space>;
    { s.lights() } -> std::same_as<std::vector<light_space<double>>>;  // one light per map and depth pass
    { Setup::grid } -> std::convertible_to<map_grid>;                  // arrangement of the maps in one image
    { Setup::outside } -> std::convertible_to<outside_map>;            // value of texels outside a map
    { s.make_uniforms(glm::ivec2(1), glm::dvec3(0)) } -> std::same_as<typename Setup::uniforms>;
    {std::span<const uniform_field>(Setup::fields)};
    {std::span<const map_place>(Setup::places(u, terms, v, v))};  // an array of one or two
    { s.placing } -> std::convertible_to<const glsl::snippet*>;
};

/// Depth pass function for maps that bend lines. The snippet takes (mat4 to_clip, vec3 world, arguments...) and returns
/// a clip position, in place of a matrix product.
struct vertex_function {
    const glsl::snippet* calls;
    std::array<glsl::interface_function::argument, 2> arguments;
};

/// Function that chooses the maps of a receiver. The snippet takes (arguments..., vec3 world). It returns a vec2: the
/// number of the first map, and the weight of the next one, or 0.
struct choice_function {
    const glsl::snippet* calls = nullptr;
    std::string_view arguments{};  ///< names of fields, and `terms`, each with a comma behind it
};

/// Maps that bend straight lines and planes: their errors, and how they draw vertices. Contact hardening compares along
/// planes, so a shadow with such maps does not take it.
struct bent_lines {
    float reach = 0;                          ///< largest error of a position, texels
    float error = 0;                          ///< largest error of a depth
    const vertex_function* vertex = nullptr;  ///< nullptr where lines stay straight
};
/// Bent lines of a setup's maps: none, unless the setup's header specializes this.
template <class Setup>
inline constexpr bent_lines bends_of{};
/// True for a setup whose maps bend straight lines.
template <class Setup>
inline constexpr bool has_bent_lines = bends_of<Setup>.reach > 0.0f;

/// True where one softness suits all maps of a setup, as texels of all are alike. Other setups have an own
/// softness for each map.
template <class Setup>
inline constexpr bool has_like_maps = Setup::grid.columns* Setup::grid.rows == 1;

/// True for a setup whose maps may be warped. Under contact hardening its block has a matrix of warps before the terms
/// (penumbra_shape.hpp). Its is_warped() says whether a map is warped.
template <class Setup>
inline constexpr bool has_warps = false;

/// Function that gives the shape of penumbras at a place: (argument, number of the map, vec2 of texels) -> vec3.
struct shape_function {
    const glsl::snippet* calls = nullptr;
    std::string_view argument{};  ///< name of a field
};

/// Places in a chosen map and in the next one.
/// @param choice     (number of the map, weight of the next one), as the snippet `choosing` returns it
/// @param place_in   (number) -> place
[[nodiscard]] UMBRAGE_INLINE inline std::array<map_place, 2> chosen_places(glm::vec2 choice, const auto& place_in) {
    std::array<map_place, 2> both{place_in(choice.x), map_place{.weight = 0.0f}};
    if (choice.y > 0.0f) both[1] = place_in(choice.x + 1.0f), both[1].weight = choice.y;
    return both;
}

/// Setup that a shadow makes of a light. It is the light itself, unless a setup's header specializes this.
template <class Light>
struct setup_for {
    using type = Light;
};

namespace detail {

/// Number of places that a receiver has at most.
template <class Setup>
inline constexpr int most_places = std::tuple_size_v<decltype(Setup::places(
    std::declval<const typename Setup::uniforms&>(), shadow_terms(), glm::vec3(), glm::vec3()))>;

/// A setup's choice of maps; none where a receiver has one place.
template <class Setup>
[[nodiscard]] constexpr choice_function choosing_of() {
    if constexpr (most_places<Setup> == 1) return {};
    else {
        constexpr bool chooses = requires { Setup::choosing; };
        static_assert(chooses, "a setup of two places has `choosing`, a choice_function");
        return Setup::choosing;
    }
}

/// True when a setup's `uniforms` have the size of its `fields`.
template <class Setup>
consteval bool has_fields() {
    std::size_t vectors = 0;
    for (const uniform_field& f : Setup::fields) vectors += f.vectors();
    return vectors * sizeof(glm::vec4) == sizeof(typename Setup::uniforms);
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

/// A position as binary32 holds it.
/// GCC 12 at -O2 drops both conversions of a pair of numbers, so each goes through memory.
[[nodiscard]] inline glm::dvec3 in_binary32(const glm::dvec3& position) {
    const auto rounded = [](double v) {
        const volatile float stored = static_cast<float>(v);
        return double(stored);
    };
    return {rounded(position.x), rounded(position.y), rounded(position.z)};
}

template <real T>
[[nodiscard]] light_space<double> in_double(const light_space<T>& light) {
    return {glm::dmat4(light.view), glm::dmat4(light.projection), light.clip, light.parallel};
}

}  // namespace detail
}  // namespace umbrage
