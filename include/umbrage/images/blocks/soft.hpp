// SPDX-License-Identifier: MIT
//
// Contact hardening (PCSS, DPCF) over blocks of receivers: discs as in disc.hpp, with two radii per receiver.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <umbrage/filter/blocker/dpcf.hpp>
#include <umbrage/filter/blocker/pcss.hpp>
#include <umbrage/images/blocks/disc.hpp>
#include <umbrage/images/blocks/form.hpp>
#include <umbrage/images/blocks/receivers.hpp>
#include <umbrage/images/blocks/texels.hpp>

namespace umbrage::detail {

/// floor(a / b), as floor_divide, for 0 <= a < 2^24 and 1 <= b.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t divide_int(std::int32_t a, std::int32_t b) {
    auto q = static_cast<std::int32_t>(static_cast<float>(a) / static_cast<float>(b));
    q -= std::int32_t(q * b > a);
    return q + std::int32_t((q + 1) * b <= a);
}

/// Blocks of a filter with contact hardening.
/// @tparam Filter   filters::pcss or filters::dpcf
template <depth_direction Direction, class Filter>
struct soft_blocks : disc_blocks<Direction> {
    using discs = disc_blocks<Direction>;
    using test = typename discs::test;
    using placed = typename discs::placed;
    static constexpr std::int32_t far_code = 65535;
    static constexpr bool filters_again = std::is_same_v<Filter, filters::pcss>;

    float per_code_x, per_code_y;
    std::int32_t min_radius, max_radius;

    soft_blocks(image_view<const float> of_map, const disc_table& turned, const Filter& filter)
        : discs{of_map, turned, filter.points, clamp_int(static_cast<int>(filter.reach()), 8)},
          per_code_x(filter.softness.per_code_x),
          per_code_y(filter.softness.per_code_y),
          min_radius(static_cast<std::int32_t>(filter.softness.min_radius)),
          max_radius(static_cast<std::int32_t>(filter.softness.max_radius)) {}

    template <class Placed, class Isa>
    UMBRAGE_INLINE void operator()(const Placed& at, int, float* visibility, Isa set) const {
        out_of_line(set, [&](auto) UMBRAGE_INLINE { soften(at, visibility); });
    }

private:
    [[nodiscard]] static UMBRAGE_INLINE std::int32_t distance_code_of(float depth) {
        const std::int32_t number = number_mask(depth), x = floor_within(depth * 65536.0f, 65535.0f);
        return ((test::forward ? x : far_code - x) & number) | (far_code & ~number);
    }
    /// Radii of ellipses along x and y, in 1/16 texel.
    struct radii {
        alignas(64) std::int32_t x[block], y[block];
    };
    UMBRAGE_INLINE void set_radii(radii& r, int i, std::int32_t apart) const {
        r.x[i] = radius(apart, per_code_x);
        r.y[i] = radius(apart, per_code_y);
    }
    [[nodiscard]] UMBRAGE_INLINE std::int32_t radius(std::int32_t apart, float per_code) const {
        const std::int32_t r = floor_int(static_cast<float>(apart) * per_code);
        const std::int32_t above = r > min_radius ? r : min_radius;
        return above < max_radius ? above : max_radius;
    }

    /// Loads the texels below one point of each receiver's ellipse.
    template <class Placed>
    UMBRAGE_INLINE void load_tap(const Placed& at, int point, const radii& of,
                                 loaded_texels<float_texels>& texels) const {
        const texel_bytes memory(this->map);
        const int last_x = this->map.size.x - 1, last_y = this->map.size.y - 1;
        alignas(64) std::int32_t offsets[block];
        const disc_table::tap& tap = this->taps.of[static_cast<std::size_t>(at.row)][static_cast<std::size_t>(point)];
        for (int i = 0; i < block; ++i)
            offsets[i] = memory.offset(clamp_int((at.x[i] + (tap.x[i] * of.x[i] >> 6)) >> 8, last_x),
                                       clamp_int((at.y[i] + (tap.y[i] * of.y[i] >> 6)) >> 8, last_y));
        texels.load_one(memory, offsets);
        texels_on_planes<test::forward>(
            at, [&](int i) UMBRAGE_INLINE { return (at.x[i] + (tap.x[i] * of.x[i] >> 6)) >> 8; },
            [&](int i) UMBRAGE_INLINE { return (at.y[i] + (tap.y[i] * of.y[i] >> 6)) >> 8; }, texels.depths);
    }

