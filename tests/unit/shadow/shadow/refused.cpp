// SPDX-License-Identifier: MIT
//
// Filters, sizes and setups that a shadow refuses when it is made.
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

#include <umbrage/light/spot_light.hpp>
#include <umbrage/shadow/shadow.hpp>

using namespace umbrage;

namespace {

/// Message with which a shadow of a spot light refuses a filter.
std::string refused(const auto& filter) {
    try {
        (void)shadow(make_spot_light<float>({.clip = cpu_clip_space}), {128, 128}, filter);
    } catch (const std::invalid_argument& error) { return error.what(); }
    return "no error";
}

}  // namespace

TEST_CASE_TEMPLATE("shadow: discs of other than 8, 16 or 32 points are refused", Filter, filters::disc, filters::pcss,
                   filters::dpcf) {
    CHECK(refused(Filter{.points = 64}) == "umbrage::shadow: filter.points must be 8, 16 or 32; got 64");
    CHECK(refused(Filter{.points = 12}) == "umbrage::shadow: filter.points must be 8, 16 or 32; got 12");
    CHECK(refused(Filter{.points = 8}) == "no error");
}

TEST_CASE("shadow: prefilters whose powers overflow or whose bias is no number are refused") {
    CHECK(refused(prefilters::esm{.settings = {.exponent = 120}}) ==
          "umbrage::shadow: filter.settings.exponent must be above 0 and at most 63; got 120. Beyond that the warped "
          "depth overflows.");
    CHECK(refused(prefilters::evsm2{{glm::vec2(200), glm::vec2(0.01f)}}) ==
          "umbrage::shadow: filter.parameters.exponents must be above 0 and at most 55; got 200");
    CHECK(refused(prefilters::msm{.bias = {2, 0.4f}}) ==
          "umbrage::shadow: filter.bias must be from 0 to 1; got (2, 0.4)");
    CHECK(refused(prefilters::vsm{.min_variance = -1}) ==
          "umbrage::shadow: filter.min_variance must be finite, 0 or more; got -1");
    CHECK(refused(prefilters::vsm{}) == "no error");
}

TEST_CASE("shadow: a window of 16 weights is refused") {
    filters::window filter;
    CHECK(refused(filter) == "no error");
    filter.row.size = 16;
    CHECK(refused(filter).starts_with("umbrage::shadow: filter.row must be of make_window_row; got 16"));
}

TEST_CASE_TEMPLATE("shadow: a softness that make_penumbra_params never makes is refused", Filter, filters::pcss,
                   filters::dpcf) {
    const std::string name = "umbrage::shadow: filter.softness.";
    CHECK(
        refused(Filter{.softness = {0.06f, 96, 16}}).starts_with(name + "min_radius and max_radius must be integers"));
    CHECK(refused(Filter{.softness = {0.06f, 1.5f, 16}}).starts_with(name + "min_radius and max_radius must be "));
    CHECK(refused(Filter{.softness = {-1, 16, 96}}) == name + "per_code must be from 0 to 4096; got -1");
    CHECK(refused(Filter{}) == "no error");
}
