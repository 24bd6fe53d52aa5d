// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/shader/compose.hpp>

#include "parts_of_text.hpp"

#include <stdexcept>
#include <string>
#include <string_view>

#include <umbrage/depth/conversions.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/depth/rg_level.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/window_hardware.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/registry.hpp>
#include <umbrage/shader/glsl.hpp>
#include <umbrage/shader/translate/words.hpp>

using namespace umbrage;
using namespace umbrage::glsl;

namespace {

/// The function of this name, from its signature to its last brace.
std::string function(const std::string& text, const std::string& name) {
    const auto at = text.find(" " + name + "(");
    REQUIRE(at != text.npos);
    const auto begin = text.rfind('\n', at) + 1;
    return text.substr(begin, text.find("\n}\n", at) + 3 - begin);
}

/// True for a text with a word that a map should have filled in.
bool has_word_to_fill_in(const std::string& text) {
    for (const std::string_view parameters : {"UMBRAGE_MAP", "UMBRAGE_PARAMETERS", "UMBRAGE_TEXTURE_SIZE"})
        if (text.find(parameters) != text.npos) return true;
    for (const glsl::detail::map_word& w : glsl::detail::map_words)
        if (text.find(w.word) != text.npos) return true;
    return false;
}

const binding packed = stored_as(rg<11>{});
const binding layered{.texture = texture::array, .direction = depth_direction::reversed};

}  // namespace

TEST_CASE("a map's functions carry its name and take what its texture is called with") {
    const std::string text = glsl::text({bind(glsl::hard, "sun", layered)});
    CHECK(text.starts_with("// umbrage 0.1.0, MIT License: hard_sun\n"));
    CHECK(function(text, "umbrage_texel_sun") ==
          "UMBRAGE_HIGHP vec4 umbrage_texel_sun(UMBRAGE_HIGHP sampler2DArray map, UMBRAGE_HIGHP float layer,\n"
          "                                     UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {\n"
          "    return texelFetch(map, ivec3(ivec2(texel), int(layer)), 0);\n}\n");
    CHECK(function(text, "umbrage_fetch_depth_sun").find("umbrage_texel_sun(map, layer, size, inside)") !=
          std::string::npos);
    CHECK(function(text, "umbrage_compare_sun").find("receiver >= stored") != std::string::npos);
    CHECK(text.find("#define UMBRAGE_HAS_HARD_SUN\n") != std::string::npos);
    CHECK(text.find("map, size   shadow map and its size") != std::string::npos);  // comments keep their words
}

TEST_CASE("several maps in one text: each its own functions, what belongs to none once and first") {
    const std::string text =
        glsl::text({bind(glsl::hard, "sun", layered), bind(glsl::box, "lamp", packed), bind(glsl::hard, "lamp", packed),
                    glsl::pcf_2x2, bind(glsl::hard, "sun", layered)});
    CHECK(count(text, "float umbrage_hard_sun(") == 1);
    CHECK(count(text, "float umbrage_hard_lamp(") == 1);
    CHECK(count(text, "float umbrage_lit_lamp(") == 1);
    CHECK(count(text, "float umbrage_pcf_2x2(") == 1);
    CHECK(count(text, "bool umbrage_inside_texel_space(") == 1);
    CHECK(count(text, "float umbrage_decode_rg11(") == 1);
    CHECK(text.find("float umbrage_decode_rg11(") < text.find("float umbrage_lit_lamp("));
    CHECK(count(text, "#if") == count(text, "#endif"));
    CHECK_THROWS_AS((void)glsl::text({bind(glsl::hard, "sun", layered), bind(glsl::box, "sun", packed)}),
                    std::invalid_argument);
}

TEST_CASE("a map without a name: beside it stands what belongs to no map, not what is for another without a name") {
    CHECK(glsl::text({bind(glsl::hard, "", packed), glsl::decode_rg<11>}).find("float umbrage_hard(") !=
          std::string::npos);
    CHECK_THROWS_WITH_AS(  // whatever the order
        (void)glsl::text({bind(glsl::hard, "", packed), glsl::box}),
        "umbrage::glsl::text: name must be another for each map; got \"\". It is the name of two maps.",
        std::invalid_argument);
    CHECK_THROWS_AS((void)glsl::text({glsl::box, bind(glsl::hard, "", packed)}), std::invalid_argument);
}

