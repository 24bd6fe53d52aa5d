// SPDX-License-Identifier: MIT
//
// How large images get to memory: past the cache, and asked for before they are needed.
//
//     const bool large = umbrage::detail::past_cache(out);
//     if (large) umbrage::detail::stream_block(to, from);
//     if (large) umbrage::detail::finish_streaming();
//
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <umbrage/image.hpp>
#include <umbrage/simd/dispatch.hpp>

namespace umbrage::detail {

/// Whether an image is so large that writing it would only push out of the cache what is read meanwhile, and fetch what
/// is overwritten anyway.
template <class T>
[[nodiscard]] inline bool past_cache(const image_view<T>& image) {
    constexpr double large = 4.0 * (1 << 20);  // bytes
    return static_cast<double>(sizeof(T)) * image.size.x * image.size.y >= large;
}

/// Whether stream() can store there.
[[nodiscard]] UMBRAGE_INLINE inline bool streams_to(const void* to) {
    return reinterpret_cast<std::uintptr_t>(to) % 16 == 0;
}

/// Stores past the cache. Wants multiples of 16 bytes, and finish_streaming() before anybody else looks.
template <std::size_t Bytes>
UMBRAGE_INLINE inline void stream(void* to, const void* from) {
#if (defined(__GNUC__) && defined(__x86_64__)) || defined(__clang__)
    typedef float four __attribute__((vector_size(16), may_alias));
    static_assert(Bytes % sizeof(four) == 0);
#pragma GCC unroll 16
    for (std::size_t i = 0; i < Bytes; i += sizeof(four)) {
        four part;
        std::memcpy(&part, static_cast<const std::byte*>(from) + i, sizeof part);
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

/// A block of texels past the cache, or through it where stream() cannot store.
template <class T>
UMBRAGE_INLINE inline void stream_block(T* to, const T* from) {
    if (streams_to(to)) stream<block * sizeof(T)>(to, from);
    else std::memcpy(static_cast<void*>(to), from, block * sizeof(T));
}

/// Starts to fetch what lies there, which may be behind the end of an array.
UMBRAGE_INLINE inline void prefetch_bytes(const void* from, std::ptrdiff_t ahead, int count) {
    const std::uintptr_t first = reinterpret_cast<std::uintptr_t>(from) + static_cast<std::uintptr_t>(ahead);
#pragma GCC unroll 16
    for (int line = 0; line < count; line += 64)
        UMBRAGE_PREFETCH(reinterpret_cast<const void*>(first + static_cast<std::uintptr_t>(line)));
}

}  // namespace umbrage::detail
