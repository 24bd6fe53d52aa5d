// SPDX-License-Identifier: MIT
//
// Cascades that hold what they should: the oracle is points that the camera sees, and for the stable ones the same
// points in another frame.
#include <doctest/doctest.h>

#include <umbrage/light/cascades/cascades.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <common/stability.hpp>

#include <umbrage/draw/rasterize.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../../../fusing.hpp"
#include "../../bodies.hpp"
#include "../../clip_spaces.hpp"

using namespace umbrage;

namespace {

const bounding_box<double> scene{{-400, -5, -350}, {380, 60, 420}};

glm::dvec3 random_vector(std::mt19937& random) { return bodies::random_vector(random, -1, 1); }

/// A camera somewhere in the scene, and the light.
cascade_fit<double> random_fit(std::mt19937& random, clip_space clip) {
    cascade_fit<double> fit{.direction = random_vector(random), .scene = scene, .margin = 3.5, .clip = clip};
    fit.camera.position = random_vector(random) * 200.0;
    fit.camera.direction = random_vector(random);
    fit.camera.up = random_vector(random);
    const glm::dvec3 tangents = random_vector(random);
    fit.camera.tan_half_x = 0.7 + 0.5 * tangents.x;
    fit.camera.tan_half_y = 0.7 + 0.5 * tangents.y;
    const auto side = [&] { return random() % 2 ? 512 : 333; };
    fit.map_size.x = side(), fit.map_size.y = random() % 2 ? fit.map_size.x : 3 * side();
    fit.overlap = random() % 2 ? 0.25 : 0.0;
    return fit;
}

/// A point that the camera sees, x and y from -1 to 1 over the picture.
glm::dvec3 seen(const frustum<double>& camera, double x, double y, double depth) {
    const glm::dmat4 view = look_along(camera.position, camera.direction, camera.up, handedness::right);
    return glm::inverse(view) * glm::dvec4(x * camera.tan_half_x * depth, y * camera.tan_half_y * depth, -depth, 1.0);
}

/// Points of a cascade's part that lie outside of it, number of points tried, and difference of its two ways to texels.
struct found {
    int outside = 0, tried = 0;
    double apart = 0;
};
template <class Make>
found of_all_conventions(bool in_scene, Make make) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0, 1);
    found f;
    for (const clip_space clip : all_clip_spaces())
        for (int i = 0; i < 20; ++i) {
            const auto fit = random_fit(random, clip);
            const auto splits = practical_splits<3>(0.5, 150.0, 0.8);
            const std::array<cascade<double>, 3> all = make(fit, splits);
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dmat4 m = texture_matrix(all[k].light, fit.map_size);
                const double from = k ? splits[k] - fit.overlap * (splits[k] - splits[k - 1]) : splits[0];
                for (int j = 0; j < 60; ++j) {
                    const bool corner = j < 8;
                    const glm::dvec3 any = random_vector(random);
                    const double x = corner ? (j & 1) * 2 - 1 : any.x, y = corner ? (j & 2) - 1 : any.y;
                    const double at = corner ? (j & 4) / 4 : share(random);
                    const glm::dvec3 p = seen(fit.camera, x, y, from + (splits[k + 1] - from) * at);
                    const bool inside =
                        glm::all(glm::lessThanEqual(scene.low, p)) && glm::all(glm::lessThanEqual(p, scene.high));
                    if (in_scene && !inside) continue;
                    const glm::dvec3 rotated(all[k].light.view * glm::dvec4(p, 1));
                    const glm::dvec3 texel = cascade_coordinate(rotated, all[k].scale, all[k].offset);
                    // depths are the scene's: those of other points may be any
                    const glm::dvec3 held(texel.x, texel.y, inside ? texel.z : 0.5);
                    f.outside += !inside_cascade(held, glm::dvec2(fit.map_size), fit.margin);
                    ++f.tried;
                    const glm::dvec3 by_matrix = through(m, p);
                    for (glm::length_t a = 0; a < 3; ++a) f.apart = worse(f.apart, std::abs(texel[a] - by_matrix[a]));
                }
            }
        }
    return f;
}

}  // namespace

