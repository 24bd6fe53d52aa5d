// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/prefilters.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

using namespace umbrage;

namespace {

constexpr float nan32 = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();

/// Message with which a prefilter is refused; its first words are always the same.
std::string refused(const auto& filter) {
    try {
        filter.check("visibility");
    } catch (const std::invalid_argument& error) { return error.what(); }
    return "no error";
}

}  // namespace

TEST_CASE("prefilters: values know themselves, and are found by name") {
    std::set<std::string_view> names;
    prefilters::all::for_each([&](auto filter) {
        CAPTURE(filter.name);
        CHECK(names.insert(filter.name).second);
        CHECK(filter.snippet->name == filter.name);
        CHECK(filter.writer != nullptr);
        CHECK(filter.decode(filter.encode(1.0f), 1.0f) > 0.99f);  // as cleared
        CHECK(filter.decode(filter.encode(0.25f), 0.75f) < 0.001f);
        filter.direction = depth_direction::reversed;
        CHECK(filter.decode(filter.encode(0.75f), 0.25f) < 0.001f);
        CHECK(filter.decode(filter.encode(0.25f), 0.75f) > 0.999f);
    });
    CHECK(names.size() == prefilters::all::size);
    CHECK(prefilters::all::with("evsm4", [](const auto&) {}));
    CHECK_FALSE(prefilters::all::with("evsm3", [](const auto&) {}));
}

TEST_CASE("prefilters: numbers that their make functions refuse are refused in a filter, too") {
    prefilters::all::for_each([](const auto& filter) { CHECK(refused(filter) == "no error"); });
    const std::string name = "umbrage::visibility: filter.";
    for (const float most : {63.0f, 14.0f}) {
        const auto store = most > 14 ? float_store::single : float_store::half;
        CHECK(refused(prefilters::esm{.settings = {most, store}}) == "no error");
        for (const float bad : {most + 1, 200.0f, 0.0f, -5.0f, nan32, inf})
            CHECK(refused(prefilters::esm{.settings = {bad, store}}).starts_with(name + "settings.exponent must be "));
    }
    const evsm_parameters made = make_evsm({.exponent = 55.0f, .falling = 43.0f});
    CHECK(refused(prefilters::evsm2{made}) == "no error");
    CHECK(refused(prefilters::evsm4{made}) == "no error");
    for (const float bad : {56.0f, 200.0f, 0.0f, -5.0f, nan32, inf}) {
        const std::string begin = name + "parameters.exponents must be above 0 and at most 55; got ";
        CHECK(refused(prefilters::evsm2{{{bad, 8}, made.deviations}}).starts_with(begin));
        CHECK(refused(prefilters::evsm4{{{bad, 8}, made.deviations}}).starts_with(begin));
        CHECK(refused(prefilters::evsm4{{{40, bad}, made.deviations}}).starts_with(begin));
        CHECK(refused(prefilters::evsm2{{{40, bad}, made.deviations}}) == "no error");  // it has one power
    }
    for (const float bad : {0.0f, -1.0f, nan32, inf}) {
        const std::string begin = name + "parameters.deviations must be finite, and large enough for the exponents; ";
        CHECK(refused(prefilters::evsm2{{made.exponents, {bad, 1}}}).starts_with(begin));
        CHECK(refused(prefilters::evsm4{{made.exponents, {1, bad}}}).starts_with(begin));
    }
    CHECK(refused(prefilters::vsm{.min_variance = 0}) == "no error");
    for (const float bad : {-1e-9f, nan32, inf})
        CHECK(refused(prefilters::vsm{.min_variance = bad}).starts_with(name + "min_variance must be finite, 0 or "));
    for (const float bad : {-1e-9f, 2.0f, nan32, inf}) {
        CHECK(refused(prefilters::msm{.bias = {bad, 0.4f}}).starts_with(name + "bias must be from 0 to 1; got "));
        CHECK(refused(prefilters::msm_unorm16{.bias = {1e-4f, bad}}).starts_with(name + "bias must be "));
        CHECK(refused(prefilters::msm_hausdorff{.bias = {bad, 0.4f}}).starts_with(name + "bias must be "));
    }
}
