// SPDX-License-Identifier: MIT
//
// Summed-area table (SAT) of a shadow map's four moments, and visibility of whole images from it.
//
//     umbrage::moment_table of{.radius = 16};
//     umbrage::image<glm::u16vec4> table = umbrage::make_moment_table(map, of);
//     umbrage::visibility(table, of, receivers, 16, out);
//
// A box of 33 x 33 texels costs as much as one of 3 x 3, and less light bleeds than with variance_table.hpp.
#pragma once

#include <cstdint>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/filter/table/summed_moments.hpp>
#include <umbrage/images/summed_area.hpp>

namespace umbrage {

/// Settings of a table.
struct moment_table {
    int radius = 16;  ///< radius of the largest box, texels: 2 radius + 1 per side
    glm::vec2 bias = msm_bias_16;
    depth_direction direction = depth_direction::forward;
};

/// Sums of a map's moments, for summed_moments.
///
/// @param map         depths; NaN counts as far
/// @param of          settings. The largest box has n texels within the map
/// @param parallel    cuts the rows into pieces, see parallel.hpp
/// @return            two halves, each with one column and row more than the map. A texel has the sum of 65535
///                    to_optimized_moments(encode_msm), rounded, over all texels before its column and row: modulo 2^16
///                    on the left, over 2^16 on the right
/// @throws std::invalid_argument  empty map; radius out of range; 65535 n >= 2^32, where the sum over a box would wrap
template <class ParallelFor = serial>
[[nodiscard]] image<glm::u16vec4> make_moment_table(image_view<const float> map, const moment_table& of,
                                                    ParallelFor&& parallel = {}) {
    constexpr auto function = "make_moment_table";
    detail::require(!map.empty(), function, "map.size", "above 0", map.size);
    detail::require(of.radius >= 0 && of.radius <= 32767, function, "radius", "from 0 to 32767", of.radius);
    const std::int64_t side = 2 * std::int64_t(of.radius) + 1;
    const std::int64_t n = (glm::min)(side, std::int64_t(map.size.x)) * (glm::min)(side, std::int64_t(map.size.y));
    detail::require(n <= 65537, function, "radius", "small enough for a box of 65537 texels", of.radius,
                    "Sums in a larger box may reach 2^32.");

    image<glm::u16vec4> codes(map.size), table({2 * (map.size.x + 1), map.size.y + 1}, glm::u16vec4(0));
    const float cleared = cleared_depth(of.direction);
    parallel(map.size.y, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < map.size.x; ++x)
                codes[{x, y}] =
                    glm::u16vec4(to_optimized_moments(encode_msm(map.row(y)[x], cleared)) * 65535.0f + 0.5f);
    });
    image<std::uint32_t> channel(map.size), sums(map.size);
    for (glm::length_t c = 0; c < 4; ++c) {
        for (int y = 0; y < map.size.y; ++y)
            for (int x = 0; x < map.size.x; ++x) channel[{x, y}] = codes[{x, y}][c];
        summed_area(channel, sums, parallel);
        for (int y = 0; y < map.size.y; ++y)
            for (int x = 0; x < map.size.x; ++x) {
                const std::uint32_t sum = sums[{x, y}];
                table[{x + 1, y + 1}][c] = static_cast<std::uint16_t>(sum & 0xFFFF);
                table[{map.size.x + x + 2, y + 1}][c] = static_cast<std::uint16_t>(sum >> 16);
            }
    }
    return table;
}

/// Visibility from a table: summed_moments of each receiver.
///
/// @param table       from make_moment_table
/// @param of          from make_moment_table
/// @param receivers   (x, y) in texels of the map, z depth with the bias already applied
/// @param radius      radius of the box in texels, at most the table's
/// @param out         receives visibility, 1 lit; same size as receivers, other memory than these
/// @param parallel    cuts the rows into pieces, see parallel.hpp
/// @param outside     bordered: everything outside the map is lit. clamped: as at the map's edge
/// @throws std::invalid_argument  sizes differ; a table without two halves; radius below 0 or above the table's
template <class ParallelFor = serial>
void visibility(image_view<const glm::u16vec4> table, const moment_table& of, image_view<const glm::vec3> receivers,
                int radius, image_view<float> out, ParallelFor&& parallel = {},
                outside_map outside = outside_map::bordered) {
    constexpr auto function = "visibility";
    detail::require_size(out.size, receivers.size, function, "out.size", "the receivers' size");
    detail::require(table.size.x >= 4 && table.size.x % 2 == 0 && table.size.y >= 2, function, "table.size",
                    "that of a table of make_moment_table", table.size);
    if (radius < 0 || radius > of.radius)
        detail::refuse(function, "radius", std::string("from 0 to the table's, ").append(detail::printed(of.radius)),
                       radius, "Make the table with this radius.");
    const auto fetch = [table](glm::ivec2 at) { return glm::vec4(table.row(at.y)[at.x]); };
    const auto reach = static_cast<float>(radius), cleared = cleared_depth(of.direction);
    parallel(out.size.y, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < out.size.x; ++x) {
                const glm::vec3 r = receivers.row(y)[x];
                out.row(y)[x] = summed_moments(fetch, table.size, glm::vec2(r), r.z, reach, of.bias, cleared, outside);
            }
    });
}

}  // namespace umbrage
