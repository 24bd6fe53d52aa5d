// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/prefilters.hpp>

#include <doctest/doctest.h>

#include <set>
#include <string_view>

using namespace umbrage;

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
