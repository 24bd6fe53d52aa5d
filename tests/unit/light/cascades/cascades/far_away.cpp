// SPDX-License-Identifier: MIT
//
// Worlds far from their origin: points told from one origin in one frame, from another in the next.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/cascades/warped.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>

#include "../../bodies.hpp"
#include "../../clip_spaces.hpp"

using namespace umbrage;

namespace {

constexpr double distances[]{0, 1e4, 1e6};  // from the world's origin

/// A frame near a place in the world: a camera, and an origin near it.
struct frame {
    glm::dvec3 middle, origin;
    frustum<double> camera;
    bounding_box<double> scene;
    glm::dvec3 direction{0.4, -0.8, 0.3};

    frame(double distance, std::mt19937& random)
        : middle(distance * glm::dvec3(0.8, 0.01, -0.6)),
          origin(middle + bodies::random_vector(random, -350, 350)),
          camera{.position = middle + bodies::random_vector(random, -5, 5),
                 .direction = bodies::random_vector(random, -1, 1),
                 .z_near = 0.5,
                 .z_far = 40},
          scene{middle - 300.0, middle + 300.0} {}

    [[nodiscard]] auto cascades(clip_space clip) const {
        return make_stable_cascades<2>(
            cascade_fit<double>{
                .camera = camera, .direction = direction, .scene = scene, .map_size = {1024, 512}, .clip = clip},
            std::array{0.5, 12.0, 40.0});
    }
};

double off_grid(double texels) { return std::abs(texels - std::round(texels)); }

}  // namespace

TEST_CASE("relative_to: in stable cascades a point keeps its place in its texel, whatever the origin, and its depth") {
    std::mt19937 random(1);
    for (const double distance : distances)
        for (const clip_space clip : all_clip_spaces()) {
            CAPTURE(distance);
            CAPTURE(to_string(clip));
            const frame first(distance, random);
            const auto exact = first.cascades(clip);
            const auto u = make_cascade_uniforms(relative_to(exact, first.origin), 0.1f);
            double drift = 0, error = 0, depth = 0, in_pass = 0;
            for (int i = 0; i < 20; ++i) {
                const frame next(distance, random);
                const auto relative = relative_to(next.cascades(clip), next.origin);
                const auto v = make_cascade_uniforms(relative, 0.1f);
                for (int k = 0; k < 20; ++k) {
                    const glm::dvec3 p = first.middle + bodies::random_vector(random, -20, 20);
                    const auto at = [&](const cascade_uniforms<float>& of, glm::dvec3 origin, int c) {
                        const glm::vec3 light(shadow_coordinate(of.rotation, glm::vec3(p - origin)));
                        return cascade_coordinate(light, of.scales[c], of.offsets[c]);
                    };
                    for (int c = 0; c < 2; ++c) {
                        const glm::dvec3 a = at(u, first.origin, c), b = at(v, next.origin, c);
                        const auto& e = exact[std::size_t(c)];
                        const glm::dvec3 truth =
                            cascade_coordinate(glm::dvec3(e.light.view * glm::dvec4(p, 1)), e.scale, e.offset);
                        const auto m = texture_matrix(relative[std::size_t(c)].light, {1024, 512});
                        const glm::dvec3 drawn = through(m, p - next.origin);
                        for (glm::length_t axis = 0; axis < 2; ++axis) {
                            drift = worse(drift, off_grid(b[axis] - a[axis]));
                            error = worse(error, std::abs(a[axis] - truth[axis]));
                            in_pass = worse(in_pass, std::abs(drawn[axis] - b[axis]));
                        }
                        depth = worse(depth, off_grid(8 * (b.z - a.z)) / 8);  // depths move by eighths
                    }
                }
            }
            CHECK(drift < 0.01);
            CHECK(error < 0.01);
            CHECK(in_pass < 0.01);
            CHECK(depth < 2e-6);
        }
}

TEST_CASE("make_stable_cascades: 1,000 km from the origin texels and depths stay on one grid") {
    std::mt19937 random(2);
    for (const double distance : distances) {
        const auto first = frame(distance, random).cascades(cpu_clip_space);
        for (int i = 0; i < 100; ++i) {
            const auto now = frame(distance, random).cascades(cpu_clip_space);
            for (std::size_t c = 0; c < 2; ++c) {
                CHECK(now[c].scale == first[c].scale);
                CHECK(off_grid(8 * now[c].offset.z) == 0);
                for (glm::length_t axis = 0; axis < 2; ++axis) CHECK(off_grid(now[c].offset[axis]) == 0);
            }
        }
    }
}

