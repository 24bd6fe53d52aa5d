// SPDX-License-Identifier: MIT
//
// Heap of this program: operator new counts bytes, and fails when told to.
//
//     const std::size_t bytes = heap::peak_of([&] { umbrage::encode(depth, packed, encoding); });
//     heap::fail(3, heap::lack::once);  // the third allocation from here on throws std::bad_alloc
#pragma once

#include <cstddef>

namespace heap {

/// Bytes that are allocated now.
[[nodiscard]] std::size_t live();

/// Largest number of bytes since restart_peak().
[[nodiscard]] std::size_t peak();
void restart_peak();

/// Bytes that run() has at most, beyond those from before it.
template <class Run>
[[nodiscard]] std::size_t peak_of(const Run& run) {
    restart_peak();
    const std::size_t before = live();
    run();
    return peak() - before;
}

enum class lack {
    once,  ///< one allocation fails
    all,   ///< it and all later ones
};

/// Makes the n-th allocation from here on fail, in whatever thread.
void fail(long nth, lack of);

/// Lets all allocations succeed again.
/// @return   true if one has failed
bool stop_failing();

}  // namespace heap
