// SPDX-License-Identifier: MIT
//
// Visibility of an image of receivers, from their places. Receivers of one map go through the filter's fast form
// together.
//
// It goes by tiles of 64 x 64 receivers, whose places stay in the cache. A tile whose receivers all have one place in
// one map is filtered straight into the result. Others are filtered once per map and place, where receivers of other
// maps lie outside and cost nothing, and then blended as `blended` does.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/images/blocks/row_filter.hpp>
#include <umbrage/images/plane_visibility.hpp>
#include <umbrage/images/prefilter.hpp>
#include <umbrage/images/visibility.hpp>
#include <umbrage/shadow/lookup.hpp>
#include <umbrage/shadow/place_blocks.hpp>
#include <umbrage/shadow/setup.hpp>
#include <umbrage/simd/dispatch.hpp>

namespace umbrage::detail {

/// Places as images, one of each number, as fast forms take them.
template <bool Sloped>
struct place_planes {
    image<float> x, y, depth, slope_x, slope_y;

    explicit place_planes(glm::ivec2 size) : x(size), y(size), depth(size) {
        if (Sloped) slope_x = image<float>(size), slope_y = image<float>(size);
    }
    UMBRAGE_INLINE void set(glm::ivec2 p, const map_place& place) {
        x[p] = place.at.x, y[p] = place.at.y, depth[p] = place.at.z;
        if constexpr (Sloped) slope_x[p] = place.slope.x, slope_y[p] = place.slope.y;
    }
    [[nodiscard]] place_row row(int at) {
        const auto of = [at](image<float>& plane) { return plane.view().row(at); };
        return {of(x), of(y), of(depth), of(slope_x), of(slope_y)};
    }
};

/// Receivers as a filter takes them: with their planes, or without.
template <bool Sloped>
using place_receivers = std::conditional_t<Sloped, sloped_receivers, receiver_planes>;

/// First rows and columns of planes, as receivers.
/// @param x   column of each receiver in texels. It may differ from that of the planes
template <bool Sloped>
[[nodiscard]] place_receivers<Sloped> receivers_of(const place_planes<Sloped>& planes, const image<float>& x,
                                                   glm::ivec2 size) {
    const auto part = [&](const image<float>& plane) { return plane.view().region({0, 0}, size); };
    const receiver_planes at{part(x), part(planes.y), part(planes.depth)};
    if constexpr (Sloped) return {at, part(planes.slope_x), part(planes.slope_y)};
    else return at;
}

/// True where a setup places receivers in blocks, along their planes.
template <class Setup, class Filter>
inline constexpr bool places_in_blocks = along_plane<Setup, Filter>&& requires(const typename Setup::uniforms& u,
                                                                               const shadow_terms& terms,
                                                                               const glm::vec3* v,
                                                                               const place_row& to) {
    Setup::template place_block<true>(u, terms, v, v, to);
};

/// Points of the world with normals, which a shadow places in its maps.
template <class Setup, class Filter>
struct world_receivers {
    const typename Setup::uniforms& uniforms;
    const shadow_terms& terms;
    depth_direction direction;
    image_view<const glm::vec3> points, normals;

