// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/shader/interface.hpp>

using namespace umbrage;

TEST_CASE("interface: declarations under another name") {
    using glsl::detail::renamed;
    CHECK(renamed("UMBRAGE_HIGHP sampler2D map", "map", "umbrage_sun_map") ==
          "UMBRAGE_HIGHP sampler2D umbrage_sun_map");
    CHECK(renamed("map: texture_2d<f32>", "map", "umbrage_sun_map") == "umbrage_sun_map: texture_2d<f32>");
    CHECK(renamed("map_sampler: sampler", "map_sampler", "s") == "s: sampler");
    CHECK(renamed("SamplerState map_sampler", "map_sampler", "s") == "SamplerState s");
}

TEST_CASE("interface: blocks, and arrays of vec4 where there are none") {
    const glsl::interface_function visibility{
        .calls = "shadow", .says = "1.0 is lit", .arguments = {{"world"}, {"normal"}}};
    const glsl::shader_interface sun{"sun", {{"to_texels"}, {"terms", false}}, {}, {visibility}};
    const glsl::detail::map_parameter map{"UMBRAGE_HIGHP sampler2D map", ""};
    CHECK(glsl::detail::glsl_interface(sun, map, glsl::version::v120).text == R"GLSL(
uniform vec4 umbrage_sun_block[5];
uniform UMBRAGE_HIGHP sampler2D umbrage_sun_map;

// umbrage_sun: 1.0 is lit
float umbrage_sun(vec3 world, vec3 normal) {
    return umbrage_shadow_sun(umbrage_sun_map,
                              mat4(umbrage_sun_block[0], umbrage_sun_block[1], umbrage_sun_block[2],
                                   umbrage_sun_block[3]), umbrage_sun_block[4], world, normal);
}
)GLSL");
}
