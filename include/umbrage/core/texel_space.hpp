// SPDX-License-Identifier: MIT
//
// Parts that all filters share: the valid range of coordinates, and the comparison with one texel.
//
//     if (!umbrage::inside_texel_space(coord)) return 1;  // NaN, infinite or far too large: lit
//
#pragma once

#include <concepts>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/compare.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/scalar.hpp>

namespace umbrage {

/// True if |coord| < 2^15 in x and y, so that texel indices and 1/256 texel stay exact.
/// Filters return lit for all other coordinates, NaN included.
/// @exactness     A
template <real T>
[[nodiscard]] constexpr bool inside_texel_space(glm::vec<2, T> coord) {
    const auto inside = [](T v) { return !is_nan(v) && v < T(32768) && v > T(-32768); };
    return inside(coord.x) && inside(coord.y);
}

/// True if a filter compares the receiver. It returns lit without a comparison for coordinates outside texel space and
/// for depths beyond the far plane.
/// @param coord    receiver position in the map, in texels
/// @param receiver receiver depth in [0, 1], with the bias already applied
/// @param is_lit   the comparison; one without beyond_far_plane has no far plane
/// @exactness      A
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr bool in_filter_domain(glm::vec<2, T> coord, T receiver, const Compare& is_lit = {}) {
    return inside_texel_space(coord) && !beyond_far_plane(receiver, is_lit);
}

/// Stored depth of a texel, by the fetch callable that filters take.
/// @param fetch   ivec2 texel -> depth, e.g. bordered(map), or decoded(map, rg<11>{}) for packed maps
/// @param texel   texel index, integers
/// @exactness     A: the fetched value
template <class Fetch>
[[nodiscard]] constexpr auto fetch_depth(Fetch&& fetch, glm::ivec2 texel) {
    return fetch(texel);
}

/// Stored depth of the texel at a point of the map.
/// @param fetch   ivec2 texel -> stored depth
/// @param size    size of the map, in texels
/// @param uv      point on the map, (0, 0) to (1, 1), no NaN
/// @exactness     C, n = 4, S = uv size: the fetched depth. At borders between texels a sampler may take the neighbor:
///                it rounds its coordinates, by 2^-10 texel (1e-3) in a map of 8192 texels
template <real T, class Fetch>
[[nodiscard]] T depth_at(Fetch&& fetch, glm::vec<2, T> size, glm::vec<2, T> uv) {
    return T(fetch(glm::ivec2(glm::floor(uv * size))));
}

/// Visibility from one comparison with a texel.
/// @param fetch      ivec2 texel -> stored depth
/// @param texel      texel index, integers
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           1 when lit, 0 in shadow
/// @exactness        A
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] constexpr T lit(Fetch&& fetch, glm::ivec2 texel, T receiver, Compare is_lit = {}) {
    return compare(receiver, T(fetch(texel)), is_lit);
}

/// Visibility from the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), the four texels of one gather.
/// Parameters as for lit.
/// @exactness   A
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] constexpr glm::vec<4, T> lit_2x2(Fetch&& fetch, glm::ivec2 texel, T receiver, Compare is_lit = {}) {
    const T a = lit(fetch, texel, receiver, is_lit), b = lit(fetch, texel + glm::ivec2(1, 0), receiver, is_lit);
    const T c = lit(fetch, texel + glm::ivec2(0, 1), receiver, is_lit);
    return {a, b, c, lit(fetch, texel + glm::ivec2(1, 1), receiver, is_lit)};
}

/// True if a receiver lies in a prefiltered map or a table. Receivers elsewhere are lit.
/// @param size      size of the map, in texels
/// @param coord     receiver position in the map, in texels
/// @param outside   clamped: always true, and receivers outside use the map's edge
/// @exactness       A
template <real T>
[[nodiscard]] constexpr bool map_covers(glm::vec<2, T> size, glm::vec<2, T> coord,
                                        outside_map outside = outside_map::bordered) {
    return outside == outside_map::clamped ||
           (coord.x >= T(0) && coord.y >= T(0) && coord.x < size.x && coord.y < size.y);
}

namespace detail {

/// Depth of the far plane under an encoding.
template <class Encoding>
[[nodiscard]] float far_depth(const Encoding& encoding) {
    if constexpr (requires { encoding.direction; }) return cleared_depth(encoding.direction);
    else return 1.0f;
}

}  // namespace detail

/// A packed map with its encoding: a fetch that counts texels outside the map as the far plane.
/// clamped() of it takes the nearest texel inside instead.
template <class Texel, class Encoding>
struct decoded_map {
    image_view<const Texel> map{};
    Encoding encoding{};
    float border = detail::far_depth(encoding);

    [[nodiscard]] auto operator()(glm::ivec2 texel) const {
        return inside_map(map.size, texel) ? encoding.decode(map.row(texel.y)[texel.x]) : border;
    }
};

