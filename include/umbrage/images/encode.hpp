// SPDX-License-Identifier: MIT
//
// Whole depth images into texels of an encoding, and back, about as fast as memory can be copied.
//
//     umbrage::image<glm::u8vec2> packed(depth.size());
//     umbrage::encode(depth.view(), packed.view(), umbrage::rg<11>{});
//
// Bit for bit what the encoding's own encode and decode give. The encodings of this library have loops of their own that
// compilers can vectorise; any other type like them works as well.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include <umbrage/depth/float_bits.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rgb24.hpp>
#include <umbrage/image.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/images/parallel.hpp>
#include <umbrage/simd/memory.hpp>

namespace umbrage {
namespace detail {

/// to_code() in a form that vectorises: what is 1 or more has the code of the last float below 1.
template <int Bits>
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t to_code_bits(float depth) {
    return static_cast<std::int32_t>(saturate_bits(depth, 0x1.fffffep-1f) * float(std::int32_t(1) << Bits));
}

/// A block of 64 depths to texels and back; this general one leaves the work to the encoding.
template <class Encoding>
struct block_codec {
    using texel = typename Encoding::texel;
    static UMBRAGE_INLINE void encode(const float* depth, texel* texels, const Encoding& encoding) {
        for (int i = 0; i < block; ++i) texels[i] = encoding.encode(depth[i]);
    }
    static UMBRAGE_INLINE void decode(const texel* texels, float* depth, const Encoding& encoding) {
        for (int i = 0; i < block; ++i) depth[i] = encoding.decode(texels[i]);
    }
};

/// Texels as 16-bit words, so that twice as many fit a register.
template <int Bits>
struct block_codec<rg<Bits>> {
    /// R | G << 8 to what this machine has in memory, and back.
    static UMBRAGE_INLINE std::uint16_t in_memory(std::uint16_t word) {
        if constexpr (std::endian::native == std::endian::little) return word;
        else return static_cast<std::uint16_t>(word << 8 | word >> 8);
    }
    static UMBRAGE_INLINE void encode(const float* depth, glm::u8vec2* texels, const rg<Bits>&) {
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const auto x = static_cast<std::uint16_t>(to_code_bits<Bits>(depth[i]));
            const std::uint16_t word = in_memory(static_cast<std::uint16_t>((x & 0xFF) | (x & 0xFF00) << (16 - Bits)));
            std::memcpy(static_cast<void*>(texels + i), &word, sizeof word);
        }
    }
    static UMBRAGE_INLINE void decode(const glm::u8vec2* texels, float* depth, const rg<Bits>& encoding) {
        const float edge = encoding.edge;  // a copy: as far as a compiler knows, depth may overwrite the other
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            std::uint16_t word;
            std::memcpy(&word, texels + i, sizeof word);
            word = in_memory(word);
            const auto x = static_cast<std::uint16_t>((word & 0xFF) + (word >> (16 - Bits) & 0xFF << (Bits - 8)));
            depth[i] = from_code<Bits>(float(x), edge);
        }
    }
};

template <>
struct block_codec<rgb24> {
    static UMBRAGE_INLINE void encode(const float* depth, glm::u8vec3* texels, const rgb24&) {
        alignas(64) std::int32_t x[block];
        for (int i = 0; i < block; ++i) x[i] = to_code_bits<24>(depth[i]);
        for (int i = 0; i < block; ++i)
            texels[i] = {static_cast<std::uint8_t>(x[i] >> 16), static_cast<std::uint8_t>(x[i] >> 8 & 0xFF),
                         static_cast<std::uint8_t>(x[i] & 0xFF)};
    }
    static UMBRAGE_INLINE void decode(const glm::u8vec3* texels, float* depth, const rgb24& encoding) {
        const float edge = encoding.edge;
        for (int i = 0; i < block; ++i) {
            const std::int32_t x = (texels[i].x << 16) + (texels[i].y << 8) + texels[i].z;
            depth[i] = from_code<24>(float(x), edge);
        }
    }
};

