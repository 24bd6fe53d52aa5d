// SPDX-License-Identifier: MIT
//
// The box filter over maps of floats: whole rows of the box are loaded at once, never one texel after the other.
//
//     std::int32_t lit = umbrage::detail::box_rows<8, 0>(map.stride, 5).count(row, 0, receiver);
//
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <glm/vec2.hpp>

#include <umbrage/filter/box.hpp>
#include <umbrage/image_ops/visibility_blocks.hpp>

namespace umbrage::detail {

#if defined(__GNUC__) || defined(__clang__)
#define UMBRAGE_HAS_VECTORS 1

/// Floats and numbers as wide as a register. The compiler's own vectors: they need no header and know no machine.
template <int Lanes>
struct vectors;
template <>
struct vectors<4> {
    typedef float floats __attribute__((vector_size(16)));
    typedef float unaligned __attribute__((vector_size(16), aligned(4), may_alias));
    typedef std::int32_t ints __attribute__((vector_size(16)));
};
template <>
struct vectors<8> {
    typedef float floats __attribute__((vector_size(32)));
    typedef float unaligned __attribute__((vector_size(32), aligned(4), may_alias));
    typedef std::int32_t ints __attribute__((vector_size(32)));
};

/// Lit texels of boxes that lie inside a map at least as wide as a register.
/// @tparam Lanes   of a register;   Whole  registers that a row of the box fills
template <int Lanes, int Whole>
struct box_rows {
    using floats = typename vectors<Lanes>::floats;
    using unaligned = typename vectors<Lanes>::unaligned;
    using ints = typename vectors<Lanes>::ints;
    std::ptrdiff_t stride;
    int width;
    std::int32_t window[3 * Lanes]{};  ///< lanes that the rest of a row has in a register, slid to where they are

    UMBRAGE_INLINE box_rows(std::ptrdiff_t bytes, int box_width) : stride(bytes), width(box_width) {
        for (int i = 0; i < width - Whole * Lanes; ++i) window[Lanes + i] = -1;
    }

    /// @param row     first texel of the box
    /// @param moved   by how much the last register of a row is moved back, so that it ends inside the map
    [[nodiscard]] UMBRAGE_INLINE std::int32_t count(const std::byte* row, std::ptrdiff_t moved, float receiver) const {
        ints lit{}, rest{};
        for (int j = 0; j < width; ++j, row += stride) {
            const float* texels = reinterpret_cast<const float*>(row);
            for (int i = 0; i < Whole; ++i) add(texels + i * Lanes, receiver, lit);
            add(texels + Whole * Lanes - moved, receiver, rest);
        }
        ints wanted;
        std::memcpy(&wanted, window + Lanes - moved, sizeof wanted);
        lit += rest & wanted;
        std::int32_t sum = 0;
        for (int i = 0; i < Lanes; ++i) sum += lit[i];
        return sum;
    }

    static UMBRAGE_INLINE void add(const float* texels, float receiver, ints& lit) {
        const floats stored = *reinterpret_cast<const unaligned*>(texels);
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
        lit -= (receiver <= stored) & (((ints)stored & 0x7FFFFFFF) <= 0x7F800000);
#else
        lit -= receiver <= stored;
#endif
    }
};
#else
#define UMBRAGE_HAS_VECTORS 0
#endif

/// Only maps of floats: others are decoded first, which costs less than decoding each texel for each of its boxes.
template <>
struct block_filter<filters::box, depth32f> {
    static constexpr int least = 1;
    image_view<const float> map;
    const depth32f& encoding;
    const filters::box& filter;

    UMBRAGE_INLINE void prefetch(const receiver_block& r) const { prefetch_texels(map, r); }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const receiver_block& r, int count, float* visibility, Isa set) const {
#if UMBRAGE_HAS_VECTORS
        constexpr int lanes = Isa::value == isa::base ? 4 : 8;
        const int whole = (2 * clamp_int(filter.radius, max_box_radius) + 1) / lanes;
        if (map.size.x >= lanes * (whole + 1)) {
            if (whole == 0) return rows<lanes, 0>(r, count, visibility);
            if (whole == 1) return rows<lanes, 1>(r, count, visibility);
            if (whole == 2) return rows<lanes, 2>(r, count, visibility);
            if (lanes == 4 && whole == 3) return rows<4, 3>(r, count, visibility);
            if (lanes == 4) return rows<4, 4>(r, count, visibility);
        }
#endif
        one_by_one<filters::box, depth32f>{map, encoding, filter}(r, count, visibility, set);
    }

#if UMBRAGE_HAS_VECTORS
    template <int Lanes, int Whole>
    UMBRAGE_INLINE void rows(const receiver_block& r, int count, float* visibility) const {
        const int radius = clamp_int(filter.radius, max_box_radius), width = 2 * radius + 1;
        const box_rows<Lanes, Whole> box(map.stride, width);
        const texel_bytes memory(map);
        const int last_x = map.size.x - width, last_y = map.size.y - width, last_load = map.size.x - Lanes * (Whole + 1);
        std::int32_t xs[block], ys[block], offsets[block], moved[block], inside[block], in_space[block], lit[block]{};
        for (int i = 0; i < block; ++i) {
            in_space[i] = texel_space_mask(r.x[i], r.y[i]);
            const std::int32_t x = floor_int(masked(r.x[i], in_space[i])) - radius;
            const std::int32_t y = floor_int(masked(r.y[i], in_space[i])) - radius;
            inside[i] = std::int32_t(x >= 0) & std::int32_t(x <= last_x) & std::int32_t(y >= 0) & std::int32_t(y <= last_y);
            offsets[i] = memory.offset(x, y);
            moved[i] = x > last_load ? x - last_load : 0;
            xs[i] = x;
            ys[i] = y;
        }
        for (int i = 0; i < count; ++i) {
            if (is_nan(r.z[i]) || !in_space[i]) continue;
            lit[i] = inside[i] ? box.count(memory.data + offsets[i], moved[i], r.z[i])
                               : count_at_border<Lanes, Whole>({xs[i], ys[i]}, width, r.z[i]);
        }
        const float scale = box_scale<float>(radius);
        for (int i = 0; i < block; ++i)
            visibility[i] = select(-std::int32_t(lit[i] == width * width) | ~in_space[i], 1.0f, static_cast<float>(lit[i]) * scale);
    }

    /// The same from a copy of the box, the map's border texels repeated.
    template <int Lanes, int Whole>
    std::int32_t count_at_border(glm::ivec2 first, int width, float receiver) const {
        float texels[2 * max_box_radius + 1][(Whole + 1) * Lanes]{};
        for (int j = 0; j < width; ++j) {
            const float* row = texel_at(map, 0, clamp_int(first.y + j, map.size.y - 1));
            for (int i = 0; i < width; ++i) texels[j][i] = row[clamp_int(first.x + i, map.size.x - 1)];
        }
        return box_rows<Lanes, Whole>(sizeof texels[0], width).count(reinterpret_cast<const std::byte*>(texels), 0, receiver);
    }
#endif
};

}  // namespace umbrage::detail
