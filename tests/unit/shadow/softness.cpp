// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include <umbrage/shader/glsl.hpp>
#include <umbrage/shadow/in_shader.hpp>
#include <umbrage/shadow/softness.hpp>

#include "../special_values.hpp"
#include "scene.hpp"
#include "texts.hpp"

using namespace umbrage;
using shadow_texts::has;

namespace {

/// A floor, and a roof over the half of it where x is below 0.
const std::vector<glm::vec3> roof_positions{{-200, 0, -200}, {200, 0, -200}, {200, 0, 200}, {-200, 0, 200},
                                            {-200, 2, -200}, {0, 2, -200},   {0, 2, 200},   {-200, 2, 200}};
const std::vector<glm::uvec3> roof_triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
const mesh_view roof{roof_positions, roof_triangles};
const bounding_box<float> roof_bounds{{-200, 0, -200}, {200, 2, 200}};
constexpr glm::vec3 above(0, 1, 0);

/// Width of the roof's penumbra at a z, from 10 to 90 % of the light, world units.
/// @param exact   what it should be; the steps are a share of it
template <class Shadow>
float width_at(const Shadow& s, const image<float>& map, float z, float exact) {
    const auto seen = [&](float x) {
        float sum = 0;
        for (int i = 0; i < 16; ++i) sum += s(map, {x, 0, z}, above, {i % 4, i / 4});  // each rotation of the disc
        return sum / 16;
    };
    const float step = exact / 64;
    const auto first = [&](float share) {
        float x = -2 * exact;
        while (x < 2 * exact && seen(x) < share) x += step;
        return x;
    };
    return first(0.9f) - first(0.1f);
}

template <class Shadow>
void check_width(const Shadow& s, const image<float>& map, float z, float exact) {
    const glm::vec2 limits = s.penumbra_widths({0, 0, z}, above);
    CAPTURE(z);
    CAPTURE(limits.x);
    CAPTURE(limits.y);
    REQUIRE(exact > limits.x);
    REQUIRE(exact < limits.y);
    CHECK(width_at(s, map, z, exact) == doctest::Approx(exact).epsilon(0.1));
}

template <class Shadow>
image<float> roof_drawn(const Shadow& s) {
    image<float> map(s.size(), s.cleared());
    s.draw(map, roof);
    return map;
}

constexpr float edge = 1.374f;  // width of a disc's darkening from 10 to 90 %, in radii

/// A sun straight above, of the tangent of half its angle.
constexpr float tangent = 0.1f, sun_width = edge * 2 * tangent;

cascade_fit<float> walk(clip_space clip) {
    return {.camera =
                {.position = {0, 2, 90}, .direction = {0, 0, -1}, .up = above, .tan_half_x = 0.8f, .tan_half_y = 0.5f},
            .direction = {0, -1, 0},
            .up = {0, 0, 1},
            .scene = roof_bounds,
            .map_size = glm::ivec2(1024),
            .overlap = 0.1f,
            .clip = clip};
}

}  // namespace

TEST_CASE("map_softness: each of eight pairs") {
    glm::mat4 all;
    for (int i = 0; i < 16; ++i) all[i / 4][i % 4] = float(i);
    for (int i = 0; i < 8; ++i) CHECK(map_softness(all, float(i)) == glm::vec2(float(2 * i), float(2 * i + 1)));
}

TEST_CASE("softness: a sun's penumbras have one width in every cascade") {
    for (const clip_space clip : {cpu_clip_space, unity_clip_space}) {
        const filters::pcss filter{.points = 32, .softness = make_penumbra_params(tangent, 0.0f, 64.0f)};
        const std::array<float, 5> splits{0.5f, 4, 12, 32, 80};
        const cascade_fit<float> fit = walk(clip);
        const shadow sun(cascaded_maps(make_stable_cascades<4>(fit, splits), 0.0f), fit.map_size, filter);
        const auto map = roof_drawn(sun);
        for (int i = 0; i < 4; ++i) {
            CHECK(sun.filter_of(i).softness.per_code_x > 0);
            check_width(sun, map, 90 - 0.5f * (splits[std::size_t(i)] + splits[std::size_t(i) + 1]), sun_width);
        }
    }
}

TEST_CASE("softness: a sun's penumbras have one width in pages of every level") {
    const auto root = make_page_root<double>({.direction = {0, -1, 0},
                                              .up = {0, 0, 1},
                                              .side = 40,
                                              .scene = {glm::dvec3(roof_bounds.low), glm::dvec3(roof_bounds.high)},
                                              .clip = cpu_clip_space});
    const glm::mat4 to_root(page_matrix(root));
    std::vector<page_receiver> seen;
    for (float x = -20; x < 21; ++x)
        for (float z = -20; z < 21; ++z)
            seen.push_back(
                {glm::vec2(shadow_coordinate(to_root, glm::vec3(x, 0, z))), 40 / (1 + glm::length(glm::vec2(x, z)))});
    page_cache cache({.slots = {8, 8}, .deepest_level = 4});
    static_cast<void>(cache.update(seen));
    const adaptive_maps pages(root, cache, {.texels = 64, .gutter = 32});
    const shadow sun(pages, glm::ivec2(128),
                     filters::pcss{.points = 32, .softness = make_penumbra_params(tangent, 0.0f, 30.0f)});
    const auto map = roof_drawn(sun);
    float least = 1e9f, most = 0;
    for (const float z : {0.3f, 3.0f, 8.0f, 14.0f, 19.0f}) {
        const glm::vec2 limits = sun.penumbra_widths({0, 0, z}, above);
        least = glm::min(least, limits.x), most = glm::max(most, limits.x);
        if (sun_width > limits.x && sun_width < limits.y) check_width(sun, map, z, sun_width);
    }
    CHECK(most > 3.9f * least);
}

