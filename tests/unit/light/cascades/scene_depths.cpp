// SPDX-License-Identifier: MIT
//
// Depths of stable cascades over scenes of any size: what a map can hold of the scene lies in its range of depths, and
// the range stays short and fixed while the camera moves. The oracle is points of the scene.
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <common/stability.hpp>

#include <umbrage/bias/constant.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/scene_depths.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../bodies.hpp"
#include "../clip_spaces.hpp"

using namespace umbrage;

namespace {

/// Depth range of a cascade, world units.
template <real T>
double range_of(const cascade<T>& c) {
    return 1 / std::abs(double(c.scale.z));
}
bool whole_steps(double depth) { return depth * 8 == std::round(depth * 8); }

}  // namespace

TEST_CASE("scene_depths: each map's part of the scene lies between its planes, in every convention") {
    std::mt19937 random(1);
    int held = 0, tall = 0;
    for (const clip_space clip : all_clip_spaces())
        for (int i = 0; i < 60; ++i) {
            const glm::dvec3 size = glm::exp(bodies::random_vector(random, -3, 8));
            const glm::dvec3 middle = bodies::random_vector(random, -1e4, 1e4);
            cascade_fit<double> fit{.direction = bodies::random_vector(random, -1, 1),
                                    .scene = {middle - size, middle + size},
                                    .map_size = {256, i % 2 ? 256 : 512},
                                    .clip = clip};
            fit.camera.position = middle + size * bodies::random_vector(random, -1.1, 1.1);
            fit.camera.direction = bodies::random_vector(random, -1, 1);
            const auto all = make_stable_cascades<3>(fit, practical_splits<3>(0.5, 60.0, 0.8));
            for (const auto& c : all) {
                CHECK(c.scale.z == all[0].scale.z);
                CHECK(whole_steps(c.offset.z));
                // the scene's points on lines along the light through the map
                const glm::dmat4 to_texels = texture_matrix(c.light, fit.map_size), from = glm::inverse(to_texels);
                for (int k = 0; k < 50; ++k) {
                    const glm::dvec2 at = glm::dvec2(bodies::random_vector(random, 0, 1)) * glm::dvec2(fit.map_size);
                    const glm::dvec3 begin(from * glm::dvec4(at, 0, 1)), end(from * glm::dvec4(at, 1, 1));
                    const glm::dvec3 along = end - begin;
                    double first = -1e30, last = 1e30;
                    for (glm::length_t a = 0; a < 3; ++a) {
                        const double low = (fit.scene.low[a] - begin[a]) / along[a],
                                     high = (fit.scene.high[a] - begin[a]) / along[a];
                        first = std::fmax(first, std::fmin(low, high)), last = std::fmin(last, std::fmax(low, high));
                    }
                    if (first > last) continue;
                    ++held, tall += last - first > 0.1;
                    CHECK(first > 0);
                    CHECK(last < 1);
                }
            }
        }
    CHECK(held > 20000);
    CHECK(tall > 2000);
}

TEST_CASE("make_stable_cascades: a sun straight above, whose direction has zeros of both signs") {
    for (const double x : {0.0, -0.0})
        for (const double z : {0.0, -0.0, 6e-17}) {
            const cascade_fit<double> fit{.camera = {.direction = {0, 0, -1}},
                                          .direction = {x, -1, z},
                                          .scene = {{-600, 0, -1000}, {600, 10, 200}},
                                          .clip = cpu_clip_space};
            const auto all = make_stable_cascades<2>(fit, {0.5, 10.0, 100.0});
            CHECK(range_of(all[0]) > 10);
            CHECK(range_of(all[0]) < 40);
        }
}

TEST_CASE_TEMPLATE("make_stable_cascades: a wide scene costs no depth, by the formula of its docstring", T, float,
                   double) {
    cascade_fit<T> fit{.camera = {.position = {0, 3, 12}, .direction = {0, T(-0.2), -1}},
                       .direction = {T(-2), T(-6), T(-3)},
                       .overlap = T(0.1),
                       .clip = cpu_clip_space};
    const auto splits = practical_splits<4>(T(0.5), T(60), T(0.9));
    const auto with = [&](T far, T height) {
        fit.scene = {glm::vec<3, T>(-far, T(0), -far), glm::vec<3, T>(far, height, far)};
        return make_stable_cascades<4>(fit, splits);
    };
    const auto wide = with(T(1e5), T(10));
    const glm::dmat4 view(wide[3].light.view);
    const double side = 2 / double(wide[3].light.projection[0][0]);
    const double range = (10 + side * (std::abs(view[1][0]) + std::abs(view[1][1]))) / std::abs(view[1][2]);
    const double whole = 8.0 / 7.0 * (range + std::sqrt(2 * side * side + range * range) / 128);
    CHECK(range_of(wide[0]) == doctest::Approx(whole).epsilon(1e-5));
    for (const T far : {T(1e6), T(1e7), T(1e12)}) CHECK(with(far, T(10))[3].scale.z == wide[3].scale.z);
    CHECK(range_of(with(T(8), T(1))[0]) < 30);                               // a small scene's own depths
    CHECK(range_of(with(T(1e5), T(1000))[0]) < 1.3 * 1000 * 7 / 6 + whole);  // a tall scene's, along the light
}

