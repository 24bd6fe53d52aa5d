// SPDX-License-Identifier: MIT
//
// The filters over blocks of 64 receivers: what visibility() is made of. Each works in two steps, some blocks apart, so
// that texels have come from memory when they are needed: place() says where to look and starts to fetch what is there;
// the second step loads it (two neighbours at a time), compares and weighs. All but the loads vectorises.
//
//     umbrage::detail::block_filter<umbrage::filters::pcf_2x2, umbrage::rg<11>> filter{map, {}, {}};
//     filter.place(receiver_texels{receivers}, placed);
//     filter(placed, count, visibility, isa);
//
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/texel_space.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/lanes.hpp>
#include <umbrage/simd/memory.hpp>

namespace umbrage::detail {

/// A block of receivers in an image, read where they are. Element by element: GCC does not vectorise whole vec3s.
struct receiver_texels {
    const glm::vec3* first;
    [[nodiscard]] UMBRAGE_INLINE float x(int i) const { return first[i].x; }
    [[nodiscard]] UMBRAGE_INLINE float y(int i) const { return first[i].y; }
    [[nodiscard]] UMBRAGE_INLINE float z(int i) const { return first[i].z; }
};

/// The same in three planes.
struct receiver_rows {
    const float *first_x, *first_y, *first_z;
    [[nodiscard]] UMBRAGE_INLINE float x(int i) const { return first_x[i]; }
    [[nodiscard]] UMBRAGE_INLINE float y(int i) const { return first_y[i]; }
    [[nodiscard]] UMBRAGE_INLINE float z(int i) const { return first_z[i]; }
};

/// The same in memory of its own; what lies behind the last receiver of a row is not read into any result.
struct receiver_block {
    alignas(64) float xs[block]{}, ys[block]{}, zs[block]{};
    [[nodiscard]] UMBRAGE_INLINE float x(int i) const { return xs[i]; }
    [[nodiscard]] UMBRAGE_INLINE float y(int i) const { return ys[i]; }
    [[nodiscard]] UMBRAGE_INLINE float z(int i) const { return zs[i]; }
    UMBRAGE_INLINE void set(int i, float x_at, float y_at, float depth) {
        xs[i] = x_at;
        ys[i] = y_at;
        zs[i] = depth;
    }
    template <class Receivers>
    UMBRAGE_INLINE void copy(const Receivers& from) {
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) set(i, from.x(i), from.y(i), from.z(i));
    }
};

/// Where a block of words comes from, at(i), and where it goes.
template <class At>
struct gathered {
    void* to;
    At at;
};
template <class At>
gathered(void*, At) -> gathered<At>;

/// Blocks of words, in turns. As many as fill a small register make one store: left alone, compilers want more at once than
/// they can hold.
template <class Word, class... At>
UMBRAGE_INLINE inline void gather(const gathered<At>&... blocks) {
    const auto word = [](const void* from) UMBRAGE_INLINE {
        Word w;
        std::memcpy(&w, from, sizeof w);
        return w;
    };
    using words = lanes_of<Word, 16 / sizeof(Word)>;
    constexpr std::size_t some = sizeof(words) / sizeof(Word);
    const auto load = [&]<std::size_t... I>(int i, const auto& from, std::index_sequence<I...>) UMBRAGE_INLINE {
        const words together{word(from.at(i + static_cast<int>(I)))...};
        std::memcpy(static_cast<std::byte*>(from.to) + static_cast<std::size_t>(i) * sizeof(Word), &together, sizeof together);
    };
    for (int i = 0; i < block; i += static_cast<int>(some)) (load(i, blocks, std::make_index_sequence<some>{}), ...);
}

