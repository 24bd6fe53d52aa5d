// SPDX-License-Identifier: MIT
//
// Batches of 64 triangles on the vertex grid: winding, edges and depth planes, in loops that vectorize.
//
//     triangles batch;
//     batch.add(p, q, r, id);  // and more, until it is full()
//     batch.set_up({{0, 0}, size}, cull_mode::none);
//     for (int i = 0; i < batch.count; ++i)
//         batch.for_each_row(i, [&](int y, int first, int last) { ... });
//
// A sample is inside an edge from a to b if E = (b.x - a.x)(y - a.y) - (b.y - a.y)(x - a.x) >= 0. For an edge that
// is neither a top nor a left one the condition is E > 0, which is E - 1 >= 0. From texel to texel E grows by multiples
// of 256. So its sign is that of floor(E / 256), or of floor((E - 1) / 256): 32 bits for triangles up to 2048 texels.
//
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/draw/mesh.hpp>
#include <umbrage/draw/raster/projection.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/min_max.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Texels first <= t < last. y counts from the bottom.
struct texel_bounds {
    glm::ivec2 first, last;
};

/// Depth over a triangle, exact on its grid: z + dx * x + dy * y for texels x, y counted from `first`.
struct depth_plane {
    glm::ivec2 first;        ///< a texel within the triangle's bounds
    double z, dx, dy;        ///< multiples of one power of two: no sum of them within the bounds is rounded
    double lowest, highest;  ///< range of the vertices' depths; samples never leave it

    [[nodiscard]] UMBRAGE_INLINE double operator()(int x, int y) const {
        const double depth = z + dx * (x - first.x) + dy * (y - first.y);
        return depth > lowest ? (depth < highest ? depth : highest) : lowest;
    }
};

/// Up to 64 triangles, with one array per coordinate.
class triangles {
public:
    int count = 0;
    alignas(64) unsigned id[block];
    // After set_up():
    alignas(64) std::int32_t first_x[block], first_y[block], columns[block];  ///< texels that may be covered
    alignas(64) std::int32_t rows[block];                                     ///< 0: none is covered
    alignas(64) std::int32_t right[3][block], up[3][block];  ///< steps of edges / 256 from texel to texel
    alignas(64) std::int32_t edge[3][block];                 ///< edges / 256 at the first texel, if is_small
    alignas(64) float per_row[3][block];                     ///< -1 / up; undefined where that is 0

    triangles() {  // every lane is set up, used or not
        for (int i = 0; i < block; ++i) {
            id[i] = 0;
            for (int k = 0; k < 3; ++k) x_[k][i] = y_[k][i] = 0, z_[k][i] = 0.0;
        }
    }

    /// Rows first <= y < second whose centers are above the lowest corner, and not above the highest. A bottom
    /// edge and a corner cover no center that they meet.
    [[nodiscard]] static UMBRAGE_INLINE glm::ivec2 rows_between(std::int32_t lowest, std::int32_t highest) {
        return {(lowest + subtexels - center) >> 8, ((highest - center) >> 8) + 1};
    }

    [[nodiscard]] bool full() const { return count == block; }

    /// Adds a triangle. There must be room.
    UMBRAGE_INLINE void add(const snapped_vertex& a, const snapped_vertex& b, const snapped_vertex& c,
                            unsigned triangle) {
        const snapped_vertex* const corners[] = {&a, &b, &c};
        for (int k = 0; k < 3; ++k)
            x_[k][count] = corners[k]->x, y_[k][count] = corners[k]->y, z_[k][count] = corners[k]->depth;
        id[count++] = triangle;
    }

    /// Sets up all triangles. Triangles that face away, without area or without a texel within `bounds`, get no rows.
    ///
    /// @exactness  edges A: integers. Planes B: the same bits with and without FMA. A sample is within 2^-48 n m of the
    ///             plane through the snapped vertices: n is the bounds' larger side in 1/256 texel, m the sum of the
    ///             magnitudes of the depth and its two slopes over the bounds
    void set_up(const texel_bounds& bounds, cull_mode cull) {
        on_best_isa([&](auto) UMBRAGE_INLINE {
            set_up_bounds(bounds);
            set_up_areas(cull);
            set_up_planes();
            for (int k = 0; k < 3; ++k) set_up_edge(k);
        });
    }