TEST_CASE("texture_matrix, relative_to: of any light in double and an origin, as the double's own") {
    std::mt19937 random(3);
    for (const double distance : distances)
        for (const clip_space clip : all_clip_spaces())
            for (int i = 0; i < 10; ++i) {
                CAPTURE(distance);
                CAPTURE(to_string(clip));
                const frame f(distance, random);
                const glm::ivec2 size(512, 1024);
                const std::array lights{
                    fit_directional_light<double>({.direction = f.direction,
                                                   .receivers = sphere_around(f.camera),
                                                   .casters = f.scene,
                                                   .snap_texels = size,
                                                   .clip = clip}),
                    make_spot_light<double>(
                        {.position = f.middle + glm::dvec3(5, 40, 3), .direction = f.direction, .clip = clip})};
                for (const light_space<double>& light : lights) {
                    const glm::dmat4 exact = texture_matrix(light, size);
                    const glm::dmat4 m(texture_matrix(light, size, f.origin));
                    const glm::dmat4 drawn(texture_matrix(relative_to(light, f.origin), size));
                    for (int k = 0; k < 20; ++k) {
                        const glm::dvec3 p = f.middle + bodies::random_vector(random, -10, 10);
                        const glm::dvec3 truth = through(exact, p), relative(glm::vec3(p - f.origin));
                        CHECK(glm::length(glm::dvec2(through(m, relative) - truth)) < 0.01);
                        CHECK(glm::length(glm::dvec2(through(drawn, relative) - truth)) < 0.02);
                        CHECK(std::abs(through(m, relative).z - truth.z) < 2e-6);
                    }
                }
            }
}

TEST_CASE("make_cascade_uniforms: of warped cascades and an origin, as the double's own") {
    std::mt19937 random(4);
    for (const double distance : distances)
        for (int i = 0; i < 20; ++i) {
            const frame f(distance, random);
            const cascade_fit<double> fit{.camera = f.camera,
                                          .direction = f.direction,
                                          .scene = f.scene,
                                          .map_size = {512, 256},
                                          .clip = cpu_clip_space};
            const auto cascades = make_warped_cascades<2>(
                fit, std::array{1.0, 8.0, 40.0}, [](const auto& part) { return fit_light_space_perspective(part); });
            const auto u = make_cascade_uniforms(cascades, fit.map_size, 0.25f, f.origin);
            const auto exact = make_cascade_uniforms(cascades, fit.map_size, 0.25);
            CHECK(u.ends[0].x == 8);
            CHECK(u.ends[0].y == detail::highest<float>);
            for (std::size_t c = 0; c < 2; ++c) {
                CHECK(glm::length(glm::dvec2(u.fades[c]) - exact.fades[c]) < 1e-6);
                for (int k = 0; k < 20; ++k) {
                    const double depth = c ? 20 : 4;
                    const glm::dvec3 p = f.camera.position + glm::normalize(f.camera.direction) * depth +
                                         bodies::random_vector(random, -2, 2);
                    const glm::dvec3 truth = through(exact.to_texels[c], p);
                    const glm::dvec3 got = through(glm::dmat4(u.to_texels[c]), glm::dvec3(glm::vec3(p - f.origin)));
                    CHECK(glm::length(glm::dvec2(got - truth)) < 0.02);
                }
            }
        }
}

TEST_CASE("texture_matrix, relative_to: what is not finite in float is named") {
    const auto spot = make_spot_light<double>({.clip = cpu_clip_space});
    CHECK(complaint([&] {
              (void)relative_to(spot, glm::dvec3(1e39));
          }).starts_with("umbrage::relative_to: light and origin must be such that the matrix is finite"));
    CHECK(
        complaint([&] {
            (void)texture_matrix(spot, {8, 8}, glm::dvec3(0, std::nan(""), 0));
        }).starts_with("umbrage::texture_matrix: light, map_size and origin must be such that their matrix is finite"));
    std::array<cascade<double>, 1> cascades;
    cascades[0].scale = glm::dvec4(1);
    CHECK(complaint([&] {
              (void)relative_to(cascades, glm::dvec3(0, INFINITY, 0));
          }).starts_with("umbrage::relative_to: origin must be such that offsets are finite"));
}
