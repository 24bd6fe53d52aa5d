// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

#include <umbrage/depth/r16.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/shader/hlsl.hpp>
#include <umbrage/shader/glsl.hpp>
#include <umbrage/shader/msl.hpp>
#include <umbrage/shader/wgsl.hpp>
#include <umbrage/shadow/in_shader.hpp>

#include "scene.hpp"
#include "texts.hpp"

using namespace umbrage;
using glsl::bind;
using glsl::version;
using shadow_texts::has;
using shadow_texts::refusal;

namespace {

const shadow lamp_in_shader(shadow_scene::spot(cpu_clip_space), {256, 256}, filters::tent<3>, rg<11>{});
const shadow sun_in_shader(shadow_scene::cascades(cpu_clip_space), {256, 256}, filters::pcf_2x2{});

}  // namespace

TEST_CASE("in_shader: a function of world and normal, and what it is bound to, in each language") {
    const auto item = bind(lamp_in_shader, "lamp", {.block = 3, .texture = 4, .sampler = 5, .set = 1});
    const std::string gl = glsl::text({item}, version::v330), vk = glsl::text({item}, version::vulkan);
    CHECK(has(gl, "layout(std140) uniform umbrage_lamp_block {\n    mat4 umbrage_lamp_to_texels;"));
    CHECK(has(gl, "float umbrage_lamp(vec3 world, vec3 normal) {"));
    CHECK(has(vk, "layout(std140, set = 1, binding = 3) uniform umbrage_lamp_block {"));
    CHECK(has(vk, "layout(set = 1, binding = 4) uniform UMBRAGE_HIGHP sampler2D umbrage_lamp_map;"));
    CHECK(has(glsl::text({item}, version::v450), "layout(std140, binding = 3) uniform umbrage_lamp_block {"));
    CHECK(has(glsl::text({item}, version::v100), "uniform highp vec4 umbrage_lamp_block[13];"));
    const std::string h = hlsl::text({item}), w = wgsl::text({item}), m = msl::text({item});
    CHECK(has(h, "cbuffer umbrage_lamp_block : register(b3, space1) {"));
    CHECK(has(h, "Texture2D<float4> umbrage_lamp_map : register(t4, space1);"));
    CHECK(has(w, "@group(1) @binding(3) var<uniform> umbrage_lamp_uniforms: umbrage_lamp_block;"));
    CHECK(has(w, "@group(1) @binding(4) var umbrage_lamp_map: texture_2d<f32>;"));
    CHECK(has(w, "fn umbrage_lamp(world: vec3f, normal: vec3f) -> f32 {"));
    CHECK(has(m, "inline float umbrage_lamp(constant umbrage_lamp_block& block, metal::texture2d<float> map,"));
}

TEST_CASE("in_shader: comparison samplers, arrays, and the pixel of filters that turn") {
    const shadow plain(shadow_scene::spot(cpu_clip_space), {256, 256}, filters::pcf_2x2{});
    const auto compared = bind(plain, "lamp", {.sampler = 7, .map = glsl::texture::shadow});
    CHECK(has(glsl::text({compared}, version::v330), "uniform UMBRAGE_HIGHP sampler2DShadow umbrage_lamp_map;"));
    CHECK(has(hlsl::text({compared}), "SamplerComparisonState umbrage_lamp_sampler : register(s7);"));
    CHECK(has(wgsl::text({compared}), "@group(0) @binding(7) var umbrage_lamp_sampler: sampler_comparison;"));
    CHECK(has(msl::text({compared}), "& block, metal::depth2d<float> map, metal::sampler map_sampler,"));
    CHECK(has(glsl::text({bind(sun_in_shader, "sun", {.map = glsl::texture::array})}, version::v330),
              "float layer = number;"));
    CHECK(has(glsl::text({bind(sun_in_shader, "sun")}, version::v330), "vec2 origin = umbrage_map_tile(number"));
    const shadow turned(shadow_scene::bulb(cpu_clip_space), {256, 256}, filters::disc{});
    CHECK(has(glsl::text({bind(turned, "bulb")}, version::v330),
              "float umbrage_bulb(vec3 world, vec3 normal, vec2 pixel) {"));
}

