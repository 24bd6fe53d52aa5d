// SPDX-License-Identifier: MIT
#include <umbrage/shader/hook_choice.hpp>

#include <doctest/doctest.h>

#include <set>
#include <string>
#include <string_view>

#include <umbrage/filter/pcf/hard.hpp>

namespace glsl = umbrage::glsl;
using namespace umbrage::glsl;
using umbrage::outside_map;

TEST_CASE("outside whole maps and layers all is lit; tiles, regions and faces of cubes clamp; a name says otherwise") {
    using enum texture;
    for (const texture kind : {texture_2d, array, integer, depth, depth_array, shadow, shadow_array}) {
        CHECK(umbrage::glsl::detail::is_bordered({.texture = kind}));
        CHECK_FALSE(umbrage::glsl::detail::is_bordered({.texture = kind, .origin = "vec2(8.0, 0.0)"}));
        CHECK_FALSE(umbrage::glsl::detail::is_bordered({.texture = kind, .outside = outside_map::clamped}));
    }
    for (const texture kind : {atlas, cube, cube_faces}) {
        CHECK_FALSE(umbrage::glsl::detail::is_bordered({.texture = kind}));
        CHECK(umbrage::glsl::detail::is_bordered({.texture = kind, .outside = outside_map::bordered}));
    }
}

TEST_CASE("a snippet is a map's own where it is a hook or calls one, and reads the map where a hook does") {
    using namespace umbrage::glsl::detail;
    CHECK(is_of_map(glsl::hard));
    CHECK(reads_map(glsl::hard));
    CHECK(is_of_map(glsl::beyond_far_plane));
    CHECK_FALSE(reads_map(glsl::in_filter_domain));
    CHECK_FALSE(is_of_map(glsl::inside_texel_space));
}

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
