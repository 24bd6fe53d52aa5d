// SPDX-License-Identifier: MIT
//
// Hierarchical evaluation of filters over many texels. Most receivers are entirely lit or in shadow: they read only the
// bounds of their texels. The other receivers read every texel. Results have the same bits.
//
// `visibility()` uses it for `filters::box`, `window` and `disc` where `bounds_pay()`.
//
//     umbrage::visibility(map, umbrage::depth32f{}, receivers, umbrage::filters::box{8}, out);
//
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>

#include <glm/vec2.hpp>

#include <umbrage/core/parallel.hpp>
#include <umbrage/images/blocks/box.hpp>
#include <umbrage/images/blocks/box_bounds.hpp>
#include <umbrage/images/blocks/disc.hpp>
#include <umbrage/images/blocks/form_map.hpp>
#include <umbrage/images/blocks/map_tile.hpp>
#include <umbrage/images/blocks/window.hpp>
#include <umbrage/simd/min_max.hpp>

namespace umbrage::detail {

/// Result of a block without a compared receiver, as all over the sky.
UMBRAGE_INLINE inline void light_all(float* visibility) {
    for (int i = 0; i < block; ++i) visibility[i] = 1.0f;
}

/// Result of a block from bounds: lit, dark, or open where the receiver's texels differ.
/// @return   not 0 if any receiver is open
template <class Test>
UMBRAGE_INLINE inline std::int32_t ask_bounds(const box_bounds& tree, const std::int32_t* offsets,
                                              const std::int32_t* compared, const float* depths, float* visibility,
                                              std::int32_t* open) {
    const texel_bytes<const glm::vec2> memory(tree.bounds.view);
    alignas(64) glm::vec2 bounds[block];
    std::int32_t any = 0;
    gather<std::uint64_t>(memory, offsets, bounds);
    for (int i = 0; i < block; ++i) {
        const std::int32_t lit = Test::all_lit(depths[i], bounds[i].x, bounds[i].y);
        const std::int32_t dark = Test::none_lit(depths[i], bounds[i].x, bounds[i].y);
        visibility[i] = select(-lit | ~compared[i], 1.0f, 0.0f);
        open[i] = compared[i] & ~-(lit | dark);
        any |= open[i];
    }
    return any;
}

/// Open receivers of a tile of 64 x 8. They are close to each other, so one copy of the map serves them all. They also
/// fill their blocks, which those of a single row do not.
struct open_receivers {
    static constexpr int rows = 8, room = rows * block;
    alignas(64) float xs[room], ys[room], zs[room];
    float* visibility[room];
    int count = 0;
    map_tile texels;

    UMBRAGE_INLINE void add(const receiver_block& r, const std::int32_t* open, int of, float* out) {
        const auto word = [](float& to, const float& from)
                              UMBRAGE_INLINE { std::memcpy(&to, &from, sizeof to); };  // more per cycle than floats
        int end = count;
        for (int i = 0; i < of; ++i) {
            word(xs[end], r.xs[i]);
            word(ys[end], r.ys[i]);
            word(zs[end], r.zs[i]);
            visibility[end] = out + i;
            end -= open[i];
        }
        count = end;
    }

