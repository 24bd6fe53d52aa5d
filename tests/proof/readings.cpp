// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/depth/r16.hpp>
#include <umbrage/filter/blocker/pcss.hpp>

#include "../unit/shadow/readings.hpp"

using namespace shadow_scene;

TEST_CASE("calibration: right, upside down, empty and another map, for each setup, by other filters and encodings") {
    all_readings(cpu_clip_space, filters::pcf_2x2{}, depth32f{});
    all_readings(cpu_clip_space, filters::disc{}, r16{});
    all_readings(reversed_clip(), sized(filters::pcss{}), depth32f{});
}
