// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/depth/render_target.hpp>

using namespace umbrage;

static_assert(render_target<float_target> && render_target<unorm_target<8, 2>> && render_target<unorm_target<10, 3>> &&
              render_target<unorm_target<16, 1>>);
static_assert(sizeof(unorm_target<8, 3>::texel) == 3 && sizeof(unorm_target<10, 3>::texel) == 4 &&
              sizeof(unorm_target<16, 2>::texel) == 4);

TEST_CASE("unorm_target: names as OpenGL has them") {
    CHECK(unorm_target<8, 2>::format == "RG8");
    CHECK(unorm_target<16, 1>::format == "R16");
    CHECK(unorm_target<10, 3>::format == "RGB10_A2");
}

TEST_CASE("render_target: depth textures hold floats, and integers of one channel of 16 or 24 bits") {
    CHECK(float_target::depth_format == "DEPTH_COMPONENT32F");
    CHECK(depth_texture<24>::depth_format == "DEPTH_COMPONENT24");
    CHECK(depth_texture<16>::depth_format == "DEPTH_COMPONENT16");
    CHECK(unorm_target<16, 1>::depth_format == "DEPTH_COMPONENT16");
    CHECK(unorm_target<8, 1>::depth_format.empty());
    CHECK(unorm_target<16, 2>::depth_format.empty());
    CHECK(unorm_target<10, 3>::depth_format.empty());
}

TEST_CASE("unorm_target: absent channels are sampled as 0, in memory R is the lowest") {
    CHECK(unorm_target<8, 2>::load({255, 0}) == glm::vec4(1, 0, 0, 0));
    CHECK(unorm_target<16, 1>::load(65535) == glm::vec4(1, 0, 0, 0));
    CHECK(unorm_target<10, 3>::store(glm::vec3(1, 0, 0)) == (0x3FFu | 3u << 30));
    CHECK(unorm_target<10, 3>::load(0x3FFu << 20) == glm::vec4(0, 0, 1, 0));
    CHECK(unorm_target<8, 3>::store(glm::vec3(0, 0.5f, 1), unorm_store::truncates) == glm::u8vec3(0, 127, 255));
}