    /// Fills the last block with copies: if all boxes of a block are in the map, none needs care.
    UMBRAGE_INLINE void fill_last_block() {
        for (int i = count; i % block != 0; ++i) xs[i] = xs[0], ys[i] = ys[0], zs[i] = zs[0];
    }
};

/// Blocks that try bounds first.
/// @tparam Blocks   blocks of the filter, which reads every texel of its box
template <class Blocks>
struct hierarchical_blocks {
    using test = typename Blocks::test;
    using tile = open_receivers;
    struct placed {
        receiver_block r;
        alignas(64) std::int32_t offsets[block], compared[block], any;  ///< for the compared receivers
    };
    const box_bounds& tree;
    Blocks every_texel;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        const texel_bytes<const glm::vec2> memory(tree.bounds.view);
        const int before = tree.cells - 1, level = tree.level;
        const glm::ivec2 last = tree.last;
        std::int32_t any = 0;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            at.r.set(i, receivers.x(i), receivers.y(i), receivers.z(i));
            at.compared[i] = test::compared(receivers.x(i), receivers.y(i), receivers.z(i));
            any |= at.compared[i];
        }
        at.any = any;
        if (!any) return;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const std::int32_t x = every_texel.first(masked(at.r.x(i), at.compared[i]));
            const std::int32_t y = every_texel.first(masked(at.r.y(i), at.compared[i]));
            at.offsets[i] =
                memory.offset(clamp_int((x >> level) + before, last.x), clamp_int((y >> level) + before, last.y));
        }
        prefetch(memory, at.offsets, 1);
    }

    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int count, float* visibility, tile& later, Isa) const {
        alignas(64) std::int32_t open[block];
        if (!at.any) return light_all(visibility);
        if (ask_bounds<test>(tree, at.offsets, at.compared, at.r.zs, visibility, open))
            later.add(at.r, open, count, visibility);
    }

    template <class Isa>
    UMBRAGE_INLINE void finish(tile& later, Isa set) const {
        if (later.count > 0) out_of_line(set, [&](auto) UMBRAGE_INLINE { count_open(later, set); });
    }

private:
    template <class Isa>
    UMBRAGE_INLINE void count_open(tile& open, Isa set) const {
        Blocks reads = every_texel;
        open.fill_last_block();
        if (map_tile::helps(reads.map.stride, reads.side())) read_copy(open, reads.map);
        alignas(64) float shares[block];
        typename Blocks::placed boxes;
        for (int from = 0; from < open.count; from += block) {
            const int count = lesser(open.count - from, block);
            reads.place(receiver_rows{open.xs + from, open.ys + from, open.zs + from}, boxes);
            reads(boxes, count, shares, set);
            for (int i = 0; i < count; ++i) *open.visibility[from + i] = shares[i];
        }
        open.count = 0;
    }

    /// If all texels that the receivers read fit, replaces the map by a copy of them. Receivers become relative to the
    /// copy.
    UMBRAGE_INLINE void read_copy(tile& open, image_view<const float>& map) const {
        glm::ivec2 first(every_texel.first(open.xs[0]), every_texel.first(open.ys[0])), last = first;
        for (int from = 0; from < open.count; from += block)
            for (int i = from; i < from + block; ++i) {
                const glm::ivec2 at(every_texel.first(open.xs[i]), every_texel.first(open.ys[i]));
                first = {lesser(first.x, at.x), lesser(first.y, at.y)};
                last = {greater(last.x, at.x), greater(last.y, at.y)};
            }
        last += glm::ivec2(every_texel.loaded(), every_texel.side()) - 1;
        if (!map_tile::holds(first, last)) return;
        if (first.x < 0 || first.y < 0 || last.x >= map.size.x || last.y >= map.size.y) return;
        open.texels.copy(map, first, last);
        map = {open.texels.texels[0], last - first + 1, sizeof open.texels.texels[0]};
        const glm::vec2 moved(first);
        for (int from = 0; from < open.count; from += block)
            for (int i = from; i < from + block; ++i) open.xs[i] -= moved.x, open.ys[i] -= moved.y;
    }
};

/// Discs that try bounds first. Rotations go by the place in a block, so a block with an open receiver is filtered
/// whole.
template <depth_direction Direction>
struct hierarchical_disc_blocks {
    using test = block_test<Direction>;
    struct placed {
        typename disc_blocks<Direction>::placed points;
        alignas(64) std::int32_t offsets[block], any;
    };
    const box_bounds& tree;
    disc_blocks<Direction> every_point;
    reached_texels reached;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at, int pixel_y) const {
        const texel_bytes<const glm::vec2> memory(tree.bounds.view);
        const int before = tree.cells - 1, shift = 8 + tree.level, ahead = reached.before();
        const glm::ivec2 last = tree.last;
        every_point.locate(receivers, at.points, pixel_y);
        at.any = 0;
        for (int i = 0; i < block; ++i) at.any |= at.points.compared[i];
        if (!at.any) return;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i)
            at.offsets[i] = memory.offset(clamp_int(((at.points.x[i] + ahead) >> shift) + before, last.x),
                                          clamp_int(((at.points.y[i] + ahead) >> shift) + before, last.y));
        prefetch(memory, at.offsets, 1);
    }

    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int count, float* visibility, Isa set) const {
        alignas(64) std::int32_t open[block];
        if (!at.any) return light_all(visibility);
        if (ask_bounds<test>(tree, at.offsets, at.points.compared, at.points.z, visibility, open))
            every_point(at.points, count, visibility, set);
    }
};

