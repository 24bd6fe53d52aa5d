// SPDX-License-Identifier: MIT
//
// Blocks of receivers that are compared along their own planes: each loaded texel is taken as by
// `apply_receiver_plane`. A form that takes planes uses `rows_on_planes()` for the registers that it loads, or
// `texels_on_planes()` for one texel per receiver. For receivers without planes both compile to nothing.
#pragma once

#include <cstdint>

#include <umbrage/core/config.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/lanes.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Planes of a block: position less half a texel, depth and slope of each receiver.
struct plane_block {
    alignas(64) float x[block], y[block], depth[block], slope_x[block], slope_y[block];

    template <class Receivers>
    UMBRAGE_INLINE void copy(const Receivers& from) {
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            x[i] = from.x(i) - 0.5f;
            y[i] = from.y(i) - 0.5f;
            depth[i] = from.z(i);
            slope_x[i] = from.slope_x(i);
            slope_y[i] = from.slope_y(i);
        }
    }
    /// apply_receiver_plane of a texel in column `across` and row `up`.
    template <bool Forward>
    [[nodiscard]] UMBRAGE_INLINE float compared(int i, float stored, float across, float up) const {
        const float along = slope_x[i] * (across - x[i]), beside = slope_y[i] * (up - y[i]);
        return lit_on_plane<Forward>(depth[i], (depth[i] + along) + beside, stored);
    }
};

/// Rows of texels around one receiver, as a form loads them.
template <int Lanes>
struct plane_rows {
    static constexpr int chunk = Lanes;
    float slope, x, first, receiver;
    alignas(32) float beside[24];  ///< per row: depth that its distance from the receiver adds to the plane

    /// @param column        column of the first texel
    /// @param row           row of the first texel
    /// @param rows          number of rows of texels, at most 24
    UMBRAGE_INLINE plane_rows(const plane_block& planes, int i, int column, int row, int rows)
        : slope(planes.slope_x[i]), x(planes.x[i]), first(static_cast<float>(column)), receiver(planes.depth[i]) {
        const float y = planes.y[i], slope_y = planes.slope_y[i];
        for (int j = 0; j < rows; j += chunk)
            for (int k = 0; k < chunk; ++k) beside[j + k] = slope_y * (static_cast<float>(row + j + k) - y);
    }
    /// Compares a register of texels along the plane.
    /// @param moved   columns from the first one
    /// @param row     row from the first one
    template <bool Forward>
    UMBRAGE_INLINE void compare(int moved, int row, lanes_of<float, Lanes>& texels) const {
        compare_on_plane<Lanes, Forward>(slope, first + static_cast<float>(moved), x, beside[row], receiver, texels);
    }
};
/// Rows of texels around a receiver without a plane.
template <int Lanes>
struct rows_as_stored {
    template <bool Forward>
    UMBRAGE_INLINE void compare(int, int, lanes_of<float, Lanes>&) const {}
};
template <int Lanes, class Placed>
[[nodiscard]] UMBRAGE_INLINE inline auto rows_on_planes([[maybe_unused]] const Placed& at, [[maybe_unused]] int i,
                                                        [[maybe_unused]] int column, [[maybe_unused]] int row,
                                                        [[maybe_unused]] int rows) {
    if constexpr (requires { at.planes; }) return plane_rows<Lanes>(at.planes, i, column, row, rows);
    else return rows_as_stored<Lanes>{};
}

/// Texel of receiver i, along its plane.
template <bool Forward, class Placed>
[[nodiscard]] UMBRAGE_INLINE inline float texel_on_plane([[maybe_unused]] const Placed& at, [[maybe_unused]] int i,
                                                         float stored, [[maybe_unused]] int column,
                                                         [[maybe_unused]] int row) {
    if constexpr (requires { at.planes; })
        return at.planes.template compared<Forward>(i, stored, static_cast<float>(column), static_cast<float>(row));
    else return stored;
}

/// One texel of each receiver of a block, along its plane.
/// @param column        returns the column of the texel of receiver i, inside or outside the map
/// @param row           returns its row
template <bool Forward, class Placed, class Column, class Row>
UMBRAGE_INLINE inline void texels_on_planes(const Placed& at, const Column& column, const Row& row, float* texels) {
    if constexpr (requires { at.planes; }) {
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) texels[i] = texel_on_plane<Forward>(at, i, texels[i], column(i), row(i));
    }
}

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
