// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <umbrage/draw/rasterize.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/four_tap.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "clip_spaces.hpp"

using namespace umbrage;

namespace {

double ulp(double v) { return std::ldexp(1.0, std::ilogb(v) - 23); }

/// Spot and directional lights around the origin by turns, random but for the convention.
light_space<float> random_light(std::mt19937& random, int i, clip_space clip = cpu_clip_space) {
    std::uniform_real_distribution<float> coordinate(-10, 10), angle(0.1f, 1.3f);
    const glm::vec3 position(coordinate(random), coordinate(random), coordinate(random));
    const glm::vec3 direction = glm::vec3(coordinate(random), coordinate(random), coordinate(random)) * 0.3f - position;
    if (i % 2)
        return make_spot_light<float>(
            {.position = position, .direction = direction, .outer_angle_radians = angle(random), .clip = clip});
    return fit_directional_light<float>(
        {.direction = direction, .receivers = bounding_box<float>{glm::vec3(-6), glm::vec3(7)}, .clip = clip});
}

}  // namespace

TEST_CASE("texture_matrix: NDC to texels and depth by hand") {
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const glm::dmat4 m = texture_matrix(light_space<double>{glm::dmat4(1), glm::dmat4(1), clip}, {8, 4});
        const bool top = clip.origin == texture_origin::top, zo = clip.range == depth_range::zero_to_one;
        CHECK(through(m, {-1, -1, 0.5}) == glm::dvec3(0, top ? 4 : 0, zo ? 0.5 : 0.75));
        CHECK(through(m, {1, 1, 1}) == glm::dvec3(8, top ? 0 : 4, 1));
        CHECK(through(m, {0.25, 0.5, zo ? 0 : -1}) == glm::dvec3(5, top ? 1 : 3, 0));
    }
}

TEST_CASE("texture_matrix: to normalized coordinates, times the size it gives that of any map") {
    std::mt19937 random(6);
    for (clip_space clip : all_clip_spaces())
        for (int i = 0; i < 20; ++i) {
            const auto light = random_light(random, i, clip);
            const glm::mat4 uv = texture_matrix(light, {1, 1});
            // a power of two changes no digits, any other size rounds
            const glm::mat4 power = texture_matrix(light, {1024, 512}), any = texture_matrix(light, {1000, 37});
            const light_space<double> exact{glm::dmat4(light.view), glm::dmat4(light.projection), clip};
            const glm::dmat4 exact_uv = texture_matrix(exact, {1, 1}), exact_any = texture_matrix(exact, {1000, 37});
            for (int c = 0; c < 4; ++c) {
                CHECK(power[c] == uv[c] * glm::vec4(1024, 512, 1, 1));
                CHECK(glm::length(glm::dvec4(any[c]) - exact_any[c]) <= 1e-6 * (1000 + glm::length(exact_any[c])));
                CHECK(glm::length(exact_uv[c] * glm::dvec4(1000, 37, 1, 1) - exact_any[c]) <
                      1e-12 * (1 + glm::length(exact_any[c])));
            }
        }
}

TEST_CASE_TEMPLATE("texture_matrix: bad input", T, float, double) {
    const auto light = make_spot_light<T>({.clip = cpu_clip_space});
    for (glm::ivec2 size : {glm::ivec2(0, 1), glm::ivec2(1, 0), glm::ivec2(0, 0), glm::ivec2(-1, 5), glm::ivec2(5, -1)})
        CHECK_THROWS_AS((void)texture_matrix(light, size), std::invalid_argument);
    CHECK_NOTHROW((void)texture_matrix(light, {1, 1}));
}

