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
// The contract of `parallel_for(count, piece)`, for count >= 0:
//   calls         piece(first, last) with 0 <= first <= last <= count, so that each of 0 .. count - 1 is in one piece.
//                 Some may be empty
//   order         any, of pieces of any lengths, on any threads and any number of them. The caller's thread may be one
//   return        after the last piece has returned. The pieces' writes must then be visible to the caller
//   exceptions    one that parallel_for throws, its own or a piece's, leaves the function. No piece may be running by
//                 then. Results are unspecified, and arguments may be used again
//   repetition    none. A piece may run again only while no other runs, and then changes no result
//   omission      a piece that never runs leaves its results unspecified, and later pieces may read them
// A function calls `parallel_for` from the caller's thread, once or several times, one call after the other. Pieces
// never call it. A piece may wait some microseconds for another that is running, but never for one that has yet to
// start. So one thread is enough, and several pools at once work too. Pieces are bands of rows, strips of columns, or
// triangles. The result has the same bits for all pieces.
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
