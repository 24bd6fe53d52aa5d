// SPDX-License-Identifier: MIT
//
// Contact hardening in a light's maps: each map has its own softness, so that penumbras have one width in the world.
// It has a part for each axis of a map, since texels need not be square.
//
//     const umbrage::filters::pcss soft{.softness = umbrage::make_penumbra_params(0.05f)};  // size of the light
//     umbrage::shadow sun(cascades, fit.map_size, soft);
//
// Each matrix of the uniform block holds the softness of eight maps. Setups whose maps are alike have none:
// `has_like_maps`. In a warped map, or in a tetrahedron's, softness also depends on the place: penumbra_shape.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/filter/blocker/penumbra.hpp>
#include <umbrage/filter/pcf/disc_tap.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shader/interface.hpp>
#include <umbrage/shadow/lookup.hpp>
#include <umbrage/shadow/map_slack.hpp>
#include <umbrage/shadow/penumbra_shape.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

/// One of eight pairs of a matrix, two a column.
/// @param eight    the pairs
/// @param number   which one, an integer from 0 to 7
/// @exactness      A: comparisons
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> map_softness(const glm::mat<4, 4, T>& eight, T number) {
    const T column = T(static_cast<int>(number) / 2);
    const glm::vec<4, T> two = cascade_column(eight, column);
    return number - T(2) * column < T(0.5) ? glm::vec<2, T>(two.x, two.y) : glm::vec<2, T>(two.z, two.w);
}

namespace glsl {

inline constexpr snippet map_softness{
    .name = "map_softness",
    .summary = "one of eight pairs of a matrix, without dynamic indexing",
    .exactness = tier::a,
    .needs = list<&cascade_column>,
    .source = R"GLSL(
// umbrage_map_softness: one of eight pairs of a matrix, two a column, by its index, 0.0 to 7.0
UMBRAGE_HIGHP vec2 umbrage_map_softness(UMBRAGE_HIGHP mat4 eight, UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP float column = floor(number * 0.5);
    UMBRAGE_HIGHP vec4 two = umbrage_cascade_column(eight, column);
    return number - 2.0 * column < 0.5 ? vec2(two.x, two.y) : vec2(two.z, two.w);
}
)GLSL",
};

inline constexpr const snippet* softness_snippets[]{&map_softness};

}  // namespace glsl

namespace detail {

/// Matrices of a uniform block that hold the softness of each map.
template <class Setup>
inline constexpr int matrices_of_maps = has_like_maps<Setup> ? 0 : (Setup::grid.columns* Setup::grid.rows + 7) / 8;
/// The same, with that of the warps behind them.
template <class Setup, class Filter>
inline constexpr int softness_matrices = contact_hardening<Filter>
                                             ? matrices_of_maps<Setup> + (has_warps<Setup> ? 1 : 0)
                                             : 0;

inline constexpr std::array<uniform_field, 8> softness_fields{{{"softness_0"},
                                                               {"softness_1"},
                                                               {"softness_2"},
                                                               {"softness_3"},
                                                               {"softness_4"},
                                                               {"softness_5"},
                                                               {"softness_6"},
                                                               {"softness_7"}}};

/// Fields of a uniform block for these matrices, in their order.
template <class Setup, class Filter>
[[nodiscard]] std::vector<uniform_field> softness_fields_of() {
    constexpr int all = softness_matrices<Setup, Filter>;
    constexpr auto maps = all > 0 ? std::size_t(matrices_of_maps<Setup>) : 0;
    std::vector<uniform_field> fields(softness_fields.begin(), softness_fields.begin() + maps);
    if (std::size_t(all) > maps) fields.push_back({"warps"});
    return fields;
}

/// Function of the shape of penumbras in a setup's maps. Setups whose maps have one shape have none.
template <class Setup>
[[nodiscard]] constexpr shape_function shaping_of() {
    if constexpr (has_warps<Setup>) return {&glsl::warp_shape, "warps"};
    else if constexpr (requires { Setup::shaping; }) return Setup::shaping;
    else return {};
}

/// True where the shape of penumbras may change within a map.
template <class Setup, class Filter>
inline constexpr bool has_shapes = contact_hardening<Filter> && (shaping_of<Setup>().calls != nullptr);

/// True where it does.
template <class Setup>
[[nodiscard]] bool changes_shape(const Setup& setup) {
    if constexpr (has_warps<Setup>) return setup.is_warped();
    else return true;
}

/// The one number of a contact-hardening filter.
template <contact_hardening Filter>
[[nodiscard]] constexpr auto& softness_of(Filter& filter) {
    return std::get<0>(std::remove_const_t<Filter>::numbers(filter));
}

/// The filter with the softness of one map, as it is by itself.
template <contact_hardening Filter>
[[nodiscard]] constexpr Filter with_per_code(Filter filter, glm::vec2 per_code) {
    softness_of(filter).per_code_x = per_code.x;
    softness_of(filter).per_code_y = per_code.y;
    softness_of(filter).light_size = 0.0f;
    return filter;
}

/// Refuses a filter with contact hardening that does not say how large the light is.
template <contact_hardening Filter>
void require_light_size(const Filter& filter) {
    const float size = softness_of(filter).light_size;
    require(is_finite(size) && size > 0.0f, "shadow", "filter.softness.light_size", "above 0 and finite", size,
            "make_penumbra_params(light_size) gives it: a radius, or the tangent of half the sun's angle.");
}

/// `per_code_x` and `per_code_y` of each map of a setup. They come from the setup's first lights, because lights that
/// share a map are alike. A sun's warped map has that of its first texel. A setup with no light has one pair of 0.
template <shadow_setup Setup>
[[nodiscard]] std::vector<glm::vec2> softness_of_maps(const Setup& setup, glm::ivec2 map_size, float light_size) {
    std::vector<glm::vec2> all;
    for (const light_space<double>& light : setup.lights())
        if (all.size() < std::size_t(Setup::grid.columns * Setup::grid.rows)) {
            const glm::dmat4 m = texture_matrix(light, map_size);
            const glm::dvec3 at = measured_at(m, glm::ivec2(0));
            const glm::dvec2 edges = edges_at(m, at);
            const double depth = units_at(m, at).y;
            all.emplace_back(softness_per_code(edges.x, depth, double(light_size)),
                             softness_per_code(edges.y, depth, double(light_size)));
        }
    if (all.empty()) all.emplace_back(0.0f);
    return all;
}

/// Texture matrix of a map at a point of the world. Of lights that share one map it is that of the light before which
/// the point lies farthest.
template <shadow_setup Setup>
[[nodiscard]] glm::dmat4 matrix_at(const Setup& setup, glm::ivec2 map_size, int number, glm::dvec3 p) {
    const std::vector<light_space<double>> lights = setup.lights();
    if (lights.size() <= std::size_t(Setup::grid.columns * Setup::grid.rows))
        return texture_matrix(lights[std::size_t(number)], map_size);
    glm::dmat4 before(0);
    for (const light_space<double>& light : lights) {
        const glm::dmat4 m = texture_matrix(light, map_size);
        if ((m * glm::dvec4(p, 1)).w > (before * glm::dvec4(p, 1)).w) before = m;
    }
    return before;
}

/// Warps of a setup's maps, one column each: up to four.
template <shadow_setup Setup>
[[nodiscard]] glm::mat4 warps_of(const Setup& setup, glm::ivec2 map_size) {
    glm::mat4 all(0);
    glm::length_t column = 0;
    for (const light_space<double>& light : setup.lights())
        if (column < 4) all[column++] = warp_of(texture_matrix(light, map_size), map_size);
    return all;
}

/// A filter by the shape of penumbras at each coordinate.
/// @tparam Shape   (coord) -> vec3, as warp_shape gives it
template <contact_hardening Filter, class Shape>
struct shaped_filter {
    Filter filter;
    Shape shape;

    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver, glm::ivec2 pixel = {}) const {
        const glm::vec3 own = shape(coord);
        const glm::vec4 soft = shaped_softness(glm::vec4(softness_of(filter)), own);
        Filter at = filter;
        softness_of(at) = {soft.x, soft.y, soft.z, soft.w};
        return at.rotated(fetch, coord, receiver, sheared_rotation(disc_rotation(glm::vec2(pixel)), own.z));
    }
    [[nodiscard]] float reach() const { return filter.reach(); }
};