TEST_CASE("texture_matrix, tap_matrices: finite, or an error that names the arguments") {
    const auto light = make_spot_light<float>(
        {.position = {1e37f, 0, 0}, .clip = cpu_clip_space});  // a matrix for NDC, none for 1024 texels
    CHECK(complaint([&] { (void)texture_matrix(light, {1, 1}); }).empty());
    CHECK(complaint([&] {
              (void)texture_matrix(light, {1024, 1024});
          }).starts_with("umbrage::texture_matrix: light and map_size "));
    CHECK(complaint([&] { (void)texture_matrix(light, {0, 1024}); }).starts_with("umbrage::texture_matrix: map_size "));
    light_space<float> broken{.clip = cpu_clip_space};
    broken.view[3][0] = std::numeric_limits<float>::quiet_NaN();
    CHECK(complaint([&] { (void)texture_matrix(broken, {1, 1}); }).starts_with("umbrage::texture_matrix: light "));

    glm::mat4 m(1);
    m[3][0] = m[3][3] = 3e38f;
    CHECK(complaint([&] { (void)tap_matrices(m, {{{-1, 0}, {0, 0}, {0, 0}, {0, 0}}}); }).empty());
    CHECK(complaint([&] {
              (void)tap_matrices(m, {{{-1, 0}, {0, 0}, {0, 0}, {0.5f, 0}}});
          }).starts_with("umbrage::tap_matrices: texture_matrix and offsets "));
}

TEST_CASE("tap_matrices: exact arithmetic cannot tell them from offsets after the division") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> coordinate(-6, 6), offset(-8, 8);
    double worst = 0;
    int tried = 0;
    for (int i = 0; i < 200; ++i) {
        const auto light = random_light(random, i);
        const glm::dmat4 m(texture_matrix(light, {1024, 1024}));
        std::array<glm::dvec2, 4> offsets = default_taps<double>;
        if (i % 3)
            for (auto& o : offsets) o = {offset(random), offset(random)};
        const auto taps = i % 3 ? tap_matrices(m, offsets) : tap_matrices(m);
        for (int k = 0; k < 50; ++k) {
            const glm::dvec3 world(coordinate(random), coordinate(random), coordinate(random));
            const glm::dvec4 h = shadow_coordinate(m, world);
            if (h.w < 0.1) continue;
            const glm::dvec3 middle = project_coordinate(h);
            for (std::size_t tap = 0; tap < 4; ++tap) {
                const glm::dvec3 expected = middle + glm::dvec3(offsets[tap], 0);
                const double scale = 1000 + glm::length(expected);
                worst = worse(worst,
                              glm::length(project_coordinate(shadow_coordinate(taps[tap], world)) - expected) / scale);
                worst =
                    worse(worst, glm::length(project_coordinate(tap_coordinate(h, offsets[tap])) - expected) / scale);
                ++tried;
            }
        }
    }
    CHECK(tried > 10000);
    CHECK(worst < 1e-13);
}

TEST_CASE("tap_matrices: the stated gap in binary32") {
    std::mt19937 random(8);
    std::uniform_real_distribution<float> coordinate(-6, 6), offset(-8, 8);
    double worst_matrix = 0, worst_coordinate = 0;
    int tried = 0, depth_changed = 0;
    for (int i = 0; i < 800; ++i) {
        const glm::mat4 m = texture_matrix(random_light(random, i), {1024, 1024});
        std::array<glm::vec2, 4> offsets = default_taps<float>;
        if (i % 4 > 1)
            for (auto& o : offsets) o = {offset(random), offset(random)};
        const auto taps = tap_matrices(m, offsets);
        for (int k = 0; k < 500; ++k) {
            const glm::vec3 world(coordinate(random), coordinate(random), coordinate(random));
            const glm::vec4 h = shadow_coordinate(m, world);
            const glm::vec3 middle = project_coordinate(h);
            if (!(middle.x > 0 && middle.x < 1024 && middle.y > 0 && middle.y < 1024)) continue;
            ++tried;
            for (std::size_t tap = 0; tap < 4; ++tap) {
                const glm::vec3 by_matrix = project_coordinate(shadow_coordinate(taps[tap], world));
                const glm::vec3 by_coordinate = project_coordinate(tap_coordinate(h, offsets[tap]));
                for (int row = 0; row < 2; ++row) {
                    const double o = offsets[tap][row], expected = double(middle[row]) + o;
                    double added = std::abs(double(m[3][row]));
                    for (int c = 0; c < 3; ++c) added += std::abs(double(m[c][row]) * double(world[c]));
                    worst_matrix = worse(worst_matrix, std::abs(by_matrix[row] - expected) / ulp(added / h.w));
                    const double greatest = std::max({double(middle[row]), std::abs(o), std::abs(expected)});
                    worst_coordinate = worse(worst_coordinate, std::abs(by_coordinate[row] - expected) / ulp(greatest));
                }
                depth_changed += by_coordinate.z != middle.z || by_matrix.z != middle.z;
            }
        }
    }
    MESSAGE("worst of " << tried << " points: tap_matrices " << worst_matrix << " ulp, tap_coordinate "
                        << worst_coordinate << " ulp");
    CHECK(tried > 50000);
    CHECK(depth_changed == 0);
    CHECK(worst_matrix < 6);
    CHECK(worst_coordinate < 3);
}

