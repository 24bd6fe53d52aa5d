// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/shader/bind.hpp>

#include <stdexcept>
#include <string>

#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rgb24.hpp>
#include <umbrage/filter/filters.hpp>

using namespace umbrage;
using namespace umbrage::glsl;

TEST_CASE("bind: a name makes a suffix") {
    CHECK(bind(glsl::hard, "").suffix.empty());
    CHECK(bind(glsl::hard, "sun").suffix == "_sun");
    CHECK(bind(glsl::hard, "Sun_2").suffix == "_Sun_2");
    for (const char* name : {"_sun", "sun_", "sun__2", "sun 2", "sun-2", "s\xc3\xbcn", "_"})
        CHECK_THROWS_AS((void)bind(glsl::hard, name), std::invalid_argument);
}

TEST_CASE("bind: what cannot compile is refused, by argument and value") {
    const auto refused = [](const snippet& s, const char* name, const binding& map, const char* message) {
        CHECK_THROWS_WITH_AS((void)bind(s, name, map), message, std::invalid_argument);
    };
    refused(glsl::hard, "a b", {},
            "umbrage::glsl::bind: name must be letters, digits and single underscores between them; got \"a b\"");
    refused(glsl::hard, "a", {.channels = 5}, "umbrage::glsl::bind: map.channels must be 1 to 4; got 5");
    refused(glsl::hard, "a", {.channels = 0}, "umbrage::glsl::bind: map.channels must be 1 to 4; got 0");
    for (const texture kind : {texture::depth, texture::depth_array, texture::shadow, texture::shadow_array})
        for (const bool gather : {false, true})
            refused(glsl::hard, "a", stored_as(rg<11>{}, {.texture = kind, .gather = gather}),
                    "umbrage::glsl::bind: map.channels must be 1 for a depth texture; got 2");
    refused(glsl::hard, "a", {.texture = texture::shadow, .depth = "1.0 - value.x"},
            "umbrage::glsl::bind: map.depth must be empty for a comparison sampler; got \"1.0 - value.x\". "
            "It reads a depth texture: depth32f, depth24 or depth16.");
    for (const texture kind : {texture::cube, texture::cube_faces, texture::integer})
        refused(glsl::pcf_2x2, "a", {.texture = kind, .gather = true},
                "umbrage::glsl::bind: map.gather must be false where texels of cubes or whole numbers are gathered; "
                "got true");
    CHECK_NOTHROW((void)bind(glsl::hard, "a", {.texture = texture::integer, .gather = true}));  // it gathers nothing
    refused(glsl::pcf_2x2_dx_sdk, "a", {.texture = texture::shadow},
            "umbrage::glsl::bind: what must be a snippet that reads no depths, as a comparison sampler gives none; got "
            "\"pcf_2x2_dx_sdk\"");
    refused(glsl::pcf_2x2, "a", stored_as(rgb24{}, {.gather = true}),
            "umbrage::glsl::bind: map.channels must be 1 or 2 where texels are gathered; got 3");
    CHECK_NOTHROW((void)bind(glsl::hard, "a", stored_as(rgb24{}, {.gather = true})));
    refused(glsl::pcf_2x2, "a", {.texture = texture::shadow, .gather = true, .receiver_plane = true},
            "umbrage::glsl::bind: map.receiver_plane must be false where a sampler gathers comparisons, or with an "
            "own comparison; got true");
    refused(glsl::hard, "a", {.compare = "exp(40.0 * (stored - receiver))", .receiver_plane = true},
            "umbrage::glsl::bind: map.receiver_plane must be false where a sampler gathers comparisons, or with an "
            "own comparison; got true");
    refused(glsl::hard, "a", {.needs = {glsl::pcf_2x2}},
            "umbrage::glsl::bind: map.needs must be snippets that read no map; got \"pcf_2x2\"");
}

TEST_CASE("bind: texts of one's own are expressions, on one line") {
    const auto refused = [](const binding& map, const char* message) {
        CHECK_THROWS_WITH_AS((void)bind(glsl::hard, "a", map), message, std::invalid_argument);
    };
    refused({.depth = "value.x; return 1.0"},
            "umbrage::glsl::bind: map.depth must be one expression on one line; got \"value.x; return 1.0\"");
    refused({.origin = "vec2(1.0"},
            "umbrage::glsl::bind: map.origin must be one expression on one line; got \"vec2(1.0\"");
    refused({.texture_size = " "},
            "umbrage::glsl::bind: map.texture_size must be one expression on one line; got \" \"");
    refused({.depth = "value.x, extra"},
            "umbrage::glsl::bind: map.depth must be one expression on one line; got \"value.x, extra\"");
    refused({.compare = "receiver = 1.0"},
            "umbrage::glsl::bind: map.compare must be one expression on one line; got \"receiver = 1.0\"");
    refused({.texel = "#ifdef A"},
            "umbrage::glsl::bind: map.texel must be one expression on one line; got \"#ifdef A\"");
    refused({.parameters = "int a // layer"},
            "umbrage::glsl::bind: map.parameters must be parameters on one line; got \"int a // layer\"");
    refused({.arguments = "a)(b"}, "umbrage::glsl::bind: map.arguments must be expressions on one line; got \"a)(b\"");
    for (const char* own : {"f(value.x, 1.0)", "a == b ? 1.0 : 0.0", "float(a <= b && c >= d && e != f)"})
        CHECK_NOTHROW((void)bind(glsl::hard, "a", {.compare = own}));
    CHECK_NOTHROW((void)bind(glsl::hard, "a", {.texel = "metal::float4{maps[layer].read(uint2(at)).x}"}));
}