    /// Rows first <= y < second that the triangles may cover. None: first >= second.
    [[nodiscard]] glm::ivec2 covered_rows() const {
        std::int32_t first = guard_band, last = 0;
        for (int i = 0; i < count; ++i)
            if (rows[i] > 0) first = lesser(first, first_y[i]), last = greater(last, first_y[i] + rows[i]);
        return {first, last};
    }

    [[nodiscard]] UMBRAGE_INLINE depth_plane plane(int i) const {
        const double a = z_[0][i], b = z_[1][i], c = z_[2][i];
        const double low = a < b ? a : b, high = a < b ? b : a;
        return {{first_x[i], first_y[i]}, depth_[i], dx_[i], dy_[i], low < c ? low : c, high < c ? c : high};
    }

    /// Depth of the plane at x, y texels from the first one, not limited to that of the corners.
    [[nodiscard]] UMBRAGE_INLINE double depth(int i, int x, int y) const { return depth_[i] + dx_[i] * x + dy_[i] * y; }
    [[nodiscard]] UMBRAGE_INLINE double corner_depth(int k, int i) const { return z_[k][i]; }
    /// Depth of the plane at a corner. It may differ from the corner's by the rounding of the slopes.
    [[nodiscard]] UMBRAGE_INLINE double depth_at_corner(int k, int i) const {
        return depth(i, 0, 0) + dx_[i] * 0x1p-8 * (x_[k][i] - first_x[i] * subtexels - center) +
               dy_[i] * 0x1p-8 * (y_[k][i] - first_y[i] * subtexels - center);
    }

    /// True when 32 bits hold the edges over the triangle's bounds, and some texels beyond.
    [[nodiscard]] UMBRAGE_INLINE bool is_small(int i) const { return side_[i] < 2048 * subtexels; }

    /// Edge / 256 at a texel: inside where it is not negative.
    [[nodiscard]] UMBRAGE_INLINE std::int64_t edge_at(int k, int i, int x, int y) const {
        const std::int64_t step_x = right[k][i], step_y = up[k][i];
        const std::int64_t e =
            step_y * (y * subtexels + center - y_[k][i]) + step_x * (x * subtexels + center - x_[k][i]);
        return (e - is_open(step_x, step_y)) >> 8;
    }

    /// Calls row() for each row that triangle i covers.
    /// @param row   (int y, int first, int last): texels first <= x < last of row y are covered; there is at least one
    template <class Row>
    UMBRAGE_INLINE void for_each_row(int i, const Row& row) const {
        // Sign of an edge's value: at texel `at`, the first of the row where it is not negative, the triangle begins or
        // has ended. From row to row it moves as far as the edge does, so no row is searched.
        struct side {
            bool begins;
            std::int64_t value, step, step_up;
            int at = 0;
        } sides[3];
        for (int k = 0; k < 3; ++k) {
            const std::int64_t value = edge_at(k, i, first_x[i], first_y[i]), r = right[k][i], u = up[k][i];
            if (r > 0) sides[k] = {true, value, r, u};
            else sides[k] = {false, -1 - value, -r, -u};
        }
        const int width = columns[i];
        for (int y = 0; y < rows[i]; ++y) {
            int first = 0, last = width;
            for (side& s : sides) {
                for (; s.at > 0 && s.value >= s.step; s.value -= s.step) --s.at;
                for (; s.at < width && s.value < 0; s.value += s.step) ++s.at;
                if (s.begins) first = greater(first, s.at);
                else last = lesser(last, s.at);
                s.value += s.step_up;
            }
            if (first < last) row(first_y[i] + y, first_x[i] + first, first_x[i] + last);
        }
    }

private:
    using bits = std::int64_t;
    static constexpr int center = subtexels / 2;

    /// True for right edges, and for bottom ones.
    template <class Int>
    [[nodiscard]] static UMBRAGE_INLINE Int is_open(Int right_step, Int up_step) {
        return Int(right_step < 0) | (Int(right_step == 0) & Int(up_step > 0));
    }