TEST_CASE("tap_coordinate, tap_matrices: by hand") {
    CHECK(tap_coordinate(glm::vec4(8, 16, 3, 4), glm::vec2(0.5f, -1)) == glm::vec4(10, 12, 3, 4));
    glm::mat4 m(1);
    m[2][3] = 2;  // w = 2 z + 1
    const auto taps = tap_matrices(m, {{{1, 0}, {0, 1}, {3, -4}, {0, 0}}});
    const glm::vec3 world(5, 6, 7);  // w = 15
    CHECK(shadow_coordinate(taps[0], world) == glm::vec4(5 + 15, 6, 7, 15));
    CHECK(shadow_coordinate(taps[1], world) == glm::vec4(5, 6 + 15, 7, 15));
    CHECK(shadow_coordinate(taps[2], world) == glm::vec4(5 + 45, 6 - 60, 7, 15));
    CHECK(taps[3] == m);
}

TEST_CASE("shadow_coordinate: near GLM's product, which adds in another order") {
    std::mt19937 random(9);
    std::uniform_real_distribution<float> coordinate(-6, 6);
    for (int i = 0; i < 200; ++i) {
        const glm::mat4 m = texture_matrix(random_light(random, i), {1024, 1024});
        const glm::vec3 world(coordinate(random), coordinate(random), coordinate(random));
        const glm::dvec4 exact = glm::dmat4(m) * glm::dvec4(world, 1);
        const glm::vec4 got = shadow_coordinate(m, world);
        for (int row = 0; row < 4; ++row) {
            double added = std::abs(m[3][row]);
            for (int c = 0; c < 3; ++c) added += std::abs(m[c][row] * world[c]);
            CHECK(std::abs(got[row] - exact[row]) <= 4 * added * std::ldexp(1.0, -24));
        }
    }
}

TEST_CASE_TEMPLATE("project_coordinate: division in front of the light, lit by every filter elsewhere", T, float,
                   double) {
    using vec4 = glm::vec<4, T>;
    using vec3 = glm::vec<3, T>;
    CHECK(project_coordinate(vec4(6, 8, 1, 4)) == vec3(1.5, 2, 0.25));
    CHECK(project_coordinate(vec4(-6, 8, 1, 0.5)) == vec3(-12, 16, 2));
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    for (T w : {T(0), T(-0.0), T(-1), -infinity, nan, -nan}) {
        const vec3 p = project_coordinate(vec4(6, 8, 1, w));
        CHECK(p == vec3(65536, 65536, 0));
        const auto dark = [](glm::ivec2) { return T(-1); };
        const glm::vec<2, T> coord(p);
        CHECK(hard(dark, coord, T(1)) == 1);
        CHECK(pcf_2x2(dark, coord, T(1)) == 1);
        CHECK(pcf_2x2_dx_sdk(dark, coord, T(1), T(0)) == 1);
        CHECK(four_tap(dark, coord, coord, coord, coord, T(1)) == 1);
        CHECK(box(dark, coord, T(1), 8) == 1);
    }
    CHECK(project_coordinate(vec4(1, 2, 3, infinity)) == vec3(0, 0, 0));
}

