// SPDX-License-Identifier: MIT
//
// Visibility of a whole image of receivers from a shadow map, with any filter and any encoding.
//
//     umbrage::visibility(map, umbrage::rg<11>{}, receivers, umbrage::filters::pcf_2x2{}, out);
//
// Straight from a camera's depth image, without an image of receivers:
//
//     umbrage::depth_receivers seen{depth, umbrage::receiver_matrix(inverse, to_texels, size, clip), bias};
//     umbrage::visibility(map, umbrage::rg<11>{}, seen, umbrage::filters::pcf_2x2{}, out);
//
// Results have the same bits as the filter for each receiver alone over bordered(map): everything outside is lit.
// Also called: shadow factor, ShadowCalculation, shadow mask, screen-space shadows (visibility).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/depth/depth32f.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/images/blocks/form_map.hpp>
#include <umbrage/images/blocks/forms.hpp>
#include <umbrage/images/blocks/receivers.hpp>
#include <umbrage/images/blocks/texels.hpp>
#include <umbrage/images/parallel.hpp>
#include <umbrage/images/receivers.hpp>

namespace umbrage {

namespace detail {

/// Visibility of a receiver, by a filter that may also take its pixel.
template <class Filter, class Fetch>
[[nodiscard]] float filtered(const Filter& filter, const Fetch& fetch, glm::vec2 coord, float receiver,
                             [[maybe_unused]] glm::ivec2 pixel) {
    if constexpr (requires { filter(fetch, coord, receiver, pixel); })
        return static_cast<float>(filter(fetch, coord, receiver, pixel));
    else return static_cast<float>(filter(fetch, coord, receiver));
}

/// Fetch of decoded texels, as one type for all encodings: code that is rarely used is not compiled for each.
struct erased_fetch {
    const void* fetch;
    float (*call)(const void*, glm::ivec2);
    float operator()(glm::ivec2 texel) const { return call(fetch, texel); }
};
template <class Fetch>
[[nodiscard]] erased_fetch erase(const Fetch& fetch) {
    return {&fetch, [](const void* of, glm::ivec2 texel) { return (*static_cast<const Fetch*>(of))(texel); }};
}

/// Receivers whose texels may be outside the map. Blocks clamp there, so these receivers are filtered again.
template <class Alone>
class map_edge {
public:
    /// @param alone        (coord, receiver, pixel) -> visibility of one receiver
    /// @param reach        filter radius in texels
    /// @param blocks_err   false: results of blocks are right there
    /// @param lit_beyond   true: a receiver that reaches no texel of the map is lit
    map_edge(Alone alone, float reach, glm::ivec2 map_size, bool blocks_err, bool lit_beyond)
        : alone_(alone),
          margin_(reach + 0.5f),  // weights are in steps of 1/256
          size_(map_size),
          blocks_err_(blocks_err),
          lit_beyond_(lit_beyond),
          inside_(glm::vec2(margin_), size_ - margin_) {}

