// SPDX-License-Identifier: MIT
//
// Without exceptions: tests/consume/project/no_exceptions.cpp.
#include <doctest/doctest.h>

#include <cstdint>
#include <stdexcept>

#include <umbrage/core/config.hpp>

TEST_CASE("fail: the message, thrown") {
    CHECK_THROWS_WITH_AS(umbrage::detail::fail("umbrage::f: a message"), "umbrage::f: a message",
                         std::invalid_argument);
}

TEST_CASE("set_error_handler: gives the one before, and errors are thrown all the same where they can be") {
    const umbrage::error_handler mine = [](const char*) { CHECK(false); };
    const auto before = umbrage::set_error_handler(mine);
    CHECK_THROWS_AS(umbrage::detail::fail("umbrage::f: a message"), std::invalid_argument);
    CHECK((umbrage::set_error_handler(before) == mine));
}

TEST_CASE("bit_cast: the bits, at compile time too") {
    static_assert(umbrage::detail::bit_cast<std::uint32_t>(1.0f) == 0x3F800000u);
    CHECK(umbrage::detail::bit_cast<float>(0xC0000000u) == -2.0f);
}
