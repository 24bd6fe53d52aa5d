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

#include <concepts>

#include <umbrage/core/check.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/images/blocks/row_filter.hpp>
#include <umbrage/images/receivers.hpp>

namespace umbrage {

template <class Texel>
struct page_map;
struct moment_table;
struct variance_table;

namespace detail {

template <class T>
concept has_texel = requires {
    typename T::texel;
};

/// Second argument of visibility that is no encoding, and no table.
template <class T>
concept no_encoding = !has_texel<T> && !std::same_as<T, moment_table> && !std::same_as<T, variance_table>;

/// Map of other texels than the encoding's.
template <class Map, class Encoding>
concept has_other_texels = has_texel<Encoding> && !std::same_as<Map, page_map<typename Encoding::texel>> &&
                           !std::convertible_to<const Map&, image_view<const typename Encoding::texel>>;

template <class Encoding, class Receivers, class Filter, class ParallelFor>
void filter_image(image_view<const typename Encoding::texel> map, const Encoding& encoding, const Receivers& receivers,
                  const Filter& filter, image_view<float> out, ParallelFor&& parallel, outside_map outside) {
    static_assert(is_encoding<Encoding>() && is_filter<Filter>());
    require_size(out.size, size_of(receivers, "visibility"), "visibility", "out.size", "the receivers' size");
    require(!map.empty(), "visibility", "map.size", "above 0", map.size);
    require_filter("visibility", filter);
    if (out.empty()) return;
    const row_filter<Receivers> rows =
        make_row_filter<Receivers>(map, encoding, filter, area_of(out.size), parallel, outside);
    parallel(out.size.y, [&](int first, int last) { rows(receivers, out, first, last); });
}

}  // namespace detail

/// Visibility of receivers from a shadow map.
/// @param map         shadow map, texels of the encoding
/// @param encoding    encoding of the map's texels, with the depth direction. Its edge decides ties
/// @param receivers   (x, y) in texels of the map, z depth with the bias already applied: an image of vec3, or planes.
///                    Or a camera's depth image, of which receiver_at gives each texel's
/// @param filter      one of filters::, whose is_lit is set to the encoding's direction. Or any callable
///                    (fetch, coord, receiver) -> visibility, optionally with the receiver's pixel as fourth argument
/// @param out         receives visibility, 1 lit; same size as receivers, other memory than these and the map
/// @param parallel    cuts the rows into pieces, see parallel.hpp. The filter is then called from all of them
/// @param outside     value of texels outside the map. The default is the far plane, so everything there is lit
/// @throws std::invalid_argument  sizes differ; an empty map; a filter's number out of range
template <class Encoding, receiver_image Receivers = receiver_planes, class Filter, class ParallelFor = serial>
void visibility(image_view<const typename Encoding::texel> map, const Encoding& encoding, const Receivers& receivers,
                const Filter& filter, image_view<float> out, ParallelFor&& parallel = {},
                outside_map outside = outside_map::bordered) {
    detail::filter_image(map, encoding, detail::viewed(receivers), filter, out, parallel, outside);
}

// Deleted, so that compilers show these lines and not all overloads.
template <class Map, detail::no_encoding Encoding>
void visibility(const Map&, const Encoding&, const auto&...) = delete;  ///< the second argument must be an encoding
template <class Map, class Encoding>
requires detail::has_other_texels<Map, Encoding>
void visibility(const Map&, const Encoding&, const auto&...) = delete;  ///< map must hold texels of the encoding

}  // namespace umbrage
