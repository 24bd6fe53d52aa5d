// SPDX-License-Identifier: MIT
//
// Promise of contact hardening: a straight edge's penumbra has the width that rays to an area light give it.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <umbrage/filter/blocker/penumbra.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../../special_values.hpp"

namespace umbrage {

/// From where a tenth of the light is seen to where nine tenths are, in texels: `seen` at each 1/4 texel.
inline double penumbra_width(const std::vector<double>& seen) {
    const auto reaches = [&](double share) {
        std::size_t i = 0;
        while (i < seen.size() && seen[i] < share) ++i;
        return static_cast<double>(i);
    };
    return (reaches(0.9) - reaches(0.1)) / 4.0;
}

/// A half plane before a plane, both square to the light's axis: what filter and rays see of the lamp along a line.
/// @param pcss   (map, where the receiver is, softness, rotation, is_lit) -> visibility
template <class Pcss>
void check_width(const Pcss& pcss, const light_space<float>& light, double lamp, double blocker, double receiver) {
    constexpr int size = 256, steps = size * 4;
    const glm::mat4 m = texture_matrix(light, {size, size});
    const auto placed = [&](double x, double distance) {
        const auto down = static_cast<float>(-distance);
        return project_coordinate(shadow_coordinate(m, glm::vec3(static_cast<float>(x), 0.0f, down)));
    };
    image<float> map({size, size}, placed(0, receiver).z);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size / 2; ++x) map[{x, y}] = placed(0, blocker).z;
    const bool spot = light.projection[2][3] != 0.0f;
    const double left = double(placed(-1, receiver).x), texels = double(placed(1, receiver).x) - left;  // in 2 units
    const auto soft = make_penumbra_params(light, {size, size}, static_cast<float>(lamp), 0.0f, 64.0f);
    const comparison is_lit{light.clip.direction};
    std::vector<double> filtered, traced;
    for (int i = 0; i < steps; ++i) {
        const double x = (i / 4.0 - left) / texels * 2.0 - 1.0;
        const glm::vec3 at = placed(x, receiver);
        double share = 0;
        for (int pixel = 0; pixel < 16; ++pixel) {
            const glm::vec4 turned = disc_rotation(glm::vec2(float(pixel % 4), float(pixel / 4)));
            share += double(pcss(map, at, glm::vec4(soft), turned, is_lit)) / 16.0;
        }
        filtered.push_back(share);
        int seen = 0;
        constexpr int rays = 200;
        for (int ray = 0; ray < rays; ++ray) {  // to points of the lamp, all around and as many in each ring
            const double r = lamp * std::sqrt((ray + 0.5) / rays), offset = r * std::cos(ray * 2.399963229728653);
            const double to = spot ? offset : x + offset * receiver;  // a sun's are as far away as the near plane's 0
            seen += x + (to - x) * (receiver - blocker) / receiver >= 0;
        }
        traced.push_back(double(seen) / rays);
    }
    const double ours = penumbra_width(filtered), theirs = penumbra_width(traced);
    CAPTURE(ours);
    CAPTURE(theirs);
    CHECK(theirs > 4.0);
    CHECK(std::abs(ours - theirs) <= std::max(1.0, 0.1 * theirs));
}

/// Checks directional lights and spot lights, both directions of depth, with and without a far plane.
template <class Pcss>
void check_widths(const Pcss& pcss) {
    for (const clip_space clip :
         {opengl_clip_space, clip_space{.range = depth_range::zero_to_one, .direction = depth_direction::reversed}}) {
        for (const float z_far : {12.0f, inf32}) {
            const auto lamp =
                make_spot_light<float>({.direction = {0, 0, -1}, .z_near = 0.5f, .z_far = z_far, .clip = clip});
            for (const double blocker : {1.5, 3.0}) check_width(pcss, lamp, 0.3, blocker, 6.0);
        }
        const auto sun = make_directional_light<float>({.direction = {0, 0, -1},
                                                        .offset = 0,
                                                        .map_size = {256, 256},
                                                        .texels_per_unit = 32,
                                                        .z_near = 0,
                                                        .z_far = 12,
                                                        .clip = clip});
        for (const double blocker : {1.0, 4.0}) check_width(pcss, sun, 0.05, blocker, 6.0);
    }
}

}  // namespace umbrage
