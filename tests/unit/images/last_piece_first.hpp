// SPDX-License-Identifier: MIT
#pragma once

/// Runs the pieces of a loop in another order than anyone would. Some are empty where there are more than indices.
struct last_piece_first {
    int pieces;
    template <class Piece>
    void operator()(int count, Piece&& piece) const {
        for (int i = pieces - 1; i >= 0; --i) piece(count * i / pieces, count * (i + 1) / pieces);
    }
};