/// What is loaded for a block of receivers, from where at(i) points to: a texel each, or two neighbours of two rows. The
/// depths in them and the receiver's are asked for in loops that vectorise; this general form decodes while it loads.
template <class Encoding>
struct loaded_texels {
    const Encoding& encoding;
    alignas(64) float depths[2 * block];
    explicit loaded_texels(const Encoding& e) : encoding(e) {}
    template <class At>
    UMBRAGE_INLINE void load_one(const At& at) {
        for (int i = 0; i < block; ++i) depths[i] = encoding.decode(*at(i));
    }
    template <class At, class Below>
    static UMBRAGE_INLINE void load_two(loaded_texels& low, const At& at, loaded_texels& high, const Below& below) {
        for (int i = 0; i < block; ++i)
            for (int k = 0; k < 2; ++k) {
                low.depths[2 * i + k] = low.encoding.decode(at(i)[k]);
                high.depths[2 * i + k] = high.encoding.decode(below(i)[k]);
            }
    }
    static UMBRAGE_INLINE float receiver(float depth) { return depth; }
    UMBRAGE_INLINE float one(int i) const { return depths[i]; }
    UMBRAGE_INLINE float first(int i) const { return depths[2 * i]; }
    UMBRAGE_INLINE float second(int i) const { return depths[2 * i + 1]; }
};

/// Floats need no decoding, and two of them are one word.
template <>
struct loaded_texels<depth32f> {
    alignas(64) float depths[2 * block];
    explicit loaded_texels(const depth32f&) {}
    template <class At>
    UMBRAGE_INLINE void load_one(const At& at) {
        gather<std::uint32_t>(gathered{depths, at});
    }
    template <class At, class Below>
    static UMBRAGE_INLINE void load_two(loaded_texels& low, const At& at, loaded_texels& high, const Below& below) {
        gather<std::uint64_t>(gathered{low.depths, at}, gathered{high.depths, below});
    }
    static UMBRAGE_INLINE float receiver(float depth) { return depth; }
    UMBRAGE_INLINE float one(int i) const { return depths[i]; }
    UMBRAGE_INLINE float first(int i) const { return depths[2 * i]; }
    UMBRAGE_INLINE float second(int i) const { return depths[2 * i + 1]; }
};

/// Byte pairs, two of them to a word. Both sides of the comparison stay 2^Bits times the depth, which changes no result.
template <int Bits>
struct loaded_texels<rg<Bits>> {
    static constexpr bool little = std::endian::native == std::endian::little;
    float edge;
    alignas(64) std::uint32_t words[block];
    explicit loaded_texels(const rg<Bits>& encoding) : edge(encoding.edge) {}
    template <class At>
    UMBRAGE_INLINE void load_one(const At& at) {
        for (int i = 0; i < block; ++i) {
            std::uint16_t word;
            std::memcpy(&word, at(i), sizeof word);
            words[i] = word;
        }
    }
    template <class At, class Below>
    static UMBRAGE_INLINE void load_two(loaded_texels& low, const At& at, loaded_texels& high, const Below& below) {
        gather<std::uint32_t>(gathered{low.words, at}, gathered{high.words, below});
    }
    static UMBRAGE_INLINE float receiver(float depth) { return depth * float(1 << Bits); }
    UMBRAGE_INLINE float one(int i) const { return number(codes(i) & 0xFFFF); }
    UMBRAGE_INLINE float first(int i) const { return number(little ? codes(i) & 0xFFFF : codes(i) >> 16); }
    UMBRAGE_INLINE float second(int i) const { return number(little ? codes(i) >> 16 : codes(i) & 0xFFFF); }
    /// R + 2^(Bits - 8) G of both texels at once, in the two halves of a word.
    UMBRAGE_INLINE std::uint32_t codes(int i) const {
        constexpr std::uint32_t low = 0x00FF00FF, high = low << (Bits - 8);
        const std::uint32_t w = words[i];
        return little ? (w & low) + (w >> (16 - Bits) & high) : (w >> 8 & low) + ((w & low) << (Bits - 8));
    }
    UMBRAGE_INLINE float number(std::uint32_t code) const { return static_cast<float>(static_cast<std::int32_t>(code)) + edge; }
};

/// Texels of a map by their distance from the first in bytes, which fits 32 bits so that it vectorises.
template <class T>
struct texel_bytes {
    const std::byte* data;
    std::int32_t stride;