    /// Places of one of them, biased.
    [[nodiscard]] UMBRAGE_INLINE auto operator()(glm::ivec2 p) const {
        auto all = Setup::places(uniforms, terms, points[p], normals[p]);
        for (map_place& place : all)
            if (place.weight > 0.0f) place.at = receiver_of<Setup, Filter>(terms, place, direction);
        return all;
    }
    /// Places of a block of them.
    UMBRAGE_INLINE void place_block(const glm::vec3* of, const glm::vec3* normals_of, const place_row& to) const {
        if (direction == depth_direction::forward)
            Setup::template place_block<true>(uniforms, terms, of, normals_of, to);
        else Setup::template place_block<false>(uniforms, terms, of, normals_of, to);
    }
};

/// Filter of a shadow, ready for one of its maps.
/// @param filter   a Filter, or one that calls it
template <class Setup, class Filter, class Encoding, class ParallelFor>
[[nodiscard]] row_filter<place_receivers<along_plane<Setup, Filter>>> make_place_filter(
    image_view<const typename Encoding::texel> own, const auto& filter, const Encoding& encoding, double count,
    ParallelFor&& parallel) {
    if constexpr (prefilter<Filter>)
        return [own, filter](const receiver_planes& at, image_view<float> out, int first, int last) {
            const auto rows = [&](int, const auto& use) { use(first, last); };
            umbrage::visibility(own, filter, at, out, rows, Setup::outside);
        };
    else
        return make_row_filter<place_receivers<along_plane<Setup, Filter>>>(own, encoding, filter, count, parallel,
                                                                            Setup::outside);
}

/// Tile of receivers, by their places in one map or several.
template <class Setup, class Filter>
class place_tile {
public:
    static constexpr int side = 64;

    place_tile() {
        for (auto& n : numbers_) n = image<std::int8_t>(glm::ivec2(side));
        for (auto& w : weights_) w = image<float>(glm::ivec2(side));
    }
    /// Begins a tile.
    void clear() { alone_ = true, used_ = {}; }
    UMBRAGE_INLINE void set(glm::ivec2 p, const std::array<map_place, std::size_t(most_places<Setup>)>& places) {
        for (std::size_t k = 0; k < places.size(); ++k) {
            const map_place& place = places[k];
            const bool counts = place.weight > 0.0f, outside = place.at.x >= 65536.0f || place.at.x <= -65536.0f;
            numbers_[k][p] = static_cast<std::int8_t>(!counts ? -1 : outside ? maps : place.number);
            if (!counts) continue;
            alone_ = alone_ && k == 0;
            planes_[k].set(p, place);
            weights_[k][p] = place.weight;
            used_[k][static_cast<std::size_t>(numbers_[k][p])] = true;
        }
    }
    /// Sets all receivers of some rows, each with its one place in map 0.
    /// @param from   pixel of the tile's first receiver
    void set_rows(const world_receivers<Setup, Filter>& receivers, glm::ivec2 from, int first, glm::ivec2 size) {
        static_assert(side == block && maps == 1);
        used_[0][0] = true;
        on_best_isa_without_fma([&](auto) UMBRAGE_INLINE {
            for (int y = first; y < size.y; ++y) {
                const glm::vec3 *points = receivers.points.row(from.y + y) + from.x,
                                *normals = receivers.normals.row(from.y + y) + from.x;
                if (size.x < block) {  // what fills the block counts nowhere
                    points = std::copy_n(points, size.x, row_points_.data()) - size.x;
                    normals = std::copy_n(normals, size.x, row_normals_.data()) - size.x;
                }
                receivers.place_block(points, normals, planes_[0].row(y));
            }
        });
    }
    /// Filters and blends the rows from `first` on.
    /// @param filters   filter of each of the light's maps
    void filter(const auto& filters, int first, image_view<float> out) {
        const auto in_map = [&](int number, const planes& of, const image<float>& x, image_view<float> to) {
            filters[std::size_t(number)](receivers_of<sloped>(of, x, out.size), to, first, out.size.y);
        };
        if (const int only = only_map(); only >= 0) return in_map(only, planes_[0], planes_[0].x, out);
        for (std::size_t k = 0; k < planes_.size(); ++k)
            for (int number = 0; number <= maps; ++number) {
                if (!used_[k][static_cast<std::size_t>(number)]) continue;
                if (number < maps) {
                    select(k, number, first, out.size);
                    in_map(number, planes_[k], selected_, seen_.view().region({0, 0}, out.size));
                }
                blend(k, number, first, out);
            }
    }

private:
    static constexpr bool sloped = along_plane<Setup, Filter>;
    using planes = place_planes<sloped>;
    static constexpr std::size_t most = std::size_t(most_places<Setup>);
    static constexpr int maps = Setup::grid.columns * Setup::grid.rows;  ///< places outside count as one more, lit
    static_assert(maps < 127, "a tile counts up to 126 maps");

