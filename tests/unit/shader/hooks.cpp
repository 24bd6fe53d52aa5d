// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/shader/hooks.hpp>

#include <set>
#include <string>
#include <string_view>

using namespace umbrage::glsl;

TEST_CASE("hooks that maps choose: functions without directives, named for the hook they stand for") {
    std::set<std::string_view> summaries;
    for (const snippet* s : hooks::all) {
        CAPTURE(s->name);
        CHECK(summaries.insert(s->summary).second);  // names are those of the hooks: these tell variants apart
        CHECK(s->summary.starts_with(s->name));
        CHECK(s->role != hook::none);
        const std::string text = s->source.str();
        CHECK(text.find("\n#") == text.npos);
        CHECK(text.find(" umbrage_" + std::string(s->name) + "(") != text.npos);
        CHECK(text.starts_with("\n// umbrage_" + std::string(s->name) + ": "));
    }
}
