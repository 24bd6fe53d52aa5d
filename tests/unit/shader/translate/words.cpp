// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <iterator>
#include <set>
#include <stdexcept>
#include <string_view>

#include <umbrage/shader/translate/words.hpp>

using namespace umbrage::glsl::detail;

TEST_CASE("words: one row a word, with a word in every language") {
    std::set<std::string_view> names;
    for (const word& w : vocabulary) {
        CAPTURE(w.glsl);
        CHECK((!w.hlsl.empty() && !w.msl.empty() && !w.wgsl.empty()));
        names.insert(w.glsl);
    }
    CHECK(names.size() == std::size(vocabulary));
}

TEST_CASE("words: types, functions, and what is neither") {
    CHECK(is_type("ivec2"));
    CHECK_FALSE(is_type("floor"));
    CHECK(find_word("fract")->hlsl == "frac");
    CHECK(find_word("while") == nullptr);
    CHECK(is_qualifier("UMBRAGE_HIGHP"));
    CHECK_FALSE(is_qualifier("UMBRAGE_MAP"));
    CHECK_THROWS_AS(unknown("hlsl", "while"), std::invalid_argument);
}
