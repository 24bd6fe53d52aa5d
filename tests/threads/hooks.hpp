// SPDX-License-Identifier: MIT
//
// Hooks for threads that keep to the contract of core/parallel.hpp, and are unlike what a scheduler does.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

using piece = std::function<void(int first, int last)>;
using hook = std::function<void(int count, const piece&)>;

namespace hooks {

inline void all_in_one(int count, const piece& run) {
    if (count > 0) run(0, count);
}

/// One index a piece, from the last to the first, and pieces of nothing between them.
inline void backwards(int count, const piece& run) {
    for (int i = count; i > 0; --i) run(i, i), run(i - 1, i);
    run(0, 0);
}

/// Pieces of 1, 2, 3, ... indices, the odd ones first, each run again after all.
inline void twice(int count, const piece& run) {
    for (int time = 0; time < 2; ++time)
        for (int odd = 1; odd >= 0; --odd)
            for (int first = 0, length = 1; first < count; first += length++)
                if (length % 2 == odd) run(first, std::min(first + length, count));
}

/// Threads that take one index after the other. The first exception of a piece ends the pool.
struct pool {
    int threads;
    void operator()(int count, const piece& run) const {
        std::atomic<int> next = 0;
        std::exception_ptr thrown;
        std::mutex of_thrown;
        const auto work = [&] {
            try {
                for (int i = next++; i < count; i = next++) run(i, i + 1);
            } catch (...) {
                next = count;
                const std::lock_guard alone(of_thrown);
                if (!thrown) thrown = std::current_exception();
            }
        };
        {
            std::vector<std::jthread> all;
            for (int i = 0; i < threads; ++i) all.emplace_back(work);
        }
        if (thrown) std::rethrow_exception(thrown);
    }
};

struct failure : std::runtime_error {
    failure() : std::runtime_error("a scheduler fails") {}
};

/// Throws in place of a piece, or before the first of them.
struct failing {
    int& pieces_left;
    void operator()(int count, const piece& run) const {
        for (int i = 0; i < count; ++i) {
            if (pieces_left-- == 0) throw failure();
            run(i, i + 1);
        }
    }
};

}  // namespace hooks
