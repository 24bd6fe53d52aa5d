// SPDX-License-Identifier: MIT
//
// Every warp under lights from all over the sky, over a ground that a camera looks along and down at.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <umbrage/light/bounds.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>

#include "../../../rounds.hpp"
#include "../../bodies.hpp"
#include "../../reference_view.hpp"

using namespace umbrage;

namespace {

struct named_warp {
    const char* name;
    int unwarped;  ///< most lights without a warp: along the view, or with the focus behind all receivers
    std::function<warped_light<double>(const warp_fit<double>&)> fit;
};
const std::vector<named_warp> all_warps{
    {"light-space perspective", 10, [](const auto& f) { return fit_light_space_perspective(f); }},
    {"light-space perspective, optimal", 10,
     [](const auto& f) { return fit_light_space_perspective<double>(f, optimal_distance(f)); }},
    {"trapezoidal, focus of 20", 410, [](const auto& f) { return fit_trapezoidal(f, 20.0); }},
    {"trapezoidal, focus of 1", 10, [](const auto& f) { return fit_trapezoidal(f, 1.0); }},
    {"perspective", 10, [](const auto& f) { return fit_perspective(f); }}};

}  // namespace

TEST_CASE("warps: of 1200 lights none loses a receiver or caster, bends a ray, or disorders depth; float holds them") {
    constexpr double radians = std::numbers::pi / 180, size = 2048;
    std::mt19937 random(7);
    for (const named_warp& warp : all_warps) {
        CAPTURE(warp.name);
        int lost = 0, bent = 0, disordered = 0, cast = 0, uniform = 0;
        double rounded_texels = 0, rounded_depth = 0;
        for (int i = 0; i < rounds(1200); ++i) {
            const double pitch = std::array{0.0, -25.0, -60.0}[std::size_t(i % 3)] * radians;
            frustum<double> camera = reference_view::reference.seen;
            camera.direction = {0, std::sin(pitch), -std::cos(pitch)};
            const double up = std::sin(3 * radians), sine = bodies::real(up, 1)(random),
                         azimuth = bodies::real(0, 360)(random);
            const bounding_box<double> scene = reference_view::reference_scene;
            const polyhedron seen = intersection(camera, scene);
            const glm::dvec3 direction = reference_view::sun(std::asin(sine) / radians, azimuth);
            const warp_fit<double> fit{.camera = camera,
                                       .direction = direction,
                                       .receivers = seen,
                                       .casters = scene,
                                       .margin = 0,
                                       .clip = cpu_clip_space};
            const warped_light<double> warped = warp.fit(fit);
            uniform += warped.strength == 0;
            const glm::dmat4 exact = texture_matrix(warped.light, glm::ivec2(int(size)));
            const glm::dmat4 rounded{glm::mat4(exact)};
            const auto place = [](const glm::dmat4& m, glm::dvec3 p) {
                const glm::dvec4 h = m * glm::dvec4(p, 1);
                return glm::dvec4(glm::dvec3(h) / h.w, h.w);
            };
            const auto inside = [](const glm::dvec4& at) {
                constexpr double e = 1e-9;
                return at.w > 0 && at.x > -e * size && at.x < size * (1 + e) && at.y > -e * size &&
                       at.y < size * (1 + e) && at.z > -e && at.z < 1 + e;
            };
            for (const glm::dvec3& corner : fit.receivers->points) lost += !inside(place(exact, corner));
            for (int k = 0; k < 8; ++k) {
                const glm::dvec3 receiver = bodies::point_between(fit.receivers->points, random);
                const glm::dvec4 own = place(exact, receiver);
                lost += !inside(own);
                double out = 1e9;  // of the scene, towards the light
                for (glm::length_t c = 0; c < 3; ++c)
                    out = std::min(out, ((direction[c] > 0 ? scene.low : scene.high)[c] - receiver[c]) / -direction[c]);
                double depth = own.z;
                for (const double share : {0.25, 0.5, 1.0}) {
                    const glm::dvec4 caster = place(exact, receiver - share * out * direction);
                    lost += !inside(caster);
                    bent += !(glm::length(glm::dvec2(caster) - glm::dvec2(own)) < 1e-6);
                    if (out > 1e-6) disordered += !(caster.z < depth), ++cast;
                    depth = caster.z;
                }
                const glm::dvec4 off = place(rounded, receiver) - own;
                rounded_texels = std::max({rounded_texels, std::abs(off.x), std::abs(off.y)});
                rounded_depth = std::max(rounded_depth, std::abs(off.z));
            }
        }
        CHECK(lost == 0);
        CHECK(bent == 0);
        CHECK(disordered == 0);
        CHECK(cast > rounds(20000));
        CHECK(uniform < rounds(warp.unwarped));
        CHECK(rounded_texels <= 0.004);
        CHECK(rounded_depth <= 4e-6);
    }
}