TEST_CASE("make_stable_cascades: each holds its part of the frustum and its filter, in every convention") {
    const found f = of_all_conventions(false, [](const auto& fit, const auto& splits) {
        const auto all = make_stable_cascades<3>(fit, splits);
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(all[k].begin == splits[k]);
            CHECK(all[k].end == splits[k + 1]);
            CHECK(std::abs(all[k].scale.x) == doctest::Approx(std::abs(all[k].scale.y)).epsilon(1e-14));  // squares
        }
        return all;
    });
    CHECK(f.outside == 0);
    CHECK(f.apart < 1e-8);
}

TEST_CASE("make_tight_cascades: each holds what its part of the frustum has of the scene, in every convention") {
    const found f = of_all_conventions(true, [](const auto& fit, const auto& splits) {
        const auto tight = make_tight_cascades<3>(fit, splits), stable = make_stable_cascades<3>(fit, splits);
        for (std::size_t k = 0; k < 3; ++k)
            for (glm::length_t i = 0; i < 2; ++i)
                CHECK(std::abs(tight[k].scale[i]) >= 0.95 * std::abs(stable[k].scale[i]));
        return tight;
    });
    CHECK(f.outside == 0);
    CHECK(f.tried > 5000);
    CHECK(f.apart < 1e-8);
}

TEST_CASE_TEMPLATE("make_stable_cascades: 3 km out, points move by whole texels, their depths by eighths", T, float,
                   double) {
    std::mt19937 random(3);
    const glm::dvec3 middle(3000, 20, -3000);
    std::vector<glm::vec<3, T>> points, first;
    for (int i = 0; i < 200; ++i) points.push_back(glm::vec<3, T>(middle + 15.0 * random_vector(random)));
    std::vector<glm::dvec3> first_by_matrix;
    double by_matrix = 0, farthest = 0;
    for (int frame = 0; frame < 100; ++frame) {
        const double a = 0.37 * frame;
        cascade_fit<T> fit{.direction = {T(0.3), T(-1), T(0.2)},
                           .scene = {glm::vec<3, T>(middle - 500.0), glm::vec<3, T>(middle + 500.0)},
                           .clip = cpu_clip_space};
        fit.camera.position = glm::vec<3, T>(middle + 5.0 * random_vector(random));
        fit.camera.direction = glm::vec<3, T>(glm::dvec3(std::cos(a), 0.3 * std::sin(3 * a), std::sin(a)));
        fit.camera.tan_half_x = fit.camera.tan_half_y = T(0.6);
        const auto cascade = make_stable_cascades<2>(fit, std::array{T(0.5), T(12), T(40)})[1];  // 36 m
        const glm::mat<4, 4, T> m = texture_matrix(cascade.light, {1024, 1024});
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::vec<3, T> rotated(shadow_coordinate(cascade.light.view, points[i]));
            const glm::vec<3, T> at = cascade_coordinate(rotated, cascade.scale, cascade.offset);
            const glm::dvec3 other(shadow_coordinate(m, points[i]));
            if (frame == 0) first.push_back(at), first_by_matrix.push_back(other);
            const glm::vec<3, T> moved = at - first[i];
            // cascade_coordinate is tier B: fused, each of the two coordinates rounds once more
            const glm::vec<3, T> off = glm::abs(moved - glm::round(moved));
            const glm::vec<3, T> bound = glm::max(glm::abs(at), glm::abs(first[i])) * std::numeric_limits<T>::epsilon();
            CHECK(off.x <= (may_fuse ? bound.x : T(0)));
            CHECK(off.y <= (may_fuse ? bound.y : T(0)));
            const T off_step = std::abs(moved.z - std::round(moved.z * T(8)) / T(8));
            CHECK(off_step <= (may_fuse ? bound.z : std::numeric_limits<T>::epsilon() / 2));
            farthest = worse(farthest, std::abs(double(moved.x)));
            for (glm::length_t axis = 0; axis < 2; ++axis)
                by_matrix = worse(by_matrix, std::abs(other[axis] - first_by_matrix[i][axis] - double(moved[axis])));
        }
    }
    CHECK(farthest > 100);
    CHECK(by_matrix < (sizeof(T) == 4 ? 0.01 : 1e-9));
}

