// SPDX-License-Identifier: MIT
//
// Encodings over blocks of 64 depths, in loops that vectorize. Results have the bits of their own encode and decode.
//
//     const auto codec = umbrage::detail::codec_of(umbrage::rg<11>{});
//     codec.with_encode([&](const auto& encode) UMBRAGE_INLINE { encode(depths, texels); });  // and more blocks
//
// A codec is `exact` where none of its results rounds. Compilers may then fuse multiplications and additions.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include <umbrage/depth/depth32f.hpp>
#include <umbrage/depth/float_bits.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rgb24.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>

namespace umbrage::detail {

/// saturate(), with NaN as `highest` or, where depth is reversed, as 0. Values that do not become 0 are one range of
/// bits, so one comparison finds them. These bits are signed integers above those of -infinity, or unsigned ones up to
/// those of infinity.
template <depth_direction Direction>
struct saturated {
    [[nodiscard]] UMBRAGE_INLINE float operator()(float v, float highest) const {
        constexpr auto minus_infinity = static_cast<std::int32_t>(0xFF800000u);
        const auto bits = bit_cast<std::int32_t>(v), top = bit_cast<std::int32_t>(highest);
        const std::int32_t magnitude = bits & 0x7FFFFFFF, clamped = magnitude < top ? magnitude : top;
        constexpr bool forward = Direction == depth_direction::forward;
        const bool kept = forward ? bits > minus_infinity : static_cast<std::uint32_t>(bits) <= 0x7F800000u;
        return bit_cast<float>(clamped & -std::int32_t(kept));
    }
    /// Code as of to_code. Depths of 1 or more get the code of the last float below 1.
    [[nodiscard]] UMBRAGE_INLINE std::int32_t code(float depth, float codes) const {
        return static_cast<std::int32_t>((*this)(depth, 0x1.fffffep-1f) * codes);
    }
};

/// Calls use(saturated) with the version for a direction.
template <class Use>
UMBRAGE_INLINE inline void with_saturated(depth_direction direction, const Use& use) {
    if (direction == depth_direction::forward) use(saturated<depth_direction::forward>{});
    else use(saturated<depth_direction::reversed>{});
}

/// Codec of any encoding, texel by texel.
template <class Encoding>
struct codec {
    using texel = typename Encoding::texel;
    static constexpr bool exact = false;
    Encoding encoding;

    /// Calls use(encode). The form of encode may depend on run-time values: checking those block by block costs a
    /// tenth.
    template <class Use>
    UMBRAGE_INLINE void with_encode(const Use& use) const {
        use([own = encoding](const float* depth, texel* texels) UMBRAGE_INLINE {
            for (int i = 0; i < block; ++i) texels[i] = own.encode(depth[i]);
        });
    }
    UMBRAGE_INLINE void decode(const texel* texels, float* depth) const {
        for (int i = 0; i < block; ++i) depth[i] = encoding.decode(texels[i]);
    }
};
template <class Encoding>
[[nodiscard]] codec<Encoding> codec_of(const Encoding& encoding) {
    return {encoding};
}

/// Codec of rg with any number of bits. Texels are 16-bit words, so that twice as many fit a register.
struct rg_codec {
    using texel = glm::u8vec2;
    static constexpr bool exact = true;
    int bits;
    float edge;
    depth_direction direction;

