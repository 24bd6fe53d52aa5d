// SPDX-License-Identifier: MIT
//
// Maps as the forms of filters read them.
//
//     if (!form_takes<Form>(map, reads_stored<Form, Encoding>, count)) return {};
//     const form_map<Encoding, reads_stored<Form, Encoding>> of(map, encoding, parallel);
//     const auto tables = Form::tables(of.texels, filter, parallel);
//
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include <glm/vec2.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/depth/depth32f.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/images/blocks/form.hpp>
#include <umbrage/images/blocks/texels.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/simd/memory.hpp>

namespace umbrage::detail {

/// Texels that are read one by one as stored, for encodings with a fast form for that. Other maps are decoded first.
[[nodiscard]] inline float_texels texels_of(image_view<const float> map, const depth32f&) { return {map}; }
template <int Bits>
[[nodiscard]] rg_texels texels_of(image_view<const glm::u8vec2> map, const rg<Bits>& encoding) {
    return {map, Bits, encoding.edge};
}
template <class Encoding>
concept has_texels_form = requires(image_view<const typename Encoding::texel> map, const Encoding& e) {
    texels_of(map, e);
};

/// True when a form reads an encoding's maps as stored.
template <class Form, class Encoding>
inline constexpr bool reads_stored = std::is_same_v<Encoding, depth32f> ||
                                     (Form::need == map_need::texels && has_texels_form<Encoding>);

/// Map as a form reads it: as stored, or decoded.
template <class Encoding, bool Stored>
struct form_map {
    decltype(texels_of(image_view<const typename Encoding::texel>(), std::declval<Encoding>())) texels;
    template <class ParallelFor>
    form_map(image_view<const typename Encoding::texel> map, const Encoding& encoding, ParallelFor&&)
        : texels(texels_of(map, encoding)) {}
};
template <class Encoding>
struct form_map<Encoding, false> {
    unset_image<float> depths;
    float_texels texels{depths.view};
    template <class ParallelFor>
    form_map(image_view<const typename Encoding::texel> map, const Encoding& encoding, ParallelFor&& parallel)
        : depths(map.size) {
        decode(map, depths.view, encoding, parallel);
    }
};

/// Number of pixels of an image.
[[nodiscard]] inline double area_of(glm::ivec2 size) { return static_cast<double>(size.x) * size.y; }

/// True when a form can read a map. Decoding a map must pay off for that number of receivers.
template <class Form, class Texel>
[[nodiscard]] bool form_takes(image_view<const Texel> map, bool stored, double receivers) {
    if (map.size.x < Form::least || map.size.y < Form::least) return false;
    if (stored) return texel_bytes<const Texel>::fits(map.size, map.stride);
    return area_of(map.size) < 16.0 * receivers &&
           texel_bytes<const float>::fits(map.size, map.size.x * std::ptrdiff_t(sizeof(float)));
}

}  // namespace umbrage::detail
