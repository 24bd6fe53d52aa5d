// SPDX-License-Identifier: MIT
//
// Memory access of large images: non-temporal stores and prefetching.
//
//     const bool large = umbrage::detail::past_cache(out);
//     if (large) umbrage::detail::stream_block(to, from);
//     if (large) umbrage::detail::finish_streaming();
//
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#if !defined(__GNUC__) && !defined(__clang__)
#include <atomic>
#endif
#if __has_include(<sched.h>)
#include <sched.h>
#else
#include <thread>
#endif

#include <umbrage/core/image.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/lanes.hpp>

namespace umbrage::detail {

/// Image that is written before it is read. It is not filled with zeros first, as other images are.
template <class T>
struct unset_image {
    explicit unset_image(glm::ivec2 size)
        : view(new T[static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)], size) {}
    ~unset_image() { delete[] view.data; }
    unset_image(const unset_image&) = delete;
    unset_image& operator=(const unset_image&) = delete;

    const image_view<T> view;
};

/// True for an image so large that non-temporal stores pay. Plain stores would read each cache line before overwriting
/// it, and evict data that is being read.
template <class T>
[[nodiscard]] inline bool past_cache(const image_view<T>& image) {
    constexpr double large = 4.0 * (1 << 20);  // bytes
    return static_cast<double>(sizeof(T)) * image.size.x * image.size.y >= large;
}

/// True when stream() can store at that address.
[[nodiscard]] UMBRAGE_INLINE inline bool streams_to(const void* to) {
    return reinterpret_cast<std::uintptr_t>(to) % 16 == 0;
}

/// Non-temporal stores of a multiple of 16 bytes. Other threads see them after finish_streaming().
template <std::size_t Bytes>
UMBRAGE_INLINE inline void stream(void* to, const void* from) {
#if (defined(__GNUC__) && defined(__x86_64__)) || defined(__clang__)
    typedef lanes_of<float, 4> four __attribute__((may_alias));
    static_assert(Bytes % sizeof(four) == 0);
#pragma GCC unroll 16
    for (std::size_t i = 0; i < Bytes; i += sizeof(four)) {
        four part;
        load_lanes(static_cast<const std::byte*>(from) + i, part);
#if defined(__clang__)
        __builtin_nontemporal_store(part, reinterpret_cast<four*>(static_cast<std::byte*>(to) + i));
#else
        __builtin_ia32_movntps(reinterpret_cast<float*>(static_cast<std::byte*>(to) + i), part);
#endif
    }
#else
    std::memcpy(to, from, Bytes);
#endif
}

inline void finish_streaming() {
#if defined(__GNUC__) && defined(__x86_64__)
    __builtin_ia32_sfence();
#endif
}

/// Stores a block of texels non-temporally where stream() can.
template <class T>
UMBRAGE_INLINE inline void stream_block(T* to, const T* from) {
    if (streams_to(to)) stream<block * sizeof(T)>(to, from);
    else std::memcpy(static_cast<void*>(to), from, block * sizeof(T));
}

/// Copies up to a block of floats. Most are full blocks, whose size the compiler then knows.
UMBRAGE_INLINE inline void copy_floats(float* to, const float* from, int count) {
    if (count == block) std::memcpy(to, from, block * sizeof(float));
    else std::memcpy(to, from, static_cast<std::size_t>(count) * sizeof(float));
}

/// Number that threads pass to each other, with everything that they wrote before. It replaces std::atomic, whose
/// header takes a tenth of the compile time of all of glm.hpp and the usual standard headers.
#if defined(__GNUC__) || defined(__clang__)
inline int load_acquire(const int& from) { return __atomic_load_n(&from, __ATOMIC_ACQUIRE); }
inline int exchange_acquire(int value, int& with) { return __atomic_exchange_n(&with, value, __ATOMIC_ACQUIRE); }
inline void store_release(int value, int& to) { __atomic_store_n(&to, value, __ATOMIC_RELEASE); }
#else
inline int load_acquire(const int& from) {
    return std::atomic_ref(const_cast<int&>(from)).load(std::memory_order_acquire);
}
inline int exchange_acquire(int value, int& with) {
    return std::atomic_ref(with).exchange(value, std::memory_order_acquire);
}
inline void store_release(int value, int& to) { std::atomic_ref(to).store(value, std::memory_order_release); }
#endif

/// Lets another thread run on this processor. <thread> would take longer to compile than <sched.h>, which most standard
/// headers include.
inline void yield_processor() {
#if __has_include(<sched.h>)
    sched_yield();
#else
    std::this_thread::yield();
#endif
}

/// Takes a lock that others hold for microseconds. It is 1 while a thread has it; store_release(0, lock) releases it.
/// After that time the holder may not be running, as with more threads than processors: it then gets this processor.
inline void take_lock(int& lock) {
    constexpr int patience = 1 << 10;  // a pause takes 10 to 40 ns
    for (int spins = 0; exchange_acquire(1, lock) != 0;)
        for (; load_acquire(lock) != 0; ++spins) {
            if (spins >= patience) yield_processor();
#if defined(__GNUC__) && defined(__x86_64__)
            else __builtin_ia32_pause();
#endif
        }
}

/// Prefetches a cache line. Callers must be UMBRAGE_INLINE or do more than that. For GCC a function that only
/// prefetches has no effect, and it removes the call.
UMBRAGE_INLINE inline void prefetch_line([[maybe_unused]] const void* at) {
#if defined(__GNUC__) || defined(__clang__)
    __builtin_prefetch(at);
#endif
}

/// Prefetches `count` bytes, `ahead` bytes from there. They may be past the end of an array.
UMBRAGE_INLINE inline void prefetch_bytes(const void* from, std::ptrdiff_t ahead, int count) {
    const std::uintptr_t first = reinterpret_cast<std::uintptr_t>(from) + static_cast<std::uintptr_t>(ahead);
#pragma GCC unroll 16
    for (int line = 0; line < count; line += 64)
        prefetch_line(reinterpret_cast<const void*>(first + static_cast<std::uintptr_t>(line)));
}

/// Prefetches the rest of a row after its last full step, before non-temporal stores to the row. The rest is stored
/// plainly. Stores complete in order, so those of the next rows would wait for its cache lines. Tables of 2032 columns
/// were five to seven times as slow.
template <class T>
UMBRAGE_INLINE inline void prefetch_rest(const T* row, int count, int step = block) {
    for (int x = count / step * step; x < count; x += static_cast<int>(64 / sizeof(T))) prefetch_line(row + x);
    if (count % step != 0) prefetch_line(row + count - 1);
}

}  // namespace umbrage::detail
