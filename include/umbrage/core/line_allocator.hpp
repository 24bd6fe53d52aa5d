// SPDX-License-Identifier: MIT
//
// Allocator of images' memory, which starts at a cache line.
//
//     std::vector<float, detail::line_allocator<float>> texels;
//
#pragma once

#include <cstddef>
#include <new>

namespace umbrage::detail {

/// Allocator that aligns memory to cache lines, so that blocks of pixels do not straddle two lines needlessly.
template <class T>
struct line_allocator {
    using value_type = T;
    static constexpr std::align_val_t line{64};

    line_allocator() = default;
    template <class Other>
    line_allocator(const line_allocator<Other>&) {}
    [[nodiscard]] T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), line)); }
    void deallocate(T* pixels, std::size_t) { ::operator delete(pixels, line); }
    bool operator==(const line_allocator&) const = default;
};

}  // namespace umbrage::detail
