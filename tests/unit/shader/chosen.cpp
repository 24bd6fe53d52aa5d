// SPDX-License-Identifier: MIT
#include <umbrage/shader/chosen.hpp>

#include <doctest/doctest.h>

#include <umbrage/filter/pcf/hard.hpp>

namespace glsl = umbrage::glsl;
using umbrage::glsl::detail::chosen;
using namespace umbrage::glsl;

TEST_CASE("four texels at once are gathered where the map says so, and stay inside a region") {
    const binding gathered{.gather = true}, region{.gather = true, .origin = "vec2(8.0, 0.0)"},
        lit_outside{.outside_lit = true, .gather = true};
    CHECK(&chosen(glsl::lit_2x2, binding{}) == &glsl::lit_2x2);
    CHECK(&chosen(glsl::lit_2x2, gathered) == &hooks::gathered);
    CHECK(&chosen(glsl::lit_2x2, region) == &hooks::gathered_region);
    CHECK(&chosen(glsl::lit_2x2, lit_outside) == &hooks::gathered_bordered);
}

TEST_CASE("a snippet is a map's own where it is a hook or calls one, and reads the map where a hook does") {
    using namespace umbrage::glsl::detail;
    CHECK(is_of_map(glsl::hard));
    CHECK(reads_map(glsl::hard));
    CHECK(is_of_map(glsl::beyond_far_plane));
    CHECK_FALSE(reads_map(glsl::in_filter_domain));
    CHECK_FALSE(is_of_map(glsl::inside_texel_space));
}
