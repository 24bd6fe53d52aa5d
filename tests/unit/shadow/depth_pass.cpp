// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

#include <umbrage/depth/rg.hpp>
#include <umbrage/shader/hlsl.hpp>
#include <umbrage/shader/glsl.hpp>
#include <umbrage/shader/msl.hpp>
#include <umbrage/shader/wgsl.hpp>
#include <umbrage/shadow/depth_pass.hpp>

#include "scene.hpp"
#include "texts.hpp"

using namespace umbrage;
using glsl::version;
using shadow_texts::has;
using shadow_texts::refusal;

namespace {

const shadow packed_lamp(shadow_scene::spot(cpu_clip_space), {256, 256}, filters::tent<3>, rg<11>{});

}  // namespace

TEST_CASE("depth_pass: it writes the map's texels, packed or moments, in each language") {
    const auto packed = glsl::bind_depth_pass(packed_lamp, "lamp");
    CHECK(has(glsl::text({packed}, version::v330), "vec2 texel = umbrage_to_unorm(umbrage_encode_rg11_lamp(depth));"));
    CHECK(has(glsl::text({packed}, version::v330), "return vec4(texel.x, texel.y, 0.0, 0.0);"));
    CHECK(has(wgsl::text({packed}), "fn umbrage_write_lamp(depth: f32) -> vec4f {"));
    CHECK(has(hlsl::text({packed}), "float4 umbrage_write_lamp(float depth) {"));
    CHECK(has(msl::text({packed}), "float4 umbrage_write_lamp(float depth) {"));
    const shadow powers(shadow_scene::spot(unity_clip_space), {256, 256}, prefilters::evsm4{});
    const std::string text = wgsl::text({glsl::bind_depth_pass(powers, "powers"), packed});
    CHECK(has(text, "fn umbrage_write_powers(depth: f32, filter_terms: vec4f) -> vec4f {"));
    CHECK(has(text, "umbrage_encode_evsm4_powers(depth, vec2f(filter_terms.x, filter_terms.y))"));
    const shadow single(shadow_scene::spot(cpu_clip_space), {256, 256}, prefilters::esm{});
    CHECK(
        has(glsl::text({glsl::bind_depth_pass(single, "lamp")}, version::v330), "return vec4(texel, 0.0, 0.0, 0.0);"));
    const shadow turned(shadow_scene::spot(cpu_clip_space), {256, 256}, prefilters::msm_unorm16{});
    CHECK(has(glsl::text({glsl::bind_depth_pass(turned, "lamp")}, version::v330),
              "umbrage_to_optimized_moments(umbrage_encode_msm_lamp(depth))"));
    CHECK(refusal([&] {
              (void)glsl::bind_depth_pass(packed_lamp, "a b");
          }).starts_with("umbrage::glsl::bind_depth_pass: name must be letters"));
}

TEST_CASE("depth_pass: vertices of parallel lights are moved onto the near plane, of others they are a product") {
    const shadow sun(shadow_scene::fitted(opengl_clip_space), {256, 256}, filters::hard{});
    const std::string text = glsl::text({glsl::bind_vertex_pass(sun, "sun")}, version::v330);
    CHECK(has(text,
              "vec4 umbrage_vertex_sun(UMBRAGE_HIGHP mat4 to_clip, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec4 "
              "anchor) {"));
    CHECK(has(text, "return umbrage_pancake(umbrage_anchored_vertex(to_clip, world, anchor), -1.0);"));
    const shadow reversed(shadow_scene::cascades(unity_clip_space), {256, 256}, filters::hard{});
    CHECK(has(hlsl::text({glsl::bind_vertex_pass(reversed, "sun")}), "(to_clip, world, anchor), 1.0);"));
    const std::string plain = wgsl::text({glsl::bind_vertex_pass(packed_lamp, "lamp")});
    CHECK(has(plain, "fn umbrage_vertex_lamp(to_clip: mat4x4f, world: vec3f, anchor: vec4f) -> vec4f {"));
    CHECK(has(plain, "return umbrage_anchored_vertex(to_clip, world, anchor);"));
    const shadow halves(shadow_scene::paraboloids(cpu_clip_space), {512, 512}, filters::hard{});
    CHECK(has(msl::text({glsl::bind_vertex_pass(halves, "halves")}),
              "float4 umbrage_vertex_halves(metal::float4x4 to_clip, float3 world, float4 anchor, float number) {"));
    CHECK(refusal([&] {
              (void)glsl::bind_vertex_pass(packed_lamp, "");
          }).starts_with("umbrage::glsl::bind_vertex_pass: name must be letters"));
}

TEST_CASE("depth_pass: a light is directional where its rays are parallel, however it is warped or shifted") {
    for (const clip_space clip : {opengl_clip_space, unity_clip_space, cpu_clip_space}) {
        const shadow warped(shadow_scene::warped(clip), {256, 256}, filters::hard{});
        CHECK(has(glsl::text({glsl::bind_vertex_pass(warped, "sun")}, version::v330), "umbrage_pancake("));
        for (const float angle : {0.001f, 0.5f, 1.5f}) {
            light_space<float> spot =
                make_spot_light<float>({.outer_angle_radians = angle, .z_near = 1, .z_far = 20, .clip = clip});
            for (const float shift : {0.0f, 0.9f, 5.0f}) {
                spot.projection[2][0] = shift;  // off its axis
                const shadow lamp(spot, {256, 256}, filters::hard{});
                CHECK(has(glsl::text({glsl::bind_vertex_pass(lamp, "lamp")}, version::v330),
                          "return umbrage_anchored_vertex(to_clip, world, anchor);"));
            }
        }
    }
}