    explicit texel_bytes(const image_view<T>& map)
        : data(reinterpret_cast<const std::byte*>(map.data)), stride(static_cast<std::int32_t>(map.stride)) {}
    static bool fits(const image_view<T>& map) {
        constexpr std::ptrdiff_t highest = 0x7FFFFFFF;
        return map.size.x <= highest / std::ptrdiff_t(sizeof(T)) && map.size.y <= highest / 2 &&
               (map.stride < 0 ? -map.stride : map.stride) <= highest / (map.size.y + 1);
    }
    UMBRAGE_INLINE std::int32_t offset(std::int32_t x, std::int32_t y) const {
        return y * stride + x * static_cast<std::int32_t>(sizeof(T));
    }
    UMBRAGE_INLINE T* at(std::int32_t offset) const { return reinterpret_cast<T*>(data + offset); }
    UMBRAGE_INLINE T* below(std::int32_t offset) const { return reinterpret_cast<T*>(data + stride + offset); }
};

/// Texel inside the map, without the assertion of image_view.
template <class T>
[[nodiscard]] UMBRAGE_INLINE inline T* texel_at(const image_view<T>& map, std::int32_t x, std::int32_t y) {
    return reinterpret_cast<T*>(reinterpret_cast<const std::byte*>(map.data) + y * map.stride) + x;
}

/// The last texel of so many that a receiver can ask for: none in texel space is farther.
[[nodiscard]] UMBRAGE_INLINE inline int last_in_space(int size) {
    constexpr int space = 1 << 15;
    return (size < space ? size : space) - 1;
}

/// Starts to fetch the texels of a block, of which neighbours mostly share a line of the cache. Where a block starts on
/// another row of the map than the one before, the machine cannot guess them; and the rows above and below are where
/// receivers come to that lie askew to the map.
template <class T>
UMBRAGE_INLINE inline void prefetch(const texel_bytes<T>& memory, const std::int32_t* offsets, int rows) {
    for (int row = -1; row <= rows; ++row)
#pragma GCC unroll 4
        for (int i = 0; i < block; i += 16) prefetch_bytes(memory.data, offsets[i] + std::ptrdiff_t(row) * memory.stride, 1);
}

/// Any filter, one receiver after the other.
template <class Filter, class Encoding>
struct one_by_one {
    using placed = receiver_block;
    image_view<const typename Encoding::texel> map;
    const Encoding& encoding;
    const Filter& filter;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        at.copy(receivers);
    }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int count, float* visibility, Isa) const {
        const auto fetch = decoded(map, encoding);
        for (int i = 0; i < count; ++i) visibility[i] = filter(fetch, glm::vec2(at.x(i), at.y(i)), at.z(i));
    }
};

/// Taps that are receivers' own texels, clamped to the map.
struct placed_tap {
    alignas(64) std::int32_t offsets[block], inside[block];

    template <class T>
    UMBRAGE_INLINE void place(const image_view<T>& map, const receiver_block& receivers, glm::vec2 offset) {
        const texel_bytes memory(map);
        const auto last_x = static_cast<float>(last_in_space(map.size.x)), last_y = static_cast<float>(last_in_space(map.size.y));
        for (int i = 0; i < block; ++i) {
            const float x = receivers.x(i) + offset.x, y = receivers.y(i) + offset.y;
            inside[i] = texel_space_mask(x, y);
            offsets[i] = memory.offset(floor_within(x, last_x), floor_within(y, last_y));
        }
        prefetch(memory, offsets, 1);
    }

    /// Adds 1 for each receiver that is lit.
    template <class Encoding>
    UMBRAGE_INLINE void count(image_view<const typename Encoding::texel> map, const Encoding& encoding, const float* z,
                              std::int32_t* lit) const {
        const texel_bytes memory(map);
        loaded_texels<Encoding> texels(encoding);
        texels.load_one([&](int i) UMBRAGE_INLINE { return memory.at(offsets[i]); });
        for (int i = 0; i < block; ++i)
            lit[i] += (is_lit(texels.receiver(z[i]), texels.one(i)) & inside[i]) | (1 & ~inside[i]);
    }
};

