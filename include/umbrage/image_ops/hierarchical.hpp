// SPDX-License-Identifier: MIT
//
// The box filter for receivers most of which are wholly lit or wholly in shadow: those ask one number for the whole box.
// visibility() does it for filters::hierarchical_box; bit for bit what filters::box gives.
//
//     umbrage::visibility(map.view(), umbrage::depth32f{}, receivers, umbrage::filters::hierarchical_box{8}, out.view());
//
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/image_ops/box_blocks.hpp>
#include <umbrage/image_ops/pyramid.hpp>

namespace umbrage::detail {

/// For every place where a box may start, the bounds of the squares of the pyramid that the box touches. A box of
/// 2r + 1 texels touches at most `cells` squares of 2^level texels in a row.
struct box_bounds {
    int level, cells;
    glm::ivec2 squares;       ///< of the level; a box starts at square -(cells - 1) .. squares - 1
    image<glm::vec2> bounds;  ///< least and greatest

    template <class ParallelFor>
    box_bounds(image_view<const float> map, int radius, ParallelFor&& parallel)
        : level(radius < 4 ? 1 : 2), cells(((1 << level) - 1 + 2 * radius) / (1 << level) + 1) {
        const std::vector<depth_bounds> pyramid = make_min_max_pyramid(map, level, parallel);
        squares = pyramid.back().least.size();
        const image<float> least = widened(pyramid.back().least, least_of{}, parallel);
        const image<float> greatest = widened(pyramid.back().greatest, greatest_of{}, parallel);
        bounds = image<glm::vec2>(squares + (cells - 1));
        for (int y = 0; y < bounds.size().y; ++y) {
            const float *a = least.view().row(y), *b = greatest.view().row(y);
            glm::vec2* to = bounds.view().row(y);
            for (int x = 0; x < bounds.size().x; ++x) to[x] = {a[x], b[x]};
        }
    }

    /// Pick over cells x cells elements, first along rows, then along columns. Rows are filled up to whole blocks.
    template <class Pick, class ParallelFor>
    [[nodiscard]] image<float> widened(const image<float>& from, Pick pick, ParallelFor&& parallel) const {
        const int width = (squares.x + cells - 1 + block - 1) / block * block;
        image<std::int32_t> rows({width, squares.y});
        image<float> out({width, squares.y + cells - 1});
        parallel(squares.y, [&](int first, int last) {
            std::vector<std::int32_t> keys(static_cast<std::size_t>(width + cells));
            for (int y = first; y < last; ++y) {
                const float* row = from.view().row(y);
                for (int x = 0; x < width + cells; ++x)
                    keys[static_cast<std::size_t>(x)] = order_key(row[clamp_int(x - (cells - 1), squares.x - 1)]);
                widen(pick, rows.view().row(y), width, [&](int k) { return keys.data() + k; });
            }
        });
        parallel(out.size().y, [&](int first, int last) {
            std::vector<std::int32_t> keys(static_cast<std::size_t>(width));
            for (int y = first; y < last; ++y) {
                widen(pick, keys.data(), width, [&](int k) {
                    return std::as_const(rows).view().row(clamp_int(y - (cells - 1) + k, squares.y - 1));
                });
                float* row = out.view().row(y);
                for (int x = 0; x < width; ++x) row[x] = from_order_key(keys[static_cast<std::size_t>(x)]);
            }
        });
        return out;
    }

    /// to[x] = pick of from(k)[x] over k < cells.
    template <class Pick, class From>
    void widen(Pick pick, std::int32_t* to, int width, From&& from) const {
        on_best_isa([&](auto) UMBRAGE_INLINE {
            for (int x = 0; x < width; x += block) {
                std::int32_t best[block];
                const std::int32_t* first = from(0) + x;
                for (int i = 0; i < block; ++i) best[i] = first[i];
                for (int k = 1; k < cells; ++k) {
                    const std::int32_t* other = from(k) + x;
                    for (int i = 0; i < block; ++i) best[i] = pick(best[i], other[i]);
                }
                for (int i = 0; i < block; ++i) to[x + i] = best[i];
            }
        });
    }
};

struct hierarchical_blocks {
    struct placed {
        receiver_block r;
        std::int32_t offsets[block], in_space[block];
    };
    const box_bounds& tree;
    block_filter<filters::box, depth32f> brute_force;

    UMBRAGE_INLINE void place(const receiver_block& r, placed& at) const {
        const int radius = brute_force.radius();
        const texel_bytes memory(tree.bounds.view());
        const int before = tree.cells - 1, level = tree.level;
        const glm::ivec2 last = tree.bounds.size() - 1;
        for (int i = 0; i < block; ++i) {
            const std::int32_t in_space = texel_space_mask(r.x[i], r.y[i]);
            const std::int32_t x = floor_int(masked(r.x[i], in_space)) - radius, y = floor_int(masked(r.y[i], in_space)) - radius;
            at.offsets[i] = memory.offset(clamp_int((x >> level) + before, last.x), clamp_int((y >> level) + before, last.y));
            at.in_space[i] = in_space;
        }
        prefetch(memory, at.offsets, 1);
        at.r = r;
    }

    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int count, float* visibility, Isa set) const {
        const texel_bytes memory(tree.bounds.view());
        const receiver_block& r = at.r;
        std::int32_t open[block];
        glm::vec2 bounds[block];
        for (int i = 0; i < block; ++i) bounds[i] = *memory.at(at.offsets[i]);
        for (int i = 0; i < block; ++i) {
            const std::int32_t lit = is_lit(r.z[i], bounds[i].x), dark = std::int32_t(r.z[i] > bounds[i].y);
            visibility[i] = select(-lit | ~at.in_space[i], 1.0f, 0.0f);
            open[i] = at.in_space[i] & ~-(lit | dark);
        }

        receiver_block rest;  // those that need the box
        float shares[block];
        int indices[block], found = 0;
        for (int i = 0; i < count; ++i) {
            indices[found] = i;
            rest.x[found] = r.x[i];
            rest.y[found] = r.y[i];
            rest.z[found] = r.z[i];
            found -= open[i];
        }
        if (found == 0) return;
        block_filter<filters::box, depth32f>::placed boxes;
        brute_force.place(rest, boxes);
        brute_force(boxes, found, shares, set);
        for (int i = 0; i < found; ++i) visibility[indices[i]] = shares[i];
    }
};

}  // namespace umbrage::detail
