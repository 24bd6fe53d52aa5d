// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/shader/map_words.hpp>

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/shader/glsl.hpp>
#include <umbrage/shader/hlsl.hpp>

using namespace umbrage;
using namespace umbrage::glsl;
using views = std::vector<std::string_view>;

TEST_CASE("lists: members between commas, and the names that parameters declare") {
    CHECK(glsl::detail::members("a, f(b, c)[d, e], g<h, i>") == views{"a", " f(b, c)[d, e]", " g<h, i>"});
    CHECK(glsl::detail::declared("highp sampler2D map, float layer") == views{"map", "layer"});
    CHECK(glsl::detail::declared("map: texture_storage_2d<r32float, read>, i: i32") == views{"map", "i"});
    CHECK(glsl::detail::declared("metal::depth2d<float> map, metal::sampler map_sampler") ==
          views{"map", "map_sampler"});
    CHECK(glsl::detail::declared("sampler2D maps[4], Texture2D<float4> map") == views{"maps", "map"});
}

TEST_CASE("operands: only sums and the like get parentheses") {
    using glsl::detail::as_operand;
    for (const char* own : {"", "size", "64.0", "map.size", "vec2(64.0, f(32.0))", "sizes[i + 1].xy", "(size * 2.0)"})
        CHECK(as_operand(own) == own);
    CHECK(as_operand("size * 2.0") == "(size * 2.0)");
    CHECK(as_operand("(a) + (b)") == "((a) + (b))");
    CHECK(as_operand("-a") == "(-a)");
    const std::string text = glsl::text({bind(
        glsl::hard, "a", {.texture = glsl::texture::shadow, .origin = "first + 1.0", .texture_size = "size * 2.0"})});
    CHECK(text.find("texel + (first + 1.0);") != text.npos);
    CHECK(text.find("(at + 0.5) / (size * 2.0)") != text.npos);
}

TEST_CASE("words: those of code, and not of comments") {
    CHECK(glsl::detail::words_of("a += b2; // c\nd(e_f)") == views{"a", "b2", "d", "e_f"});
}

TEST_CASE("parameters of one's own: what is read is among them, and no name is taken twice") {
    const auto refused = [](const binding& map, const char* message) {
        CHECK_THROWS_WITH_AS((void)glsl::text({bind(glsl::hard, "a", map)}), message, std::invalid_argument);
    };
    refused({.parameters = "int layer", .arguments = "layer"},
            "umbrage::glsl::bind: map.parameters must be parameters that declare map; got \"int layer\"");
    refused({.texture = texture::array, .parameters = "sampler2DArray map"},
            "umbrage::glsl::bind: map.arguments must be as many as map.parameters; got \"map, layer\". "
            "The parameters are sampler2DArray map.");
    refused({.arguments = "map, 1"},
            "umbrage::glsl::bind: map.arguments must be as many as map.parameters; got \"map, 1\". "
            "The parameters are UMBRAGE_HIGHP sampler2D map.");
    refused({.parameters = "int size", .arguments = "size", .texel = "fetch(size, at)"},
            "umbrage::glsl::bind: map.parameters must be named otherwise than what umbrage_texel names; got \"size\"");
    CHECK_NOTHROW((void)glsl::text({bind(glsl::hard, "a", {.parameters = "lowp sampler2D map"})}));
    const binding unity{.texture = texture::shadow, .parameters = "Texture2D map, SamplerComparisonState map_sampler"};
    CHECK_NOTHROW((void)hlsl::text({bind(glsl::hard, "a", unity)}));
    const binding without{.texture = texture::shadow, .parameters = "Texture2D map, SamplerComparisonState s"};
    CHECK_THROWS_WITH_AS((void)hlsl::text({bind(glsl::hard, "a", without)}),
                         "umbrage::glsl::bind: map.parameters must be parameters that declare map_sampler; got "
                         "\"Texture2D map, SamplerComparisonState s\"",
                         std::invalid_argument);
}