template <>
struct block_codec<float_bits> {
    static_assert(sizeof(glm::u8vec4) == sizeof(float));
    static UMBRAGE_INLINE void encode(const float* depth, glm::u8vec4* texels, const float_bits& encoding) {
        if constexpr (std::endian::native == std::endian::little)
            std::memcpy(static_cast<void*>(texels), depth, block * sizeof(float));
        else
            for (int i = 0; i < block; ++i) texels[i] = encoding.encode(depth[i]);
    }
    static UMBRAGE_INLINE void decode(const glm::u8vec4* texels, float* depth, const float_bits& encoding) {
        if constexpr (std::endian::native == std::endian::little)
            std::memcpy(depth, texels, block * sizeof(float));
        else
            for (int i = 0; i < block; ++i) depth[i] = encoding.decode(texels[i]);
    }
};

template <>
struct block_codec<depth32f> {
    static UMBRAGE_INLINE void encode(const float* depth, float* texels, const depth32f&) {
        for (int i = 0; i < block; ++i) texels[i] = saturate_bits(depth[i]);
    }
    static UMBRAGE_INLINE void decode(const float* texels, float* depth, const depth32f&) {
        std::memcpy(depth, texels, block * sizeof(float));
    }
};

/// A row in blocks; the last one goes through copies as long as a block.
template <class From, class To, class Convert>
UMBRAGE_INLINE inline void convert_row(const From* from, To* to, int count, const Convert& convert) {
    int x = 0;
    for (; x + block <= count; x += block) convert(from + x, to + x);
    if (x == count) return;
    From padded[block]{};
    To result[block];
    for (int i = 0; i < count - x; ++i) padded[i] = from[x + i];
    convert(padded, result);
    for (int i = 0; i < count - x; ++i) to[x + i] = result[i];
}

}  // namespace detail

/// @param depth      any values; what the encoding makes of them
/// @param texels     same size, in memory of its own
/// @param encoding   rg<Bits>, rgb24, float_bits, depth32f, or a type like them
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ
template <class Encoding, class ParallelFor = serial>
void encode(image_view<const float> depth, image_view<typename Encoding::texel> texels, Encoding encoding,
            ParallelFor&& parallel = {}) {
    if (depth.size != texels.size) detail::fail("umbrage::encode: sizes differ");
    if (depth.empty()) return;
    const bool large = detail::past_cache(texels);
    parallel(depth.size.y, [&](int first, int last) {
        detail::on_best_isa([&](auto) UMBRAGE_INLINE {
            using texel = typename Encoding::texel;
            const auto in_place = [&](const float* from, texel* to) UMBRAGE_INLINE {
                detail::block_codec<Encoding>::encode(from, to, encoding);
            };
            const auto by_a_copy = [&](const float* from, texel* to) UMBRAGE_INLINE {
                alignas(64) texel texels_of_block[detail::block];
                in_place(from, texels_of_block);
                detail::stream_block(to, texels_of_block);
            };
            for (int y = first; y < last; ++y)
                if (large) detail::convert_row(depth.row(y), texels.row(y), depth.size.x, by_a_copy);
                else detail::convert_row(depth.row(y), texels.row(y), depth.size.x, in_place);
        });
        if (large) detail::finish_streaming();
    });
}

/// @param texels     any texels of the encoding
/// @param depth      same size, in memory of its own
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ
template <class Encoding, class ParallelFor = serial>
void decode(image_view<const typename Encoding::texel> texels, image_view<float> depth, Encoding encoding,
            ParallelFor&& parallel = {}) {
    if (depth.size != texels.size) detail::fail("umbrage::decode: sizes differ");
    if (depth.empty()) return;
    parallel(depth.size.y, [&](int first, int last) {
        detail::on_best_isa([&](auto) UMBRAGE_INLINE {
            for (int y = first; y < last; ++y)
                detail::convert_row(texels.row(y), depth.row(y), depth.size.x,
                                    [&](const auto* from, auto* to) UMBRAGE_INLINE {
                                        detail::block_codec<Encoding>::decode(from, to, encoding);
                                    });
        });
    });
}

}  // namespace umbrage
