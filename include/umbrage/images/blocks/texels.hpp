// SPDX-License-Identifier: MIT
//
// Maps as blocks of receivers read them: floats, and the two channels of rg with any number of bits. Other encodings
// are decoded to floats first. A block's texels are loaded word by word, and compared in loops that vectorize.
//
//     lit += test::lit(texels.receiver(depth), texels.one(i));
//
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include <glm/vec2.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/lanes.hpp>
#include <umbrage/simd/memory.hpp>

namespace umbrage::detail {

/// Comparison in a depth direction, as numbers and masks.
template <depth_direction Direction>
struct block_test {
    static constexpr bool forward = Direction == depth_direction::forward;

    /// 1 when lit. NaN is not.
    [[nodiscard]] static UMBRAGE_INLINE std::int32_t lit(float receiver, float stored) {
        return forward ? is_lit(receiver, stored) : is_lit(stored, receiver);
    }
    /// Bounds tests of a receiver: true when all texels between the bounds are lit, or when none is. The lower bound is
    /// NaN where a texel is.
    [[nodiscard]] static UMBRAGE_INLINE std::int32_t all_lit(float receiver, float least, float greatest) {
        return forward ? is_lit(receiver, least) : is_lit(greatest, receiver) & is_lit(least, greatest);
    }
    [[nodiscard]] static UMBRAGE_INLINE std::int32_t none_lit(float receiver, float least, float greatest) {
        return forward ? std::int32_t(receiver > greatest) : std::int32_t(receiver < least) & number_mask(least);
    }
    /// in_filter_domain as a mask.
    [[nodiscard]] static UMBRAGE_INLINE std::int32_t compared(float x, float y, float z) {
        return texel_space_mask(x, y) & ~beyond_far_plane_mask<forward>(z);
    }
};

/// Map of floats.
struct float_texels {
    using texel = float;
    image_view<const float> map;
};

/// Map of rg texels.
struct rg_texels {
    using texel = glm::u8vec2;
    image_view<const glm::u8vec2> map;
    int bits;
    float edge;
};

/// Texels of a map by their distance in bytes from the start of its middle row. In maps of up to 4 GiB it fits 32 bits,
/// so loops vectorize.
template <class T>
struct texel_bytes {
    const std::byte* data;  ///< middle row
    std::int32_t stride, middle;

    explicit texel_bytes(const image_view<T>& map)
        : stride(static_cast<std::int32_t>(map.stride)), middle((map.size.y - (stride < 0 ? 1 : 0)) / 2) {
        data = reinterpret_cast<const std::byte*>(map.data) + middle * map.stride;
    }
    static bool fits(glm::ivec2 size, std::ptrdiff_t stride) {
        constexpr std::int64_t half = std::int64_t(1) << 31;
        const std::int64_t row = std::int64_t(size.x) * std::int64_t(sizeof(T)), apart = stride < 0 ? -stride : stride;
        return row <= half && apart < half && apart * ((size.y + 1) / 2) <= half;
    }
    UMBRAGE_INLINE std::int32_t offset(std::int32_t x, std::int32_t y) const {
        return (y - middle) * stride + x * static_cast<std::int32_t>(sizeof(T));
    }
};

/// Gathers a block of words from offsets, and blocks of words from the rows below. Words that fill a small register
/// make one store. Without that, compilers want more at once than they can hold.
template <class Word, class T, class... To>
UMBRAGE_INLINE inline void gather(const texel_bytes<T>& memory, const std::int32_t* offsets, To*... rows) {
    using words = lanes_of<Word, 16 / sizeof(Word)>;
    constexpr std::size_t some = sizeof(words) / sizeof(Word);
    const auto word = [](const std::byte* from) UMBRAGE_INLINE {
        Word w;
        std::memcpy(&w, from, sizeof w);
        return w;
    };
    const auto load = [&]<std::size_t... I>(int i, int row, void* to, std::index_sequence<I...>) UMBRAGE_INLINE {
        const std::byte* const from = memory.data + std::ptrdiff_t(row) * memory.stride;
        const words together{word(from + offsets[i + static_cast<int>(I)])...};
        std::memcpy(static_cast<std::byte*>(to) + static_cast<std::size_t>(i) * sizeof(Word), &together,
                    sizeof together);
    };
    for (int i = 0; i < block; i += static_cast<int>(some)) {
        int row = 0;
        (load(i, row++, rows, std::make_index_sequence<some>{}), ...);
    }
}

/// Texels loaded for a block of receivers: one per receiver, or two neighbors in each of two rows.
template <class Map>
struct loaded_texels;

/// Float texels. They need no decoding, and two of them are one word.
template <>
struct loaded_texels<float_texels> {
    alignas(64) float depths[2 * block];
    explicit loaded_texels(const float_texels&) {}
    UMBRAGE_INLINE void load_one(const texel_bytes<const float>& memory, const std::int32_t* offsets) {
        gather<std::uint32_t>(memory, offsets, depths);
    }
    static UMBRAGE_INLINE void load_two(const texel_bytes<const float>& memory, const std::int32_t* offsets,
                                        loaded_texels& low, loaded_texels& high) {
        gather<std::uint64_t>(memory, offsets, low.depths, high.depths);
    }
    UMBRAGE_INLINE float receiver(float depth) const { return depth; }
    UMBRAGE_INLINE float one(int i) const { return depths[i]; }
    UMBRAGE_INLINE float first(int i) const { return depths[2 * i]; }
    UMBRAGE_INLINE float second(int i) const { return depths[2 * i + 1]; }
};

/// Byte pairs, two to a word. Both sides of the comparison are scaled by 2^bits, which changes no result.
template <>
struct loaded_texels<rg_texels> {
    static constexpr bool little = std::endian::native == std::endian::little;
    static constexpr std::uint32_t low_bytes = 0x00FF00FF;
    alignas(64) std::uint32_t words[block];
    float edge, scale;
    int up;  ///< bits - 8: the code is R + 2^up G
    std::uint32_t high_bytes;

