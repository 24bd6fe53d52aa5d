// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/filter/filters.hpp>
#include <umbrage/filter/numbers.hpp>
#include <umbrage/filter/prefiltered/prefilters.hpp>

#include "../shadow/own_filter.hpp"

using namespace umbrage;
using detail::packed_numbers;
using detail::with_numbers;

namespace {

struct many {
    glm::vec4 all{1};
    float more = 0;
    static constexpr auto numbers(auto& f) { return std::tie(f.all, f.more); }
};
struct precise {
    double radius = 0;
    static constexpr auto numbers(auto& f) { return std::tie(f.radius); }
};
struct silent {
    float radius = 1;
};

}  // namespace

TEST_CASE("numbers: a block has them one behind the other, whatever their names and types") {
    CHECK(packed_numbers(own::two_taps{.sharpness = 0.5f, .aside = {3, -4}, .steps = 7}) == glm::vec4(0.5f, 3, -4, 7));
    CHECK(packed_numbers(filters::box{.radius = 3}) == glm::vec4(3, 0, 0, 0));
    CHECK(packed_numbers(filters::hard{}) == glm::vec4(0));
    CHECK(packed_numbers(filters::pcss{.softness = {0.5f, 0.25f, 2, 9}}) == glm::vec4(0.5f, 0.25f, 2, 9));
    const evsm_parameters powers{{5, 6}, {7, 8}};
    CHECK(packed_numbers(prefilters::evsm4{powers}) == glm::vec4(5, 6, 7, 8));
    CHECK(packed_numbers(prefilters::evsm2{powers}) == glm::vec4(5, 7, 0, 0));
    static_assert(detail::width_of_numbers<own::two_taps> == 4 && detail::width_of_numbers<filters::disc> == 1);
}

TEST_CASE("numbers: what a block holds makes the filter again") {
    const own::two_taps own = detail::with_packed_numbers(own::two_taps{}, {0.5f, 3, -4, 7});
    CHECK(own.sharpness == 0.5f);
    CHECK(own.aside == glm::vec2(3, -4));
    CHECK(own.steps == 7);
    CHECK(detail::with_packed_numbers(filters::pcss{}, {0.5f, 0.25f, 2, 9}).softness.max_radius == 9);
    const auto again = detail::with_packed_numbers(prefilters::evsm4{}, {5, 6, 7, 8});
    CHECK(packed_numbers(again) == glm::vec4(5, 6, 7, 8));
}

TEST_CASE("numbers: of types that shaders lack, of five floats, or unstated, they are none of a shadow's") {
    static_assert(with_numbers<own::two_taps> && with_numbers<filters::window> && with_numbers<prefilters::esm>);
    static_assert(!with_numbers<many> && !with_numbers<precise> && !with_numbers<silent>);
    static_assert(!with_numbers<filters::four_tap>);  // eight floats
}
