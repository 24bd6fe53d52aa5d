// SPDX-License-Identifier: MIT
//
// parallel_for, as umbrage's image functions take it, by whatever runs threads in your program.
#pragma once

#include <thread>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#endif
#ifdef THREADS_HAVE_TBB
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#endif

/// One std::thread for each piece but the last, which the caller does.
struct std_threads {
    int threads;
    template <class Piece>
    void operator()(int count, Piece&& piece) const {
        std::vector<std::jthread> others;
        for (int i = 0; i < threads; ++i) {
            const int first = static_cast<int>(static_cast<long long>(count) * i / threads);
            const int last = static_cast<int>(static_cast<long long>(count) * (i + 1) / threads);
            if (first == last) continue;
            if (i + 1 < threads)
                others.emplace_back([&piece, first, last] { piece(first, last); });
            else
                piece(first, last);
        }
    }
};

#ifdef _OPENMP
struct openmp {
    int threads;
    template <class Piece>
    void operator()(int count, Piece&& piece) const {
        constexpr int rows = 16;
        const int pieces = (count + rows - 1) / rows;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
        for (int i = 0; i < pieces; ++i) piece(i * rows, i + 1 < pieces ? (i + 1) * rows : count);
    }
};
#endif

#ifdef THREADS_HAVE_TBB
struct one_tbb {
    int threads;
    template <class Piece>
    void operator()(int count, Piece&& piece) const {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
        tbb::parallel_for(tbb::blocked_range<int>(0, count),
                          [&](const tbb::blocked_range<int>& rows) { piece(rows.begin(), rows.end()); });
    }
};
#endif
