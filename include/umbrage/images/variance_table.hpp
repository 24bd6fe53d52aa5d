// SPDX-License-Identifier: MIT
//
// Summed-area table (SAT, SAVSM) of a shadow map's depths and their squares, and visibility of whole images from it.
//
//     umbrage::variance_table of{.bits = 11, .radius = 16};
//     umbrage::image<glm::u16vec4> table = umbrage::make_variance_table(map, of);
//     umbrage::visibility(table, of, receivers, 16, out);
//
// A box of 33 x 33 texels costs as much as one of 3 x 3.
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/compare.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/filter/blocker/penumbra.hpp>
#include <umbrage/filter/table/summed_variance.hpp>
#include <umbrage/images/summed_area.hpp>
#include <umbrage/simd/min_max.hpp>

namespace umbrage {

/// Settings of a table.
struct variance_table {
    int bits = 11;    ///< bits of a quantized depth, 1 to 12
    int radius = 16;  ///< radius of the largest box, texels: 2 radius + 1 per side
    depth_direction direction = depth_direction::forward;
};

/// Sums of a map's depth codes (distances from the near plane) and of their squares, for summed_variance.
///
/// @param map         depths; NaN counts as far
/// @param of          settings. The largest box has n texels within the map
/// @param parallel    cuts the rows into pieces, see parallel.hpp
/// @return            one column and row more than the map. A texel has the sums over all texels before its column and
///                    row: of codes modulo 2^16 and over 2^16, then the same of their squares
/// @throws std::invalid_argument  empty map; bits or radius out of range; n 2^bits > 2^24; n (s^2 / 4 + 1) >= 2^32,
///                                where the sum over a box would wrap. s is the map's largest code minus its smallest
template <class ParallelFor = serial>
[[nodiscard]] image<glm::u16vec4> make_variance_table(image_view<const float> map, const variance_table& of,
                                                      ParallelFor&& parallel = {}) {
    constexpr auto function = "make_variance_table";
    detail::require(!map.empty(), function, "map.size", "above 0", map.size);
    detail::require(of.bits >= 1 && of.bits <= 12, function, "bits", "from 1 to 12", of.bits);
    detail::require(of.radius >= 0 && of.radius <= 32767, function, "radius", "from 0 to 32767", of.radius);
    const comparison is_lit{of.direction};
    image<std::uint32_t> codes(map.size), sums(map.size);
    std::uint32_t least = 65535, greatest = 0;
    for (int y = 0; y < map.size.y; ++y)
        for (int x = 0; x < map.size.x; ++x) {
            const auto code = static_cast<std::uint32_t>(distance_code(map.row(y)[x], is_lit)) >> (16 - of.bits);
            codes[{x, y}] = code;
            least = detail::lesser(least, code), greatest = detail::greater(greatest, code);
        }
    const std::int64_t side = 2 * std::int64_t(of.radius) + 1, spread = std::int64_t(greatest) - std::int64_t(least);
    const std::int64_t n =
        detail::lesser<std::int64_t>(side, map.size.x) * detail::lesser<std::int64_t>(side, map.size.y);
    detail::require(
        n << of.bits <= std::int64_t(1) << 24, function, "bits and radius", "small enough for sums of 24 bits",
        glm::dvec2(of.bits, of.radius),
        "A box within the map holds min(2 radius + 1, width) min(2 radius + 1, height) texels of 2^bits codes.");
    detail::require(n * (spread * spread + 4) < std::int64_t(1) << 34, function, "bits and radius",
                    "small enough for squared distances of 32 bits", glm::dvec2(of.bits, of.radius));

    image<glm::u16vec4> table(map.size + 1, glm::u16vec4(0));
    const auto store = [&](glm::length_t first_channel) {
        summed_area(codes, sums, parallel);
        for (int y = 0; y < map.size.y; ++y)
            for (int x = 0; x < map.size.x; ++x) {
                const std::uint32_t sum = sums[{x, y}];
                glm::u16vec4& texel = table[{x + 1, y + 1}];
                texel[first_channel] = static_cast<std::uint16_t>(sum & 0xFFFF);
                texel[first_channel + 1] = static_cast<std::uint16_t>(sum >> 16);
            }
    };
    store(0);
    for (int y = 0; y < map.size.y; ++y)
        for (int x = 0; x < map.size.x; ++x) codes[{x, y}] *= codes[{x, y}];
    store(2);
    return table;
}

/// Visibility from a table: summed_variance of each receiver.
///
/// @param table       from make_variance_table
/// @param of          from make_variance_table
/// @param receivers   (x, y) in texels of the map, z depth with the bias already applied
/// @param radius      radius of the box in texels, at most the table's
/// @param out         receives visibility, 1 lit; same size as receivers, other memory than these
/// @param parallel    cuts the rows into pieces, see parallel.hpp
/// @param outside     bordered: everything outside the map is lit. clamped: as at the map's edge
/// @throws std::invalid_argument  sizes differ; a table without texels; bits out of range; radius below 0 or above the
///                                table's
template <class ParallelFor = serial>
void visibility(image_view<const glm::u16vec4> table, const variance_table& of, image_view<const glm::vec3> receivers,
                int radius, image_view<float> out, ParallelFor&& parallel = {},
                outside_map outside = outside_map::bordered) {
    constexpr auto function = "visibility";
    detail::require_size(out.size, receivers.size, function, "out.size", "the receivers' size");
    detail::require(table.size.x >= 2 && table.size.y >= 2, function, "table.size", "2 x 2 or more", table.size);
    detail::require(of.bits >= 1 && of.bits <= 12, function, "bits", "from 1 to 12", of.bits);
    if (radius < 0 || radius > of.radius)
        detail::refuse(function, "radius", std::string("from 0 to the table's, ").append(detail::printed(of.radius)),
                       radius, "Make the table with this radius.");
    const auto fetch = [table](glm::ivec2 at) { return glm::vec4(table.row(at.y)[at.x]); };
    const auto codes = static_cast<float>(1 << of.bits), reach = static_cast<float>(radius);
    const comparison is_lit{of.direction};
    parallel(out.size.y, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < out.size.x; ++x) {
                const glm::vec3 r = receivers.row(y)[x];
                out.row(y)[x] =
                    summed_variance(fetch, table.size - 1, glm::vec2(r), r.z, reach, codes, is_lit, outside);
            }
    });
}

}  // namespace umbrage
