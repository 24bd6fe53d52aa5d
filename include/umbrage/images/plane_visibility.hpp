// SPDX-License-Identifier: MIT
//
// Receiver plane depth bias over whole images: each receiver is compared along its own plane, so no filter radius needs
// another bias. Use it for contact hardening (PCSS, DPCF), whose radius differs from receiver to receiver.
//
//     umbrage::sloped_receivers receivers{{x, y, depth}, slope_x, slope_y};  // plane_slope of each receiver
//     umbrage::visibility(map, umbrage::depth32f{}, receivers, umbrage::filters::pcss{.softness = soft}, out);
//
// Results have the same bits as the filter for each receiver alone over apply_receiver_plane(fetch, slope, coord).
#pragma once

#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/core/check.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/images/blocks/plane_forms.hpp>
#include <umbrage/images/visibility.hpp>

namespace umbrage {

/// Receivers with their planes, as five images of one size.
struct sloped_receivers {
    receiver_planes at;                        ///< x and y in texels of the map, depth with a bias for rounding only
    image_view<const float> slope_x, slope_y;  ///< change of depth per texel: plane_slope
};

namespace detail {

[[nodiscard]] inline glm::ivec2 size_of(const sloped_receivers& receivers, const char* function) {
    const glm::ivec2 size = size_of(receivers.at, function);
    require_size(receivers.slope_x.size, size, function, "receivers.slope_x.size", "that of receivers.at");
    require_size(receivers.slope_y.size, size, function, "receivers.slope_y.size", "that of receivers.at");
    return size;
}

/// Block of receivers with their planes.
struct sloped_rows : receiver_rows {
    const float *first_slope_x, *first_slope_y;
    [[nodiscard]] UMBRAGE_INLINE float slope_x(int i) const { return first_slope_x[i]; }
    [[nodiscard]] UMBRAGE_INLINE float slope_y(int i) const { return first_slope_y[i]; }
};
template <isa Set>
[[nodiscard]] UMBRAGE_INLINE inline sloped_rows block_at(const sloped_receivers& from, const block_walk& at,
                                                         receiver_room& room, isa_constant<Set> set) {
    return {block_at(from.at, at, room, set), whole_block(from.slope_x.row(at.y) + at.x, at.count(), room.rows[3]),
            whole_block(from.slope_y.row(at.y) + at.x, at.count(), room.rows[4])};
}
UMBRAGE_INLINE inline void prefetch(const sloped_receivers& from, const block_walk& at) {
    prefetch(from.at, at);
    for (const auto* slope : {&from.slope_x, &from.slope_y}) prefetch(*slope, at);
}

}  // namespace detail

/// Visibility of receivers along their planes, with the filter over apply_receiver_plane(fetch, slope, coord) for each.
///
/// @param map         shadow map, texels of the encoding. For a spot light z/w, in which a plane stays a plane
/// @param encoding    encoding of the map's texels, with the depth direction
/// @param receivers   with the slopes of their planes
/// @param filter      as for visibility of receivers without planes. Your own callables, filters::four_tap and
///                    pcf_2x2_dx_sdk are called receiver by receiver: many times slower than the others
/// @param out         receives visibility, 1 lit; same size as receivers, other memory than these and the map
/// @param parallel    cuts the rows into pieces, see parallel.hpp
/// @param outside     value of texels outside the map. By default the far plane, so everything there is lit
/// @throws std::invalid_argument  sizes differ; an empty map; a filter's number out of range
template <class Encoding, class Filter, class ParallelFor = serial>
void visibility(image_view<const typename Encoding::texel> map, const Encoding& encoding,
                const sloped_receivers& receivers, const Filter& filter, image_view<float> out,
                ParallelFor&& parallel = {}, outside_map outside = outside_map::bordered) {
    static_assert(detail::is_encoding<Encoding>() && detail::is_filter<Filter>());
    detail::require_size(out.size, detail::size_of(receivers, "visibility"), "visibility", "out.size",
                         "the receivers' size");
    detail::require(!map.empty(), "visibility", "map.size", "above 0", map.size);
    detail::require_filter("visibility", filter);
    if (out.empty()) return;
    const depth_direction direction = detail::direction_of(encoding, filter);
    const auto& directed = detail::in_direction(filter, direction);
    const bool has_border = outside == outside_map::bordered;
    const auto clamped_map = decoded(clamped(map), encoding);
    const decoded_map<typename Encoding::texel, Encoding> bordered_map{map, encoding, cleared_depth(direction)};
    const detail::erased_fetch fetch = has_border ? detail::erase(bordered_map) : detail::erase(clamped_map);
    const auto alone = [&](glm::vec2 coord, float receiver, glm::ivec2 pixel) {
        const glm::vec2 slope(receivers.slope_x[pixel], receivers.slope_y[pixel]);
        return detail::filtered(directed, apply_receiver_plane(fetch, slope, coord, direction), coord, receiver, pixel);
    };
    bool done = false;
    if constexpr (detail::has_plane_form<Filter>) {
        // a clamped texel keeps its own place on the plane
        const detail::map_edge edge(alone, filter.reach(), map.size, true, has_border);
        done = detail::filter_by_form<detail::plane_form<Filter>>(map, encoding, receivers, directed, direction, edge,
                                                                  out, parallel);
    }
    if (!done) detail::for_each_receiver(receivers, out, parallel, alone);
}

}  // namespace umbrage
