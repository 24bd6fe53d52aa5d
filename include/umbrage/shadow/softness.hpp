// SPDX-License-Identifier: MIT
//
// Contact hardening in a light's maps: each map has its own softness, so that penumbras have one width in the world.
// It has a part for each axis of a map, since texels need not be square.
//
//     const umbrage::filters::pcss soft{.softness = umbrage::make_penumbra_params(0.05f)};  // size of the light
//     umbrage::shadow sun(cascades, fit.map_size, soft);
//
// The uniform block holds those of eight maps in a matrix. Setups whose maps are alike have none: `has_like_maps`.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/filter/blocker/penumbra.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shader/interface.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/lookup.hpp>
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
template <class Setup, class Filter>
inline constexpr int softness_matrices =
    contact_hardening<Filter> && !has_like_maps<Setup> ? (Setup::grid.columns * Setup::grid.rows + 7) / 8 : 0;

inline constexpr std::array<uniform_field, 8> softness_fields{{{"softness_0"},
                                                               {"softness_1"},
                                                               {"softness_2"},
                                                               {"softness_3"},
                                                               {"softness_4"},
                                                               {"softness_5"},
                                                               {"softness_6"},
                                                               {"softness_7"}}};

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
/// share a map are alike. A setup with no light has one pair of 0.
template <shadow_setup Setup>
[[nodiscard]] std::vector<glm::vec2> softness_of_maps(const Setup& setup, glm::ivec2 map_size, float light_size) {
    std::vector<glm::vec2> all;
    for (const light_space<double>& light : setup.lights())
        if (all.size() < std::size_t(Setup::grid.columns * Setup::grid.rows)) {
            const glm::dmat4 m = texture_matrix(light, map_size);
            const glm::dvec3 at = measured_at(m, map_size);
            const glm::dvec2 edges = edges_at(m, at);
            const double depth = units_at(m, at).y;
            all.emplace_back(softness_per_code(edges.x, depth, double(light_size)),
                             softness_per_code(edges.y, depth, double(light_size)));
        }
    if (all.empty()) all.emplace_back(0.0f);
    return all;
}

/// Words of the frame's text that find a map's softness. All are empty but `terms` for other filters, and for maps that
/// are alike.
struct softness_words {
    std::string fields{}, names{};          ///< matrices, as parameters and as arguments
    std::vector<std::string> statements{};  ///< those that find `own_terms` of the map `number`
    std::string terms = "filter_terms";     ///< terms of the filter in that map
    std::vector<const glsl::snippet*> needs{};
};

/// Words for a number of matrices.
[[nodiscard]] inline softness_words softness_words_of(int matrices) {
    softness_words w;
    if (matrices == 0) return w;
    w.statements = {"UMBRAGE_HIGHP vec2 softness = umbrage_map_softness(softness_0, number);"};
    for (int i = 0; i < matrices; ++i) {
        const std::string name(softness_fields[std::size_t(i)].name), before = std::to_string(8 * i) + ".0";
        w.fields += "UMBRAGE_HIGHP mat4 " + name + ", ";
        w.names += name + ", ";
        if (i > 0)
            w.statements.push_back("softness = number >= " + before + " ? umbrage_map_softness(" + name +
                                   ", number - " + before + ") : softness;");
    }
    w.statements.push_back("UMBRAGE_HIGHP vec4 own_terms = vec4(softness, filter_terms.z, filter_terms.w);");
    w.terms = "own_terms";
    w.needs = {&glsl::map_softness};
    return w;
}

}  // namespace detail
}  // namespace umbrage
