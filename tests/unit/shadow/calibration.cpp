// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string_view>

#include <umbrage/depth/rg.hpp>
#include <umbrage/shadow/calibration.hpp>

#include "readings.hpp"
#include "scene.hpp"

using namespace umbrage;

TEST_CASE("calibration: right, upside down, empty and another map, for each setup") {
    shadow_scene::all_readings(shadow_scene::reversed_clip(), filters::tent<3>,
                               rg<11>{});  // other filters: proof/readings
}

TEST_CASE("calibration: prefiltered maps") {
    const auto known_and_flipped = [](const auto& filter) {
        for (const clip_space clip : {cpu_clip_space, shadow_scene::reversed_clip()}) {
            const shadow s(shadow_scene::spot(clip), {64, 64}, filter);
            CAPTURE(filter.name);
            CHECK(calibrate(s, calibration_map(s), 0) == map_reading::right);
            CHECK(calibrate(s, shadow_scene::flipped_rows(calibration_map(s), s.map_size()), 0) ==
                  map_reading::upside_down);
        }
    };
    known_and_flipped(prefilters::vsm{});
    known_and_flipped(prefilters::esm{});
    known_and_flipped(prefilters::evsm2{});
    known_and_flipped(prefilters::evsm4{});
    known_and_flipped(prefilters::msm{});
}

TEST_CASE("calibration: dark, coarse, reversed and wrong") {
    const shadow s(shadow_scene::spot(cpu_clip_space), {64, 32}, filters::pcf_2x2{});
    const auto known = calibration_map(s);
    const auto changed = [&](const auto& change) {
        auto map = known;
        for (float& depth : map.texels()) depth = change(depth);
        return calibrate(s, map, 0);
    };
    CHECK(changed([](float) { return 0.0f; }) == map_reading::dark);
    CHECK(changed([](float) { return std::numeric_limits<float>::quiet_NaN(); }) == map_reading::dark);
    CHECK(changed([](float d) { return std::round(d * 255.0f) / 255.0f; }) == map_reading::coarse);
    CHECK(changed([](float d) { return std::round(d * 65535.0f) / 65535.0f; }) == map_reading::coarse);
    CHECK(changed([](float d) { return std::round(d * 16777215.0f) / 16777215.0f; }) == map_reading::right);
    CHECK(changed([](float d) { return std::pow(d, 2.2f); }) == map_reading::wrong);
    CHECK(changed([](float d) { return d * 0.5f; }) == map_reading::wrong);

    clip_space other = cpu_clip_space;
    other.direction = depth_direction::reversed;
    const shadow reversed(shadow_scene::spot(other), {64, 32}, filters::pcf_2x2{});
    CHECK(calibrate(reversed, known, 0) == map_reading::wrong);  // depths of the other direction, compared as asked
}

TEST_CASE("calibration: a packed map whose channels are lost or swapped") {
    const shadow s(shadow_scene::spot(cpu_clip_space), {64, 64}, filters::tent<3>, rg<11>{});
    auto map = calibration_map(s);
    CHECK(calibrate(s, map, 0) == map_reading::right);
    for (auto& texel : map.texels()) std::swap(texel.x, texel.y);
    CHECK(calibrate(s, map, 0) == map_reading::wrong);
    for (auto& texel : map.texels()) texel.x = 0;
    CHECK(calibrate(s, map, 0) == map_reading::wrong);
    const shadow fine(shadow_scene::spot(cpu_clip_space), {64, 64}, filters::tent<3>, rg<16>{});
    auto bytes = calibration_map(fine);
    CHECK(calibrate(fine, bytes, 0) == map_reading::right);
    for (auto& texel : bytes.texels()) texel.x = 0;
    CHECK(calibrate(fine, bytes, 0) == map_reading::coarse);
}

TEST_CASE("calibration: bad input, and a sentence for each reading") {
    const shadow s(shadow_scene::spot(cpu_clip_space), {8, 8}, filters::box{.radius = 2});
    CHECK_THROWS_WITH((void)calibration_map(s),
                      doctest::Contains("of.map_size() must be four times the filter's reach"));
    const shadow t(shadow_scene::spot(cpu_clip_space), {32, 32}, filters::box{.radius = 2});
    CHECK_THROWS_WITH((void)calibrate(t, calibration_map(t), 1),
                      doctest::Contains("number must be one of the light's maps"));
    CHECK_THROWS_WITH((void)calibrate(t, image<float>({31, 32}), 0), doctest::Contains("map.size"));
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < i; ++k)
            CHECK(std::string_view(explain(map_reading(i))) != std::string_view(explain(map_reading(k))));
}