TEST_CASE("in_shader: contact hardening along the receiver's plane, and prefiltered maps, in each language") {
    const shadow soft(shadow_scene::cascades(cpu_clip_space), {256, 256}, shadow_scene::sized(filters::pcss{}));
    const shadow smooth(shadow_scene::spot(cpu_clip_space), {256, 256}, prefilters::evsm4{});
    const auto both = {bind(soft, "soft", {.map = glsl::texture::array}),
                       bind(smooth, "smooth", {.block = 3, .texture = 4, .sampler = 5})};
    const std::string gl = glsl::text(both, version::v330), w = wgsl::text(both);
    CHECK(has(gl, "vec2 receiver_slope = vec2(slope.x, slope.y);"));
    CHECK(has(gl, "umbrage_pcss16_soft(map, layer, receiver_slope, receiver_at,"));
    CHECK(has(gl, "umbrage_look_soft(map, layer, terms"));
    CHECK(has(gl, "float umbrage_soft(vec3 world, vec3 normal, vec2 pixel) {"));
    CHECK(has(gl, "vec2(filter_terms.x, filter_terms.y)"));
    CHECK(has(gl, "vec2(filter_terms.z, filter_terms.w));"));
    CHECK(has(w, "layer: f32, receiver_slope: vec2f, receiver_at: vec3f,"));
    CHECK(has(hlsl::text(both), "float2 receiver_slope, float3 receiver_at"));
    CHECK(has(msl::text(both), "float2 receiver_slope,"));
}

TEST_CASE("in_shader: functions to debug a shadow, in each language") {
    const auto item = bind(sun_in_shader, "sun", {.map = glsl::texture::array, .debug = true});
    const std::string gl = glsl::text({item}, version::v330), w = wgsl::text({item});
    CHECK(has(gl, "vec3 umbrage_probe_sun(vec3 world, vec3 normal) {"));
    CHECK(has(gl, "float umbrage_calibrate_sun(float number) {"));
    CHECK(has(glsl::text({bind(lamp_in_shader, "lamp", {.debug = true})}, version::v100),
              "highp float umbrage_calibrate_lamp(highp float number) {"));
    CHECK(has(w, "fn umbrage_probe_sun(world: vec3f, normal: vec3f) -> vec3f {"));
    CHECK(has(w, "fn umbrage_calibrate_sun(number: f32) -> f32 {"));
    CHECK(has(hlsl::text({item}), "float3 umbrage_probe_sun(float3 world, float3 normal) {"));
    CHECK(has(msl::text({item}), "inline float3 umbrage_probe_sun(constant umbrage_sun_block& block, float3 world"));
    CHECK(has(msl::text({item}), "umbrage_calibrate_sun(constant umbrage_sun_block& block, metal::texture2d_array"));
    CHECK(!has(glsl::text({bind(sun_in_shader, "sun")}, version::v330), "probe"));
    CHECK(refusal([&] {
              (void)glsl::text({item, bind(lamp_in_shader, "probe_sun")}, version::v330);
          }).starts_with("umbrage::glsl::text: name must be another than a snippet's or shadow's"));
}

TEST_CASE("in_shader: several shadows in one text, each under its name") {
    const std::string both =
        wgsl::text({bind(lamp_in_shader, "lamp"), bind(sun_in_shader, "sun", {.block = 3, .texture = 4})});
    CHECK(has(both, "fn umbrage_lamp("));
    CHECK(has(both, "fn umbrage_sun("));
    CHECK(has(both, "fn umbrage_plane_in_map("));
    CHECK(both.find("fn umbrage_plane_in_map(") == both.rfind("fn umbrage_plane_in_map("));
}

