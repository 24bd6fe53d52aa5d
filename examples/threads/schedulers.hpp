// SPDX-License-Identifier: MIT
//
// parallel_for, as umbrage's image functions take it, by whatever runs threads in your program.
#pragma once

#include <algorithm>
#include <atomic>
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

/// Threads that take the next piece when they are done with one: no two rows cost the same.
struct std_threads {
    int threads;
    template <class Piece>
    void operator()(int count, Piece&& piece) const {
        const int rows = std::max(1, count / (8 * threads));
        std::atomic<int> next = 0;
        const auto work = [&] {
            for (int first = next.fetch_add(rows); first < count; first = next.fetch_add(rows))
                piece(first, std::min(first + rows, count));
        };
        std::vector<std::jthread> others;
        for (int i = 1; i < threads; ++i) others.emplace_back(work);
        work();
    }
};

#ifdef _OPENMP
struct openmp {
    int threads;
    template <class Piece>
    void operator()(int count, Piece&& piece) const {
        const int rows = std::max(1, count / (8 * threads)), pieces = (count + rows - 1) / rows;
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
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                        static_cast<std::size_t>(threads));
        tbb::parallel_for(tbb::blocked_range<int>(0, count),
                          [&](const tbb::blocked_range<int>& rows) { piece(rows.begin(), rows.end()); });
    }
};
#endif
