// SPDX-License-Identifier: MIT
//
// Triangles on the vertex grid, 64 at a time: edges and depth planes set up in loops that vectorise, then spans row by
// row without a division.
//
//     triangle_batch batch;
//     batch.add(p, q, r, id, {{0, 0}, size}, cull_mode::none);  // and more, until it is full()
//     batch.set_up();
//     for (int i = 0; i < batch.count; ++i)
//         batch.for_each_row(i, [&](int y, int first, int last) { ... });
//
// A sample is inside an edge from a to b where E = (b.x - a.x)(y - a.y) - (b.y - a.y)(x - a.x) >= 0, or > 0 where the
// edge is neither a top nor a left one. In a row the last such sample is a quotient of integers; from row to row the
// quotient and its remainder grow by constants, so that it stays exact.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/vec2.hpp>

#include <umbrage/images/mesh.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/raster/projection.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Depth over a triangle, exact on its grid: z + dx * x + dy * y for texels x, y counted from `first`.
struct depth_plane {
    glm::ivec2 first;        ///< a texel within the triangle's bounds
    double z, dx, dy;        ///< multiples of one power of two, so that no sum of theirs within the bounds is rounded
    double lowest, highest;  ///< of the vertices; samples never leave it

    [[nodiscard]] UMBRAGE_INLINE double unclamped(int x, int y) const {
        return z + dx * (x - first.x) + dy * (y - first.y);
    }
    [[nodiscard]] UMBRAGE_INLINE double operator()(int x, int y) const {
        const double depth = unclamped(x, y);
        return depth > lowest ? (depth < highest ? depth : highest) : lowest;
    }
};

/// Texels first <= t < last; y counts from the bottom.
struct texel_bounds {
    glm::ivec2 first, last;
};

/// A whole number to an integer, anything else to one of its neighbours; |v| < 2^51. AVX2 has no conversion.
[[nodiscard]] UMBRAGE_INLINE inline std::int64_t to_integer(double v) {
    constexpr double magic = 0x1.8p52;
    return bit_cast<std::int64_t>(v + magic) - bit_cast<std::int64_t>(magic);
}

/// Towards zero; |v| < 2^63.
template <isa Set>
[[nodiscard]] UMBRAGE_INLINE inline double truncate(double v) {
    if constexpr (Set == isa::avx2) return std::trunc(v);
    else return static_cast<double>(static_cast<std::int64_t>(v));
}

/// Up to 64 triangles, each coordinate an array of its own.
class triangle_batch {
public:
    int count = 0;
    alignas(64) unsigned id[block];

    triangle_batch() {  // every lane is set up, used or not
        for (int i = 0; i < block; ++i) {
            id[i] = 0;
            first_[0][i] = first_[1][i] = last_[0][i] = last_[1][i] = 0;
            for (auto& depth : z_) depth[i] = 0.0;
            for (int k = 0; k < 3; ++k) x_[k][i] = k == 1, y_[k][i] = k == 2;
        }
    }

    /// Rows first <= y < second whose centres are above the lowest corner, the highest included: a bottom edge and
    /// a corner cover no centre that they meet.
    [[nodiscard]] static UMBRAGE_INLINE std::pair<int, int> rows(std::int32_t lowest, std::int32_t highest) {
        return {(lowest + subtexels - centre) >> 8, ((highest - centre) >> 8) + 1};
    }

    [[nodiscard]] bool full() const { return count == block; }

