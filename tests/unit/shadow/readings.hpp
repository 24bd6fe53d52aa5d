// SPDX-License-Identifier: MIT
//
// A calibration map under each setup of the scene: right, upside down, cleared, and the first map for all.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <type_traits>
#include <utility>

#include <umbrage/shadow/calibration.hpp>

#include "scene.hpp"

namespace shadow_scene {

template <class Shadow>
constexpr int maps_of = std::remove_cvref_t<decltype(std::declval<Shadow>().setup())>::grid
                            .columns* std::remove_cvref_t<decltype(std::declval<Shadow>().setup())>::grid.rows;

/// Each map upside down.
template <class Texel>
image<Texel> flipped_rows(const image<Texel>& map, glm::ivec2 map_size) {
    image<Texel> out = map;
    for (int y = 0; y < map.size().y; ++y) {
        const int row = y % map_size.y;
        std::copy_n(map.view().row(y - row + map_size.y - 1 - row), map.size().x, out.view().row(y));
    }
    return out;
}

/// The first map's content in all of them.
template <class Texel>
image<Texel> first_everywhere(const image<Texel>& map, glm::ivec2 map_size) {
    image<Texel> out = map;
    for (int y = 0; y < map.size().y; ++y)
        for (int x = 0; x < map.size().x; x += map_size.x)
            std::copy_n(map.view().row(y % map_size.y), map_size.x, out.view().row(y) + x);
    return out;
}

template <class Filter, class Encoding>
void all_readings(clip_space clip, const Filter& filter, const Encoding& encoding) {
    for_each_shadow(clip, filter, encoding, [&](const auto& s) {
        const auto known = calibration_map(s);
        CAPTURE(known.size().x);
        CAPTURE(filter.snippet->name);
        const int last = maps_of<decltype(s)> - 1;
        for (int number = 0; number <= last; ++number) CHECK(calibrate(s, known, number) == map_reading::right);
        CHECK(calibrate(s, flipped_rows(known, s.map_size()), last) == map_reading::upside_down);
        auto other = known;
        std::fill(other.texels().begin(), other.texels().end(), s.cleared());
        CHECK(calibrate(s, other, last) == map_reading::empty);
        const auto shared = first_everywhere(known, s.map_size());
        CHECK(calibrate(s, shared, 0) == map_reading::right);
        if (last > 0) CHECK(calibrate(s, shared, last) == map_reading::another_map);
    });
}

inline clip_space reversed_clip() {
    clip_space clip = cpu_clip_space;
    clip.direction = depth_direction::reversed;
    return clip;
}

}  // namespace shadow_scene