TEST_CASE("a snippet alone is bound to a plain map without a name") {
    for (const snippet* s : registry()) {
        CAPTURE(s->name);
        CHECK(glsl::text({*s}) == glsl::text({bind(*s, "")}));
    }
    CHECK_NOTHROW((void)glsl::text({bind(glsl::hard, "", {}), glsl::box}));
}

TEST_CASE("a text has no directives but guards, those of its head, and questions for the version of GLSL") {
    const std::string head(glsl::prelude);
    for (const snippet* s : registry()) {
        CAPTURE(s->name);
        std::string text = glsl::text({*s});
        REQUIRE(text.find(head) != text.npos);
        text.erase(text.find(head), head.size());
        for (const char* guard :
             {"\n#ifndef UMBRAGE_HAS_", "\n#define UMBRAGE_HAS_", "\n#if __VERSION__ >= ", "\n#else\n", "\n#endif\n"})
            for (auto at = text.find(guard); at != text.npos; at = text.find(guard)) text.erase(at + 1, 1);
        CHECK(text.find("\n#") == text.npos);
    }
}

TEST_CASE("names that make one function of two, or one guard, are refused") {
    CHECK_THROWS_WITH_AS((void)glsl::text({bind(glsl::pcf_2x2, "rg11", stored_as(rg<11>{}, {.gather = true}))}),
                         "umbrage::glsl::text: name must be such that functions differ, in capitals too; got "
                         "umbrage_decode_rg11 and umbrage_decode_rg11",
                         std::invalid_argument);
    CHECK_THROWS_WITH_AS((void)glsl::text({bind(glsl::hard, "sun"), bind(glsl::hard, "Sun", layered)}),
                         "umbrage::glsl::text: name must be such that functions differ, in capitals too; got "
                         "umbrage_beyond_far_plane_sun "
                         "and umbrage_beyond_far_plane_Sun",
                         std::invalid_argument);
    CHECK_THROWS_AS((void)glsl::text({bind(glsl::hard, "2x2"), glsl::pcf_2x2}), std::invalid_argument);
}

TEST_CASE("what belongs to no map is put in front, however the snippets are listed") {
    const std::string a = glsl::text({glsl::hard, glsl::decode_rg<11>}),
                      b = glsl::text({glsl::decode_rg<11>, glsl::hard});
    for (const std::string& text : {a, b}) CHECK(text.find("umbrage_decode_rg11(") < text.find("umbrage_fetch_depth("));
}

TEST_CASE("a map of depths on a scale of their own has no far plane") {
    binding levels{.depth = "umbrage_level_rg11(value.xy)", .channels = 2, .needs = {glsl::level_rg<11>}};
    CHECK(function(glsl::text({bind(glsl::hard, "a", levels)}), "umbrage_beyond_far_plane_a").find("return false;") !=
          std::string::npos);
    CHECK(function(glsl::text({bind(glsl::hard, "a", levels)}), "umbrage_fetch_depth_a").find(" : 65536.0;\n") !=
          std::string::npos);
    CHECK(function(glsl::text({glsl::hard, glsl::level_rg<11>}), "umbrage_beyond_far_plane").find("> 1.0;") !=
          std::string::npos);
}

TEST_CASE("a comparison of one's own stands for all of the map's, and knows no far plane") {
    const std::string text = glsl::text({bind(glsl::hard, "a", {.compare = "exp(stored - receiver)"})});
    CHECK(function(text, "umbrage_compare_a").find("return exp(stored - receiver);\n") != std::string::npos);
    CHECK(function(text, "umbrage_beyond_far_plane_a").find("return false;") != std::string::npos);
    CHECK(function(text, "umbrage_fetch_depth_a").find(" : 1.0;\n") != std::string::npos);
    CHECK_THROWS_WITH_AS((void)bind(glsl::hard, "a", {.texture = texture::shadow, .compare = "1.0"}),
                         "umbrage::glsl::bind: map.compare must be empty for a comparison sampler; got \"1.0\"",
                         std::invalid_argument);
    CHECK_THROWS_AS((void)bind(glsl::hard, "a", {.compare = "1.0; return"}), std::invalid_argument);
}

