// SPDX-License-Identifier: MIT
//
// Summed-area tables, and bounds of filters.
#include <algorithm>
#include <cstdint>
#include <memory>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <umbrage/filter/bounds_lit.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/images/filter_bounds.hpp>
#include <umbrage/images/moment_table.hpp>
#include <umbrage/images/summed_area.hpp>
#include <umbrage/images/variance_table.hpp>

#include "works.hpp"

namespace {

using namespace umbrage;

/// 16 numbers, and the sum of the first of them from 0 on.
std::uint32_t value_of(int i) { return std::uint32_t(i) * 7u & 15u; }
std::uint32_t sum_of(int count) {
    std::uint32_t sum = std::uint32_t(count / 16) * 120u;
    for (int i = count / 16 * 16; i < count; ++i) sum += value_of(i);
    return sum;
}

prepared sums(int power) {
    struct both {
        image<std::uint32_t> values, table{values.size()};
    };
    const auto of = std::make_shared<both>(both{image<std::uint32_t>(size_of(power))});
    const glm::ivec2 size = of->values.size();
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) of->values.view().row(y)[x] = value_of(x) + value_of(y);
    return {double(area(size)), std::size_t(8 * size.y + 8 * size.x) + small_change,
            [of](stopwatch& watch) { watch.add([&] { summed_area(of->values, of->table); }); },
            [of] {
                return at_probes(of->table.size(), [&](glm::ivec2 at) {  // modulo 2^32
                    return of->table[at] ==
                           std::uint32_t(at.y + 1) * sum_of(at.x + 1) + std::uint32_t(at.x + 1) * sum_of(at.y + 1);
                });
            }};
}

prepared filter_bounds_of(int power) {
    struct both {
        image<float> depths;
        filter_bounds found{};
    };
    static constexpr filters::box filter{3};
    const auto of = std::make_shared<both>(both{depths_of(size_of(power))});
    const auto texels = area(of->depths.size());
    return {double(texels),
            texels / 4 * 33 + 320 * std::size_t(of->depths.size().y) +
                small_change,  // a copy with a border, and twice the bounds
            [of](stopwatch& watch) {
                of->found = {};
                watch.add([&] { of->found = make_filter_bounds(of->depths, filter.reach()); });
            },
            [of] {
                int decided = 0;
                const bool same = at_probes(of->depths.size(), [&](glm::ivec2 at) {
                    const glm::vec2 coord = glm::vec2(at) + 0.25f;
                    const float depth = at.x % 2 ? 0.1f : 0.9f;
                    const float lit = bounds_lit(clamped(of->found.bounds.view()), coord, depth, of->found.place);
                    if (lit < 0) return true;
                    ++decided;
                    return lit == filter(bordered(of->depths.view()), coord, depth);
                });
                return same && decided > 1000;
            }};
}

/// A table, and the visibility of receivers in it.
template <class Table>
struct with_table {
    Table of;
    image<float> depths;
    image<glm::u16vec4> table;
};

constexpr int radius = 3;

/// Bytes of a table's further column and row, and of sums of rows and columns.
std::size_t borders(glm::ivec2 size) { return 32 * std::size_t(size.x + size.y); }

/// Sum of the codes' or moments' first channel over a box, from the table: an integer below 2^32.
std::uint32_t box_of(const image<glm::u16vec4>& table, glm::ivec2 at, glm::ivec2 size, const auto& sum_at) {
    const glm::ivec2 first = glm::max(at - radius, glm::ivec2(0)), end = glm::min(at + radius + 1, size);
    return sum_at(table, end) - sum_at(table, {first.x, end.y}) - sum_at(table, {end.x, first.y}) +
           sum_at(table, first);
}
std::uint32_t box_of(glm::ivec2 at, glm::ivec2 size, const auto& value_at) {
    std::uint32_t sum = 0;
    for (int y = std::max(at.y - radius, 0); y < std::min(at.y + radius + 1, size.y); ++y)
        for (int x = std::max(at.x - radius, 0); x < std::min(at.x + radius + 1, size.x); ++x) sum += value_at(x, y);
    return sum;
}

prepared variances(int power) {
    const auto of = std::make_shared<with_table<variance_table>>();
    of->of.radius = radius, of->depths = depths_of(size_of(power));
    const auto texels = area(of->depths.size());
    return {double(texels), texels * 16 + borders(of->depths.size()) + small_change,
            [of](stopwatch& watch) {
                of->table = {};
                watch.add([&] { of->table = make_variance_table(of->depths, of->of); });
            },
            [of] {
                const auto code = [](int x, int y) { return std::uint32_t(depth_of(x, y) * 2048); };
                return at_probes(of->depths.size(), [&](glm::ivec2 at) {
                    const auto sum_at = [](glm::length_t channel) {
                        return [channel](const image<glm::u16vec4>& table, glm::ivec2 p) {
                            return std::uint32_t(table[p][channel]) | std::uint32_t(table[p][channel + 1]) << 16;
                        };
                    };
                    const glm::ivec2 size = of->depths.size();
                    return box_of(of->table, at, size, sum_at(0)) == box_of(at, size, code) &&
                           box_of(of->table, at, size, sum_at(2)) ==
                               box_of(at, size, [&](int x, int y) { return code(x, y) * code(x, y); });
                });
            }};
}

prepared moments(int power) {
    const auto of = std::make_shared<with_table<moment_table>>();
    of->of.radius = radius, of->depths = depths_of(size_of(power));
    const auto texels = area(of->depths.size());
    return {double(texels), texels * 32 + borders(of->depths.size()) + small_change,
            [of](stopwatch& watch) {
                of->table = {};
                watch.add([&] { of->table = make_moment_table(of->depths, of->of); });
            },
            [of] {
                return at_probes(of->depths.size(), [&](glm::ivec2 at) {
                    const glm::ivec2 size = of->depths.size();
                    for (glm::length_t channel = 0; channel < 4; ++channel) {
                        const auto sum_at = [&](const image<glm::u16vec4>& table, glm::ivec2 p) {
                            return std::uint32_t(table[p][channel]) |
                                   std::uint32_t(table[{p.x + size.x + 1, p.y}][channel]) << 16;
                        };
                        const auto moment = [&](int x, int y) {
                            const glm::vec4 m = to_optimized_moments(encode_msm(depth_of(x, y), 1.0f));
                            return std::uint32_t(m[channel] * 65535.0f + 0.5f);
                        };
                        if (box_of(of->table, at, size, sum_at) != box_of(at, size, moment)) return false;
                    }
                    return true;
                });
            }};
}

const registered here({{"big_tables", "summed_area", 30, 8.1, sums},
                       {"big_tables", "make_filter_bounds", 30, 12.3, filter_bounds_of},
                       {"big_tables", "make_variance_table", 29, 10.1, variances},
                       {"big_tables", "make_moment_table", 28, 9.1, moments}});

}  // namespace
