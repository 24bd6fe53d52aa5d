// SPDX-License-Identifier: MIT
//
// A shadow map from light to picture, through every function over images; and a shadow's text in every language.
#include <umbrage/umbrage.hpp>

#include <array>
#include <cstdint>
#include <string>

bool shadows();  // main.cpp calls it

namespace {

const glm::ivec2 map_size(64, 64), size(80, 48);

/// Share of the plane below the square that lies in its shadow.
template <class Encoding, class Filter>
float shadow(const umbrage::image<float>& depth, const umbrage::image<glm::vec3>& receivers, Encoding encoding,
             Filter filter) {
    umbrage::image<typename Encoding::texel> map(depth.size());
    umbrage::image<float> decoded(depth.size()), lit(receivers.size());
    umbrage::encode(depth.view(), map.view(), encoding);
    umbrage::decode(map.view(), decoded.view(), encoding);
    umbrage::visibility(map.view(), encoding, receivers.view(), filter, lit.view());
    float sum = 0.0f;
    for (const float v : lit.texels()) sum += 1.0f - v;
    return sum / float(size.x * size.y);
}

std::string texts(const umbrage::light_space<float>& light) {
    const umbrage::shadow spot(light, map_size, umbrage::filters::tent<3>, umbrage::rg<11>{});
    const auto lookup = umbrage::glsl::bind(spot, "spot");
    return umbrage::glsl::source(umbrage::glsl::version::v450, {lookup}) + umbrage::hlsl::text({lookup}) +
           umbrage::msl::text({lookup}) + umbrage::wgsl::text({lookup});
}

}  // namespace

bool shadows() {
    const std::array<glm::vec3, 4> square{{{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}}};
    const std::array<glm::uvec3, 2> triangles{{{0, 1, 2}, {0, 2, 3}}};
    const auto spot = umbrage::make_spot_light(
        {.position = {0, 5, 0}, .direction = {0, -1, 0}, .z_near = 1, .clip = umbrage::cpu_clip_space});
    const auto sun = umbrage::make_directional_light(
        {.direction = {0, -1, 0}, .map_size = map_size, .z_far = 20, .clip = umbrage::cpu_clip_space});

    bool ok = texts(spot).find("umbrage_spot(") != std::string::npos;
    for (const umbrage::light_space<float>& light : {spot, sun}) {
        umbrage::image<float> depth(map_size, umbrage::cleared_depth(light.clip));
        umbrage::rasterize_depth(depth.view(), {square, triangles}, light.projection * light.view, light.clip);

        const glm::mat4 m = umbrage::texture_matrix(light, map_size);
        umbrage::image<glm::vec3> receivers(size);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::vec3 world(0.05f * float(x) - 2.0f, 0.0f, 0.05f * float(y) - 1.2f);
                const glm::vec4 c = umbrage::shadow_coordinate(m, world);
                receivers[{x, y}] = umbrage::project_coordinate(c) - glm::vec3(0, 0, 0.01f);
            }
        const float expected = shadow(depth, receivers, umbrage::depth32f{}, umbrage::filters::hard{});
        const auto near = [&](float share) { return share > 0.8f * expected && share < 1.2f * expected; };
        ok = ok && expected > 0.1f && expected < 0.9f;
        umbrage::for_each_encoding([&](const auto& encoding) {  // foreign ones may lose the far plane: more shadow
            ok = ok && shadow(depth, receivers, encoding, umbrage::filters::pcf_2x2{}) > 0.8f * expected;
        });
        ok = ok && near(shadow(depth, receivers, umbrage::rg<11>{}, umbrage::filters::four_tap{})) &&
             near(shadow(depth, receivers, umbrage::float_bits{}, umbrage::filters::box{.radius = 2}));

        umbrage::image<float> blurred(map_size);
        umbrage::blur(depth.view(), blurred.view(), umbrage::make_gaussian_kernel(7, 1.5f));
        umbrage::image<std::uint32_t> sums(map_size), ones(map_size, 1u);
        umbrage::summed_area(ones.view(), sums.view());
        const auto pyramid = umbrage::make_min_max_pyramid(depth.view(), 6);
        ok = ok && umbrage::box_sum(sums.view(), {0, 0}, {7, 3}) == 32 && pyramid.back().least.size() == glm::ivec2(1);

        umbrage::image<glm::u8vec3> picture(size);
        umbrage::overlay(picture.view(), depth.view(), {.size = {32, 32}}, umbrage::stretch(depth.view()));
    }
    return ok;
}