/// The filter of one map, by the shapes that its penumbras have.
/// @param uniforms   a shadow_uniforms of the setup and the filter
template <class Setup, class Filter, class Uniforms>
[[nodiscard]] auto shaped(const Filter& filter, const Uniforms& uniforms, int number) {
    const auto shape = [&uniforms, number](glm::vec2 at) {
        if constexpr (has_warps<Setup>) return warp_shape(uniforms.softness.back(), float(number), at);
        else return Setup::shape(uniforms.maps, float(number), at);
    };
    return shaped_filter<Filter, decltype(shape)>{filter, shape};
}

/// Words of the frame's text that find the softness of a place. For other filters all are empty but `terms`. Maps that
/// are alike and have one shape have no statements.
struct softness_words {
    std::string fields{}, names{};          ///< matrices, as parameters and as arguments
    std::vector<std::string> statements{};  ///< those that find `own_terms` of the place, and its `shape`
    std::string terms = "filter_terms";     ///< terms of the filter there
    bool has_shape = false;                 ///< true where umbrage_look takes the shear behind the pixel
    std::vector<const glsl::snippet*> needs{};
};

/// Words for a setup and a filter.
template <class Setup, class Filter>
[[nodiscard]] softness_words softness_words_of([[maybe_unused]] const Setup& setup) {
    softness_words w;
    if constexpr (contact_hardening<Filter>) {
        constexpr int matrices = matrices_of_maps<Setup>;
        for (const uniform_field& field : softness_fields_of<Setup, Filter>()) {
            w.fields.append("UMBRAGE_HIGHP mat4 ").append(field.name).append(", ");
            w.names.append(field.name).append(", ");
        }
        std::string softness = w.terms;
        if (matrices > 0) {
            w.statements = {"UMBRAGE_HIGHP vec2 softness = umbrage_map_softness(softness_0, number);"};
            for (int i = 1; i < matrices; ++i) {
                const std::string name(softness_fields[std::size_t(i)].name), before = std::to_string(8 * i) + ".0";
                w.statements.push_back("softness = number >= " + before + " ? umbrage_map_softness(" + name +
                                       ", number - " + before + ") : softness;");
            }
            softness = "vec4(softness, filter_terms.z, filter_terms.w)";
            w.needs = {&glsl::map_softness};
        }
        if constexpr (has_shapes<Setup, Filter>)
            if (changes_shape(setup)) {
                constexpr shape_function shaping = shaping_of<Setup>();
                w.statements.push_back("UMBRAGE_HIGHP vec3 shape = umbrage_" + std::string(shaping.calls->name) + '(' +
                                       std::string(shaping.argument) + ", number, vec2(at.x, at.y));");
                softness = "umbrage_shaped_softness(" + softness + ", shape)";
                w.has_shape = true;
                for (const glsl::snippet* need : {shaping.calls, &glsl::shaped_softness}) w.needs.push_back(need);
            }
        if (softness != w.terms) {
            w.statements.push_back("UMBRAGE_HIGHP vec4 own_terms = " + softness + ";");
            w.terms = "own_terms";
        }
    }
    return w;
}

}  // namespace detail
}  // namespace umbrage