    /// Puts the smallest vertex first, so results do not depend on the order in the mesh. Finds texels within the
    /// bounds.
    UMBRAGE_INLINE void set_up_bounds(const texel_bounds& bounds) {
        const int min_x = bounds.first.x, min_y = bounds.first.y, max_x = bounds.last.x - 1, max_y = bounds.last.y - 1;
        for (int i = 0; i < block; ++i) {
            const std::int32_t ax = x_[0][i], bx = x_[1][i], cx = x_[2][i], ay = y_[0][i], by = y_[1][i], cy = y_[2][i];
            const std::int32_t b_first = -std::int32_t((bx < ax) | ((bx == ax) & (by < ay)));
            const std::int32_t x = b_first ? bx : ax, y = b_first ? by : ay;
            const std::int32_t c_first = -std::int32_t((cx < x) | ((cx == x) & (cy < y)));
            const auto pick = [=](std::int32_t p, std::int32_t q, std::int32_t r) UMBRAGE_INLINE {
                const std::int32_t of_two = b_first ? q : p;
                return c_first ? r : of_two;
            };
            second_is_first_[i] = b_first & ~c_first;
            third_is_first_[i] = c_first;
            x_[0][i] = pick(ax, bx, cx), x_[1][i] = pick(bx, cx, ax), x_[2][i] = pick(cx, ax, bx);
            y_[0][i] = pick(ay, by, cy), y_[1][i] = pick(by, cy, ay), y_[2][i] = pick(cy, ay, by);

            const std::int32_t left = lesser(lesser(ax, bx), cx), end = greater(greater(ax, bx), cx);
            const std::int32_t bottom = lesser(lesser(ay, by), cy), top = greater(greater(ay, by), cy);
            width_[i] = end - left, height_[i] = top - bottom;
            side_[i] = greater(end - left, top - bottom);
            const std::int32_t from_x = greater((left + subtexels - 1 - center) >> 8, min_x);
            const std::int32_t from_y = greater((bottom + subtexels - center) >> 8, min_y);
            const std::int32_t to_x = lesser((end - center) >> 8, max_x), to_y = lesser((top - center) >> 8, max_y);
            first_x[i] = from_x, first_y[i] = from_y;
            columns[i] = to_x - from_x + 1;
            rows[i] = (to_y - from_y + 1) & -std::int32_t((to_x >= from_x) & (to_y >= from_y));
        }
        for (int i = 0; i < block; ++i) {
            const bits second = second_is_first_[i], third = third_is_first_[i];
            const bits a = bit_cast<bits>(z_[0][i]), b = bit_cast<bits>(z_[1][i]), c = bit_cast<bits>(z_[2][i]);
            const auto pick = [=](bits p, bits q, bits r) UMBRAGE_INLINE {
                return bit_cast<double>((p & ~(second | third)) | (q & second) | (r & third));
            };
            z_[0][i] = pick(a, b, c), z_[1][i] = pick(b, c, a), z_[2][i] = pick(c, a, b);
        }
    }

    UMBRAGE_INLINE void set_up_areas(cull_mode cull) {
        const bits keep_front = -bits(cull != cull_mode::front), keep_back = -bits(cull != cull_mode::back);
        for (int i = 0; i < block; ++i) {
            const double x1 = x_[1][i] - x_[0][i], y1 = y_[1][i] - y_[0][i];
            const double x2 = x_[2][i] - x_[0][i], y2 = y_[2][i] - y_[0][i];
            area_[i] = x1 * y2 - x2 * y1;
        }
        for (int i = 0; i < block; ++i) {
            const bits area = bit_cast<bits>(area_[i]), clockwise = -bits(area < 0);
            const bits kept = -bits(area != 0) & ((keep_back & clockwise) | (keep_front & ~clockwise));
            clockwise_[i] = static_cast<std::int32_t>(clockwise);
            rows[i] &= static_cast<std::int32_t>(kept);
        }
    }

