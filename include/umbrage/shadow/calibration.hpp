// SPDX-License-Identifier: MIT
//
// Calibration of a shadow's map: tests how a host reads a map of known depths, and names the likely mistake.
//
//     auto known = umbrage::calibration_map(sun);                      // upload it in place of the drawn map
//     umbrage::map_reading says = umbrage::calibrate(sun, known, 0);   // on the CPU: map_reading::right
//     std::puts(umbrage::explain(says));
//
// `bind(sun, "sun", {.debug = true})` gives a shader the same test: `umbrage_calibrate_sun(0.0)` returns the reading's
// number. See in_shader.hpp. A map that was just cleared must read as `map_reading::empty`.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/shadow/lookup.hpp>
#include <umbrage/shadow/shadow.hpp>

namespace umbrage {

/// Result of reading a map of known depths.
enum class map_reading { right, empty, dark, upside_down, another_map, reversed, coarse, wrong };

/// Sentence for a reading, with the likely causes to check.
[[nodiscard]] constexpr const char* explain(map_reading reading) {
    switch (reading) {
        case map_reading::right: return "The map is read right.";
        case map_reading::empty: return "Every depth is lit: the map is cleared, or another texture is bound.";
        case map_reading::dark:
            return "No depth is lit: the map was cleared to the near plane, or holds no numbers, or is not bound.";
        case map_reading::upside_down:
            return "The map is upside down: check the clip space's origin, or which row an upload begins with.";
        case map_reading::another_map: return "Another map of the light is read: check the order of layers or tiles.";
        case map_reading::reversed:
            return "Depths compare the wrong way round: check the sampler's comparison, or the clip space's direction.";
        case map_reading::coarse:
            return "Depths have too few bits: check the texture's format, and that all channels are read.";
        default:
            return "Other depths are read: check sRGB, filtering of packed texels, the order of channels, the map's "
                   "size and the encoding.";
    }
}

namespace detail {

/// Distance of the k-th of 32 known depths from the near plane, 0 to 1. A map has four of them, and every eighth map
/// has the same four.
[[nodiscard]] constexpr float known_distance(float k) { return (k + 1.0f) * (1.0f / 34.0f); }

/// Tolerance that separates known depths: below half of their distance, with room for rounding.
inline constexpr float coarse_tolerance = 1.0f / 72.0f;

/// Distance of the read points from the middle of a map, texels. A map of another size has its blocks' border
/// elsewhere, so the points lie beside it, as near as the filter allows.
[[nodiscard]] inline glm::vec2 aside_of_middle(const shadow_terms& terms) {
    return (glm::min)(glm::vec2(terms.reach + 2.0f), terms.map_size * 0.25f);
}

/// Largest error of a right reading, in depth: a power of two above the errors of encoding, rounding and bias, or
/// coarse_tolerance. Prefilters turn a step of depth into a ramp, so their readings only separate known depths.
template <class Setup, class Filter, class Encoding>
[[nodiscard]] float calibration_tolerance(const Encoding& encoding) {
    if constexpr (prefilter<Filter>) return coarse_tolerance;
    else {
        const decoding_error both = encoding.error();
        float tolerance = 0x1p-18f;
        while (double(tolerance) < 2.0 * (both.below + both.above + double(bends_of<Setup>.error)) + 0x1p-19)
            tolerance *= 2.0f;
        return tolerance < coarse_tolerance ? tolerance : coarse_tolerance;
    }
}

}  // namespace detail

/// Map of known depths: four blocks in each of the light's maps, with other depths in each map.
///
/// @return   image of the shadow's size(), in its encoding. The first row is the first in memory
/// @throws std::invalid_argument   maps smaller than four times the filter's reach
template <class Setup, class Filter, class Encoding>
[[nodiscard]] image<typename Encoding::texel> calibration_map(const shadow<Setup, Filter, Encoding>& of) {
    const glm::ivec2 map_size = of.map_size(), size = of.size();
    const float reach = detail::reach_of(of.filter());
    detail::require(4.0f * reach <= static_cast<float>((glm::min)(map_size.x, map_size.y)), "calibration_map",
                    "of.map_size()", "four times the filter's reach or more", map_size);
    image<float> depths(size);
    for (glm::ivec2 p(0); p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x) {
            const glm::ivec2 tile = p / map_size, in_map = p % map_size;
            const int number = (tile.x + tile.y * Setup::grid.columns) % 8;
            const int block = (2 * in_map.x >= map_size.x ? 1 : 0) + (2 * in_map.y >= map_size.y ? 2 : 0);
            const float distance = detail::known_distance(static_cast<float>(8 * block + number));
            depths[p] = of.encoding().direction == depth_direction::forward ? distance : 1.0f - distance;
        }
    image<typename Encoding::texel> map(size, of.cleared());
    of.store(depths, map);
    return map;
}

/// Reads a map of known depths through the shadow's own filter.
///
/// @param of       the shadow
/// @param map      calibration_map(of) as the host has it, or a map that was just cleared
/// @param number   number of the light's map, >= 0
/// @return         map_reading::right if every block is read as it was stored; map_reading::empty for a cleared map
/// @throws std::invalid_argument   a map of another size; a number that the light lacks
/// @exactness      the reading is the shader's wherever the filter's visibilities are on the same side of 1/2
template <class Setup, class Filter, class Encoding>
[[nodiscard]] map_reading calibrate(const shadow<Setup, Filter, Encoding>& of,
                                    image_view<const typename Encoding::texel> map, int number) {
    detail::require_size(map.size, of.size(), "calibrate", "map.size", "the shadow's size()");
    detail::require(number >= 0 && number < Setup::grid.columns * Setup::grid.rows, "calibrate", "number",
                    "one of the light's maps", number);
    const shadow_terms terms = of.uniforms().terms;
    const auto own = map.region(detail::first_texel(number, Setup::grid, of.map_size()), of.map_size());
    const depth_direction direction = of.encoding().direction;
    const float bias = detail::bias_of<Setup, Filter>(terms, map_place{});
    const auto lit_at = [&](glm::vec2 coord, float distance) {
        const float depth = direction == depth_direction::forward ? distance : 1.0f - distance;
        return detail::look<Setup, Filter>(own, of.filter_of(0), of.encoding(),
                                           glm::vec3(coord, biased(depth, bias, direction)), glm::vec2(0), {}) > 0.5f;
    };
    const float tolerance = detail::calibration_tolerance<Setup, Filter>(of.encoding());
    const float map_number = static_cast<float>(number % 8);
    int right = 0, nearly = 0, lit = 0, dark = 0, turned = 0, flipped = 0, others = 0;
    for (int block = 0; block < 4; ++block) {
        const float row = block < 2 ? 0.0f : 1.0f, column = float(block) - 2.0f * row;
        const glm::vec2 side(2.0f * column - 1.0f, 2.0f * row - 1.0f);
        const glm::vec2 coord = terms.map_size * 0.5f + side * detail::aside_of_middle(terms);
        float found = 0.0f, step = 0.5f;
        for (int i = 0; i < 20; ++i, step *= 0.5f) found = lit_at(coord, found + step) ? found + step : found;
        const auto is = [&](float of_block, float of_map, float within) {
            return std::abs(found - detail::known_distance(8.0f * of_block + of_map)) <= within;
        };
        right += is(float(block), map_number, tolerance);
        nearly += is(float(block), map_number, detail::coarse_tolerance);
        lit += found > 0.9999f;
        dark += found < 0.0001f;
        turned += !lit_at(coord, 0.0f) && lit_at(coord, 1.0f);
        flipped += is(column + 2.0f - 2.0f * row, map_number, detail::coarse_tolerance);
        for (int other = 0; other < 8; ++other) others += is(float(block), float(other), detail::coarse_tolerance);
    }
    return right == 4     ? map_reading::right
           : turned == 4  ? map_reading::reversed
           : lit == 4     ? map_reading::empty
           : dark == 4    ? map_reading::dark
           : nearly == 4  ? map_reading::coarse
           : flipped == 4 ? map_reading::upside_down
           : others == 4  ? map_reading::another_map
                          : map_reading::wrong;
}

namespace detail {

/// GLSL version of calibrate for one map, whatever the light and the filter.
inline constexpr std::string_view read_map_text = R"GLSL(
// umbrage_read_map: what one map of known depths is read as, within a tolerance of depth
UMBRAGE_HIGHP float umbrage_read_map(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms,
                                     UMBRAGE_HIGHP float number, UMBRAGE_HIGHP float tolerance) {
    UMBRAGE_HIGHP float coarse = 1.0 / 72.0;
    UMBRAGE_HIGHP float own = number - 8.0 * floor(number * 0.125) + 1.0;
    UMBRAGE_HIGHP vec4 met = vec4(0.0, 0.0, 0.0, 0.0);
    UMBRAGE_HIGHP vec3 seen = vec3(0.0, 0.0, 0.0);
    for (int block = 0; block < 4; ++block) {
        UMBRAGE_HIGHP float row = block < 2 ? 0.0 : 1.0;
        UMBRAGE_HIGHP float column = float(block) - 2.0 * row;
        UMBRAGE_HIGHP vec2 side = vec2(2.0 * column - 1.0, 2.0 * row - 1.0);
        UMBRAGE_HIGHP vec2 aside = min(vec2(terms.z + 2.0, terms.z + 2.0), vec2(terms.x, terms.y) * 0.25);
        UMBRAGE_HIGHP vec2 coord = vec2(terms.x, terms.y) * 0.5 + side * aside;
        UMBRAGE_HIGHP float found = 0.0;
        UMBRAGE_HIGHP float step_size = 0.5;
        for (int i = 0; i < 20; ++i) {
            found += umbrage_lit_at_distance(map, terms, filter_terms, coord, found + step_size) * step_size;
            step_size *= 0.5;
        }
        UMBRAGE_HIGHP float first = 8.0 * float(block);
        UMBRAGE_HIGHP float turned = 8.0 * (column + 2.0 - 2.0 * row);
        UMBRAGE_HIGHP float here = abs(found - (first + own) * (1.0 / 34.0));
        UMBRAGE_HIGHP float there = abs(found - (turned + own) * (1.0 / 34.0));
        UMBRAGE_HIGHP float nearest = clamp(floor(found * 34.0 + 0.5), first + 1.0, first + 8.0);
        UMBRAGE_HIGHP float other = abs(found - nearest * (1.0 / 34.0));
        met += vec4(here <= tolerance ? 1.0 : 0.0, here <= coarse ? 1.0 : 0.0, there <= coarse ? 1.0 : 0.0,
                    other <= coarse ? 1.0 : 0.0);
        UMBRAGE_HIGHP float front = umbrage_lit_at_distance(map, terms, filter_terms, coord, 0.0);
        UMBRAGE_HIGHP float back = umbrage_lit_at_distance(map, terms, filter_terms, coord, 1.0);
        seen += vec3(found > 0.9999 ? 1.0 : 0.0, found < 0.0001 ? 1.0 : 0.0, (1.0 - front) * back);
    }
    UMBRAGE_HIGHP float reading = 7.0;
    reading = met.w > 3.5 ? 4.0 : reading;
    reading = met.z > 3.5 ? 3.0 : reading;
    reading = met.y > 3.5 ? 6.0 : reading;
    reading = seen.y > 3.5 ? 2.0 : reading;
    reading = seen.x > 3.5 ? 1.0 : reading;
    reading = seen.z > 3.5 ? 5.0 : reading;
    return met.x > 3.5 ? 0.0 : reading;
}
)GLSL";

/// GLSL version of calibrate: umbrage_reading, after the functions that it calls.
/// @param terms    declarations of shadow_terms
/// @param pixel    ", vec2(0.5, 0.5)" for filters with a rotated disc
/// @param choice   statement that chooses the map of `number`; empty for one map
template <class Setup, class Filter, class Encoding>
[[nodiscard]] std::array<glsl::own_text, 3> calibration_texts(const Encoding& encoding, const std::string& terms,
                                                              const std::string& pixel, const std::string& choice) {
    const int parts = static_cast<int>(1.0f / calibration_tolerance<Setup, Filter>(encoding) + 0.5f);
    return {
        {{"lit_at_distance",
          "\n// umbrage_lit_at_distance: 1.0 where a receiver at a distance from the near plane, 0.0 to 1.0, is lit\n"
          "UMBRAGE_HIGHP float umbrage_lit_at_distance(UMBRAGE_MAP map, " +
              terms +
              "UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float distance) {\n"
              "    UMBRAGE_HIGHP float depth = umbrage_cleared_depth() > 0.5 ? distance : 1.0 - distance;\n"
              "    UMBRAGE_HIGHP vec3 at = vec3(coord.x, coord.y, depth);\n"
              "    return umbrage_look(map, terms, filter_terms, at, vec3(0.0, 0.0, 0.0)" +
              pixel + ") > 0.5 ? 1.0 : 0.0;\n}\n",
          {&glsl::cleared_depth}},
         {"read_map", std::string(read_map_text), {}},
         {"reading",
          "\n// umbrage_reading: what a map of known depths is read as, a map_reading's number; 0.0 is right\n"
          "UMBRAGE_HIGHP float umbrage_reading(UMBRAGE_MAP map, " +
              terms + "UMBRAGE_HIGHP float number) {\n" + choice +
              "    return umbrage_read_map(map, terms, filter_terms, number, 1.0 / " + std::to_string(parts) +
              ".0);\n}\n",
          {}}}};
}

}  // namespace detail
}  // namespace umbrage
