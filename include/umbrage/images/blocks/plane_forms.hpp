// SPDX-License-Identifier: MIT
//
// Blocks of filters for receivers that are compared along their own planes.
//
// At the map's border a clamped texel keeps its own place on the plane. A form that clamps is therefore right only
// where the filter stays inside the map. For other receivers, plane_visibility.hpp calls the filter itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <umbrage/images/blocks/forms.hpp>
#include <umbrage/images/blocks/planes.hpp>

namespace umbrage::detail {

/// Blocks of a filter for receivers with planes.
template <class Blocks>
struct plane_blocks {
    struct placed : Blocks::placed {
        plane_block planes;
    };
    Blocks of;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at, int pixel_y) const {
        if constexpr (requires { of.place(receivers, at, pixel_y); }) of.place(receivers, at, pixel_y);
        else of.place(receivers, at);
        at.planes.copy(receivers);
    }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int count, float* visibility, Isa set) const {
        of(at, count, visibility, set);
    }
};

/// Boxes of any radius. Radius 0 is the receiver's own texel.
template <depth_direction Direction>
struct plane_box_blocks {
    using test = block_test<Direction>;
    static constexpr int lanes = 8;
    using ints = lanes_of<std::int32_t, lanes>;
    struct placed {
        alignas(64) std::int32_t x[block], y[block], inside[block], compared[block];  ///< first texel of the box
        alignas(64) float z[block];
    };
    image_view<const float> map;
    int radius;

    [[nodiscard]] UMBRAGE_INLINE int side() const { return 2 * radius + 1; }

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        const texel_bytes memory(map);
        const int last_x = map.size.x - side(), last_y = map.size.y - side(), before = radius;
        alignas(64) std::int32_t offsets[block];
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            at.compared[i] = test::compared(receivers.x(i), receivers.y(i), receivers.z(i));
            const std::int32_t x = floor_int(masked(receivers.x(i), at.compared[i])) - before;
            const std::int32_t y = floor_int(masked(receivers.y(i), at.compared[i])) - before;
            const std::int32_t inside = ~((x | y | (last_x - x) | (last_y - y)) >> 31);
            offsets[i] = memory.offset(x & inside, y & inside);
            at.inside[i] = inside & at.compared[i] & number_mask(receivers.z(i));
            at.x[i] = x;
            at.y[i] = y;
            at.z[i] = receivers.z(i);
        }
        prefetch(memory, offsets, last_y < 0 ? 1 : side());
    }
    template <class Placed, class Isa>
    UMBRAGE_INLINE void operator()(const Placed& at, int count, float* visibility, Isa set) const {
        out_of_line(set, [&](auto) UMBRAGE_INLINE {
            std::int32_t window[24 + lanes]{};
            for (int i = 0; i < side(); ++i) window[i] = -1;
            alignas(64) std::int32_t lit[block]{};
            for (int i = 0; i < count; ++i)
                if (at.inside[i]) lit[i] = count_box(at, i, window);
            const float scale = box_scale<float>(radius);
            for (int i = 0; i < block; ++i)
                visibility[i] = select(-std::int32_t(lit[i] == side() * side()) | ~at.compared[i], 1.0f,
                                       static_cast<float>(lit[i]) * scale);
        });
    }

private:
    /// Number of lit texels in the box of receiver i.
    /// @param window   all bits in the lanes of a row that belong to the box
    template <class Placed>
    [[nodiscard]] UMBRAGE_INLINE std::int32_t count_box(const Placed& at, int i, const std::int32_t* window) const {
        const int x = at.x[i], y = at.y[i], registers = (side() + lanes - 1) / lanes;
        if (x + registers * lanes > map.size.x) {  // a register would end outside the map
            std::int32_t lit = 0;
            for (int row = y; row < y + side(); ++row)
                for (int column = x; column < x + side(); ++column) {
                    const float stored = *texel_at(map, column, row);
                    lit += test::lit(at.z[i], texel_on_plane<test::forward>(at, i, stored, column, row));
                }
            return lit;
        }
        ints lit{}, mask, kept;
        const auto on_planes = rows_on_planes<lanes>(at, i, x, y, side());
        for (int r = 0; r < registers; ++r) {
            load_lanes(window + r * lanes, kept);
            for (int row = y; row < y + side(); ++row) {
                lanes_of<float, lanes> texels;
                load_lanes(texel_at(map, x + r * lanes, row), texels);
                on_planes.template compare<test::forward>(r * lanes, row - y, texels);
                lit_lanes<lanes, test::forward>(at.z[i], texels, mask);
                lit -= mask & kept;
            }
        }
        std::int32_t sums[2];
        sum_two_lanes<lanes>(lit, lit, sums);
        return sums[0];
    }
};

/// Form of a filter for receivers with planes. Without one, as in the primary template, the filter is called for each.
template <class Filter>
struct plane_form;
template <class Filter>
concept has_plane_form = requires {
    plane_form<Filter>::need;
};

/// Blocks of a form, for receivers with planes.
template <class Form>
struct on_planes : Form {
    static constexpr bool rounds = true;  // products of slopes
    template <depth_direction Direction, class Filter, class Tables>
    [[nodiscard]] static auto blocks(const float_texels& map, const Filter& filter, const Tables& tables) {
        using of_form = decltype(Form::template blocks<Direction>(map, filter, tables));
        return plane_blocks<of_form>{Form::template blocks<Direction>(map, filter, tables)};
    }
};

/// pcf_2x2 as a kernel of one weight: the same four texels, weights and sum.
struct one_weight_form : plain_form {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 2;
    static constexpr window_row row = make_window_row(1, {1.0f});
    template <class ParallelFor>
    [[nodiscard]] static window_table tables(const float_texels&, const filters::pcf_2x2&, ParallelFor&&) {
        return window_table(row);
    }
    template <depth_direction Direction>
    [[nodiscard]] static window_blocks<Direction> blocks(const float_texels& map, const filters::pcf_2x2&,
                                                         const window_table& weights) {
        return {map.map, row, weights};
    }
};

/// Boxes, and the receiver's own texel as a box of radius 0.
struct plane_box_form : without_tables {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction, class Filter>
    [[nodiscard]] static plane_box_blocks<Direction> blocks(const float_texels& map, const Filter& filter, no_tables) {
        if constexpr (std::is_same_v<Filter, filters::hard>) return {map.map, 0};
        else return {map.map, clamp_int(filter.radius, max_box_radius)};
    }
};

template <>
struct plane_form<filters::window> : on_planes<every_texel_form<filters::window>> {};
template <>
struct plane_form<filters::disc> : on_planes<every_texel_form<filters::disc>> {};
template <>
struct plane_form<filters::pcss> : on_planes<block_form<filters::pcss>> {};
template <>
struct plane_form<filters::dpcf> : on_planes<block_form<filters::dpcf>> {};
template <>
struct plane_form<filters::pcf_2x2> : on_planes<one_weight_form> {};
template <>
struct plane_form<filters::hard> : on_planes<plane_box_form> {};
template <>
struct plane_form<filters::box> : on_planes<plane_box_form> {};

}  // namespace umbrage::detail