    /// Takes a triangle unless it faces away, has no area or no sample in its bounds can be within `bounds`.
    /// There must be room.
    UMBRAGE_INLINE void add(const snapped_vertex& a, const snapped_vertex& b, const snapped_vertex& c,
                            unsigned triangle, const texel_bounds& bounds, cull_mode cull) {
        const auto [lowest, highest] = rows(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}));
        const int first_y = std::max(lowest, bounds.first.y), last_y = std::min(highest, bounds.last.y) - 1;
        const int left = std::min({a.x, b.x, c.x}) + subtexels - 1 - centre, right = std::max({a.x, b.x, c.x}) - centre;
        const int first_x = std::max(left >> 8, bounds.first.x), last_x = std::min(right >> 8, bounds.last.x - 1);
        if (first_x > last_x || first_y > last_y) return;

        const std::int64_t area = std::int64_t(b.x - a.x) * (c.y - a.y) - std::int64_t(c.x - a.x) * (b.y - a.y);
        if (area == 0 || cull == (area > 0 ? cull_mode::front : cull_mode::back)) return;

        // Counter-clockwise, the smallest vertex first, whatever the order in the mesh was.
        const snapped_vertex* const around[] = {&a, area > 0 ? &b : &c, area > 0 ? &c : &b, &a, area > 0 ? &b : &c};
        const auto key = [](const snapped_vertex& v) { return std::int64_t(v.x) * (std::int64_t(1) << 32) + v.y; };
        const std::int64_t keys[] = {key(*around[0]), key(*around[1]), key(*around[2])};
        const int second_or_third = keys[1] < keys[2] ? 1 : 2;
        const int smallest = keys[0] < keys[second_or_third] ? 0 : second_or_third;
        for (int k = 0; k < 3; ++k) {
            const snapped_vertex& v = *around[smallest + k];
            x_[k][count] = v.x, y_[k][count] = v.y, z_[k][count] = v.depth;
        }
        first_[0][count] = first_x, first_[1][count] = first_y;
        last_[0][count] = last_x, last_[1][count] = last_y;
        id[count++] = triangle;
    }

    /// Edges and planes of all triangles.
    ///
    /// @exactness  edges A: integers. Planes B: the same bits with and without FMA. With n the bounds' larger side in
    ///             1/256 texel and m the sum of the depth's and the two slopes' magnitudes over the bounds, a sample is
    ///             within 2^-48 n m of the plane through the snapped vertices
    void set_up() {
        on_best_isa([this](auto set) UMBRAGE_INLINE {
            for (int k = 0; k < 3; ++k) set_up_edges(k);
            set_up_planes<decltype(set)::value>();
        });
    }

    [[nodiscard]] UMBRAGE_INLINE depth_plane plane(int i) const {
        const double a = z_[0][i], b = z_[1][i], c = z_[2][i];
        const auto smaller = [](double p, double q) { return p < q ? p : q; };
        const auto larger = [](double p, double q) { return p < q ? q : p; };
        return {{first_[0][i], first_[1][i]}, depth_[i], dx_[i], dy_[i], smaller(smaller(a, b), c),
                larger(larger(a, b), c)};
    }

    [[nodiscard]] UMBRAGE_INLINE texel_bounds bounds(int i) const {
        return {{first_[0][i], first_[1][i]}, {last_[0][i] + 1, last_[1][i] + 1}};
    }

    /// @param row   (int y, int first, int last): texels first <= x < last of row y are covered; there is at least one
    template <class Row>
    UMBRAGE_INLINE void for_each_row(int i, const Row& row) const {
        // One edge bounds the rows on its side alone, the others on theirs.
        const bool left[] = {is_left(0, i), is_left(1, i), is_left(2, i)};
        const bool lone_is_left = left[0] + left[1] + left[2] == 1;
        const int lone = left[0] == lone_is_left ? 0 : left[1] == lone_is_left ? 1 : 2;
        auto p = edge_at(lone, i), q = edge_at(lone == 2 ? 0 : lone + 1, i), r = edge_at(lone == 0 ? 2 : lone - 1, i);
        const int x = first_[0][i], last_y = last_[1][i];
        const std::int64_t width = last_[0][i] - x;
        for (int y = first_[1][i]; y <= last_y; ++y) {
            const std::int64_t single = p.quotient, pair = q.quotient < r.quotient ? q.quotient : r.quotient;
            const std::int64_t before = lone_is_left ? single : pair, behind = lone_is_left ? pair : single;
            const std::int64_t low = before < 0 ? -before : 0, high = behind < width ? behind : width;
            if (low <= high) row(y, x + int(low), x + int(high) + 1);
            p.step(), q.step(), r.step();
        }
    }