    UMBRAGE_INLINE void set_up_edge(int k) {
        const auto &ax = x_[k], &ay = y_[k], &bx = x_[k == 2 ? 0 : k + 1], &by = y_[k == 2 ? 0 : k + 1];
        for (int i = 0; i < block; ++i) {
            const std::int32_t turn = clockwise_[i];  // for the other winding all signs change
            const std::int32_t step_x = ((ay[i] - by[i]) ^ turn) - turn, step_y = ((bx[i] - ax[i]) ^ turn) - turn;
            right[k][i] = step_x, up[k][i] = step_y;
            per_row[k][i] = -1.0f / static_cast<float>(step_y | std::int32_t(step_y == 0));
            const double e = double(step_y) * (first_y[i] * subtexels + center - ay[i]) +
                             double(step_x) * (first_x[i] * subtexels + center - ax[i]) - is_open(step_x, step_y);
            // As an integer: the lower 51 bits of the double, without the last 8.
            edge[k][i] = static_cast<std::int32_t>(bit_cast<std::uint64_t>(e + 0x1.8p52) >> 8);
        }
    }

    UMBRAGE_INLINE void set_up_planes() {
        constexpr bits exponent = 0x7FF0000000000000, magnitude = 0x7FFFFFFFFFFFFFFF, short_digits = ~bits(0x3FFFFFF);
        constexpr bits tiny = bit_cast<bits>(0x1p-200);
        const auto power_of_two = [](double a, double b, double c)
                                      UMBRAGE_INLINE {  // of the largest number, rounded down
                                          const bits p = bit_cast<bits>(a) & exponent, q = bit_cast<bits>(b) & exponent;
                                          const bits r = bit_cast<bits>(c) & exponent;
                                          const bits largest = p < q ? q : p, other = r < tiny ? tiny : r;
                                          return bit_cast<double>(largest < other ? other : largest);
                                      };
        const auto one_over = [](double power) UMBRAGE_INLINE {
            return bit_cast<double>((bits(2046) << 52) - bit_cast<bits>(power));
        };
        const auto truncate = [](double v) UMBRAGE_INLINE {  // |v| < 2^52. GCC has no vectors of trunc() for AVX2
            const double size = masked(v, magnitude), rounded = (size + 0x1p52) - 0x1p52;
            const double whole = rounded - masked(1.0, -bits(rounded > size));
            return bit_cast<double>(bit_cast<bits>(whole) | (bit_cast<bits>(v) & ~magnitude));
        };
        for (int i = 0; i < block; ++i) {
            const double x1 = x_[1][i] - x_[0][i], y1 = y_[1][i] - y_[0][i];
            const double x2 = x_[2][i] - x_[0][i], y2 = y_[2][i] - y_[0][i];
            const double per_area = 1.0 / area_[i];

            // Depths with so few bits that the products with x1 .. y2 and their differences need no rounding.
            double unit = power_of_two(z_[0][i], z_[1][i], z_[2][i]) * masked(double(side_[i]), exponent) * 0x1p-49;
            double units = one_over(unit);
            const double z0 = truncate(z_[0][i] * units) * unit;
            const double z1 = truncate(z_[1][i] * units) * unit;
            const double z2 = truncate(z_[2][i] * units) * unit;
            const double slope_x = ((z1 - z0) * y2 + (z2 - z0) * -y1) * per_area;
            const double slope_y = ((z2 - z0) * x1 + (z1 - z0) * -x2) * per_area;

            // Slopes with so few bits that every sample needs no rounding. Here for the products.
            const double reach = masked(z0, magnitude) + masked(slope_x, magnitude & short_digits) * double(width_[i]) +
                                 masked(slope_y, magnitude & short_digits) * double(height_[i]);
            unit = power_of_two(reach, 0.0, 0.0) * 0x1p-51;
            units = one_over(unit);
            const double dx = truncate(slope_x * units) * unit;
            const double dy = truncate(slope_y * units) * unit;
            depth_[i] = truncate(z0 * units) * unit + dx * (first_x[i] * subtexels + center - x_[0][i]) +
                        dy * (first_y[i] * subtexels + center - y_[0][i]);
            dx_[i] = dx * subtexels;
            dy_[i] = dy * subtexels;
            z_[0][i] = z0, z_[1][i] = z1, z_[2][i] = z2;
        }
    }

    alignas(64) std::int32_t x_[3][block], y_[3][block];
    alignas(64) double z_[3][block];
    alignas(64) std::int32_t second_is_first_[block], third_is_first_[block], clockwise_[block];  // masks
    alignas(64) std::int32_t width_[block], height_[block], side_[block];  // in 1/256 texel; side_ is the larger one
    alignas(64) double area_[block], depth_[block], dx_[block], dy_[block];
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