TEST_CASE("make_stable_cascades: depths are the scene's alone, one scale for all, while the camera leaves the scene") {
    cascade_fit<float> fit{.camera = {.position = {0, 2, 8}, .direction = {0, -1, -4}, .tan_half_x = 0.8f},
                           .direction = {-2, -6, -3},
                           .scene = {{-4, 0, -4}, {4, 0.3f, 4}},
                           .overlap = 0.1f,
                           .clip = cpu_clip_space};
    const auto splits = practical_splits<4>(0.5f, 30.0f, 0.9f);
    const auto first = make_stable_cascades<4>(fit, splits);
    for (int step = 0; step < 1000; ++step) {
        fit.camera.position.z -= 0.01f;
        const auto now = make_stable_cascades<4>(fit, splits);
        for (std::size_t i = 0; i < 4; ++i) {
            CHECK(now[i].scale == first[i].scale);
            CHECK(now[i].scale.z == first[0].scale.z);
            CHECK(now[i].offset.z == first[0].offset.z);
            for (glm::length_t axis = 0; axis < 2; ++axis)
                CHECK(now[i].offset[axis] == std::round(now[i].offset[axis]));
        }
    }
    for (const glm::dvec3& corner : corners(fit.scene)) {
        const glm::vec3 rotated(first[0].light.view * glm::vec4(glm::vec3(corner), 1));
        const float depth = cascade_coordinate(rotated, first[0].scale, first[0].offset).z;
        CHECK((depth > 0 && depth < 1));
    }
}

TEST_CASE("make_stable_cascades: what a map shows of fixed points never changes while the camera moves and turns") {
    std::mt19937 random(4);
    const glm::vec3 middle(2900, 10, 1700), direction(0.4f, -1, 0.3f);
    const auto vector = [&] { return glm::vec3(random_vector(random)); };
    const glm::mat4 rotation(look_along(glm::dvec3(0), glm::dvec3(direction), glm::dvec3(0, 1, 0), handedness::right));
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    for (unsigned i = 0; i < 300; ++i) {
        const glm::vec3 at = middle + vector() * glm::vec3(20, 5, 20);
        for (int k = 0; k < 3; ++k) positions.push_back(glm::vec3(shadow_coordinate(rotation, at + 2.0f * vector())));
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    std::vector<glm::vec3> points;
    for (int i = 0; i < 4000; ++i)
        points.push_back(glm::vec3(shadow_coordinate(rotation, middle + vector() * glm::vec3(25, 8, 25))));

    for (const clip_space clip : {vulkan_clip_space, clip_space{.range = depth_range::minus_one_to_one,
                                                     .direction = depth_direction::reversed,
                                                     .origin = texture_origin::top}}) {
        std::size_t partly = 0;
        const example::stability_report r = example::measure_stability(12, points.size(), [&](int frame) {
            const float a = 0.61f * static_cast<float>(frame);
            cascade_fit<float> fit{.direction = direction,
                                   .scene = {middle - 60.0f, middle + 60.0f},
                                   .map_size = {256, 256},
                                   .clip = clip};
            fit.camera.position = middle + vector() * 6.0f;
            fit.camera.direction = glm::vec3(std::cos(a), -0.2f, std::sin(a));
            const auto cascade = make_stable_cascades<1>(fit, std::array{0.5f, 15.0f})[0];
            CHECK(cascade.light.view == rotation);
            image<float> map({256, 256}, cleared_depth(clip));
            rasterize_depth(map, {positions, triangles}, cascade.light.projection, clip);
            return [&, cascade, map = std::move(map)](std::size_t i) -> example::placed_point {
                const glm::vec3 at = cascade_coordinate(points[i], cascade.scale, cascade.offset);
                if (!inside_cascade(at, glm::vec2(256), 1.5f)) return {};
                const float visibility = pcf_2x2(clamped(map), glm::vec2(at), at.z, comparison{clip.direction});
                partly += visibility > 0.0f && visibility < 1.0f;
                return {0, glm::dvec2(at), double(visibility)};
            };
        });
        CHECK(r.drift <= (may_fuse ? 256 * 0x1p-23 : 0));  // as above, on a map of 256 texels
        CHECK(r.changed == 0);
        CHECK(r.compared > 2000);
        CHECK(partly > 300);
    }
}