TEST_CASE("a depth is of a texel's value and of its number; a gather knows no number") {
    const binding tilted{.depth = "value.x + texel.x * slope"};
    for (const auto outside : {outside_map::bordered, outside_map::clamped}) {
        binding map = tilted;
        map.outside = outside;
        CHECK(function(glsl::text({bind(glsl::hard, "a", map)}), "umbrage_fetch_depth_a")
                  .find("value.x + texel.x * slope;\n") != std::string::npos);
    }
    binding gathered = tilted;
    gathered.gather = true;
    CHECK_NOTHROW((void)bind(glsl::hard, "a", gathered));  // it gathers nothing
    CHECK_THROWS_WITH_AS((void)bind(glsl::pcf_2x2, "a", gathered),
                         "umbrage::glsl::bind: map.depth must be of value alone where texels are gathered; got "
                         "\"value.x + texel.x * slope\"",
                         std::invalid_argument);
}

TEST_CASE("regions: the origin is added where the texture is read, and nowhere else") {
    const std::string tile = glsl::text({bind(glsl::hard, "a", {.origin = "vec2(512.0, 0.0)"})});
    CHECK(function(tile, "umbrage_texel_a").find("vec2 at = texel + vec2(512.0, 0.0);\n") != std::string::npos);
    CHECK(function(tile, "umbrage_texel_a").find("texelFetch(map, ivec2(at), 0)") != std::string::npos);
    CHECK(count(tile, "512.0") == 1);
    const std::string atlas = glsl::text({bind(glsl::hard, "a", {.texture = texture::atlas})});
    CHECK(function(atlas, "umbrage_hard_a").find("UMBRAGE_HIGHP vec2 origin, UMBRAGE_HIGHP vec2 size") !=
          std::string::npos);
    CHECK(function(atlas, "umbrage_texel_a").find("texel + origin;") != std::string::npos);
    const std::string whole = glsl::text({bind(glsl::hard, "a", {})});
    CHECK(function(whole, "umbrage_texel_a").find(" at ") == std::string::npos);
}

TEST_CASE("exactness: the worst tier of a text, its maps' hooks included") {
    CHECK(exactness({}) == tier::a);
    CHECK(exactness({bind(glsl::hard, "a", packed), glsl::hard}) == tier::a);
    CHECK(exactness({glsl::hard, glsl::shadow_coordinate}) == tier::b);
    CHECK(exactness({bind(glsl::hard, "a", packed), glsl::view_z_from_depth, glsl::hard}) == tier::c);
    CHECK(exactness({bind(glsl::hard, "a", stored_as(threejs_rgba{}))}) == tier::b);   // decoded by a snippet of tier B
    CHECK(exactness({bind(glsl::hard, "a", {.texture = texture::cube})}) == tier::b);  // found by one
    CHECK(exactness({bind(glsl::hard, "a", {.texture = texture::shadow})}) == tier::a);
    CHECK(exactness({bind(glsl::lit_at, "a", {.texture = texture::shadow})}) == tier::c);  // the sampler's own weights
    CHECK_THROWS_AS((void)exactness({bind(glsl::hard, "a", layered), bind(glsl::box, "a", packed)}),
                    std::invalid_argument);
}

TEST_CASE("a text bounds the functions asked for, each by the worst of what it holds, its maps' hooks included") {
    const auto bound_of = [](const bound& item) {
        const std::string text = glsl::text({glsl::hard, item}),
                          start = "\n// " + std::string(item.what.name) + item.suffix;
        const auto at = text.find(start + ", tier ");
        if (at == text.npos) return std::string();
        return text.substr(at + start.size() + 2, text.find('\n', at + 1) - at - start.size() - 2);
    };
    CHECK(bound_of(bind(glsl::box_count, "a", packed)).empty());
    const std::string n = std::to_string(glsl::decode_threejs_rgba.operations);
    CHECK(bound_of(bind(glsl::hard, "a", stored_as(threejs_rgba{}))) ==
          "tier B: within " + n + " x 2^-23 x S of the exact result.");
    CHECK(bound_of(bind(glsl::lit_at, "a", {.texture = texture::shadow})) == "tier C: within 1/128 of C++.");
    CHECK(bound_of(glsl::msm) ==
          "tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].");
    for (const snippet* s : registry()) {  // no bound is below what it needs
        CAPTURE(s->name);
        if (s->exactness != tier::a) CHECK(bound_of(*s).substr(8) == bound_in_words(*s));
    }
}