    explicit UMBRAGE_INLINE loaded_texels(const rg_texels& map)
        : edge(map.edge), scale(static_cast<float>(1 << map.bits)), up(map.bits - 8), high_bytes(low_bytes << up) {}
    UMBRAGE_INLINE void load_one(const texel_bytes<const glm::u8vec2>& memory, const std::int32_t* offsets) {
        for (int i = 0; i < block; ++i) {
            std::uint16_t word;
            std::memcpy(&word, memory.data + offsets[i], sizeof word);
            words[i] = word;
        }
    }
    static UMBRAGE_INLINE void load_two(const texel_bytes<const glm::u8vec2>& memory, const std::int32_t* offsets,
                                        loaded_texels& low, loaded_texels& high) {
        gather<std::uint32_t>(memory, offsets, low.words, high.words);
    }
    UMBRAGE_INLINE float receiver(float depth) const { return depth * scale; }
    UMBRAGE_INLINE float one(int i) const { return number(codes(i) & 0xFFFF); }
    UMBRAGE_INLINE float first(int i) const { return number(little ? codes(i) & 0xFFFF : codes(i) >> 16); }
    UMBRAGE_INLINE float second(int i) const { return number(little ? codes(i) >> 16 : codes(i) & 0xFFFF); }
    /// R + 2^(bits - 8) G of both texels at once, in the two halves of a word.
    UMBRAGE_INLINE std::uint32_t codes(int i) const {
        const std::uint32_t w = words[i];
        return little ? (w & low_bytes) + (w >> (8 - up) & high_bytes) : (w >> 8 & low_bytes) + ((w & low_bytes) << up);
    }
    UMBRAGE_INLINE float number(std::uint32_t code) const {
        return static_cast<float>(static_cast<std::int32_t>(code)) + edge;
    }
};

/// Texel inside the map, without the assertion of image_view.
template <class T>
[[nodiscard]] UMBRAGE_INLINE inline T* texel_at(const image_view<T>& map, std::int32_t x, std::int32_t y) {
    return reinterpret_cast<T*>(reinterpret_cast<const std::byte*>(map.data) + y * map.stride) + x;
}

/// Last texel of a map that a receiver can read, for texel numbers below `space`.
[[nodiscard]] UMBRAGE_INLINE inline int last_in_space(int size, int space) { return (size < space ? size : space) - 1; }

/// Prefetches the texels of a block, of which neighbors mostly share a cache line. The machine cannot guess them where
/// a block starts on another row of the map. Receivers that run diagonally across the map come to the rows above and
/// below.
template <class T>
UMBRAGE_INLINE inline void prefetch(const texel_bytes<T>& memory, const std::int32_t* offsets, int rows) {
    for (int row = -1; row <= rows; ++row)
#pragma GCC unroll 4
        for (int i = 0; i < block; i += 16)
            prefetch_bytes(memory.data, offsets[i] + std::ptrdiff_t(row) * memory.stride, 1);
}

}  // namespace umbrage::detail
