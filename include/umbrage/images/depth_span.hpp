// SPDX-License-Identifier: MIT
//
// Range of distances that a camera sees, for cascades that cover no more.
//
//     const auto seen = umbrage::measure_depths(camera_depths.view(), umbrage::cleared_depth(clip));
//     const glm::vec2 range = umbrage::seen_range(seen, z_near, z_far, clip.direction);
//     auto splits = umbrage::practical_splits<4>(range.x, range.y, 1.0f);
//
// Also called: SDSM, sample distribution shadow maps, auto-fit to the depth buffer (measure_depths, seen_range).
//
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/depth/conversions.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>

namespace umbrage {

/// Smallest and largest of some depths.
struct depth_span {
    float least = detail::highest<float>, greatest = -least;
    [[nodiscard]] bool empty() const { return least > greatest; }
};

/// Smallest and largest depth of an image.
/// @param depths     any values; NaN and texels of the cleared depth, where nothing was drawn, are skipped
/// @param cleared    cleared depth: 1, or 0 where depth is reversed. Compared by the bits: -0 is not +0
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @exactness        A: selects, never computes
/// @cite             Lauritzen, Salvi, Lefohn: Sample distribution shadow maps, I3D 2011
template <class ParallelFor = serial>
[[nodiscard]] depth_span measure_depths(image_view<const float> depths, float cleared, ParallelFor&& parallel = {}) {
    constexpr auto lowest = std::numeric_limits<std::int32_t>::lowest(), highest = detail::highest<std::int32_t>;
    struct ends {
        std::int32_t least = highest, greatest = lowest;
    };
    std::vector<ends> rows(depths.empty() ? 0 : static_cast<std::size_t>(depths.size.y));
    const std::int32_t empty = detail::order_key(cleared);
    parallel(static_cast<int>(rows.size()), [&](int first, int last) {
        detail::on_best_isa([&](auto) UMBRAGE_INLINE {
            for (int y = first; y < last; ++y) {
                const float* row = depths.row(y);
                ends found;
                for (int x = 0; x < depths.size.x; ++x) {
                    const std::int32_t key = detail::order_key(row[x]);
                    const std::int32_t kept = detail::number_mask(row[x]) & -std::int32_t(key != empty);
                    const std::int32_t low = (key & kept) | (highest & ~kept), high = (key & kept) | (lowest & ~kept);
                    found.least = low < found.least ? low : found.least;
                    found.greatest = high > found.greatest ? high : found.greatest;
                }
                rows[static_cast<std::size_t>(y)] = found;
            }
        });
    });
    ends all;
    for (const ends& row : rows) {
        all.least = row.least < all.least ? row.least : all.least;
        all.greatest = row.greatest > all.greatest ? row.greatest : all.greatest;
    }
    if (all.least > all.greatest) return {};
    return {detail::from_order_key(all.least), detail::from_order_key(all.greatest)};
}

/// Range of distances along a camera's axis, from the depths it saw. It is wider by 1/1000, for rounding of the depths.
/// @param seen             depths in [0, 1] of a perspective camera
/// @param direction        depth direction of the camera's image
/// @param z_near           near plane of the camera, 0 < z_near < z_far
/// @param z_far            far plane of the camera; may be infinite
/// @return                 x < y within z_near .. z_far, world units
/// @edge                   nothing seen: (z_near, z_far)
template <real T>
[[nodiscard]] glm::vec<2, T> seen_range(const depth_span& seen, T z_near, T z_far, depth_direction direction) {
    if (seen.empty()) return {z_near, z_far};
    const bool forward = direction == depth_direction::forward;
    const T nearest = static_cast<T>(forward ? seen.least : seen.greatest);
    const T farthest = static_cast<T>(forward ? seen.greatest : seen.least);
    const auto distance = [&](T depth) {
        return forward ? view_z_from_depth(depth, z_near, z_far) : view_z_from_reversed_depth(depth, z_near, z_far);
    };
    return {(glm::max)(distance(nearest) * T(1.0 - 1.0 / 1024), z_near),
            (glm::min)(distance(farthest) * T(1.0 + 1.0 / 1024), z_far)};
}

}  // namespace umbrage