/// Fetch callable that decodes a packed map.
/// @param fetch      ivec2 -> texel, e.g. clamped(map); a map means bordered(map)
/// @param encoding   an encoding of encodings.hpp
template <std::invocable<glm::ivec2> Fetch, class Encoding>
[[nodiscard]] auto decoded(Fetch fetch, Encoding encoding) {
    return [fetch, encoding](glm::ivec2 texel) { return encoding.decode(fetch(texel)); };
}
template <class Texel, class Encoding>
[[nodiscard]] decoded_map<std::remove_const_t<Texel>, Encoding> decoded(image_view<Texel> map, Encoding encoding) {
    return {map, encoding};
}
template <class Texel, class Encoding>
[[nodiscard]] decoded_map<Texel, Encoding> decoded(const image<Texel>& map, Encoding encoding) {
    return {map, encoding};
}
template <class Texel, class Encoding>
[[nodiscard]] decoded_map<Texel, Encoding> decoded(bordered_texels<Texel> map, Encoding encoding) {
    return {map.map, encoding};
}

/// Same as decoded(bordered(map), encoding).
template <class Texel, class Encoding>
[[nodiscard]] decoded_map<Texel, Encoding> bordered(decoded_map<Texel, Encoding> map) {
    return map;
}
/// Same as decoded(clamped(map), encoding).
/// @throws std::invalid_argument  empty map
template <class Texel, class Encoding>
[[nodiscard]] auto clamped(const decoded_map<Texel, Encoding>& map) {
    return decoded(clamped(map.map), map.encoding);
}

namespace glsl {

inline constexpr snippet inside_texel_space{
    .name = "inside_texel_space",
    .summary = "true for coordinates that a filter can take",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
bool umbrage_inside_texel_space(UMBRAGE_HIGHP vec2 coord) {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}
)GLSL",
};

inline constexpr snippet in_filter_domain{
    .name = "in_filter_domain",
    .summary = "true for receivers that a filter compares; others are lit",
    .exactness = tier::a,
    .needs = list<&inside_texel_space, &beyond_far_plane>,
    .source = R"GLSL(
// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
bool umbrage_in_filter_domain(UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
)GLSL",
};

/// Text for a bordered map. For other maps bind() replaces it.
inline constexpr snippet fetch_depth{
    .name = "fetch_depth",
    .summary = "stored depth of a texel",
    .exactness = tier::a,
    .needs = list<&texel, &texel_inside>,
    .role = hook::fetch_depth,
    .source = R"GLSL(
// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
UMBRAGE_HIGHP float umbrage_fetch_depth(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 inside = umbrage_texel_inside(size, texel);
    UMBRAGE_HIGHP vec4 value = umbrage_texel(map, size, inside);
    UMBRAGE_HIGHP float depth = UMBRAGE_DEPTH;
    return inside.x == texel.x && inside.y == texel.y ? depth : UMBRAGE_BORDER;
}
)GLSL",
};

inline constexpr snippet map_covers{
    .name = "map_covers",
    .summary = "true if a receiver lies in a prefiltered map",
    .exactness = tier::a,
    .role = hook::map_covers,
    .source = R"GLSL(
// umbrage_map_covers: true if a receiver lies in a prefiltered map or a table; elsewhere it is lit
bool umbrage_map_covers(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord) {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
)GLSL",
};

inline constexpr snippet lit{
    .name = "lit",
    .summary = "visibility from one comparison with a texel",
    .exactness = tier::a,
    .needs = list<&compare, &fetch_depth>,
    .role = hook::lit,
    .source = R"GLSL(
// umbrage_lit: visibility from one comparison with a texel
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
)GLSL",
};

inline constexpr snippet lit_2x2{
    .name = "lit_2x2",
    .summary = "visibility from comparisons with 2x2 texels",
    .exactness = tier::a,
    .needs = list<&lit>,
    .role = hook::lit_2x2,
    .source = R"GLSL(
// umbrage_lit_2x2: visibility from the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float a = umbrage_lit(map, size, texel, receiver);
    UMBRAGE_HIGHP float b = umbrage_lit(map, size, texel + vec2(1.0, 0.0), receiver);
    UMBRAGE_HIGHP float c = umbrage_lit(map, size, texel + vec2(0.0, 1.0), receiver);
    UMBRAGE_HIGHP float d = umbrage_lit(map, size, texel + vec2(1.0, 1.0), receiver);
    return vec4(a, b, c, d);
}
)GLSL",
};

/// Text that calls fetch_depth. For a map that fills its texture and has a sampler, bind() samples the texture instead.
inline constexpr snippet depth_at{
    .name = "depth_at",
    .summary = "stored depth at a point of the map",
    .exactness = tier::c,
    .operations = 4,
    .needs = list<&fetch_depth>,
    .role = hook::depth_at,
    .source = R"GLSL(
// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the neighbor's
//   uv  point on the map, (0.0, 0.0) to (1.0, 1.0), no NaN
UMBRAGE_HIGHP float umbrage_depth_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    return umbrage_fetch_depth(map, size, floor(uv * size));
}
)GLSL",
};

inline constexpr const snippet* texel_space_snippets[]{&fetch_depth, &depth_at, &inside_texel_space, &in_filter_domain,
                                                       &lit,         &lit_2x2,  &map_covers};

}  // namespace glsl
}  // namespace umbrage