TEST_CASE("make_stable_cascades: a camera that walks over a wide ground changes nothing inside a map") {
    std::mt19937 random(5);
    const auto vector = [&] { return glm::vec3(bodies::random_vector(random, -1, 1)); };
    const glm::vec3 direction(0.8f, -1, 0.3f);
    const glm::mat4 rotation(look_along(glm::dvec3(0), glm::dvec3(direction), glm::dvec3(0, 1, 0), handedness::right));
    for (const glm::vec3 start : {glm::vec3(0), glm::vec3(8000, 0, -6000)})
        for (const clip_space clip : {vulkan_clip_space, clip_space{.range = depth_range::minus_one_to_one,
                                                         .direction = depth_direction::reversed,
                                                         .origin = texture_origin::top}}) {
            const glm::vec3 walk(120, 0, 40);  // over 200 frames
            std::vector<glm::vec3> positions, points;
            std::vector<glm::uvec3> triangles;
            const auto rotated = [&](glm::vec3 p) { return glm::vec3(shadow_coordinate(rotation, p)); };
            const auto quad = [&](glm::vec3 corner, glm::vec3 a, glm::vec3 b) {
                const auto n = static_cast<unsigned>(positions.size());
                for (const glm::vec3 p : {corner, corner + a, corner + a + b, corner + b})
                    positions.push_back(rotated(p));
                triangles.push_back({n, n + 1, n + 2}), triangles.push_back({n, n + 2, n + 3});
            };
            for (int i = -2; i < 18; ++i)
                for (int j = -8; j < 9; ++j) quad(start + glm::vec3(10 * i, 0, 10 * j), {10, 0, 0}, {0, 0, 10});
            for (int i = 0; i < 400; ++i) {
                const glm::vec3 at = start + glm::vec3(60, 3, 20) + vector() * glm::vec3(80, 2.5f, 40);
                quad(at, vector() * 2.0f, vector() * 2.0f);
            }
            for (int i = 0; i < 3000; ++i)
                points.push_back(rotated(start + glm::vec3(60, 0, 20) + vector() * glm::vec3(80, 0, 40)));

            const float texel = 2.0f * 40 / 256;  // more than a texel of the larger map, along the ground
            std::size_t partly = 0, dark = 0;
            std::vector<double> offsets;
            const auto report = example::measure_stability(200, points.size(), [&](int frame) {
                const float share = static_cast<float>(frame) / 200.0f, a = 0.61f * static_cast<float>(frame);
                cascade_fit<float> fit{.direction = direction,
                                       .scene = {{-1e6f, 0, -1e6f}, {1e6f, 10, 1e6f}},
                                       .map_size = {256, 256},
                                       .clip = clip};
                fit.camera.position = start + walk * share + glm::vec3(0, 2, 0);
                fit.camera.direction = glm::vec3(std::cos(a), -0.2f, std::sin(a));
                const auto all = make_stable_cascades<2>(fit, std::array{0.5f, 8.0f, 25.0f});
                std::vector<image<float>> maps;
                for (const auto& c : all) {
                    offsets.push_back(double(c.offset.z));
                    maps.emplace_back(glm::ivec2(256), cleared_depth(clip));
                    rasterize_depth(maps.back(), {positions, triangles}, c.light.projection, clip);
                }
                return [&, all, maps = std::move(maps)](std::size_t i) -> example::placed_point {
                    for (std::size_t k = 0; k < 2; ++k) {
                        const glm::vec3 at = cascade_coordinate(points[i], all[k].scale, all[k].offset);
                        if (!inside_cascade(at, glm::vec2(256), 1.5f)) continue;
                        const comparison is_lit{clip.direction};
                        const float receiver = biased(at.z, 2 * texel * std::abs(all[k].scale.z), clip.direction);
                        const float visibility = pcf_2x2(clamped(maps[k]), glm::vec2(at), receiver, is_lit);
                        partly += visibility > 0 && visibility < 1, dark += visibility == 0;
                        return {int(k), glm::dvec2(at), double(visibility)};
                    }
                    return {};
                };
            });
            CHECK(report.changed == 0);
            CHECK(report.compared > 1500);
            CHECK(report.drift <= 0x1p-14);  // as make_stable_cascades has it
            CHECK(partly > 1000);
            CHECK(dark > 1000);
            std::size_t moves = 0;
            for (std::size_t i = 2; i < offsets.size(); ++i) moves += offsets[i] != offsets[i - 2];
            CHECK(moves > 4);  // the depths did move
            for (const double offset : offsets) CHECK(whole_steps(offset));
        }
}
