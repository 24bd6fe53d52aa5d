// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>

#include <umbrage/core/list.hpp>

namespace {

struct first {
    static constexpr std::string_view name = "first";
};
struct second {
    static constexpr std::string_view name = "second";
};
using both = umbrage::list_of<first, second>;

}  // namespace

TEST_CASE("list_of: walks all in order, finds one by its name, and says when there is none") {
    static_assert(both::size == 2);
    std::string names;
    both::for_each([&](auto value) { names += std::string(value.name) + ' '; });
    CHECK(names == "first second ");
    int called = 0;
    CHECK(both::with("second", [&](auto value) { called += value.name == "second" ? 1 : 100; }));
    CHECK(called == 1);
    CHECK_FALSE(both::with("third", [&](auto) { ++called; }));
    CHECK(called == 1);
}