private:
    static constexpr int centre = subtexels / 2;

    /// E divided by the magnitude of its step from texel to texel: how many texels further E still is not negative.
    struct edge {
        std::int64_t quotient, remainder, quotient_step, remainder_step, divisor;

        UMBRAGE_INLINE void step() {
            quotient += quotient_step;
            remainder += remainder_step;
            const bool carry = remainder >= divisor;
            quotient += carry;
            remainder -= carry ? divisor : 0;
        }
    };
    struct edges {
        alignas(64) std::int64_t quotient[block], remainder[block], quotient_step[block],
            remainder_step[block], divisor[block];
    };

    [[nodiscard]] UMBRAGE_INLINE edge edge_at(int k, int i) const {
        const edges& e = edges_[k];
        return {e.quotient[i], e.remainder[i], e.quotient_step[i], e.remainder_step[i], e.divisor[i]};
    }
    [[nodiscard]] UMBRAGE_INLINE bool is_left(int k, int i) const { return y_[k == 2 ? 0 : k + 1][i] < y_[k][i]; }

    UMBRAGE_INLINE void set_up_edges(int k) {
        edges& e = edges_[k];
        const auto &ax = x_[k], &ay = y_[k], &bx = x_[k == 2 ? 0 : k + 1], &by = y_[k == 2 ? 0 : k + 1];
        for (int i = 0; i < block; ++i) {
            const std::int32_t up = by[i] - ay[i], level = up == 0, right = (bx[i] - ax[i]) & (level - 1);
            const std::int32_t from_a_x = first_[0][i] * subtexels + centre - ax[i];
            const std::int32_t from_a_y = first_[1][i] * subtexels + centre - ay[i];
            const double value = double(right) * from_a_y + double(-up) * from_a_x - double(up > 0);
            const double divisor = double((up < 0 ? -up : up) + level) * subtexels, step = double(right) * subtexels;
            const std::int64_t d = to_integer(divisor);
            const auto divide = [&](double dividend, std::int64_t& quotient, std::int64_t& remainder) UMBRAGE_INLINE {
                const std::int64_t q = to_integer(dividend / divisor);  // or one off
                const std::int64_t rest = to_integer(dividend) - q * d;
                const std::int64_t below = -std::int64_t(rest < 0), above = -std::int64_t(rest >= d);
                quotient = q + below - above;
                remainder = rest + (d & below) - (d & above);
            };
            std::int64_t quotient;
            divide(value, quotient, e.remainder[i]);
            divide(step, e.quotient_step[i], e.remainder_step[i]);
            e.quotient[i] = quotient | std::int64_t(level) << 40;  // a level edge bounds no row from the side
            e.divisor[i] = d;
        }
    }

    template <isa Set>
    UMBRAGE_INLINE void set_up_planes() {
        using bits = std::int64_t;
        constexpr bits exponent = 0x7FF0000000000000, magnitude = 0x7FFFFFFFFFFFFFFF, short_digits = ~bits(0x3FFFFFF);
        constexpr bits tiny = bit_cast<bits>(0x1p-200);
        const auto power_of_two = [](double a, double b, double c) UMBRAGE_INLINE {  // the largest's, rounded down
            const bits p = bit_cast<bits>(a) & exponent, q = bit_cast<bits>(b) & exponent;
            const bits r = bit_cast<bits>(c) & exponent;
            const bits largest = p < q ? q : p, other = r < tiny ? tiny : r;
            return bit_cast<double>(largest < other ? other : largest);
        };
        for (int i = 0; i < block; ++i) {
            const double x1 = x_[1][i] - x_[0][i], y1 = y_[1][i] - y_[0][i];
            const double x2 = x_[2][i] - x_[0][i], y2 = y_[2][i] - y_[0][i];
            const std::int32_t left = std::min(std::min(x_[0][i], x_[1][i]), x_[2][i]);
            const std::int32_t right = std::max(std::max(x_[0][i], x_[1][i]), x_[2][i]);
            const std::int32_t bottom = std::min(std::min(y_[0][i], y_[1][i]), y_[2][i]);
            const std::int32_t top = std::max(std::max(y_[0][i], y_[1][i]), y_[2][i]);
            const double width = right - left, height = top - bottom;
            const double per_area = 1.0 / (x1 * y2 + x2 * -y1);

            // Depths with so few digits that the products with x1 .. y2 and their differences need no rounding.
            const double side = std::max(right - left, top - bottom);
            double unit = power_of_two(z_[0][i], z_[1][i], z_[2][i]) * masked(side, exponent) * 0x1p-49;
            double units = 1.0 / unit;
            const double z0 = truncate<Set>(z_[0][i] * units) * unit;
            const double z1 = truncate<Set>(z_[1][i] * units) * unit;
            const double z2 = truncate<Set>(z_[2][i] * units) * unit;
            const double slope_x = ((z1 - z0) * y2 + (z2 - z0) * -y1) * per_area;
            const double slope_y = ((z2 - z0) * x1 + (z1 - z0) * -x2) * per_area;

            // Slopes with so few digits that the same holds for every sample; here for the products.
            const double reach = masked(z0, magnitude) + masked(slope_x, magnitude & short_digits) * width +
                                 masked(slope_y, magnitude & short_digits) * height;
            unit = power_of_two(reach, 0.0, 0.0) * 0x1p-51;
            units = 1.0 / unit;
            const double dx = truncate<Set>(slope_x * units) * unit;
            const double dy = truncate<Set>(slope_y * units) * unit;
            depth_[i] = truncate<Set>(z0 * units) * unit + dx * (first_[0][i] * subtexels + centre - x_[0][i]) +
                        dy * (first_[1][i] * subtexels + centre - y_[0][i]);
            dx_[i] = dx * subtexels;
            dy_[i] = dy * subtexels;
            z_[0][i] = z0, z_[1][i] = z1, z_[2][i] = z2;
        }
    }

    alignas(64) std::int32_t x_[3][block], y_[3][block];  // counter-clockwise from the smallest
    alignas(64) double z_[3][block];
    alignas(64) std::int32_t first_[2][block], last_[2][block];  // texels whose centres are within the bounds
    edges edges_[3];
    alignas(64) double depth_[block], dx_[block], dy_[block];
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
