// SPDX-License-Identifier: MIT
//
// A filter over one map, made ready once for receivers that come in pieces: its texels are decoded and its tables made
// where that pays. It has the bits of the filter for each receiver alone.
//
//     const auto rows = make_row_filter<Receivers>(map, encoding, filter, count, parallel, outside);
//     parallel(out.size.y, [&](int first, int last) { rows(receivers, out, first, last); });
//
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <glm/vec2.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/images/blocks/form_map.hpp>
#include <umbrage/images/blocks/forms.hpp>
#include <umbrage/images/blocks/receivers.hpp>
#include <umbrage/images/blocks/texels.hpp>

namespace umbrage::detail {

/// Visibility of a receiver, by a filter that may also take its pixel.
template <class Filter, class Fetch>
[[nodiscard]] float filtered(const Filter& filter, const Fetch& fetch, glm::vec2 coord, float receiver,
                             [[maybe_unused]] glm::ivec2 pixel) {
    if constexpr (requires { filter(fetch, coord, receiver, pixel); })
        return static_cast<float>(filter(fetch, coord, receiver, pixel));
    else return static_cast<float>(filter(fetch, coord, receiver));
}

/// Fetch of decoded texels, as one type for all encodings. So rarely used code is not compiled once per encoding.
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
/// @tparam Rounds   true for blocks whose results round: their code is compiled without FMA
template <bool Rounds = false, class Receivers, class Blocks, class Edge>
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
    if constexpr (Rounds) on_best_isa_without_fma(all_rows);
    else on_best_isa(all_rows);
    if (large) finish_streaming();
}

/// Filters the receivers of some rows one after the other.
/// @param alone   (coord, receiver, pixel) -> visibility
template <class Receivers, class Alone>
void filter_each(const Receivers& receivers, image_view<float> out, int first, int last, const Alone& alone) {
    receiver_room room;
    for (block_walk at{0, first, out.size.x}; at.y < last; at.step()) {
        const auto r = block_at(receivers, at, room, isa_constant<isa::base>{});
        float* const to = out.row(at.y) + at.x;
        for (int i = 0; i < at.count(); ++i)
            to[i] = alone(glm::vec2(r.x(i), r.y(i)), r.z(i), glm::ivec2(at.x + i, at.y));
    }
}

/// Depth direction of a map: its encoding's, or the filter's if the encoding has none.
template <class Encoding, class Filter>
[[nodiscard]] depth_direction direction_of(const Encoding& encoding, const Filter& filter) {
    if constexpr (requires { encoding.direction; }) return encoding.direction;
    else if constexpr (requires { filter.direction; }) return filter.direction;
    else return depth_direction::forward;
}

/// Filter that compares in the direction of the map's depth. A callable without a direction is returned unchanged.
template <class Filter>
[[nodiscard]] decltype(auto) in_direction(const Filter& filter, [[maybe_unused]] depth_direction direction) {
    if constexpr (requires(Filter own) { own.direction = direction; }) {
        Filter own = filter;
        own.direction = direction;
        return own;
    } else return filter;
}

/// Fast form of a filter for a kind of receivers. plane_visibility.hpp has that of receivers with planes.
template <class Receivers, class Filter>
struct form_for {
    static constexpr bool known = has_block_form<Filter>;
    static constexpr bool clamps = true;  ///< its blocks are right at the border of a clamped map
    using type = block_form<Filter>;

    /// Texels as a receiver compares them.
    template <class Fetch>
    [[nodiscard]] static const Fetch& texels(const Receivers&, const Fetch& fetch, glm::vec2, glm::ivec2,
                                             depth_direction) {
        return fetch;
    }
};

/// A filter over a map, receiver by receiver.
template <class Encoding, class Filter>
struct map_filter {
    image_view<const typename Encoding::texel> map;
    Encoding encoding;
    Filter filter;
    outside_map outside;
    depth_direction direction;

    template <class Receivers>
    [[nodiscard]] float operator()(const Receivers& receivers, glm::vec2 coord, float receiver,
                                   glm::ivec2 pixel) const {
        const auto over = [&](const auto& fetch) {
            using form = form_for<Receivers, Filter>;
            return filtered(filter, form::texels(receivers, fetch, coord, pixel, direction), coord, receiver, pixel);
        };
        const auto seldom = [&](const auto& fetch) {
            if constexpr (has_block_form<Filter>) return over(erase(fetch));
            else return over(fetch);
        };
        if (outside == outside_map::clamped) return seldom(decoded(clamped(map), encoding));
        return seldom(decoded_map<typename Encoding::texel, Encoding>{map, encoding, cleared_depth(direction)});
    }
};

/// A form over a map, with what its blocks read.
template <class Form, depth_direction Direction, class Encoding, class Filter>
struct form_over_map {
    static constexpr bool rounds = Form::rounds;
    map_filter<Encoding, Filter> each;  ///< blocks keep references to its filter
    form_map<Encoding, reads_stored<Form, Encoding>> of;
    decltype(Form::tables(of.texels, std::declval<const Filter&>(), serial())) tables;
    decltype(Form::template blocks<Direction>(of.texels, std::declval<const Filter&>(), tables)) blocks;