TEST_CASE("in_shader: shadows of a text have slots and names of their own, where it writes them") {
    const auto lamp = bind(lamp_in_shader, "lamp"), sun = bind(sun_in_shader, "sun");
    const auto slots = [](const std::string& function, const std::string& got) {
        return "umbrage::" + function + ": slots must be others for each block, texture and sampler of a text; got " +
               got + " for lamp and sun";
    };
    CHECK(refusal([&] {
              (void)glsl::text({lamp, sun}, version::v450);
          }) == slots("glsl::text", "binding 0 of uniform blocks"));
    CHECK(refusal([&] {
              (void)glsl::text({lamp, bind(sun_in_shader, "sun", {.block = 1})}, version::v450);
          }) == slots("glsl::text", "binding 1 of textures"));
    CHECK(refusal([&] {
              (void)glsl::text({lamp, bind(sun_in_shader, "sun", {.block = 1, .texture = 2})}, version::vulkan);
          }) == slots("glsl::text", "binding 1 of set 0"));
    CHECK(refusal([&] { (void)wgsl::text({lamp, sun}); }) == slots("wgsl::text", "binding 0 of group 0"));
    CHECK(refusal([&] { (void)hlsl::text({lamp, sun}); }) == slots("hlsl::text", "register b0 of space 0"));
    (void)glsl::text({lamp, sun}, version::v330);
    (void)msl::text({lamp, sun});
    (void)wgsl::text({lamp, bind(sun_in_shader, "sun", {.set = 1})});
    CHECK(refusal([&] {
              (void)glsl::text({lamp, bind(glsl::hard, "map"), bind(sun_in_shader, "hard")}, version::v330);
          }) == "umbrage::glsl::text: name must be another than a snippet's or shadow's of the text; got \"hard_map\"");
    CHECK(refusal([&] {
              (void)glsl::text({lamp, bind(sun_in_shader, "lamp_block")}, version::v330);
          }).ends_with("got \"lamp_block\""));
}

TEST_CASE("in_shader: a text promises what its parts promise") {
    const std::string text = glsl::text({bind(lamp_in_shader, "lamp")}, version::v330);
    CHECK(has(text, "// umbrage 0.1.0, MIT License: lamp\n"));
    CHECK(has(text, "// anchored_place, tier C: within 121 x 2^-23 x S of the exact result.\n"));
    CHECK(glsl::exactness({bind(lamp_in_shader, "lamp")}) == glsl::tier::c);
}

TEST_CASE("in_shader: a linear comparison sampler weights the filters that have such a form") {
    const shadow sun(shadow_scene::fitted(cpu_clip_space), {64, 64}, filters::tent<3>);
    const auto text = glsl::text({bind(sun, "sun", {.map = glsl::texture::shadow, .linear = true})}, version::v330);
    CHECK(has(text, "return umbrage_window_hardware3_sun(map, receiver_slope, receiver_at,"));
    CHECK(has(text, "coord, receiver, 4.0,"));  // weights of 1 2 1, on two lines
    CHECK(has(text, " 8.0);"));
    CHECK(has(text, "error = terms.w + slope.z + 0.5 * (abs(slope.x) + abs(slope.y));"));
    CHECK(refusal([&] {
              (void)bind(sun, "sun", {.linear = true});
          }).starts_with("umbrage::glsl::bind: slots.linear must be false where slots.map is no comparison sampler"));
    const shadow halves(shadow_scene::paraboloids(cpu_clip_space), {512, 512}, filters::tent<3>);
    CHECK(refusal([&] {
              (void)bind(halves, "sun", {.map = glsl::texture::shadow_array, .linear = true});
          }).starts_with("umbrage::glsl::bind: slots.linear must be false where"));
    const shadow sharp(shadow_scene::fitted(cpu_clip_space), {64, 64}, filters::hard{});
    CHECK(refusal([&] { (void)bind(sharp, "sun", {.map = glsl::texture::shadow, .linear = true}); }) ==
          "umbrage::glsl::bind: of.filter() must be pcf_2x2, a disc, or a kernel of 3, 5 or 7 weights, as slots.linear "
          "is true; got \"hard\"");
}

TEST_CASE("in_shader: gathers read four texels at once where the language has them") {
    const shadow sun(shadow_scene::fitted(cpu_clip_space), {64, 64}, filters::tent<3>);
    const auto item = bind(sun, "sun", {.gather = true});
    const auto text = glsl::text({item}, version::v450);
    CHECK(has(text, "textureGather(map, (texel + 1.0) / size, 0)"));
    CHECK(!has(text, "texelFetch"));
    CHECK(!glsl::supports(item, version::v330));
    const shadow sharp(shadow_scene::fitted(cpu_clip_space), {64, 64}, filters::hard{});
    CHECK(refusal([&] { (void)bind(sharp, "sun", {.gather = true}); }) ==
          "umbrage::glsl::bind: of.filter() must be pcf_2x2 or a kernel, as slots.gather is true; got \"hard\"");
    CHECK(refusal([&] {
              (void)bind(sun, "sun", {.map = glsl::texture::shadow, .gather = true});
          }).starts_with("umbrage::glsl::bind: slots.gather must be false where slots.map is a comparison sampler"));
}