/// The filters that have a form for blocks; `least` is the side of the smallest map that it can take.
template <class Filter, class Encoding>
struct block_filter {
    static constexpr int least = 0;  ///< none
};

template <class Encoding>
struct block_filter<filters::hard, Encoding> {
    static constexpr int least = 1;
    struct placed {
        receiver_block r;
        placed_tap tap;
    };
    image_view<const typename Encoding::texel> map;
    const Encoding& encoding;
    const filters::hard& filter;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        at.r.copy(receivers);
        at.tap.place(map, at.r, glm::vec2(0.0f));
    }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int, float* visibility, Isa) const {
        alignas(64) std::int32_t lit[block]{};
        at.tap.count(map, encoding, at.r.zs, lit);
        for (int i = 0; i < block; ++i) visibility[i] = static_cast<float>(lit[i]);
    }
};

template <class Encoding>
struct block_filter<filters::four_tap, Encoding> {
    static constexpr int least = 1;
    struct placed {
        receiver_block r;
        placed_tap taps[4];
    };
    image_view<const typename Encoding::texel> map;
    const Encoding& encoding;
    const filters::four_tap& filter;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        at.r.copy(receivers);
        for (int tap = 0; tap < 4; ++tap) at.taps[tap].place(map, at.r, filter.offsets[static_cast<std::size_t>(tap)]);
    }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int, float* visibility, Isa) const {
        alignas(64) std::int32_t lit[block]{};
        for (const placed_tap& tap : at.taps) tap.count(map, encoding, at.r.zs, lit);
        for (int i = 0; i < block; ++i) visibility[i] = static_cast<float>(lit[i]) * 0.25f;
    }
};

/// A position clamped to the middles of the map's border texels has the same neighbours and weights that add up to the
/// same, so that both neighbours are in the map and one load gets them.
template <class Encoding>
struct block_filter<filters::pcf_2x2, Encoding> {
    static constexpr int least = 2;
    struct placed {
        alignas(64) std::int32_t offsets[block], inside[block];
        alignas(64) float hi_x[block], hi_y[block], z[block];
    };
    image_view<const typename Encoding::texel> map;
    const Encoding& encoding;
    const filters::pcf_2x2& filter;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        const texel_bytes memory(map);
        const int last_x = last_in_space(map.size.x), last_y = last_in_space(map.size.y);
        const auto axis = [](float coord, int last, float& hi) UMBRAGE_INLINE {
            const std::int32_t position = floor_within(coord * 256.0f - 128.0f, static_cast<float>(last * 256));
            const std::int32_t here = position >> 8, last_pair = last - 1;
            const std::int32_t texel = here < last_pair ? here : last_pair;
            hi = static_cast<float>(position - texel * 256);
            return texel;
        };
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const float x = receivers.x(i), y = receivers.y(i);
            at.inside[i] = texel_space_mask(x, y);
            at.offsets[i] = memory.offset(axis(x, last_x, at.hi_x[i]), axis(y, last_y, at.hi_y[i]));
            at.z[i] = receivers.z(i);
        }
        prefetch(memory, at.offsets, 2);
    }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int, float* visibility, Isa) const {
        const texel_bytes memory(map);
        loaded_texels<Encoding> low(encoding), high(encoding);
        loaded_texels<Encoding>::load_two(low, [&](int i) UMBRAGE_INLINE { return memory.at(at.offsets[i]); },
                                          high, [&](int i) UMBRAGE_INLINE { return memory.below(at.offsets[i]); });
        for (int i = 0; i < block; ++i) {
            const float z = low.receiver(at.z[i]), lo_x = 256.0f - at.hi_x[i], lo_y = 256.0f - at.hi_y[i];
            const auto weigh = [&](const auto& row) UMBRAGE_INLINE {
                return masked(lo_x, -is_lit(z, row.first(i))) + masked(at.hi_x[i], -is_lit(z, row.second(i)));
            };
            const float sum = lo_y * weigh(low) + at.hi_y[i] * weigh(high);
            visibility[i] = select(at.inside[i], sum * (1.0f / 65536.0f), 1.0f);
        }
    }
};

}  // namespace umbrage::detail