    template <class Placed>
    UMBRAGE_INLINE void soften(const Placed& at, float* visibility) const {
        alignas(64) std::int32_t codes[block], blocked[block]{}, sums[block]{};
        radii searched, filtered;
        loaded_texels<float_texels> texels(float_texels{this->map});
        for (int i = 0; i < block; ++i) {
            codes[i] = distance_code_of(at.z[i]);
            set_radii(searched, i, codes[i]);
        }
        for (int p = 0; p < this->points; ++p) {
            load_tap(at, p, searched, texels);
            std::int32_t found = 0;
            for (int i = 0; i < block; ++i) {
                const std::int32_t before = 1 - test::lit(at.z[i], texels.one(i));
                blocked[i] += before;
                found |= before;
            }
            if (found == 0) continue;  // most blocks of a picture are lit
            for (int i = 0; i < block; ++i)
                sums[i] += distance_code_of(texels.one(i)) & -(1 - test::lit(at.z[i], texels.one(i)));
        }
        std::int32_t any = 0;
        for (int i = 0; i < block; ++i) {
            any |= blocked[i] & at.compared[i];
            set_radii(filtered, i, codes[i] - divide_int(sums[i], blocked[i] > 1 ? blocked[i] : 1));
        }
        if (any == 0) {
            for (int i = 0; i < block; ++i) visibility[i] = 1.0f;
        } else if constexpr (filters_again) {
            alignas(64) std::int32_t lit[block]{};
            for (int p = 0; p < this->points; ++p) {
                load_tap(at, p, filtered, texels);
                for (int i = 0; i < block; ++i) lit[i] += test::lit(at.z[i], texels.one(i));
            }
            const float share = 1.0f / static_cast<float>(this->points);
            UMBRAGE_NO_OVERLAP
            for (int i = 0; i < block; ++i)
                visibility[i] =
                    select(at.compared[i] & -std::int32_t(blocked[i] > 0), static_cast<float>(lit[i]) * share, 1.0f);
        } else {
            const std::int32_t n = this->points, cube = n * n * n;
            const float share = 1.0f / (512.0f * static_cast<float>(cube));
            UMBRAGE_NO_OVERLAP
            for (int i = 0; i < block; ++i) {
                const std::int32_t whole = searched.x[i] + searched.y[i];
                const std::int32_t ratio = divide_int((filtered.x[i] + filtered.y[i]) * 256, whole > 1 ? whole : 1);
                const std::int32_t u = blocked[i] * 2 - n, d = n - (u < 0 ? -u : u), steep = cube - d * d * d;
                const std::int32_t hard = u < 0 ? cube - steep : cube + steep;
                const std::int32_t dark = hard * (256 - ratio) + blocked[i] * ratio * (2 * n * n);
                visibility[i] = select(at.compared[i], 1.0f - static_cast<float>(dark) * share, 1.0f);
            }
        }
    }
};

template <class Filter>
struct soft_form : plain_form {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    /// Rotated points in 1/16 of 1/64 of a radius. With a radius of 4 texels there is nothing to divide by.
    template <class ParallelFor>
    [[nodiscard]] static disc_table tables(const float_texels&, const Filter& filter, ParallelFor&&) {
        return {points_of_disc(filter.points).data(), filter.points, 4.0f};
    }
    template <depth_direction Direction>
    [[nodiscard]] static soft_blocks<Direction, Filter> blocks(const float_texels& map, const Filter& filter,
                                                               const disc_table& turned) {
        return {map.map, turned, filter};
    }
};
template <>
struct block_form<filters::pcss> : soft_form<filters::pcss> {};
template <>
struct block_form<filters::dpcf> : soft_form<filters::dpcf> {};

}  // namespace umbrage::detail