TEST_CASE("texture_matrix: lands on the texel and the depth that the rasterizer wrote, in every convention") {
    const std::array positions{glm::vec3(-2, 0.5f, -1.5f), glm::vec3(2.5f, -0.5f, -1), glm::vec3(-1, 0.3f, 2)};
    const std::array triangles{glm::uvec3(0, 1, 2)};
    const glm::dvec3 a(positions[0]), b(positions[1]), c(positions[2]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const glm::ivec2 size(160, 120);

    for (clip_space clip : all_clip_spaces())
        for (int kind = 0; kind < 3; ++kind) {
            CAPTURE(to_string(clip));
            CAPTURE(kind);
            const light_space<float> light =
                kind == 0 ? make_spot_light<float>({.position = {1, 4, -2},
                                                    .direction = {-0.7f, -4, 1.8f},
                                                    .outer_angle_radians = 0.7f,
                                                    .z_near = 1,
                                                    .z_far = 9,
                                                    .clip = clip})
                : kind == 1
                    ? make_directional_light<float>({.direction = {0.3f, -1, 0.2f},
                                                     .map_size = {60, 60},
                                                     .texels_per_unit = 10,
                                                     .z_near = 1,
                                                     .z_far = 20,
                                                     .clip = clip})
                    : fit_directional_light<float>({.direction = {0, -1, 0},
                                                    .receivers = bounding_box<float>{{-2.5f, -1, -2}, {3, 1, 3}},
                                                    .clip = clip});
            image<float> map(size, cleared_depth(clip));
            rasterize_depth(map, {positions, triangles}, light.projection * light.view, clip);

            const glm::mat4 m = texture_matrix(light, size);
            // Each texel's center and depth, back in the world, is on the triangle: in its plane, inside but for the
            // vertices' snapping to 1/256 texel.
            const glm::dmat4 back = glm::inverse(glm::dmat4(m));
            double worst_height = 0, worst_outside = 0;
            int covered = 0;
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    if (map[{x, y}] == cleared_depth(clip)) continue;
                    ++covered;
                    const glm::dvec3 p = through(back, {x + 0.5, y + 0.5, map[{x, y}]});
                    worst_height = worse(worst_height, std::abs(glm::dot(p - a, glm::normalize(normal))));
                    const double area = glm::dot(normal, normal);
                    for (double weight : {glm::dot(glm::cross(b - a, p - a), normal) / area,
                                          glm::dot(glm::cross(c - b, p - b), normal) / area,
                                          glm::dot(glm::cross(a - c, p - c), normal) / area})
                        worst_outside = worse(worst_outside, -weight);
                }
            CHECK(covered > 1000);
            CHECK(worst_height < 1e-4);
            CHECK(worst_outside < 1e-3);

            // And the way there: points of the triangle fall on covered texels, each at the depth of its plane.
            std::mt19937 random(10);
            std::uniform_real_distribution<float> weight(0.05f, 0.45f);
            double worst_depth = 0;
            int missed = 0;
            for (int i = 0; i < 500; ++i) {
                const float u = weight(random), v = weight(random);
                const glm::vec3 world = positions[0] * (1 - u - v) + positions[1] * u + positions[2] * v;
                const glm::vec3 p = project_coordinate(shadow_coordinate(m, world));
                const glm::ivec2 texel(glm::floor(glm::vec2(p)));
                const float stored = map[texel];
                missed += stored == cleared_depth(clip);
                // the neighbors say how steep the depth is
                const double slope = std::abs(map[texel + glm::ivec2(1, 0)] - map[texel - glm::ivec2(1, 0)]) / 2 +
                                     std::abs(map[texel + glm::ivec2(0, 1)] - map[texel - glm::ivec2(0, 1)]) / 2;
                worst_depth = worse(worst_depth, std::abs(stored - p.z) - slope * 0.51);
            }
            CHECK(missed == 0);
            CHECK(worst_depth < 2e-5);
        }
}