    /// Number of the map that holds the one place of all receivers, or -1.
    [[nodiscard]] int only_map() const {
        int count = 0, only = -1;
        for (int m = 0; m <= maps; ++m)
            if (used_[0][static_cast<std::size_t>(m)]) ++count, only = m;
        return alone_ && count == 1 && only < maps ? only : -1;
    }
    /// Moves the receivers of other maps outside.
    void select(std::size_t k, int number, int first, glm::ivec2 size) {
        for (int row = first; row < size.y; ++row) {
            const auto* const of = numbers_[k].view().row(row);
            const float* const from = planes_[k].x.view().row(row);
            float* const to = selected_.view().row(row);
            for (int i = 0; i < size.x; ++i) to[i] = of[i] == number ? from[i] : 65536.0f;
        }
    }
    void blend(std::size_t k, int number, int first, image_view<float> out) const {
        for (glm::ivec2 p(0, first); p.y < out.size.y; ++p.y)
            for (p.x = 0; p.x < out.size.x; ++p.x) {
                if (numbers_[k][p] != number) continue;
                const float weight = weights_[k][p], next = number == maps ? 1.0f : seen_[p];
                out[p] = weight < 1.0f ? out[p] + (next - out[p]) * weight : next;
            }
    }

    std::array<planes, most> planes_ = make(std::make_index_sequence<most>());
    std::array<image<std::int8_t>, most> numbers_;
    std::array<image<float>, most> weights_;
    image<float> selected_{glm::ivec2(side)}, seen_{glm::ivec2(side)};
    std::array<std::array<bool, std::size_t(maps + 1)>, most> used_{};
    std::array<glm::vec3, side> row_points_{}, row_normals_{};
    bool alone_ = true;  ///< each receiver has one place

    template <std::size_t... K>
    static std::array<planes, most> make(std::index_sequence<K...>) {
        return {((void)K, planes(glm::ivec2(side)))...};
    }
};

/// Visibility of an image of receivers.
/// @param map_size    size of one map, texels
/// @param filter_of   (number) -> filter of a map
template <class Setup, class Filter, class FilterOf, class Encoding, class ParallelFor>
void visibility_of_places(image_view<const typename Encoding::texel> map, glm::ivec2 map_size,
                          const FilterOf& filter_of, const Encoding& encoding,
                          const world_receivers<Setup, Filter>& receivers, image_view<float> out,
                          ParallelFor&& parallel) {
    constexpr int maps = Setup::grid.columns * Setup::grid.rows;
    std::vector<row_filter<place_receivers<along_plane<Setup, Filter>>>> filters;
    for (int number = 0; number < maps; ++number) {
        const auto own = map.region(first_texel(number, Setup::grid, map_size), map_size);
        filters.push_back(
            make_place_filter<Setup, Filter>(own, filter_of(number), encoding, area_of(out.size) / maps, parallel));
    }
    using tile_type = place_tile<Setup, Filter>;
    parallel(out.size.y, [&](int first, int last) {
        tile_type tile;
        for (int y = first, end = 0; y < last; y = end) {
            // Rotations of discs repeat every 16 rows, so tiles begin at multiples of 16.
            const int before = y % 16;
            end = (glm::min)(last, y - before + tile_type::side);
            for (int x = 0; x < out.size.x; x += tile_type::side) {
                const glm::ivec2 from(x, y - before), size((glm::min)(tile_type::side, out.size.x - x), end - from.y);
                tile.clear();
                if constexpr (places_in_blocks<Setup, Filter>) tile.set_rows(receivers, from, before, size);
                else
                    for (glm::ivec2 p(0, before); p.y < size.y; ++p.y)
                        for (p.x = 0; p.x < size.x; ++p.x) tile.set(p, receivers(from + p));
                tile.filter(filters, before, out.region(from, size));
            }
        }
    });
}

}  // namespace umbrage::detail
