// SPDX-License-Identifier: MIT
//
// Encoding of whole depth images into texels, and decoding, about as fast as memory can be copied.
//
//     umbrage::image<glm::u8vec2> packed(depth.size());
//     umbrage::encode(depth, packed, umbrage::rg<11>{});
//
// Results have the same bits as the encoding's own encode and decode. Encodings of this library have loops that
// compilers can vectorize. Any other type with the same functions works as well.
#pragma once

#include <umbrage/core/check.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/depth/encoding.hpp>
#include <umbrage/images/codec.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/memory.hpp>

namespace umbrage {
namespace detail {

/// Runs the loops of a codec. FMA, which comes with AVX-512, changes no result of an exact codec.
template <class Codec, class Body>
void on_isa_of(const Codec&, const Body& body) {
    if constexpr (Codec::exact) on_best_isa(body);
    else on_best_isa_without_fma(body);
}

/// Converts a row in blocks. The rest goes through copies of block length, by a conversion that may differ.
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
                // The rest of a row is copied from where it is put, so it does not bypass the cache.
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
            const Codec own = codec;  // for the compiler, depths might overwrite the other one
            for (int y = first; y < last; ++y)
                convert_row(texels.row(y), depth.row(y), depth.size.x,
                            [&](const auto* from, auto* to) UMBRAGE_INLINE { own.decode(from, to); });
        });
    });
}

}  // namespace detail

/// Encodes an image of depths.
/// @param depth      any values, converted as by the encoding's encode
/// @param texels     receives the texels: same size, other memory
/// @param encoding   one of this library (encodings.hpp), or any type with texel, encode, decode
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ
template <class Encoding, class ParallelFor = serial>
void encode(image_view<const float> depth, image_view<typename Encoding::texel> texels, const Encoding& encoding,
            ParallelFor&& parallel = {}) {
    static_assert(detail::is_encoding<Encoding>());
    detail::encode_rows(depth, texels, detail::codec_of(encoding), parallel);
}

/// Decodes an image of texels.
/// @param texels     any texels of the encoding
/// @param depth      receives the depths: same size, other memory
/// @param encoding   encoding of the texels, with the depth direction
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ
template <class Encoding, class ParallelFor = serial>
void decode(image_view<const typename Encoding::texel> texels, image_view<float> depth, const Encoding& encoding,
            ParallelFor&& parallel = {}) {
    static_assert(detail::is_encoding<Encoding>());
    detail::decode_rows(texels, depth, detail::codec_of(encoding), parallel);
}

}  // namespace umbrage
