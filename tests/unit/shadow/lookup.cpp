// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <limits>
#include <string>

#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/lookup.hpp>
#include <umbrage/shadow/paraboloid_maps.hpp>
#include <umbrage/shadow/single_map.hpp>

#include "own_filter.hpp"

using namespace umbrage;

TEST_CASE("lookup: which filters a shadow takes, and which encodings with them") {
    static_assert(shadow_filter<filters::window> && shadow_filter<filters::disc> && shadow_filter<filters::dpcf>);
    static_assert(shadow_filter<prefilters::vsm> && shadow_filter<prefilters::msm_unorm16>);
    static_assert(!shadow_filter<filters::four_tap>);        // its offsets do not fit into a block
    static_assert(!shadow_filter<filters::pcf_2x2_dx_sdk>);  // it compares in one direction of depth
    static_assert(shadow_encoding<depth32f, filters::window> && !shadow_encoding<depth32f, prefilters::vsm>);
    static_assert(shadow_encoding<moment_texels<prefilters::vsm>, prefilters::vsm>);
    static_assert(!shadow_encoding<moment_texels<prefilters::vsm>, prefilters::esm>);
}

TEST_CASE("lookup: each filter's numbers are in the block where its text reads them") {
    CHECK(detail::terms_of(filters::pcss{.softness = {0.1f, 0.2f, 2, 9}}, 0.5f) == glm::vec4(0.1f, 0.2f, 2, 9));
    CHECK(detail::arguments_of<filters::pcss>() ==
          ", vec4(filter_terms.x, filter_terms.y, filter_terms.z, filter_terms.w), umbrage_disc_rotation(pixel)");
    const filters::disc disc{.radius_texels = 3};
    CHECK(detail::terms_of(disc, 0.5f) == glm::vec4(3, disc.farthest_point() + 0.5f, 0, 0));
    CHECK(detail::arguments_of<filters::disc>() == ", filter_terms.x, umbrage_disc_rotation(pixel)");
    CHECK(detail::terms_of(filters::box{.radius = 2}, 0.5f) == glm::vec4(2, 0, 0, 0));
    CHECK(detail::arguments_of<filters::box>() == ", int(filter_terms.x)");
    const prefilters::evsm4 powers;
    CHECK(detail::terms_of(powers, 0.5f) == glm::vec4(powers.parameters.exponents, powers.parameters.deviations));
    CHECK(detail::arguments_of<prefilters::evsm2>() == ", filter_terms.x, filter_terms.y");
    CHECK(detail::terms_of(prefilters::msm{}, 0.5f) == glm::vec4(msm_bias_32, 0, 0));
    CHECK(detail::arguments_of<prefilters::msm>() == ", vec2(filter_terms.x, filter_terms.y)");
    CHECK(detail::arguments_of<filters::hard>().empty());
}

TEST_CASE("lookup: numbers of any name and type reach a user's filter, each as its snippet takes it") {
    static_assert(shadow_filter<own::two_taps>);
    CHECK(detail::terms_of(own::two_taps{.sharpness = 1.5f}, 0.5f) == glm::vec4(1.5f, 1, -2, 2));
    CHECK(detail::arguments_of<own::two_taps>() ==
          ", filter_terms.x, vec2(filter_terms.y, filter_terms.z), int(filter_terms.w)");
}

TEST_CASE(
    "lookup: a receiver's bias is its plane's slack, or that of the filter's reach or disc where maps bend planes") {
    map_place place{.slope = {0.01f, -0.02f}, .slack = 2e-6f};
    const shadow_terms terms{.reach = 3, .error = 1e-4f, .filter_terms = {2, 2.5f, 0, 0}};
    const float error = 1e-4f + 2e-6f;
    CHECK(detail::bias_of<single_map, filters::window>(terms, place) == error);
    CHECK(detail::bias_of<cube_maps, filters::disc>(terms, place) == error);
    CHECK(detail::bias_of<cascaded_maps<1>, filters::pcss>(terms, place) == error);
    const float whole = acne_free_bias(place.slope, 3.0f, error),
                of_disc = acne_free_disc_bias(place.slope, 2.5f, error);
    CHECK(detail::bias_of<paraboloid_maps, filters::window>(terms, place) == whole);
    CHECK(detail::bias_of<paraboloid_maps, filters::disc>(terms, place) == of_disc);
    CHECK(detail::bias_of<single_map, prefilters::vsm>(terms, place) == whole);
    for (const glm::vec2 edge_on : {glm::vec2(2, 0), glm::vec2(0, -2), glm::vec2(1, 1)}) {
        place.slope = edge_on;
        CHECK(detail::bias_of<single_map, filters::window>(terms, place) == 1.0f);
    }
}

TEST_CASE("lookup: a receiver beyond the far plane, or on a plane that the light sees edge-on, lies outside all maps") {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const shadow_terms terms{.map_size = {64, 64}, .reach = 3};
    const auto x_of = [&]<class Filter>(const Filter&, const map_place& place, depth_direction direction) {
        return detail::receiver_of<single_map, Filter>(terms, place, direction).x;
    };
    const auto forward = depth_direction::forward, reversed = depth_direction::reversed;
    const map_place place{.at = {7, 9, 0.5f}, .slope = {0.5f, -1.25f}};
    CHECK(detail::receiver_of<single_map, filters::window>(terms, place, forward) == place.at);
    CHECK(x_of(filters::hard{}, {.at = {7, 9, 1.5f}}, forward) == 65536.0f);
    CHECK(x_of(filters::hard{}, {.at = {7, 9, 1.5f}}, reversed) == 7.0f);
    CHECK(x_of(filters::hard{}, {.at = {7, 9, -0.5f}}, reversed) == 65536.0f);
    CHECK(x_of(prefilters::vsm{}, {.at = {7, 9, 1.5f}}, forward) == 65536.0f);
    for (const glm::vec2 edge_on : {glm::vec2(1, -1), glm::vec2(inf, 0), glm::vec2(0, -inf), glm::vec2(nan, 0)}) {
        const map_place unseen{.at = {7, 9, 0.5f}, .slope = edge_on};
        CHECK(x_of(filters::hard{}, unseen, forward) == 65536.0f);
        CHECK(x_of(prefilters::vsm{}, unseen, forward) == 7.0f);  // its bias is 1 there
    }
}