    /// Word R | G << 8 in this machine's byte order, and back.
    static UMBRAGE_INLINE std::uint16_t in_memory(std::uint16_t word) {
        if constexpr (std::endian::native == std::endian::little) return word;
        else return static_cast<std::uint16_t>(word << 8 | word >> 8);
    }
    template <class Use>
    UMBRAGE_INLINE void with_encode(const Use& use) const {
        const auto codes = static_cast<float>(1 << bits);
        const auto up = static_cast<std::uint16_t>(1 << (16 - bits));
        with_saturated(direction, [&](auto saturate) UMBRAGE_INLINE {
            use([=](const float* depth, texel* texels) UMBRAGE_INLINE {
                UMBRAGE_NO_OVERLAP
                for (int i = 0; i < block; ++i) {
                    const auto x = static_cast<std::uint16_t>(saturate.code(depth[i], codes));
                    const auto stored = static_cast<std::uint16_t>((x & 0xFF) | (x & 0xFF00) * up);
                    const std::uint16_t word = in_memory(stored);
                    std::memcpy(static_cast<void*>(texels + i), &word, sizeof word);
                }
            });
        });
    }
    UMBRAGE_INLINE void decode(const texel* texels, float* depth) const {
        const float from = edge, step = 1.0f / static_cast<float>(1 << bits);
        const auto up = static_cast<std::uint16_t>(1 << (bits - 8));
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            std::uint16_t word;
            std::memcpy(&word, texels + i, sizeof word);
            word = in_memory(word);
            const auto x = static_cast<std::uint16_t>((word & 0xFF) + (word >> 8) * up);
            depth[i] = (static_cast<float>(x) + from) * step;
        }
    }
};
template <int Bits>
[[nodiscard]] rg_codec codec_of(const rg<Bits>& encoding) {
    return {Bits, encoding.edge, encoding.direction};
}

template <>
struct codec<rgb24> {
    using texel = glm::u8vec3;
    static constexpr bool exact = true;
    rgb24 encoding;

    template <class Use>
    UMBRAGE_INLINE void with_encode(const Use& use) const {
        with_saturated(encoding.direction, [&](auto saturate) UMBRAGE_INLINE {
            use([=](const float* depth, texel* texels) UMBRAGE_INLINE {
                alignas(64) std::int32_t x[block];
                for (int i = 0; i < block; ++i) x[i] = saturate.code(depth[i], 0x1p24f);
                for (int i = 0; i < block; ++i)
                    texels[i] = {static_cast<std::uint8_t>(x[i] >> 16), static_cast<std::uint8_t>(x[i] >> 8 & 0xFF),
                                 static_cast<std::uint8_t>(x[i] & 0xFF)};
            });
        });
    }
    UMBRAGE_INLINE void decode(const texel* texels, float* depth) const {
        const float edge = encoding.edge;
        for (int i = 0; i < block; ++i) {
            const std::int32_t x = (texels[i].x << 16) + (texels[i].y << 8) + texels[i].z;
            depth[i] = from_code<24>(static_cast<float>(x), edge);
        }
    }
};

template <>
struct codec<float_bits> {
    static_assert(sizeof(glm::u8vec4) == sizeof(float));
    using texel = glm::u8vec4;
    static constexpr bool exact = true;
    float_bits encoding;

    template <class Use>
    UMBRAGE_INLINE void with_encode(const Use& use) const {
        use([&](const float* depth, texel* texels) UMBRAGE_INLINE {
            if constexpr (std::endian::native == std::endian::little)
                std::memcpy(static_cast<void*>(texels), depth, block * sizeof(float));
            else
                for (int i = 0; i < block; ++i) texels[i] = encoding.encode(depth[i]);
        });
    }
    UMBRAGE_INLINE void decode(const texel* texels, float* depth) const {
        if constexpr (std::endian::native == std::endian::little) std::memcpy(depth, texels, block * sizeof(float));
        else
            for (int i = 0; i < block; ++i) depth[i] = encoding.decode(texels[i]);
    }
};

template <>
struct codec<depth32f> {
    using texel = float;
    static constexpr bool exact = true;
    depth32f encoding;

    template <class Use>
    UMBRAGE_INLINE void with_encode(const Use& use) const {
        with_saturated(encoding.direction, [&](auto saturate) UMBRAGE_INLINE {
            use([=](const float* depth, texel* texels) UMBRAGE_INLINE {
                for (int i = 0; i < block; ++i) texels[i] = saturate(depth[i], 1.0f);
            });
        });
    }
    UMBRAGE_INLINE void decode(const texel* texels, float* depth) const {
        std::memcpy(depth, texels, block * sizeof(float));
    }
};

}  // namespace umbrage::detail