/// Largest number of texels that a filter reads in a row.
[[nodiscard]] inline int width_of(const filters::box& filter) {
    return 2 * clamp_int(filter.radius, max_box_radius) + 1;
}
[[nodiscard]] inline int width_of(const filters::window& filter) { return filter.row.touched(); }
[[nodiscard]] inline int width_of(const filters::disc& filter) { return reached_texels(filter.reach()).count(); }

/// True when an image is filtered faster by bounds, including the pass over the map that makes them.
///
/// Neighbors in the image of receivers should be near each other in the map: discs of random receivers lose (0.6).
/// @param width   texels that the filter reads in a row
// Gain for 2048 x 2048 texels and 1920 x 1080 receivers, shadow_render's scene and a floor with boxes. Box of radius 2:
// 1.2, 0.9; 3: 1.4, 1.1; 4: 4.4, 3.5; 8: 1.7, 4.0. castano<5>: 2.0, 1.5; castano<7>: 2.4, 1.7. disc<16> of radius 4:
// 4.3, 3.8; 8: 1.2, 2.9; 16: 1.3, 0.8. At 2.5 texels per receiver, box of radius 3: 1.2, 1.0; at 16, radius 4: 1.4,
// 1.3.
[[nodiscard]] inline bool bounds_pay(int width, glm::ivec2 map, double receivers) {
    if (map.x < block) return false;            // bounds come in full blocks and would outgrow the map
    if (width < 6 || width > 17) return false;  // narrower: no gain. Wider: their texels mostly differ
    // From 9 texels on, bounds are of squares of 4 x 4, not 2 x 2, and take 0.9 ms to make, not 2.1 ms.
    return area_of(map) <= (width < 9 ? 2.5 : 16.0) * receivers;
}

/// Bounds of a map, and tables of the blocks that read every texel.
template <class Tables>
struct bounds_and {
    box_bounds tree;
    Tables other;
};

/// Form of a filter that tries bounds first, even where that does not pay.
template <class Filter>
struct hierarchical_form : every_texel_form<Filter> {
    using reads = every_texel_form<Filter>;
    template <class ParallelFor>
    [[nodiscard]] static auto tables(const float_texels& map, const Filter& filter, ParallelFor&& parallel) {
        return bounds_and<decltype(reads::tables(map, filter, parallel))>{
            box_bounds(map.map, width_of(filter), parallel), reads::tables(map, filter, parallel)};
    }
    template <depth_direction Direction, class Tables>
    [[nodiscard]] static auto blocks(const float_texels& map, const Filter& filter, const Tables& tables) {
        const auto every_texel = reads::template blocks<Direction>(map, filter, tables.other);
        if constexpr (std::is_same_v<Filter, filters::disc>)
            return hierarchical_disc_blocks<Direction>{tables.tree, every_texel, reached_texels(filter.reach())};
        else return hierarchical_blocks<std::remove_const_t<decltype(every_texel)>>{tables.tree, every_texel};
    }
};

/// Form that reads every texel, or tries bounds first where bounds_pay().
template <class Filter>
struct faster_form : every_texel_form<Filter> {
    using by_bounds = hierarchical_form<Filter>;
};
template <>
struct block_form<filters::box> : faster_form<filters::box> {};
template <>
struct block_form<filters::window> : faster_form<filters::window> {};
template <>
struct block_form<filters::disc> : faster_form<filters::disc> {};

}  // namespace umbrage::detail
