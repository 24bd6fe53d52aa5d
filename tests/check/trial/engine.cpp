// SPDX-License-Identifier: MIT
//
// The engine alone, with C++ in the shader's place.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include <umbrage/depth/foreign/base255.hpp>
#include <umbrage/filter/filters.hpp>

#include "investigation.hpp"
#include "values.hpp"

using namespace check;
using glm::ivec2;
using glm::vec2;
using glm::vec4;

namespace {

using filter_in_cpp = std::function<float(const std::function<float(ivec2)>& fetch, vec2 coord, float receiver)>;

verdict of_filter(const filter_in_cpp& f, const expectation& e = {}) {
    investigation question(subject::filter, e);
    while (const auto b = question.next()) {
        const umbrage::image_view<const float> map(b->map.data(), b->size);
        std::vector<vec4> outputs;
        for (const vec4& x : b->inputs) outputs.push_back({f(umbrage::clamped(map), vec2(x), x.z), 0, 0, 0});
        question.answer(outputs);
    }
    return question.result();
}

}  // namespace

TEST_CASE("a filter itself: the same bits") {
    const verdict v = of_filter([](auto& fetch, vec2 coord, float z) { return umbrage::pcf_2x2(fetch, coord, z); });
    CHECK(v.how == agreement::same_bits);
    CHECK(v.function == "pcf_2x2");
    CHECK(v.same_bits == v.inputs);
    CHECK(!v.first);
}

TEST_CASE("two filters that differ by rounding alone: the plain one, but for the other's own bits") {
    const verdict own =
        of_filter([](auto& fetch, vec2 coord, float z) { return umbrage::pcf_2x2_dx_sdk(fetch, coord, z, 0.0f); });
    CHECK(own.how == agreement::same_bits);
    CHECK(own.function == "pcf_2x2_dx_sdk");
    const verdict unrounded = of_filter([](auto& fetch, vec2 coord, float z) {
        const vec2 from = coord - 0.5f, first = glm::floor(from), share = from - first;
        const auto row = [&](int y) {
            const ivec2 texel = ivec2(first) + ivec2(0, y);
            return glm::mix(umbrage::lit(fetch, texel, z), umbrage::lit(fetch, texel + ivec2(1, 0), z), share.x);
        };
        return glm::mix(row(0), row(1), share.y);
    });
    CHECK(unrounded.how == agreement::same_but);
    CHECK(unrounded.function == "pcf_2x2");
}

TEST_CASE("two slips: both are named, and the smallest input is small") {
    const verdict v = of_filter(
        [](auto& fetch, vec2 coord, float z) { return 1.0f - umbrage::tent<3>(fetch, coord + vec2(1, 0), z); },
        {"tent3"});
    CHECK(v.how == agreement::other);
    CHECK(v.function == "tent3");
    REQUIRE(v.slips.size() == 2);
    CHECK(v.slips[0].says == "shifted by (1, 0) texel");
    CHECK(v.slips[1].kind == "in_shadow");
    CHECK(v.explained == v.inputs);
    REQUIRE(v.first);
    CHECK(v.first->size == ivec2(1, 1));
    CHECK(text(v).find("1 x 1 map of 0.5") != std::string::npos);
    CHECK(json(v).find("\"kind\": \"shift\"") != std::string::npos);
}

TEST_CASE("none of ours: no name, but what it reads") {
    const verdict v = of_filter([](auto& fetch, vec2 coord, float z) {
        const ivec2 texel(glm::floor(coord));
        return (umbrage::lit(fetch, texel, z) * 3 + umbrage::lit(fetch, texel + ivec2(2, 0), z)) / 4;
    });
    CHECK(v.how == agreement::unknown);
    CHECK(v.function.empty());
    CHECK(text(v).find("75    .   25") != std::string::npos);
}

TEST_CASE("no comparison: it says so") {
    const verdict v = of_filter(
        [](auto& fetch, vec2 coord, float z) { return std::exp(-8 * (z - fetch(ivec2(glm::floor(coord))))); });
    CHECK(v.how == agreement::unknown);
    CHECK(text(v).find("is no comparison") != std::string::npos);
}

TEST_CASE("an expected codec that is another one") {
    investigation question(subject::pack, {"threejs_rgba"});
    while (const auto b = question.next()) {
        std::vector<vec4> outputs;
        for (const vec4& x : b->inputs) outputs.push_back(umbrage::write_base255(x.x));
        question.answer(outputs);
    }
    const verdict v = question.result();
    CHECK(v.how == agreement::other);
    CHECK(v.function == "base255");
    CHECK(v.expected == "threejs_rgba");
}

TEST_CASE("values: a table in either form, and what differs") {
    std::string error;
    for (const char* file :
         {"x,y,sum\n0.5,0.25,0.75\n1,2,3\n0x3f800000,1,2\n", "[[0.5, 0.25, 0.75], [1, 2, 3],\n [1, 1, 2]]"}) {
        const value_table table = read_table(file, error);
        REQUIRE(error.empty());
        CHECK(table.arguments == 2);
        REQUIRE(table.inputs.size() == 3);
        value_check question(table);
        while (const auto b = question.next()) {
            std::vector<vec4> outputs;
            for (const vec4& x : b->inputs) outputs.push_back(vec4(x.x + (x.x == 1 ? 1 : x.y)));
            question.answer(outputs);
        }
        CHECK(question.result().within == 2);
        REQUIRE(question.result().first);
        CHECK(question.result().first->input == vec4(1, 2, 0, 0));
    }
    CHECK(read_table("1, 2\n1\n", error).inputs.empty());
    CHECK(error.starts_with("row 2 has 1 numbers"));
}

TEST_CASE("values: against C++, to the roundest input that differs") {
    const auto expected = [](vec4 x) { return x.x * x.x; };
    value_check question(expected, 1, vec4(0), vec4(8), 1);
    while (const auto b = question.next()) {
        std::vector<vec4> outputs;
        for (const vec4& x : b->inputs) outputs.push_back(vec4(x.x > 3 ? x.x * x.x + 1 : x.x * x.x));
        question.answer(outputs);
    }
    CHECK(question.result().within < question.result().inputs);
    REQUIRE(question.result().first);
    CHECK(question.result().first->input.x == 4);
    CHECK(question.result().first->got.x == 17);
    CHECK(ulps_between(1.0f, 1.0f + 0x1p-22f) == 2);
    CHECK(ulps_between(-0.0f, 0.0f) == 0);
}
