// SPDX-License-Identifier: MIT
//
// Debug overlay of a shadow map in the corner of a rendered picture, with stretched contrast.
//
//     umbrage::overlay(picture, map, {.size = {256, 256}}, umbrage::stretch(map));
//     umbrage::overlay(picture, map, {.size = {256, 256}}, [s = umbrage::stretch(map)](float depth) {
//         return umbrage::false_color(s(depth));
//     });
//
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <glm/common.hpp>
#include <glm/fwd.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/unorm.hpp>
#include <umbrage/debug/overlay_texel.hpp>

namespace umbrage {

/// Mapping of low..high to 0..1. Clamps values outside, and returns 1 for NaN.
struct contrast_stretch {
    float low = 0.0f, high = 1.0f;

    [[nodiscard]] float operator()(float v) const {
        if (is_nan(v) || v >= high) return 1.0f;
        return v > low ? static_cast<float>((double(v) - double(low)) / (double(high) - double(low))) : 0.0f;
    }
};

/// Range of a map's depths, without the texels to which nothing was drawn.
///
/// @param map       depths, any values
/// @param cleared   texels of this value are skipped, as are NaN and infinities
/// @param outliers  share of the depths to drop at each end, 0 <= outliers < 1/2
/// @return          the range
/// @edge            no texel left: 0..1
/// @throws std::invalid_argument  outliers out of range
template <class = detail::on_use>
[[nodiscard]] contrast_stretch stretch(image_view<const float> map, float cleared = 1.0f, double outliers = 0.01) {
    detail::require(outliers >= 0.0 && outliers < 0.5, "stretch", "outliers", "0 or more and below 1/2", outliers);
    std::vector<float> depths;
    for (int y = 0; y < map.size.y && !map.empty(); ++y)
        for (int x = 0; x < map.size.x; ++x)
            if (const float depth = map.row(y)[x]; is_finite(depth) && depth != cleared) depths.push_back(depth);
    if (depths.empty()) return {};
    const auto given_up = static_cast<std::ptrdiff_t>(outliers * static_cast<double>(depths.size()));
    const auto ranked = [&](auto at) {
        std::nth_element(depths.begin(), at, depths.end());
        return *at;
    };
    return {ranked(depths.begin() + given_up), ranked(depths.end() - 1 - given_up)};
}

/// Placement of an overlay: its size, and the row order of both images. It goes to the visible top left corner.
struct overlay_placement {
    glm::ivec2 size{0, 0};                                ///< in texels of the picture; 0 stands for the map's own side
    texture_origin map_origin = texture_origin::bottom;   ///< place of row 0 of the map
    texture_origin picture_origin = texture_origin::top;  ///< place of row 0 of the picture; at the top in image files
};

/// Draws a map into the top left corner of a picture, scaled by nearest texel as in `overlay_texel`. Cuts off the part
/// that does not fit.
///
/// @param picture   picture to draw into
/// @param map       depths, any values
/// @param place     size of the overlay, and the row order of both images
/// @param color     color of a map's texel, from float: a float (gray) or a vec3 (red, green, blue), in [0, 1]
/// @throws std::invalid_argument  negative size
template <class Color>
void overlay(image_view<glm::u8vec3> picture, image_view<const float> map, const overlay_placement& place,
             Color&& color) {
    detail::require(place.size.x >= 0 && place.size.y >= 0, "overlay", "place.size", "0 or more", place.size);
    if (map.empty()) return;
    const glm::ivec2 size{place.size.x ? place.size.x : map.size.x, place.size.y ? place.size.y : map.size.y};
    const auto nearest = [](int i, double count, double from) {
        return static_cast<int>(overlay_texel(i + 0.5, count, from, from / count));
    };
    const auto row_from_top = [](int y, int count, texture_origin origin) {
        return origin == texture_origin::top ? y : count - 1 - y;
    };
    for (int y = 0; y < (glm::min)(size.y, picture.size.y); ++y) {
        const float* depths = map.row(row_from_top(nearest(y, size.y, map.size.y), map.size.y, place.map_origin));
        glm::u8vec3* out = picture.row(row_from_top(y, picture.size.y, place.picture_origin));
        for (int x = 0; x < (glm::min)(size.x, picture.size.x); ++x)
            out[x] = store_unorm(glm::vec3(color(depths[nearest(x, size.x, map.size.x)])));
    }
}

}  // namespace umbrage
