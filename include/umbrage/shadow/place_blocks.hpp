// SPDX-License-Identifier: MIT
//
// Places of a block of 64 receivers in a light's one map, biased along their planes. It is anchored_place and
// receiver_of, with the same bits, as a loop that compilers vectorize: an image under tent<3> takes 0.4 of the time.
// See also: place_images.hpp, which calls it row by row.
#pragma once

#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/setup.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>

namespace umbrage::detail {

/// Memory for a block of places: x and y in texels, depth with the bias applied, and slopes.
struct place_row {
    float *x, *y, *depth, *slope_x, *slope_y;
};

/// Places of a block. Receivers that are not compared lie outside the map.
/// @tparam Forward   depth direction of the map
/// @param points     of `block` receivers
/// @param normals    likewise
/// @param to         memory for `block` places, other than that of the receivers
template <bool Forward>
UMBRAGE_INLINE inline void place_anchored_block(const anchored_map& map, const shadow_terms& terms,
                                                const glm::vec3* points, const glm::vec3* normals,
                                                const place_row& to) {
    // copies, which the loop cannot write
    const glm::mat4 to_texels = map.to_texels, planes = map.planes;
    const glm::vec4 anchor = map.anchor, rounding = map.rounding, slack = map.slack;
    const float error = terms.error;
    UMBRAGE_NO_OVERLAP
    for (int i = 0; i < block; ++i) {
        const float x = points[i].x - anchor.x, y = points[i].y - anchor.y, z = points[i].z - anchor.z;
        const float nx = normals[i].x, ny = normals[i].y, nz = normals[i].z, d = -(nx * x + ny * y + nz * z);
        const auto coordinate = [&](glm::length_t k) UMBRAGE_INLINE {
            return to_texels[3][k] + to_texels[0][k] * x + to_texels[1][k] * y + to_texels[2][k] * z;
        };
        const auto of_plane = [&](glm::length_t k) UMBRAGE_INLINE {
            return planes[3][k] * d + planes[0][k] * nx + planes[1][k] * ny + planes[2][k] * nz;
        };
        const float along = of_plane(2), rise = select(-std::int32_t(along == 0.0f), 1e-30f, along);
        const float slope_x = -of_plane(0) / rise, slope_y = -of_plane(1) / rise;
        const float steep = magnitude(slope_x) + magnitude(slope_y);

        const float w = coordinate(3);
        const std::int32_t before = -std::int32_t(w > 0.0f) & number_mask(w);
        const float inverse = masked(1.0f / w, before), depth = coordinate(2) * inverse, reach = magnitude(depth);
        const float moves = rounding.x + rounding.y * inverse, beside = moves * rounding.z + slack.x;
        const float off = moves * (rounding.w + reach) + (reach * slack.y + slack.z), at = depth + slack.w;

        const std::int32_t seen = -std::int32_t(steep < 2.0f) & number_mask(steep);
        const std::int32_t compared = before & seen & ~beyond_far_plane_mask<Forward>(at);
        const float bias = select(seen, clamped_to_one(error + (beside * steep + off)), 1.0f);
        const float by = masked(bias, number_mask(bias));
        to.x[i] = select(compared, coordinate(0) * inverse, 65536.0f);
        to.y[i] = coordinate(1) * inverse;
        to.depth[i] = Forward ? at - by : at + by;
        to.slope_x[i] = slope_x;
        to.slope_y[i] = slope_y;
    }
}

}  // namespace umbrage::detail