TEST_CASE("softness: a lamp's penumbras have the width of its radius") {
    const filters::pcss filter{.points = 32, .softness = make_penumbra_params(0.5f, 0.0f, 24.0f)};
    const float exact = edge * 0.5f * 2 / 6;  // 2 units behind a roof 6 units away
    const shadow spot(make_spot_light<float>({.position = {0, 8, 0},
                                              .direction = {0, -1, 0},
                                              .up = {0, 0, 1},
                                              .outer_angle_radians = 0.8f,
                                              .z_near = 1,
                                              .z_far = 60,
                                              .clip = cpu_clip_space}),
                      {512, 512}, filter);
    const shadow bulb(
        point_light<float>{
            .position = {0, 8, 0}, .z_near = 1, .z_far = 60, .map_size = 512, .border = 32, .clip = cpu_clip_space},
        {512, 512}, filter);
    const auto spot_map = roof_drawn(spot), bulb_map = roof_drawn(bulb);
    for (const float z : {0.0f, 3.0f, -4.0f}) {
        check_width(spot, spot_map, z, exact);
        check_width(bulb, bulb_map, z, exact);
    }
    const glm::vec4 first(bulb.filter_of(0).softness);
    CHECK(first == glm::vec4(bulb.filter_of(5).softness));
    CHECK(first == bulb.uniforms().terms.filter_terms);
}

TEST_CASE("softness: a light's matrices times a number are the same light") {
    const filters::pcss filter{.softness = make_penumbra_params(0.2f)};
    const auto of = [&](const light_space<float>& light) {
        return glm::vec4(shadow(light, {256, 256}, filter).filter_of(0).softness);
    };
    const auto spot = make_spot_light<float>(
        {.position = {2, 6, 3}, .direction = {-2, -6, -3}, .z_near = 0.5f, .z_far = 40, .clip = vulkan_clip_space});
    const glm::vec4 right = of(spot);
    CHECK(right.x > 0);
    for (const float scale : {0.01f, 0.125f, 100.0f}) {
        auto scaled = spot;
        scaled.projection *= scale;
        CHECK(of(scaled) == right);
        scaled = spot;  // a view that scales, with the planes of its projection
        scaled.view = glm::mat4(glm::mat3(scale)) * spot.view;
        scaled.view[3] = glm::vec4(glm::vec3(spot.view[3]) * scale, 1);
        scaled.projection[3][2] *= scale;
        CHECK(of(scaled) == right);
    }
}

TEST_CASE("softness: an origin changes none") {
    const auto fit = walk(cpu_clip_space);
    const shadow sun(make_stable_cascades<4>(fit, std::array<float, 5>{0.5f, 4, 12, 32, 80}), fit.map_size,
                     filters::pcss{.softness = make_penumbra_params(tangent)});
    const auto moved = sun.relative_to({30, -2, 50});
    for (int i = 0; i < 4; ++i) CHECK(glm::vec4(moved.filter_of(i).softness) == glm::vec4(sun.filter_of(i).softness));
    CHECK(moved.penumbra_widths(glm::vec3(0, 0, 85) - glm::vec3(30, -2, 50), above) ==
          sun.penumbra_widths({0, 0, 85}, above));
    CHECK(sun.penumbra_widths({0, 0, 500}, above) == glm::vec2(0));
}

TEST_CASE("softness: a text has a matrix for each eight maps, and none where maps are alike") {
    using namespace umbrage::glsl;
    const auto text = [](const auto& light, glm::ivec2 size, const auto& filter) {
        return glsl::text({bind(shadow(light, size, shadow_scene::sized(filter)), "s")}, version::v330);
    };
    const auto pages = text(shadow_scene::pages(opengl_clip_space), glm::ivec2(80), filters::pcss{});
    CHECK(has(pages, "mat4 umbrage_s_softness_7;"));
    CHECK(has(pages, "softness = number >= 56.0 ? umbrage_map_softness(softness_7, number - 56.0) : softness;"));
    const auto sun = text(shadow_scene::cascades(opengl_clip_space), glm::ivec2(256), filters::dpcf{});
    CHECK(has(sun, "mat4 umbrage_s_softness_0;"));
    CHECK_FALSE(has(sun, "softness_1"));
    CHECK_FALSE(has(text(shadow_scene::bulb(opengl_clip_space), glm::ivec2(256), filters::pcss{}), "softness_0"));
    CHECK_FALSE(has(text(shadow_scene::cascades(opengl_clip_space), glm::ivec2(256), filters::disc{}), "softness_0"));
}
