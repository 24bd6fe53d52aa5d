// SPDX-License-Identifier: MIT
//
// Root of a virtual shadow map: the square of the world that contains all pages, as a directional light sees it.
// The square and its pages stay in place while the camera moves.
//
//     auto root = umbrage::make_page_root<double>(
//         {.direction = d, .center = {0, 0, 0}, .side = 2400, .scene = box, .clip = clip});
//     auto light = umbrage::page_light(root, {.level = 5, .x = 12, .y = 9}, {});  // for the depth pass of that page
//     glm::mat4 to_root(umbrage::page_matrix(root));                              // for page_coordinate
//
// See also: pages.hpp, page_table.hpp.
#pragma once

#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/light/adaptive/pages.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/sweep.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace umbrage {

/// Square of a directional light that virtual shadow map pages divide.
template <real T = float>
struct page_root {
    glm::vec<3, T> direction{T(0), T(-1), T(0)};   ///< direction the light travels; any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};           ///< up axis of the pages; keep it constant, pages rotate with it
    glm::vec<3, T> center{T(0)};                   ///< center of the square, world
    T side = T(0);                                 ///< required: side of the square, world units, > 0
    bounding_box<T> scene = detail::unset_box<T>;  ///< required: bounds of all casters and receivers
    clip_space clip{};                             ///< required: clip space of your API or engine, see clip_space.hpp
};

/// Size of the pages in an atlas.
struct page_size {
    int texels = 128;  ///< side of a page, a power of two up to 16384
    int gutter = 4;    ///< border around a page, 0 to texels / 2: the filter's reach or more

    [[nodiscard]] constexpr int pitch() const { return texels + 2 * gutter; }
};

/// Light space of the whole root.
/// @throws std::invalid_argument  zero or non-finite direction; center or scene missing or not finite; a side not above
///                                0, or too small for T's precision at the farthest coordinate of center and scene;
///                                clip unset; matrices that would not be finite
template <real T = float>
[[nodiscard]] light_space<T> make_page_root(const page_root<T>& root) {
    constexpr auto function = "make_page_root";
    detail::require_given(root.clip, function);
    detail::require_given(root.scene, function, "scene");
    detail::require(detail::all_finite(root.center), function, "center", "finite", root.center);
    detail::require(is_finite(root.side) && root.side > T(0), function, "side", "finite and above 0", root.side);
    light_space<double> light{detail::look_along(glm::dvec3(0), glm::dvec3(root.direction), glm::dvec3(root.up),
                                                 root.clip.hand, function, ""),
                              {},
                              root.clip};
    const glm::dmat4 frame = detail::light_frame(light.view, root.clip.hand);
    const auto depths = detail::extent_of(detail::seen(frame, hull(root.scene).points));
    const auto farthest =
        (glm::max)(glm::abs(root.center), (glm::max)(glm::abs(root.scene.low), glm::abs(root.scene.high)));
    const T rounding = std::numeric_limits<T>::epsilon() * (glm::max)((glm::max)(farthest.x, farthest.y), farthest.z);
    detail::require(root.side > T(16) * rounding, function, "side", "large enough for the digits of center and scene",
                    root.side);
    const glm::dvec2 middle(frame * glm::dvec4(glm::dvec3(root.center), 1)), half(double(root.side) / 2);
    const double spare =
        (depths.high.z - depths.low.z) / 1024 + double(root.side) / 1048576;  // keeps the scene off both planes
    light.projection = detail::orthographic(middle - half, middle + half, depths.low.z - spare, depths.high.z + spare,
                                            root.clip, function, "center and side", "scene");
    const light_space<T> cast{glm::mat<4, 4, T>(light.view), glm::mat<4, 4, T>(light.projection), root.clip};
    return detail::checked(cast, function, "center, side and scene");
}

/// Matrix from the world to the root's coordinates, 1 to 2, and depth.
/// @formula   texture_matrix of a map of one texel, moved by 1
template <real T>
[[nodiscard]] glm::mat<4, 4, T> page_matrix(const light_space<T>& root) {
    glm::mat<4, 4, T> m = texture_matrix(root, glm::ivec2(1));
    m[3][0] += T(1), m[3][1] += T(1);
    return m;
}

/// Light space of one page with its gutter, for a depth pass of pitch() x pitch() texels.
/// @throws std::invalid_argument  a page outside the root; texels no power of two, or above 16384; gutter out of range
template <real T>
[[nodiscard]] light_space<T> page_light(const light_space<T>& root, const page& p, const page_size& size) {
    constexpr auto function = "page_light";
    detail::require(p.level >= 0 && p.level <= deepest_page_level, function, "level", "from 0 to 15", p.level);
    const int across = 1 << p.level;
    detail::require(p.x >= 0 && p.y >= 0 && p.x < across && p.y < across, function, "x and y", "in the root",
                    glm::ivec2(p.x, p.y));
    detail::require(size.texels >= 1 && size.texels <= 16384 && (size.texels & (size.texels - 1)) == 0, function,
                    "texels", "a power of two up to 16384", size.texels);
    detail::require(size.gutter >= 0 && size.gutter <= size.texels / 2, function, "gutter", "from 0 to half the texels",
                    size.gutter);
    const double scale = double(across) * size.texels / size.pitch();
    const double up = root.clip.origin == texture_origin::bottom ? 1.0 : -1.0;
    const glm::dvec2 middle((2 * p.x + 1.0) / across - 1.0, up * ((2 * p.y + 1.0) / across - 1.0));
    glm::dmat4 projection(root.projection);
    for (glm::length_t axis = 0; axis < 2; ++axis)
        for (glm::length_t column = 0; column < 4; ++column)
            projection[column][axis] = (projection[column][axis] - projection[column][3] * middle[axis]) * scale;
    return detail::checked<T>({root.view, glm::mat<4, 4, T>(projection), root.clip}, function, "root");
}

}  // namespace umbrage
