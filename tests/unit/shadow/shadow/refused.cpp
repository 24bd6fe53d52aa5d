// SPDX-License-Identifier: MIT
//
// Filters, sizes and setups that a shadow refuses when it is made.
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>
#include <utility>

#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/cascades/warped.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/shadow.hpp>
#include <umbrage/shadow/warped_maps.hpp>

using namespace umbrage;

namespace {

std::string complaint(const auto& call) {
    try {
        call();
    } catch (const std::invalid_argument& error) { return error.what(); }
    return "no error";
}
/// Message with which a shadow of a spot light refuses a filter.
std::string refused(const auto& filter) {
    return complaint([&] { (void)shadow(make_spot_light<float>({.clip = cpu_clip_space}), {128, 128}, filter); });
}
/// Message with which a shadow of a light refuses a size.
std::string of_size(const auto& light, glm::ivec2 size) {
    return complaint([&] { (void)shadow(light, size, filters::hard{}); });
}

const cascade_fit<float> fit{.scene = {glm::vec3(-8), glm::vec3(8)}, .map_size = {64, 64}, .clip = cpu_clip_space};
const auto splits = practical_splits<3>(0.5f, 40.0f, 0.7f);

}  // namespace

TEST_CASE_TEMPLATE("shadow: discs of other than 8, 16 or 32 points are refused", Filter, filters::disc, filters::pcss,
                   filters::dpcf) {
    const auto of = [](int points) {
        Filter filter{.points = points};
        if constexpr (detail::contact_hardening<Filter>) filter.softness = make_penumbra_params(0.1f);
        return refused(filter);
    };
    CHECK(of(64) == "umbrage::shadow: filter.points must be 8, 16 or 32; got 64");
    CHECK(of(12) == "umbrage::shadow: filter.points must be 8, 16 or 32; got 12");
    CHECK(of(8) == "no error");
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
    CHECK(refused(Filter{.softness = {0, 0, 96, 16, 1}})
              .starts_with(name + "min_radius and max_radius must be integers"));
    CHECK(refused(Filter{.softness = {0, 0, 1.5f, 16, 1}}).starts_with(name + "min_radius and max_radius must be "));
    CHECK(refused(Filter{.softness = make_penumbra_params(0.1f)}) == "no error");
}

TEST_CASE_TEMPLATE("shadow: contact hardening without a size of the light is refused", Filter, filters::pcss,
                   filters::dpcf) {
    const std::string name = "umbrage::shadow: filter.softness.light_size must be above 0 and finite; got ";
    CHECK(refused(Filter{}).starts_with(name + "0. make_penumbra_params(light_size) gives it"));
    CHECK(refused(Filter{.softness = {0.06f, 0.06f, 16, 96}}).starts_with(name + "0"));  // of one map, by itself
    CHECK(refused(Filter{.softness = {0, 0, 16, 96, -1}}).starts_with(name + "-1"));
    CHECK(refused(Filter{.softness = {0, 0, 16, 96, detail::highest<float> * 2}}).starts_with(name + "inf"));
}

TEST_CASE("shadow: cascades that were moved from or taken away are refused, as are more than there are maps") {
    const std::string name = "umbrage::shadow: light.cascades.size() must be from 1 to 4; got ";
    const std::string moved = name + "0. A setup that was moved from has none.";
    cascaded_maps stable(make_stable_cascades<3>(fit, splits));
    warped_maps warped(
        make_warped_cascades<3>(fit, splits, [](const auto& p) { return fit_light_space_perspective(p); }), fit.camera);
    CHECK(of_size(stable, {64, 64}) == "no error");
    CHECK(of_size(warped, {64, 64}) == "no error");
    shadow sun(stable, {64, 64}, filters::hard{});
    const shadow taken = std::move(sun);
    CHECK(complaint([&] { (void)sun.relative_to({}); }) == moved);
    CHECK(complaint([&] { (void)taken.relative_to({}); }) == "no error");
    for (int i = 0; i < 2; ++i)
        stable.cascades.push_back(stable.cascades[0]), warped.cascades.push_back(warped.cascades[0]);
    CHECK(of_size(stable, {64, 64}).starts_with(name + "5"));
    CHECK(of_size(warped, {64, 64}).starts_with(name + "5"));
    stable.cascades.clear(), warped.cascades.clear();
    CHECK(of_size(stable, {64, 64}) == moved);
    CHECK(of_size(warped, {64, 64}) == moved);
    CHECK(complaint([&] { (void)warped.make_uniforms({64, 64}, {}); }) == moved);
}

TEST_CASE("shadow: maps with texels beyond the coordinates of filters are refused") {
    const cascaded_maps stable(make_stable_cascades<3>(fit, splits));
    const std::string text = "umbrage::shadow: map_size must be 32768 or less; got ";
    CHECK(of_size(stable, {1 << 30, 64}).starts_with(text + "1073741824 x 64. Filters take"));
    CHECK(of_size(stable, {64, 32769}).starts_with(text + "64 x 32769"));
    cascade_fit<float> wide = fit;
    wide.map_size = {32768, 64};
    CHECK(of_size(make_stable_cascades<3>(wide, splits), wide.map_size) == "no error");
    CHECK(of_size(make_spot_light<float>({.clip = cpu_clip_space}), glm::ivec2(32768)) == "no error");
}