    template <class ParallelFor>
    form_over_map(const map_filter<Encoding, Filter>& m, ParallelFor&& parallel)
        : each(m),
          of(m.map, m.encoding, parallel),
          tables(Form::tables(of.texels, each.filter, parallel)),
          blocks(Form::template blocks<Direction>(of.texels, each.filter, tables)) {}
};

/// Filters rows of receivers: (receivers, out, first, last). It owns any callable of these. std::function and what
/// holds one alone reach <functional> and <ostream>, which cost users of the header too much.
template <class Receivers>
class row_filter {
public:
    row_filter() = default;
    template <class Run>
    requires(!std::same_as<std::remove_cvref_t<Run>, row_filter>) row_filter(Run&& run)
        : rows_(new rows_of<std::remove_cvref_t<Run>>(std::forward<Run>(run))) {}
    row_filter(row_filter&& o) noexcept : rows_(std::exchange(o.rows_, nullptr)) {}
    row_filter& operator=(row_filter&& o) noexcept {
        std::swap(rows_, o.rows_);
        return *this;
    }
    ~row_filter() { delete rows_; }

    /// Makes the callable in its place, for those that refer to themselves.
    template <class Run, class... Arguments>
    [[nodiscard]] static row_filter made(Arguments&&... arguments) {
        row_filter all;
        all.rows_ = new rows_of<Run>(std::forward<Arguments>(arguments)...);
        return all;
    }

    [[nodiscard]] explicit operator bool() const { return rows_ != nullptr; }
    void operator()(const Receivers& receivers, image_view<float> out, int first, int last) const {
        rows_->filter(receivers, out, first, last);
    }

private:
    struct rows {
        virtual ~rows() = default;
        virtual void filter(const Receivers& receivers, image_view<float> out, int first, int last) const = 0;
    };
    template <class Run>
    struct rows_of final : rows {
        Run run;
        template <class... Arguments>
        explicit rows_of(Arguments&&... arguments) : run(std::forward<Arguments>(arguments)...) {}
        void filter(const Receivers& receivers, image_view<float> out, int first, int last) const override {
            run(receivers, out, first, last);
        }
    };

    const rows* rows_ = nullptr;
};

/// Rows by a form over a map.
template <class Receivers, class Over, class Filter>
struct form_rows {
    Over over;

    template <class MapFilter, class ParallelFor>
    form_rows(const MapFilter& m, ParallelFor&& parallel) : over(m, parallel) {}
    void operator()(const Receivers& receivers, image_view<float> out, int first, int last) const {
        const auto& each = over.each;
        const auto alone = [&](glm::vec2 coord, float receiver, glm::ivec2 pixel) {
            return each(receivers, coord, receiver, pixel);
        };
        const bool has_border = each.outside == outside_map::bordered;
        const bool blocks_err = has_border || !form_for<Receivers, Filter>::clamps;
        const map_edge edge(alone, each.filter.reach(), each.map.size, blocks_err, has_border);
        filter_rows<Over::rounds>(receivers, over.blocks, edge, out, first, last);
    }
};

/// Makes a row filter by a form.
/// @return   empty if the form does not support the map, or does not pay
template <class Receivers, class Form, class Encoding, class Filter, class ParallelFor>
[[nodiscard]] row_filter<Receivers> row_filter_by(const map_filter<Encoding, Filter>& m, double count,
                                                  ParallelFor&& parallel) {
    if (!form_takes<Form>(m.map, reads_stored<Form, Encoding>, count)) return {};
    if constexpr (!std::is_void_v<typename Form::by_bounds>)
        if (bounds_pay(width_of(m.filter), m.map.size, count))
            return row_filter_by<Receivers, typename Form::by_bounds>(m, count, parallel);
    const auto make = [&]<depth_direction Direction>() {
        using over = form_over_map<Form, Direction, Encoding, Filter>;
        return row_filter<Receivers>::template made<form_rows<Receivers, over, Filter>>(m, parallel);
    };
    return m.direction == depth_direction::forward ? make.template operator()<depth_direction::forward>()
                                                   : make.template operator()<depth_direction::reversed>();
}

/// Makes a filter ready for a map.
/// @param count   number of receivers to come. Decoding the map, and tables of it, must pay for so many
template <class Receivers, class Encoding, class Filter, class ParallelFor>
[[nodiscard]] row_filter<Receivers> make_row_filter(image_view<const typename Encoding::texel> map,
                                                    const Encoding& encoding, const Filter& filter, double count,
                                                    ParallelFor&& parallel, outside_map outside) {
    const depth_direction direction = direction_of(encoding, filter);
    const map_filter<Encoding, Filter> m{map, encoding, in_direction(filter, direction), outside, direction};
    using form = form_for<Receivers, Filter>;
    if constexpr (form::known)
        if (auto rows = row_filter_by<Receivers, typename form::type>(m, count, parallel)) return rows;
    return [m](const Receivers& receivers, image_view<float> out, int first, int last) {
        filter_each(receivers, out, first, last, [&](glm::vec2 coord, float receiver, glm::ivec2 pixel) {
            return m(receivers, coord, receiver, pixel);
        });
    };
}

}  // namespace umbrage::detail
