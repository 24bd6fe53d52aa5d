// SPDX-License-Identifier: MIT
//
// Whole depth images into texels of an encoding, and back, about as fast as memory can be copied.
//
//     umbrage::image<glm::u8vec2> packed(depth.size());
//     umbrage::encode(depth, packed, umbrage::rg<11>{});
//
// Bit for bit what the encoding's own encode and decode give. The encodings of this library have loops of their own
// that compilers can vectorise; any other type like them works as well.
#pragma once

#include <umbrage/core/check.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/depth/encoding.hpp>
#include <umbrage/images/blocks/codec.hpp>
#include <umbrage/images/parallel.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/memory.hpp>

namespace umbrage {
namespace detail {

/// Runs loops of a codec. FMA, which AVX-512 brings along, changes no result of an exact codec.
template <class Codec, class Body>
void on_isa_of(const Codec&, const Body& body) {
    if constexpr (Codec::exact) on_best_isa(body);
    else on_best_isa_without_fma(body);
}

/// A row in blocks; what is left goes through copies as long as a block, by a conversion that may be another.
template <class From, class To, class Convert, class ConvertRest>
UMBRAGE_INLINE inline void convert_row(const From* from, To* to, int count, const Convert& convert,
                                       const ConvertRest& convert_rest) {
    int x = 0;
    for (; x + block <= count; x += block) convert(from + x, to + x);
    if (x == count) return;
    From padded[block]{};
    To result[block];
    for (int i = x; i < count; ++i) padded[i - x] = from[i];
    convert_rest(padded, result);
    for (int i = x; i < count; ++i) to[i] = result[i - x];
}
template <class From, class To, class Convert>
UMBRAGE_INLINE inline void convert_row(const From* from, To* to, int count, const Convert& convert) {
    convert_row(from, to, count, convert, convert);
}

template <class Codec, class ParallelFor>
void encode_rows(image_view<const float> depth, image_view<typename Codec::texel> texels, const Codec& codec,
                 ParallelFor&& parallel) {
    using texel = typename Codec::texel;
    require_size(texels.size, depth.size, "encode", "texels.size", "depth's size");
    if (depth.empty()) return;
    const bool large = past_cache(texels);
    parallel(depth.size.y, [&](int first, int last) {
        on_isa_of(codec, [&](auto) UMBRAGE_INLINE {
            codec.with_encode([&](const auto& in_place) UMBRAGE_INLINE {
                const auto past_caches = [&](const float* from, texel* to) UMBRAGE_INLINE {
                    alignas(64) texel texels_of_block[block];
                    in_place(from, texels_of_block);
                    stream_block(to, texels_of_block);
                };
                // What is left of a row is copied from where it is put: not past the cache.
                for (int y = first; y < last; ++y) {
                    if (large) prefetch_rest(texels.row(y), depth.size.x);
                    if (large) convert_row(depth.row(y), texels.row(y), depth.size.x, past_caches, in_place);
                    else convert_row(depth.row(y), texels.row(y), depth.size.x, in_place);
                }
            });
        });
        if (large) finish_streaming();
    });
}

template <class Codec, class ParallelFor>
void decode_rows(image_view<const typename Codec::texel> texels, image_view<float> depth, const Codec& codec,
                 ParallelFor&& parallel) {
    require_size(depth.size, texels.size, "decode", "depth.size", "the texels' size");
    if (depth.empty()) return;
    parallel(depth.size.y, [&](int first, int last) {
        on_isa_of(codec, [&](auto) UMBRAGE_INLINE {
            const Codec own = codec;  // as far as a compiler knows, depths may overwrite the other
            for (int y = first; y < last; ++y)
                convert_row(texels.row(y), depth.row(y), depth.size.x,
                            [&](const auto* from, auto* to) UMBRAGE_INLINE { own.decode(from, to); });
        });
    });
}

}  // namespace detail

/// @param depth      any values; what the encoding makes of them
/// @param texels     same size, in memory of its own
/// @param encoding   one of the library's (encodings.hpp), or a type like them: texel, encode, decode
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ
template <class Encoding, class ParallelFor = serial>
void encode(image_view<const float> depth, image_view<typename Encoding::texel> texels, const Encoding& encoding,
            ParallelFor&& parallel = {}) {
    static_assert(detail::is_encoding<Encoding>());
    detail::encode_rows(depth, texels, detail::codec_of(encoding), parallel);
}

/// @param texels     any texels of the encoding
/// @param depth      same size, in memory of its own
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ
template <class Encoding, class ParallelFor = serial>
void decode(image_view<const typename Encoding::texel> texels, image_view<float> depth, const Encoding& encoding,
            ParallelFor&& parallel = {}) {
    static_assert(detail::is_encoding<Encoding>());
    detail::decode_rows(texels, depth, detail::codec_of(encoding), parallel);
}

}  // namespace umbrage