TEST_CASE("what a map cannot have is refused") {
    const auto refused = [](const snippet& s, const binding& map) {
        CHECK_THROWS_AS((void)glsl::text({bind(s, "a", map)}), std::invalid_argument);
    };
    refused(glsl::pcf_2x2_dx_sdk, {.texture = texture::shadow});  // it needs depths
    refused(glsl::pcf_2x2, {.texture = texture::cube, .gather = true});
    refused(glsl::pcf_2x2, {.texture = texture::cube_faces, .gather = true});
    refused(glsl::pcf_2x2, {.texture = texture::integer, .gather = true});
    refused(glsl::pcf_2x2, stored_as(rgb24{}, {.gather = true}));
    CHECK_NOTHROW((void)glsl::text({bind(glsl::pcf_2x2, "a", {.texture = texture::shadow, .gather = true})}));
    CHECK_NOTHROW((void)glsl::text({bind(glsl::pcf_2x2, "a", stored_as(rg<11>{}, {.gather = true}))}));
    const auto too_old = [](version v, const binding& map) {
        CHECK_FALSE(supports(bind(glsl::pcf_2x2, "a", map), v));
        CHECK_THROWS_AS((void)source(v, {bind(glsl::pcf_2x2, "a", map)}), std::invalid_argument);
    };
    too_old(version::v120, {.texture = texture::array});
    too_old(version::v150, {.texture = texture::shadow});
    too_old(version::v330, {.gather = true});
    too_old(version::v300_es, {.gather = true});
    too_old(version::v120, {.texture = texture::atlas});  // the texture's size is not known
    CHECK(supports(bind(glsl::pcf_2x2, "a", {.gather = true}), version::v310_es));
    CHECK(supports(bind(glsl::pcf_2x2, "a", {.texture = texture::cube}), version::v100));
    CHECK(supports(bind(glsl::pcf_2x2, "a", {.origin = "first", .texture_size = "all"}), version::v100));
}

TEST_CASE("own words for a texture: parameters, arguments and the value") {
    const binding mine{
        .parameters = "int layer", .arguments = "layer", .texel = "texelFetch(maps, ivec3(at, layer), 0)"};
    const std::string text = glsl::text({bind(glsl::hard, "a", mine)});
    CHECK(function(text, "umbrage_texel_a").find("(int layer, UMBRAGE_HIGHP vec2 size") != std::string::npos);
    CHECK(function(text, "umbrage_texel_a").find("return texelFetch(maps, ivec3(texel, layer), 0);") !=
          std::string::npos);
    CHECK(function(text, "umbrage_hard_a").find("umbrage_lit_a(layer, size, texel, receiver)") != std::string::npos);
}

TEST_CASE("every filter and every kind of texture make a text without a word left to fill in") {
    for (const texture kind :
         {texture::texture_2d, texture::atlas, texture::array, texture::cube, texture::cube_faces, texture::integer,
          texture::depth, texture::depth_array, texture::shadow, texture::shadow_array})
        for (const auto outside : {umbrage::outside_map::bordered, umbrage::outside_map::clamped})
            for (const bool gather : {false, true}) {
                if (gather && !glsl::detail::gathers(kind)) continue;
                const binding map{.texture = kind, .outside = outside, .gather = gather};
                for (const snippet& s :
                     {glsl::hard, glsl::pcf_2x2, glsl::box, glsl::pcf_2x2_hardware, glsl::window_hardware<3>}) {
                    const std::string text = glsl::text({bind(s, "a", map)});
                    CHECK(!has_word_to_fill_in(text));
                }
                if (gather) continue;
                const std::string planed =
                    glsl::text({bind(glsl::hard, "a", {.texture = kind, .outside = outside, .receiver_plane = true})});
                CHECK(!has_word_to_fill_in(planed));
            }
}
