// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include <umbrage/depth/depth16.hpp>
#include <umbrage/shader/glsl.hpp>
#include <umbrage/shadow/in_shader.hpp>

#include "../scene.hpp"

using namespace umbrage;

TEST_CASE("depth16: an empty floor under cascades is lit, compared as a GPU compares") {
    const cascade_fit<float> fit{
        .camera = {.position = {0, 3, 12}, .direction = {0, -0.2f, -1}, .tan_half_x = 0.8f, .tan_half_y = 0.5f},
        .direction = {-0.2f, -6, -0.3f},
        .scene = {{-200, 0, -200}, {200, 4000, 200}},  // so deep that a step is more than a texel of the first cascade
        .overlap = 0.1f,
        .clip = {.range = depth_range::minus_one_to_one, .subpixel_bits = 8}};
    const auto cascades = make_stable_cascades<4>(fit, practical_splits<4>(0.5f, 60.0f, 0.9f));
    const std::vector<glm::vec3> corners{{-200, 0, -200}, {200, 0, -200}, {200, 0, 200}, {-200, 0, 200}};
    const std::vector<glm::uvec3> floor{{0, 1, 2}, {0, 2, 3}};
    const auto dark = [&](const auto& encoding) {
        const shadow sun(cascades, {1024, 1024}, filters::tent<3>, encoding);
        image<float> depths(sun.size(), cleared_depth(opengl_clip_space));
        sun.draw(depths, {corners, floor});
        image<typename std::decay_t<decltype(encoding)>::texel> map(sun.size());
        for (std::size_t i = 0; i < map.texels().size(); ++i) {
            const float sampled = depth16{}.decode(depth16{}.encode(depths.texels()[i]));  // what the texture holds
            map.texels()[i] = encoding.encode(sampled);
        }
        int count = 0;
        std::mt19937 random(1);
        std::uniform_real_distribution<float> any(-10, 10);
        for (int i = 0; i < 20000; ++i) count += sun(map, {any(random), 0, any(random)}, {0, 1, 0}) < 1;
        return count;
    };
    CHECK(dark(depth16{}) == 0);
    CHECK(dark(depth32f{}) > 100);  // its bias knows nothing of the texture's steps
}

TEST_CASE("depth16: comparison samplers read it, and no conversion is in the text") {
    const shadow one(shadow_scene::spot(cpu_clip_space), {256, 256}, filters::tent<3>, depth16{});
    const shadow same(shadow_scene::spot(cpu_clip_space), {256, 256}, filters::tent<3>);
    const auto text = [](const auto& of, glsl::texture kind) {
        return glsl::text({glsl::bind(of, "lamp", {.map = kind})}, glsl::version::v330);
    };
    CHECK(text(one, glsl::texture::shadow).find("sampler2DShadow") != std::string::npos);
    CHECK(text(one, glsl::texture::shadow) == text(same, glsl::texture::shadow));
    CHECK(text(one, glsl::texture::depth) == text(same, glsl::texture::depth));
    CHECK(one.uniforms().terms.error > same.uniforms().terms.error + 0x1p-18f);
}
