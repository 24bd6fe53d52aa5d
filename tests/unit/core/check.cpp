// SPDX-License-Identifier: MIT
#include <umbrage/core/check.hpp>

#include <doctest/doctest.h>

#include <stdexcept>

using umbrage::detail::require;

TEST_CASE("require: what is met passes, what is not names function, argument, condition and value") {
    CHECK_NOTHROW(require(true, "make_light", "angle", "must be above 0"));
    CHECK_NOTHROW(require(true, "make_light", "angle", "must be above 0", -1.0));
    CHECK_THROWS_WITH_AS(require(false, "make_light", "low and high", "must be finite"),
                         "umbrage::make_light: low and high must be finite", std::invalid_argument);
    CHECK_THROWS_WITH_AS(require(false, "make_light", "angle", "must be above 0", -0.5),
                         "umbrage::make_light: angle must be above 0; got -0.5", std::invalid_argument);
}
