// SPDX-License-Identifier: MIT
#include <umbrage/core/check.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

using umbrage::detail::printed;
using umbrage::detail::require;

TEST_CASE("require: what is met passes, what is not names function, argument, condition, value and cause") {
    CHECK_NOTHROW(require(true, "make_light", "angle", "above 0", -1.0));
    CHECK_THROWS_WITH_AS(require(false, "make_light", "angle", "above 0", -0.5f),
                         "umbrage::make_light: angle must be above 0; got -0.5", std::invalid_argument);
    CHECK_THROWS_WITH_AS(require(false, "make_light", "angle", "below pi / 2", 30, "Is it in degrees?"),
                         "umbrage::make_light: angle must be below pi / 2; got 30. Is it in degrees?",
                         std::invalid_argument);
}

TEST_CASE("require: of no cost to constants") {
    constexpr auto half = [](int n) {
        require(n % 2 == 0, "half", "n", "even", n);
        return n / 2;
    };
    static_assert(half(6) == 3);
    CHECK_THROWS_WITH(half(7), "umbrage::half: n must be even; got 7");
}

TEST_CASE("require_size: both sizes") {
    using umbrage::detail::require_size;
    CHECK_NOTHROW(require_size({4, 3}, {4, 3}, "visibility", "out.size", "the receivers' size"));
    CHECK_THROWS_WITH_AS(require_size({320, 240}, {640, 480}, "visibility", "out.size", "the receivers' size"),
                         "umbrage::visibility: out.size must be the receivers' size, 640 x 480; got 320 x 240",
                         std::invalid_argument);
}

TEST_CASE("printed: each kind of value") {
    CHECK(printed("none") == "none");
    CHECK(printed(std::string("my-map")) == "\"my-map\"");
    CHECK(printed(std::string_view()) == "\"\"");
    CHECK(printed(true) == "true");
    CHECK(printed(std::uint8_t(200)) == "200");
    CHECK(printed(std::numeric_limits<std::int64_t>::max()) == "9223372036854775807");
    CHECK(printed(0.1f) == "0.1");
    CHECK(printed(std::numeric_limits<double>::infinity()) == "inf");
    CHECK(printed(glm::ivec2(640, 480)) == "640 x 480");
    CHECK(printed(glm::vec2(0.5f, 2)) == "(0.5, 2)");
    CHECK(printed(glm::dvec3(1, 0, -2.5)) == "(1, 0, -2.5)");
    CHECK(printed(glm::uvec3(0, 1, 12)) == "(0, 1, 12)");
    CHECK(printed(glm::mat2(1)) == "((1, 0), (0, 1))");
}
