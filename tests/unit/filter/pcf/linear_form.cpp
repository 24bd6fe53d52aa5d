// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/filter/pcf/linear_form.hpp>

#include <umbrage/filter/blocker/pcss.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/hard.hpp>

using namespace umbrage;
using glsl::linear_form_of;

TEST_CASE("linear_form: filters of the sampler's weights, and none for others") {
    CHECK(linear_form_of(filters::pcf_2x2{}).what == &glsl::pcf_2x2_hardware);
    CHECK(linear_form_of(filters::disc{8}).what == &glsl::disc_hardware<8>);
    CHECK(linear_form_of(filters::disc{32}).what == &glsl::disc_hardware<32>);
    CHECK(linear_form_of(filters::hard{}).what == nullptr);
    CHECK(linear_form_of(filters::box{}).what == nullptr);
    CHECK(linear_form_of(filters::pcss{}).what == nullptr);
}

TEST_CASE("linear_form: a kernel's weights are its function's numbers") {
    CHECK(linear_form_of(filters::tent<3>).what == &glsl::window_hardware<3>);
    CHECK(linear_form_of(filters::tent<3>).weights == ", 4.0, 8.0");
    CHECK(linear_form_of(filters::castano<5>).weights == ", 1.0, 3.0, 4.0");
    CHECK(linear_form_of(filters::castano<7>).what == &glsl::window_hardware<7>);
    CHECK(linear_form_of(filters::binomial<7>).weights == ", 0.25, 1.5, 3.75, 5.0");
    CHECK(linear_form_of(filters::tent<2>).what == nullptr);
    CHECK(linear_form_of(filters::quadratic_b_spline).what == nullptr);
    CHECK(linear_form_of(filters::window{make_window_row(3, {0, 4})}).what == nullptr);
}