    /// True when a block has such receivers.
    template <class Receivers>
    [[nodiscard]] UMBRAGE_INLINE bool meets(const Receivers& r) const {
        return blocks_err_ && !inside_.holds(r);
    }
    /// Filters such receivers of a block again.
    template <class Receivers>
    void filter_again(const Receivers& receivers, const block_walk& at, float* visibility) const {
        const glm::vec2 last = size_ - margin_, beyond = size_ + margin_;
        receiver_room room;
        const auto r = block_at(receivers, at, room, isa_constant<isa::base>{});
        for (int i = 0; i < at.count(); ++i) {
            const glm::vec2 c(r.x(i), r.y(i));
            if (c.x >= margin_ && c.y >= margin_ && c.x <= last.x && c.y <= last.y) continue;
            const bool apart = c.x < -margin_ || c.y < -margin_ || c.x > beyond.x || c.y > beyond.y;
            visibility[i] =
                lit_beyond_ && apart && !is_nan(r.z(i)) ? 1.0f : alone_(c, r.z(i), glm::ivec2(at.x + i, at.y));
        }
    }

private:
    Alone alone_;
    float margin_;
    glm::vec2 size_;
    bool blocks_err_, lit_beyond_;
    receiver_rectangle inside_;
};

/// Filters the receivers of some rows by a filter's blocks.
template <class Receivers, class Blocks, class Edge>
void filter_rows(const Receivers& receivers, const Blocks& blocks, const Edge& edge, image_view<float> out, int first,
                 int last) {
    const bool large = past_cache(out);
    const auto all_rows = [&](auto set) UMBRAGE_INLINE {
        constexpr unsigned ring = 4;  // blocks in flight
        constexpr bool in_tiles = requires { typename Blocks::tile; };
        typename Blocks::placed placed[ring];
        typename tile_of<Blocks>::type tile;
        alignas(64) float visibility[std::size_t(tile.rows)][block];
        bool at_edge[ring], again[std::size_t(tile.rows)];
        receiver_room room;
        block_walk ahead{0, first, out.size.x, tile.rows, last}, at = ahead;
        for (unsigned n = 0; at.y < last; ++n) {
            if (ahead.y < last) {
                prefetch(receivers, ahead);
                const auto of_block = block_at(receivers, ahead, room, set);
                at_edge[n % ring] = edge.meets(of_block);
                if constexpr (requires { blocks.place(of_block, placed[0], 0); })
                    blocks.place(of_block, placed[n % ring], ahead.y);
                else blocks.place(of_block, placed[n % ring]);
                ahead.step();
            }
            if (n + 1 < ring) continue;
            float* const to_tile = visibility[at.y - at.first];
            if constexpr (in_tiles) blocks(placed[(n + 1) % ring], at.count(), to_tile, tile, set);
            else blocks(placed[(n + 1) % ring], at.count(), to_tile, set);
            again[at.y - at.first] = at_edge[(n + 1) % ring];
            if (at.ends_tile()) {
                if constexpr (in_tiles) blocks.finish(tile, set);
                for (int y = at.first; y <= at.y; ++y) {
                    float* const from = visibility[y - at.first];
                    if (again[y - at.first]) edge.filter_again(receivers, {at.x, y, at.width}, from);
                    float* const to = out.row(y) + at.x;
                    if (large && at.x == 0) prefetch_rest(to, out.size.x);
                    if (large && at.count() == block) stream_block(to, from);
                    else copy_floats(to, from, at.count());
                }
            }
            at.step();
        }
    };
    if constexpr (requires { Blocks::rounds; }) on_best_isa_without_fma(all_rows);
    else on_best_isa(all_rows);
    if (large) finish_streaming();
}

/// Filters one receiver after the other.
/// @param alone   (coord, receiver, pixel) -> visibility
template <class Receivers, class ParallelFor, class Alone>
void for_each_receiver(const Receivers& receivers, image_view<float> out, ParallelFor&& parallel, const Alone& alone) {
    parallel(out.size.y, [&](int first, int last) {
        receiver_room room;
        for (block_walk at{0, first, out.size.x}; at.y < last; at.step()) {
            const auto r = block_at(receivers, at, room, isa_constant<isa::base>{});
            float* const to = out.row(at.y) + at.x;
            for (int i = 0; i < at.count(); ++i)
                to[i] = alone(glm::vec2(r.x(i), r.y(i)), r.z(i), glm::ivec2(at.x + i, at.y));
        }
    });
}

/// Filters receiver by receiver, with any filter.
template <class Receivers, class Filter, class Fetch, class ParallelFor>
void filter_each(const Receivers& receivers, const Filter& filter, const Fetch& fetch, image_view<float> out,
                 ParallelFor&& parallel) {
    for_each_receiver(receivers, out, parallel, [&](glm::vec2 coord, float receiver, glm::ivec2 pixel) {
        return filtered(filter, fetch, coord, receiver, pixel);
    });
}

/// Depth direction of a map: its encoding's, or the filter's if the encoding has none.
template <class Encoding, class Filter>
[[nodiscard]] depth_direction direction_of(const Encoding& encoding, const Filter& filter) {
    if constexpr (requires { encoding.direction; }) return encoding.direction;
    else if constexpr (requires { filter.is_lit.direction; }) return filter.is_lit.direction;
    else return depth_direction::forward;
}

/// Filter that compares in the direction of the map's depth. A callable without is_lit is returned unchanged.
template <class Filter>
[[nodiscard]] decltype(auto) in_direction(const Filter& filter, [[maybe_unused]] depth_direction direction) {
    if constexpr (requires(Filter own) { own.is_lit.direction = direction; }) {
        Filter own = filter;
        own.is_lit.direction = direction;
        return own;
    } else return filter;
}

/// Filters all rows by a filter's blocks.
template <class Receivers, class Blocks, class Edge, class ParallelFor>
void filter_pieces(const Receivers& receivers, const Blocks& blocks, const Edge& edge, image_view<float> out,
                   ParallelFor&& parallel) {
    parallel(out.size.y, [&](int first, int last) { filter_rows(receivers, blocks, edge, out, first, last); });
}

/// Filters by the filter's fast form.
/// @return   false if the form does not support the map. Nothing is done then
template <class Form, class Encoding, class Receivers, class Filter, class Edge, class ParallelFor>
bool filter_by_form(image_view<const typename Encoding::texel> map, const Encoding& encoding,
                    const Receivers& receivers, const Filter& filter, depth_direction direction, const Edge& edge,
                    image_view<float> out, ParallelFor&& parallel) {
    constexpr bool stored = reads_stored<Form, Encoding>;
    if (!form_takes<Form>(map, stored, out.size)) return false;
    if constexpr (requires { typename Form::by_bounds; })
        if (bounds_pay(width_of(filter), map.size, out.size))
            return filter_by_form<typename Form::by_bounds>(map, encoding, receivers, filter, direction, edge, out,
                                                            parallel);
    const form_map<Encoding, stored> of(map, encoding, parallel);
    const auto tables = Form::tables(of.texels, filter, parallel);
    if (direction == depth_direction::forward) {
        const auto blocks = Form::template blocks<depth_direction::forward>(of.texels, filter, tables);
        filter_pieces(receivers, blocks, edge, out, parallel);
    } else {
        const auto blocks = Form::template blocks<depth_direction::reversed>(of.texels, filter, tables);
        filter_pieces(receivers, blocks, edge, out, parallel);
    }
    return true;
}

template <class Encoding, class Receivers, class Filter, class ParallelFor>
void filter_image(image_view<const typename Encoding::texel> map, const Encoding& encoding, const Receivers& receivers,
                  const Filter& filter, image_view<float> out, ParallelFor&& parallel, outside_map outside) {
    static_assert(is_encoding<Encoding>() && is_filter<Filter>());
    require_size(out.size, size_of(receivers, "visibility"), "visibility", "out.size", "the receivers' size");
    require(!map.empty(), "visibility", "map.size", "above 0", map.size);
    require_filter("visibility", filter);
    if (out.empty()) return;
    const depth_direction direction = direction_of(encoding, filter);
    const auto& directed = in_direction(filter, direction);
    const auto clamped_map = decoded(clamped(map), encoding);
    const decoded_map<typename Encoding::texel, Encoding> bordered_map{map, encoding, cleared_depth(direction)};
    if constexpr (has_block_form<Filter>) {
        const erased_fetch bordered = erase(bordered_map);
        const bool has_border = outside == outside_map::bordered;
        const auto alone = [&](glm::vec2 coord, float receiver, glm::ivec2 pixel) {
            return filtered(directed, bordered, coord, receiver, pixel);
        };
        const map_edge edge(alone, filter.reach(), map.size, has_border, has_border);
        const bool done =
            filter_by_form<block_form<Filter>>(map, encoding, receivers, directed, direction, edge, out, parallel);
        if (!done) filter_each(receivers, directed, has_border ? bordered : erase(clamped_map), out, parallel);
    } else if (outside == outside_map::bordered) {
        filter_each(receivers, directed, bordered_map, out, parallel);
    } else {
        filter_each(receivers, directed, clamped_map, out, parallel);
    }
}

}  // namespace detail

/// Visibility of receivers from a shadow map.
/// @param map         shadow map, texels of the encoding
/// @param encoding    encoding of the map's texels, with the depth direction. Its edge decides ties
/// @param receivers   (x, y) in texels of the map, z depth with the bias already applied
/// @param filter      one of filters::, whose is_lit is set to the encoding's direction. Or any callable
///                    (fetch, coord, receiver) -> visibility, optionally with the receiver's pixel as fourth argument
/// @param out         receives visibility, 1 lit; same size as receivers, other memory than these and the map
/// @param parallel    cuts the rows into pieces, see parallel.hpp. The filter is then called from all of them
/// @param outside     value of texels outside the map. By default the far plane, so everything there is lit
/// @throws std::invalid_argument  sizes differ; an empty map; a filter's number out of range
template <class Encoding, class Filter, class ParallelFor = serial>
void visibility(image_view<const typename Encoding::texel> map, const Encoding& encoding,
                image_view<const glm::vec3> receivers, const Filter& filter, image_view<float> out,
                ParallelFor&& parallel = {}, outside_map outside = outside_map::bordered) {
    detail::filter_image(map, encoding, receivers, filter, out, parallel, outside);
}

/// Visibility of receivers as a structure of arrays.
template <class Encoding, class Filter, class ParallelFor = serial>
void visibility(image_view<const typename Encoding::texel> map, const Encoding& encoding,
                const receiver_planes& receivers, const Filter& filter, image_view<float> out,
                ParallelFor&& parallel = {}, outside_map outside = outside_map::bordered) {
    detail::filter_image(map, encoding, receivers, filter, out, parallel, outside);
}

/// Visibility of receivers from a camera's depth image: of receiver_at for each of its texels.
template <class Encoding, class Filter, class ParallelFor = serial>
void visibility(image_view<const typename Encoding::texel> map, const Encoding& encoding,
                const depth_receivers& receivers, const Filter& filter, image_view<float> out,
                ParallelFor&& parallel = {}, outside_map outside = outside_map::bordered) {
    detail::filter_image(map, encoding, receivers, filter, out, parallel, outside);
}

}  // namespace umbrage
