// SPDX-License-Identifier: MIT
//
// Threads for image functions, from the caller's scheduler: the library starts none.
//
//     auto parallel_for = [&](int count, auto&& piece) {
//         tbb::parallel_for(tbb::blocked_range<int>(0, count),
//                           [&](const auto& range) { piece(range.begin(), range.end()); });
//     };
//     umbrage::encode(depth.view(), packed.view(), umbrage::rg<11>{}, parallel_for);
//
// parallel_for(count, piece) must call piece(first, last) so that the pieces cover 0 .. count once, in any order and on
// any threads. It returns when all are done. Pieces are bands of rows, or strips of columns. The result has the same
// bits for all pieces.
#pragma once

namespace umbrage {

/// Default: everything in one piece, on the caller's thread.
struct serial {
    template <class Piece>
    void operator()(int count, Piece&& piece) const {
        if (count > 0) piece(0, count);
    }
};

namespace detail {

/// Runs pieces on the caller's scheduler. A single piece runs directly, since threads would not help.
template <class ParallelFor, class Piece>
void in_pieces(int count, ParallelFor&& parallel, const Piece& piece) {
    if (count == 1) piece(0, 1);
    else parallel(count, piece);
}

}  // namespace detail
}  // namespace umbrage
