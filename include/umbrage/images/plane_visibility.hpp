// SPDX-License-Identifier: MIT
//
// Receiver plane depth bias over whole images: each receiver is compared along its own plane, so no filter radius needs
// another bias.
//
//     umbrage::sloped_receivers receivers{{x, y, depth}, slope_x, slope_y};  // plane_slope of each receiver
//     umbrage::visibility(map, umbrage::depth32f{}, receivers, umbrage::filters::pcss{.softness = soft}, out);
//
// Results have the same bits as the filter for each receiver alone over `apply_receiver_plane(fetch, slope, at)`.
#pragma once

#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/images/blocks/plane_forms.hpp>
#include <umbrage/images/receivers.hpp>
#include <umbrage/images/visibility.hpp>

namespace umbrage {

namespace detail {

/// Receivers with planes: each compares texels along its own.
template <class Filter>
struct form_for<sloped_receivers, Filter> {
    static constexpr bool known = has_plane_form<Filter>;
    static constexpr bool clamps = false;  // a clamped texel keeps its own place on the plane
    using type = plane_form<Filter>;

    template <class Fetch>
    [[nodiscard]] static auto texels(const sloped_receivers& receivers, const Fetch& fetch, glm::vec2 coord,
                                     glm::ivec2 pixel, depth_direction direction) {
        const glm::vec3 at(coord, receivers.at.depth[pixel]);
        return apply_receiver_plane(fetch, {receivers.slope_x[pixel], receivers.slope_y[pixel]}, at, direction);
    }
};

}  // namespace detail

/// Visibility of receivers along their planes, with the filter over apply_receiver_plane(fetch, slope, at) for each.
///
/// @param map         shadow map, texels of the encoding. A spot light's map must hold z/w, in which planes stay planes
/// @param encoding    encoding of the map's texels, with the depth direction
/// @param receivers   with the slopes of their planes
/// @param filter      as for visibility of receivers without planes. Your own callables, filters::four_tap and
///                    pcf_2x2_dx_sdk are called receiver by receiver: many times slower than the others
/// @param out         receives visibility, 1 lit; same size as receivers, other memory than these and the map
/// @param parallel    cuts the rows into pieces, see parallel.hpp
/// @param outside     value of texels outside the map. The default is the far plane, so everything there is lit
/// @throws std::invalid_argument  sizes differ; an empty map; a filter's number out of range
template <class Encoding, class Filter, class ParallelFor = serial>
void visibility(image_view<const typename Encoding::texel> map, const Encoding& encoding,
                const sloped_receivers& receivers, const Filter& filter, image_view<float> out,
                ParallelFor&& parallel = {}, outside_map outside = outside_map::bordered) {
    detail::filter_image(map, encoding, receivers, filter, out, parallel, outside);
}

}  // namespace umbrage
