// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>
#include <sstream>
#include <string>

#include <umbrage/depth/rg.hpp>
#include <umbrage/registry.hpp>
#include <umbrage/shader/wgsl.hpp>

#include "parts_of_text.hpp"

using namespace umbrage;

TEST_CASE("wgsl::text: a snippet reads as written in WGSL") {
    CHECK(wgsl::detail::translate(glsl::encode_rg<11>) == R"(
// umbrage_encode_rg11: two channels of a 11-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg11(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 32.0);
}
)");
    CHECK(wgsl::detail::translate(glsl::encode_float_bits) == R"(
// umbrage_encode_float_bits: bit pattern of v as four channels, R least significant, integers 0..255
fn umbrage_encode_float_bits(v: f32) -> vec4f {
    let bits: u32 = bitcast<u32>(v);
    return vec4f(f32(bits & 255u), f32((bits >> 8) & 255u), f32((bits >> 16) & 255u), f32(bits >> 24));
}
)");
    CHECK(wgsl::detail::translate(glsl::box_scale).find(R"(
fn umbrage_box_scale(radius: i32) -> f32 {
    var scale: f32 = 0.00346020772;  // not returned as a literal: that would have the host's precision
    if (radius < 8) { scale = 0.00444444455; }
)") != std::string::npos);
}

TEST_CASE("wgsl::text: every snippet translates, in lines that people read, each function once") {
    for (const glsl::snippet* s : glsl::registry()) {
        CAPTURE(s->name);
        const std::string text = wgsl::text({*s});
        CHECK(text.starts_with("// umbrage "));
        std::set<std::string> functions;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            const std::string code = line.substr(0, line.find("//"));
            CAPTURE(code);
            CHECK(code.size() <= 120);
            CHECK(code.find_first_of("#?") == std::string::npos);
            CHECK(code.find("UMBRAGE_") == std::string::npos);
            if (code.starts_with("fn ")) CHECK(functions.insert(code.substr(0, code.find('('))).second);
        }
        CHECK(functions.contains("fn umbrage_" + std::string(s->name)));
    }
}

TEST_CASE("wgsl::text: a text that may round differently bounds each function by name, another does not") {
    for (const glsl::snippet* s : glsl::registry()) {
        CAPTURE(s->name);
        const std::string text = wgsl::text({*s});
        CHECK(second_line_on(text).starts_with(bounds_note(*s, "WGSL") + "\n//"));
    }
    const std::string exact_then_not = wgsl::text({glsl::encode_rg<11>, glsl::spot_cone, glsl::project_coordinate});
    CHECK(second_line_on(exact_then_not)
              .starts_with("// WGSL lets compilers fuse or reorder sums.\n"
                           "// spot_cone, tier B: within 11 x 2^-23 x S of the exact result.\n"
                           "// project_coordinate, tier C: within 3 x 2^-23 x S of the exact result.\n"
                           "// S is the formula with the magnitude of every value and a plus for every minus.\n"
                           "// Inside the bound, a comparison or floor may fall on either side.\n"));
    CHECK(count(wgsl::text({glsl::spot_cone, glsl::spot_cone}), "// spot_cone, tier B") == 1);
}

TEST_CASE("wgsl::text: maps of several kinds in one shader") {
    namespace g = glsl;
    const std::string text =
        wgsl::text({bind(g::pcf_2x2, "sun", {.texture = g::texture::shadow_array, .gather = true}),
                    bind(g::hard, "lamp", g::stored_as(rg<11>{}, {.texture = g::texture::atlas})),
                    bind(g::hard, "cube", {.texture = g::texture::cube, .direction = depth_direction::reversed}),
                    bind(g::pcf_2x2, "small", {.gather = true}), g::encode_rg_table<11>});
    const auto has = [&](const std::string& part) { return text.find(part) != std::string::npos; };
    CHECK(
        has("fn umbrage_pcf_2x2_sun(map: texture_depth_2d_array, map_sampler: sampler_comparison, layer: f32, size: "
            "vec2f,\n                       coord: vec2f, receiver: f32) -> f32 {\n"));
    CHECK(has(
        "    let lit: vec4f = textureGatherCompare(map, map_sampler, (texel + 1.0) / size, i32(layer), receiver);\n"));
    CHECK(has("fn umbrage_hard_lamp(map: texture_2d<f32>, origin: vec2f, size: vec2f, coord: vec2f, receiver: f32)"));
    CHECK(has("    let at: vec2f = texel + origin;\n    return textureLoad(map, vec2i(at), 0);\n"));
    CHECK(has("    return umbrage_decode_rg11(value.xy, 1.0);\n"));
    CHECK(has(
        "    return textureSampleLevel(map, map_sampler, umbrage_cube_direction(face, (texel + 0.5) / size), 0.0);\n"));
    CHECK(has("    return select(0.0, 1.0, receiver >= stored);\n"));
    CHECK(has("fn umbrage_pcf_2x2_small(map: texture_2d<f32>, map_sampler: sampler, size: vec2f,"));
    CHECK(has("    let r: vec4f = textureGather(0, map, map_sampler, (texel + 1.0) / size);\n"));
    CHECK(has("fn umbrage_encode_rg11_table(table: texture_2d<f32>, depth: f32) -> vec2f {\n"));
    CHECK(has("umbrage_fetch_clamped(table, vec2f(2048.0, 1.0), texel)"));
}
