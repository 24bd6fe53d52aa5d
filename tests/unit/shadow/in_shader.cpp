// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

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
    CHECK(has(glsl::text({item}, version::v100), "uniform highp vec4 umbrage_lamp_block[10];"));
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
    CHECK(has(glsl::text({bind(sun_in_shader, "sun")}, version::v330), "vec2 origin = umbrage_cascade_tile(number"));
    const shadow turned(shadow_scene::bulb(cpu_clip_space), {256, 256}, filters::disc{});
    CHECK(has(glsl::text({bind(turned, "bulb")}, version::v330),
              "float umbrage_bulb(vec3 world, vec3 normal, vec2 pixel) {"));
}

TEST_CASE("in_shader: contact hardening along the receiver's plane, and prefiltered maps, in each language") {
    const shadow soft(shadow_scene::cascades(cpu_clip_space), {256, 256}, filters::pcss{});
    const shadow smooth(shadow_scene::spot(cpu_clip_space), {256, 256}, prefilters::evsm4{});
    const auto both = {bind(soft, "soft", {.map = glsl::texture::array}),
                       bind(smooth, "smooth", {.block = 3, .texture = 4, .sampler = 5})};
    const std::string gl = glsl::text(both, version::v330), w = wgsl::text(both);
    CHECK(has(gl, "vec2 receiver_slope = slope;"));
    CHECK(has(gl, "umbrage_pcss16_soft(map, layer, receiver_slope, receiver_coord,"));
    CHECK(has(gl, "        umbrage_look_soft(map, layer, terms"));
    CHECK(has(gl, "float umbrage_soft(vec3 world, vec3 normal, vec2 pixel) {"));
    CHECK(has(gl, "vec2(filter_terms.x, filter_terms.y), vec2(filter_terms.z, filter_terms.w));"));
    CHECK(has(w, "layer: f32, receiver_slope: vec2f, receiver_coord: vec2f,"));
    CHECK(has(hlsl::text(both), "float2 receiver_slope, float2 receiver_coord"));
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
    CHECK(both.find("fn umbrage_acne_free_bias(") == both.rfind("fn umbrage_acne_free_bias("));
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
    CHECK(has(text, "// project_coordinate, tier C: within 3 x 2^-23 x S of the exact result.\n"));
    CHECK(glsl::exactness({bind(lamp_in_shader, "lamp")}) == glsl::tier::c);
}

TEST_CASE("in_shader: bad input") {
    const auto lamp = bind(lamp_in_shader, "lamp");
    CHECK(refusal([&] { (void)bind(lamp_in_shader, "2 lamps"); }).starts_with("umbrage::glsl::bind: name must be"));
    CHECK(refusal([&] { (void)bind(lamp_in_shader, ""); }).starts_with("umbrage::glsl::bind: name must be"));
    CHECK(refusal([&] {
              (void)bind(lamp_in_shader, "lamp", {.map = glsl::texture::array});
          }).starts_with("umbrage::glsl::bind: slots.map must be texture_2d, depth or shadow"));
    CHECK(refusal([&] {
              (void)bind(sun_in_shader, "sun", {.map = glsl::texture::texture_2d});
          }).starts_with("umbrage::glsl::bind: slots.map must be atlas, array, depth_array or shadow_array"));
    CHECK(refusal([&] {
              (void)bind(lamp_in_shader, "lamp", {.map = glsl::texture::shadow});
          }).starts_with("umbrage::glsl::bind: map.channels must be 1 for a depth texture"));
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
              (void)wgsl::text({bind(lamp_in_shader, "clamp_bias")});
          }).starts_with("umbrage::wgsl::text: name must be another than a snippet's"));
    const shadow soft(shadow_scene::spot(cpu_clip_space), {256, 256}, filters::pcss{});
    CHECK(refusal([&] {
              (void)bind(soft, "soft", {.map = glsl::texture::shadow});
          }).starts_with("umbrage::glsl::bind: map.receiver_plane must be false"));
    CHECK(refusal([&] { (void)glsl::text({lamp}); }).starts_with("umbrage::glsl::text: version must be given"));
}