TEST_CASE("in_shader: bad input") {
    const auto lamp = bind(lamp_in_shader, "lamp");
    CHECK(refusal([&] { (void)bind(lamp_in_shader, "2 lamps"); }).starts_with("umbrage::glsl::bind: name must be"));
    CHECK(refusal([&] { (void)bind(lamp_in_shader, ""); }).starts_with("umbrage::glsl::bind: name must be"));
    CHECK(refusal([&] { (void)bind(lamp_in_shader, "lamp", {.map = glsl::texture::array}); })
              .starts_with(
                  "umbrage::glsl::bind: slots.map must be texture_2d, depth or shadow, as the shadow has one map; got "
                  "array"));
    CHECK(refusal([&] { (void)bind(sun_in_shader, "sun", {.map = glsl::texture::texture_2d}); })
              .starts_with(
                  "umbrage::glsl::bind: slots.map must be atlas, array, depth_array or shadow_array, as the shadow has "
                  "several maps; got texture_2d"));
    CHECK(refusal([&] { (void)bind(lamp_in_shader, "lamp", {.map = glsl::texture::shadow}); }) ==
          "umbrage::glsl::bind: of.encoding() must be depth32f, depth24 or depth16, as slots.map is a comparison "
          "sampler; got \"rg11\"");
    CHECK(refusal([&] { (void)bind(lamp_in_shader, "lamp", {.map = glsl::texture::depth}); }) ==
          "umbrage::glsl::bind: of.encoding() must be of one channel, as slots.map is a depth texture; got \"rg11\"");
    const shadow r16_map(shadow_scene::spot(cpu_clip_space), {64, 64}, filters::hard{}, r16{});
    CHECK(refusal([&] { (void)bind(r16_map, "lamp", {.map = glsl::texture::shadow}); }) ==
          "umbrage::glsl::bind: of.encoding() must be depth32f, depth24 or depth16, as slots.map is a comparison "
          "sampler; got \"r16\"");
    const std::string filter = "umbrage::glsl::bind: of.filter() must be one that needs no depths, as slots.map is a ";
    const shadow variance(shadow_scene::spot(cpu_clip_space), {64, 64}, prefilters::vsm{});
    const std::string moments =
        "umbrage::glsl::bind: slots.map must be a color texture, as the filter reads moments; got ";
    CHECK(refusal([&] { (void)bind(variance, "lamp", {.map = glsl::texture::shadow}); }) == moments + "shadow");
    CHECK(refusal([&] { (void)bind(variance, "lamp", {.map = glsl::texture::depth}); }) == moments + "depth");
    CHECK(refusal([&] {
              (void)bind(lamp_in_shader, "lamp", {.sampler = -1});
          }).starts_with("umbrage::glsl::bind: slots.sampler must be 0 or above; got -1"));
    CHECK(refusal([&] {
              (void)glsl::text({lamp, lamp}, version::v330);
          }).starts_with("umbrage::glsl::text: name must be another"));
    CHECK(refusal([&] {
              (void)wgsl::text({lamp, bind(sun_in_shader, "lamp")});
          }).starts_with("umbrage::wgsl::text: name must be another for each map"));
    CHECK(refusal([&] {
              (void)wgsl::text({bind(lamp_in_shader, "plane_in_map")});
          }).starts_with("umbrage::wgsl::text: name must be another than a snippet's"));
    const shadow soft(shadow_scene::spot(cpu_clip_space), {256, 256}, shadow_scene::sized(filters::pcss{}));
    CHECK(refusal([&] { (void)bind(soft, "soft", {.map = glsl::texture::shadow}); }) ==
          filter + "comparison sampler; got \"" + std::string(soft.filter().name) + "\"");
    CHECK(refusal([&] { (void)glsl::text({lamp}); }).starts_with("umbrage::glsl::text: version must be given"));
}
