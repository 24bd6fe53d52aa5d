// SPDX-License-Identifier: MIT
//
// How image functions use threads: they have none, and ask the caller's scheduler.
//
//     auto parallel_for = [&](int count, auto&& piece) {
//         tbb::parallel_for(tbb::blocked_range<int>(0, count),
//                           [&](const auto& range) { piece(range.begin(), range.end()); });
//     };
//     umbrage::encode(depth.view(), packed.view(), umbrage::rg<11>{}, parallel_for);
//
// parallel_for(count, piece) calls piece(first, last) so that the pieces cover 0 .. count once, in any order, on any
// threads, and returns when all are done. Pieces are bands of rows, or strips of columns; no way to cut them changes a
// bit.
#pragma once

namespace umbrage {

/// The default: everything in one piece, on the caller's thread.
struct serial {
    template <class Piece>
    void operator()(int count, Piece&& piece) const {
        if (count > 0) piece(0, count);
    }
};

namespace detail {

/// By the caller's scheduler, unless there is only one piece, for which it would start threads in vain.
template <class ParallelFor, class Piece>
void in_pieces(int count, ParallelFor&& parallel, const Piece& piece) {
    if (count == 1) piece(0, 1);
    else parallel(count, piece);
}

}  // namespace detail
}  // namespace umbrage
