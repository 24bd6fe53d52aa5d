// SPDX-License-Identifier: MIT
//
// Locks for rows of an image to which several threads draw: one thread at a time may draw to a row.
//
//     row_locks<> locks(height);
//     locks.hold({first, last}, [&] { ... });
//
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/simd/memory.hpp>

namespace umbrage::detail {

template <class = on_use>
class row_locks {
public:
    explicit row_locks(int height) : locks_(std::size_t(height / rows_a_lock + 1)) {}

    /// Runs `use` while no other thread draws to the rows.
    /// @param rows   first <= y < second, at least one row
    /// @param use    (); must not throw
    template <class Use>
    void hold(const glm::ivec2& rows, const Use& use) {
        const std::size_t first = std::size_t(rows.x / rows_a_lock), last = std::size_t((rows.y - 1) / rows_a_lock);
        // From the first on in every thread, so that no two threads wait for each other.
        for (std::size_t i = first; i <= last; ++i) take_lock(locks_[i].held);
        use();
        for (std::size_t i = first; i <= last; ++i) store_release(0, locks_[i].held);
    }

private:
    static constexpr int rows_a_lock = 16;

    struct alignas(64) lock {  // one cache line each: threads at other rows take none from each other
        int held = 0;
    };
    std::vector<lock> locks_;
};

}  // namespace umbrage::detail
