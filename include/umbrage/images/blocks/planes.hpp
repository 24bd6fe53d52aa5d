// SPDX-License-Identifier: MIT
//
// Blocks of receivers that are compared along their own planes: each loaded texel is moved as in apply_receiver_plane.
// A form that takes planes uses rows_on_planes() to move the registers that it loads, or move_texels() to move one
// texel per receiver. For receivers without planes both compile to nothing.
#pragma once

#include <cstdint>

#include <umbrage/core/config.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/lanes.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Planes of a block: position and slope of each receiver.
struct plane_block {
    alignas(64) float x[block], y[block], slope_x[block], slope_y[block];
    float cleared;  ///< depth of the far plane

    template <class Receivers>
    UMBRAGE_INLINE void copy(const Receivers& from, float far_plane) {
        cleared = far_plane;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            x[i] = from.x(i);
            y[i] = from.y(i);
            slope_x[i] = from.slope_x(i);
            slope_y[i] = from.slope_y(i);
        }
    }
    /// apply_receiver_plane of a texel in column `across` and row `up`.
    [[nodiscard]] UMBRAGE_INLINE float moved(int i, float stored, float across, float up) const {
        const float along = slope_x[i] * (across + 0.5f - x[i]), beside = slope_y[i] * (up + 0.5f - y[i]);
        return select(cleared_mask(stored, cleared), stored, stored - (along + beside));
    }
};

/// Rows of texels around one receiver, as a form loads them.
template <int Lanes>
struct plane_rows {
    static constexpr int chunk = Lanes;
    float slope, x, first, cleared;
    alignas(32) float beside[24];  ///< per row: depth that its distance from the receiver adds to the plane

    /// @param column        column of the first texel
    /// @param row           row of the first texel
    /// @param rows          number of rows of texels, at most 24
    UMBRAGE_INLINE plane_rows(const plane_block& planes, int i, int column, int row, int rows)
        : slope(planes.slope_x[i]), x(planes.x[i]), first(static_cast<float>(column)), cleared(planes.cleared) {
        const float y = planes.y[i], slope_y = planes.slope_y[i];
        for (int j = 0; j < rows; j += chunk)
            for (int k = 0; k < chunk; ++k) beside[j + k] = slope_y * (static_cast<float>(row + j + k) + 0.5f - y);
    }
    /// Moves a register of texels along the plane.
    /// @param moved   columns from the first one
    /// @param row     row from the first one
    UMBRAGE_INLINE void move(int moved, int row, lanes_of<float, Lanes>& texels) const {
        move_to_plane<Lanes>(slope, first + static_cast<float>(moved), x, beside[row], cleared, texels);
    }
};
/// Rows of texels around a receiver without a plane.
template <int Lanes>
struct rows_as_stored {
    UMBRAGE_INLINE void move(int, int, lanes_of<float, Lanes>&) const {}
};
template <int Lanes, class Placed>
[[nodiscard]] UMBRAGE_INLINE inline auto rows_on_planes([[maybe_unused]] const Placed& at, [[maybe_unused]] int i,
                                                        [[maybe_unused]] int column, [[maybe_unused]] int row,
                                                        [[maybe_unused]] int rows) {
    if constexpr (requires { at.planes; }) return plane_rows<Lanes>(at.planes, i, column, row, rows);
    else return rows_as_stored<Lanes>{};
}

/// Texel of receiver i, moved along its plane.
template <class Placed>
[[nodiscard]] UMBRAGE_INLINE inline float moved_texel([[maybe_unused]] const Placed& at, [[maybe_unused]] int i,
                                                      float stored, [[maybe_unused]] int column,
                                                      [[maybe_unused]] int row) {
    if constexpr (requires { at.planes; })
        return at.planes.moved(i, stored, static_cast<float>(column), static_cast<float>(row));
    else return stored;
}

/// Moves one texel of each receiver of a block.
/// @param column        returns the column of the texel of receiver i, inside or outside the map
/// @param row           returns its row
template <class Placed, class Column, class Row>
UMBRAGE_INLINE inline void move_texels(const Placed& at, const Column& column, const Row& row, float* texels) {
    if constexpr (requires { at.planes; }) {
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) texels[i] = moved_texel(at, i, texels[i], column(i), row(i));
    }
}

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
