// SPDX-License-Identifier: MIT
//
// Filters over many texels for receivers most of which are wholly lit or wholly in shadow: those ask one number for all
// of them. visibility() does it for filters::hierarchical_box, hierarchical_window and hierarchical_disc, which give
// bit for bit what filters::box, window and rotated_disc do.
//
//     umbrage::visibility(map, umbrage::depth32f{}, receivers, umbrage::filters::hierarchical_box{8}, out);
//
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include <umbrage/images/parallel.hpp>
#include <umbrage/simd/blocks/box.hpp>
#include <umbrage/simd/blocks/box_bounds.hpp>
#include <umbrage/simd/blocks/disc.hpp>
#include <umbrage/simd/blocks/window.hpp>

namespace umbrage::detail {

/// What bounds say of a block: lit or dark, and which receivers are open, as their texels differ.
/// @return   whether any is open: not 0
template <class Test>
UMBRAGE_INLINE inline std::int32_t ask_bounds(const box_bounds& tree, const std::int32_t* offsets,
                                              const std::int32_t* compared, const float* depths, float* visibility,
                                              std::int32_t* open) {
    const texel_bytes<const glm::vec2> memory(tree.bounds.view);
    alignas(64) glm::vec2 bounds[block];
    std::int32_t some = 0, any = 0;
    for (int i = 0; i < block; ++i) some |= compared[i];
    if (!some) {  // as all over the sky
        for (int i = 0; i < block; ++i) visibility[i] = 1.0f;
        return 0;
    }
    gather<std::uint64_t>(gathered{bounds, [&](int i) UMBRAGE_INLINE { return memory.at(offsets[i]); }});
    for (int i = 0; i < block; ++i) {
        const std::int32_t lit = Test::all_lit(depths[i], bounds[i].x, bounds[i].y);
        const std::int32_t dark = Test::none_lit(depths[i], bounds[i].x, bounds[i].y);
        visibility[i] = select(-lit | ~compared[i], 1.0f, 0.0f);
        open[i] = compared[i] & ~-(lit | dark);
        any |= open[i];
    }
    return any;
}

/// @tparam Blocks   of the filter that reads every texel of its box
template <class Blocks>
struct hierarchical_blocks {
    using test = typename Blocks::test;
    struct placed {
        receiver_block r;
        alignas(64) std::int32_t offsets[block], compared[block];
    };
    const box_bounds& tree;
    Blocks every_texel;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        const texel_bytes<const glm::vec2> memory(tree.bounds.view);
        const int before = tree.cells - 1, level = tree.level;
        const glm::ivec2 last = tree.last;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const std::int32_t compared = test::compared(receivers.x(i), receivers.y(i), receivers.z(i));
            const std::int32_t x = every_texel.first(masked(receivers.x(i), compared));
            const std::int32_t y = every_texel.first(masked(receivers.y(i), compared));
            at.r.set(i, receivers.x(i), receivers.y(i), receivers.z(i));
            at.offsets[i] =
                memory.offset(clamp_int((x >> level) + before, last.x), clamp_int((y >> level) + before, last.y));
            at.compared[i] = compared;
        }
        prefetch(memory, at.offsets, 1);
    }

    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int count, float* visibility, Isa set) const {
        alignas(64) std::int32_t open[block];
        if (ask_bounds<test>(tree, at.offsets, at.compared, at.r.zs, visibility, open))
            out_of_line(set, [&](auto) UMBRAGE_INLINE { count_open(at.r, open, count, visibility, set); });
    }

private:
    /// Those that need the box.
    template <class Isa>
    UMBRAGE_INLINE void count_open(const receiver_block& r, const std::int32_t* open, int count, float* visibility,
                                   Isa set) const {
        receiver_block rest;
        alignas(64) float shares[block];
        int indices[block], found = 0;
        for (int i = 0; i < count; ++i) {
            indices[found] = i;
            rest.set(found, r.x(i), r.y(i), r.z(i));
            found -= open[i];
        }
        // Copies behind them: if all 64 boxes are in the map, none needs care.
        for (int i = found; i < block; ++i) rest.set(i, rest.xs[0], rest.ys[0], rest.zs[0]);
        typename Blocks::placed boxes;
        every_texel.place(rest, boxes);
        every_texel(boxes, found, shares, set);
        for (int i = 0; i < found; ++i) visibility[indices[i]] = shares[i];
    }
};

/// Turns go by the place in a block: one that has an open receiver is looked up whole.
template <depth_direction Direction>
struct hierarchical_disc_blocks {
    using test = block_test<Direction>;
    struct placed {
        typename disc_blocks<Direction>::placed points;
        alignas(64) std::int32_t offsets[block];
    };
    const box_bounds& tree;
    const disc_blocks<Direction>& every_point;
    reached_texels reached;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at, int pixel_y) const {
        const texel_bytes<const glm::vec2> memory(tree.bounds.view);
        const int before = tree.cells - 1, shift = 8 + tree.level, ahead = reached.before();
        const glm::ivec2 last = tree.last;
        every_point.locate(receivers, at.points, pixel_y);
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i)
            at.offsets[i] = memory.offset(clamp_int(((at.points.x[i] + ahead) >> shift) + before, last.x),
                                          clamp_int(((at.points.y[i] + ahead) >> shift) + before, last.y));
        prefetch(memory, at.offsets, 1);
    }

    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int count, float* visibility, Isa set) const {
        alignas(64) std::int32_t open[block];
        if (ask_bounds<test>(tree, at.offsets, at.points.compared, at.points.z, visibility, open))
            every_point(at.points, count, visibility, set);
    }
};

template <>
struct block_form<filters::hierarchical_box> {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction, class ParallelFor, class Use>
    static void with_blocks(const float_texels& map, const filters::hierarchical_box& filter, ParallelFor&& parallel,
                            const Use& use) {
        const box_blocks<Direction> every_texel{map.map, clamp_int(filter.radius, max_box_radius)};
        if (map.map.size.x < block) return use(every_texel);  // bounds come in whole blocks: they would outgrow the map
        const box_bounds tree(map.map, 2 * every_texel.radius + 1, parallel);
        use(hierarchical_blocks<box_blocks<Direction>>{tree, every_texel});
    }
};

template <>
struct block_form<filters::hierarchical_window> {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction, class ParallelFor, class Use>
    static void with_blocks(const float_texels& map, const filters::hierarchical_window& filter, ParallelFor&& parallel,
                            const Use& use) {
        const window_table weights(filter.row);
        const window_blocks<Direction> every_texel{map.map, filter.row, weights};
        if (map.map.size.x < block) return use(every_texel);
        const box_bounds tree(map.map, filter.row.touched(), parallel);
        use(hierarchical_blocks<window_blocks<Direction>>{tree, every_texel});
    }
};

template <>
struct block_form<filters::hierarchical_disc> {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction, class ParallelFor, class Use>
    static void with_blocks(const float_texels& map, const filters::hierarchical_disc& filter, ParallelFor&& parallel,
                            const Use& use) {
        using plain = block_form<filters::rotated_disc>;
        plain::with_blocks<Direction>(map, filter, parallel, [&](const disc_blocks<Direction>& every_point) {
            if (map.map.size.x < block) return use(every_point);
            const reached_texels reached(filter.reach());
            const box_bounds tree(map.map, reached.count(), parallel);
            use(hierarchical_disc_blocks<Direction>{tree, every_point, reached});
        });
    }
};

}  // namespace umbrage::detail
