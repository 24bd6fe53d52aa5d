// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/plane_optimal.hpp>

#include "../../rounds.hpp"
#include "../bodies.hpp"
#include "../clip_spaces.hpp"
#include "../reference_view.hpp"

using namespace umbrage;

namespace {

const glm::dvec4 level(0, 1, 0, 0);

}  // namespace

TEST_CASE("fit_plane_optimal: every texel of a ground is as long as any other, under every light") {
    for (const auto& s : reference_view::suns) {
        const auto warped = fit_plane_optimal(reference_view::warp_under(s), level).value();
        const example::quality_report report =
            reference_view::on_ground({texture_matrix(warped.light, reference_view::map_size)});
        CHECK(report.mean == doctest::Approx(0.625).epsilon(1e-9));  // 1280 pixels over 2048 texels
        CHECK(report.greatest == doctest::Approx(0.625).epsilon(1e-9));
        CHECK(report.storage_factor == doctest::Approx(1));
    }
}

TEST_CASE("fit_plane_optimal: the plane is the screen, rays are texels, what is above it lies before it") {
    std::mt19937 random(3);
    constexpr double size = 2048;
    int cast = 0, lost = 0, bent = 0, disordered = 0, mirrored = 0;
    double off_screen = 0, rounded_texels = 0, rounded_depth = 0;
    for (int i = 0; i < rounds(1200); ++i) {
        warp_fit<double> fit = reference_view::warp_under({90, 0});
        fit.clip = all_clip_spaces()[std::size_t(i % 16)];
        const double elevation = bodies::real(3, 90)(random), azimuth = bodies::real(0, 360)(random);
        fit.direction = reference_view::sun(elevation, azimuth);
        if (i % 3 == 0) fit.margin = 0.05;
        const auto warped = fit_plane_optimal(fit, i % 2 ? level : -3.0 * level).value();
        const glm::dmat4 uv = texture_matrix(warped.light, {1, 1}), rounded{glm::mat4(uv)};
        const glm::dmat4 other = texture_matrix(fit_light_space_perspective(fit).light, {1, 1});
        for (int k = 0; k < 8; ++k) {
            const glm::dvec3 ground(bodies::real(-2, 2)(random), 0, -std::pow(10, bodies::real(0.7, 2.9)(random)));
            const glm::dvec2 pixel(through(reference_view::reference.to_pixels, ground));
            glm::dvec2 screen = pixel / glm::dvec2(reference_view::screen) * 2.0 - 1.0;
            const glm::dvec3 at = through(uv, ground);
            glm::dvec2 found = (glm::dvec2(at) * 2.0 - 1.0) * (1 + 2 * fit.margin);
            if (fit.clip.origin == texture_origin::top) found.y = -found.y;
            if (fit.clip.hand == handedness::left) found.x = -found.x;
            off_screen = std::max(off_screen, glm::length(found - screen));
            const glm::dvec3 off = through(rounded, ground) - at;
            rounded_texels = std::max(rounded_texels, size * glm::length(glm::dvec2(off)));
            rounded_depth = std::max(rounded_depth, std::abs(off.z));

            const auto turn = [&](const glm::dmat4& m) {
                const glm::dvec2 p(through(m, ground)), x(through(m, ground + glm::dvec3(0.1, 0, 0))),
                    z(through(m, ground + glm::dvec3(0, 0, 0.1)));
                return (x.x - p.x) * (z.y - p.y) > (x.y - p.y) * (z.x - p.x);
            };
            mirrored += turn(uv) != turn(other);
            double depth = in_convention(at, fit.clip, 1).z;
            for (const double height : {0.1, 3.0, 10.0}) {
                const glm::dvec3 p = ground + fit.direction * (height / fit.direction.y);
                if (glm::any(glm::lessThan(p, reference_view::reference_scene.low)) ||
                    glm::any(glm::greaterThan(p, reference_view::reference_scene.high + 1e-9)))
                    continue;
                const glm::dvec3 caster = through(uv, p);
                const double own = in_convention(caster, fit.clip, 1).z;
                ++cast;
                lost += !(own > 0 && own < 1);
                disordered += !(own < depth);
                bent += !(glm::length(glm::dvec2(caster) - glm::dvec2(at)) < 1e-9);
                depth = own;
            }
        }
    }
    CHECK(off_screen < 1e-9);
    CHECK(rounded_texels <= 0.004);
    CHECK(rounded_depth <= plane_optimal_rounding<double>);
    CHECK(mirrored == 0);
    CHECK(lost == 0);
    CHECK(bent == 0);
    CHECK(disordered == 0);
    CHECK(cast > rounds(20000));
}

TEST_CASE("plane_optimal_rounding: more than rounding spreads the plane's depth by, for cameras near the origin") {
    std::mt19937 random(11);
    double greatest = 0;
    for (int i = 0; i < rounds(20000); ++i) {
        warp_fit<double> fit = reference_view::warp_under({90, 0});
        const double yaw = bodies::real(0, 6.28)(random), pitch = bodies::real(-1.05, 0.09)(random);
        fit.camera.position = bodies::random_vector(random, -17, 17);
        fit.camera.position.y = bodies::real(1, 10)(random);
        fit.camera.direction = {std::sin(yaw), std::tan(pitch), std::cos(yaw)};
        fit.direction = reference_view::sun(bodies::real(3, 90)(random), bodies::real(0, 360)(random));
        const glm::dmat4 rounded{glm::mat4(texture_matrix(fit_plane_optimal(fit, level).value().light, {1, 1}))};
        double least = 1, most = 0;
        for (const glm::dvec3& p : detail::crossings(polyhedron(fit.camera), level)) {
            const double depth = through(rounded, p).z;
            least = std::min(least, depth), most = std::max(most, depth);
        }
        greatest = std::max(greatest, most - least);
    }
    CHECK(greatest <= plane_optimal_rounding<double>);
    CHECK(greatest > 0.25 * plane_optimal_rounding<double>);
}

TEST_CASE_TEMPLATE("fit_plane_optimal: bad input", T, float, double) {
    using vec4 = glm::vec<4, T>;
    const T nan = std::numeric_limits<T>::quiet_NaN();
    const auto with = [](auto change, const vec4& plane = vec4(0, 1, 0, 1)) {
        return complaint([&] {
            warp_fit<T> fit{.direction = {1, -2, T(0.5)},
                            .receivers = bounding_box<T>{},
                            .casters = bounding_box<T>{},
                            .clip = cpu_clip_space};
            change(fit);
            const auto warped = fit_plane_optimal(fit, plane).value();
            CHECK(umbrage::detail::all_finite(warped.light.projection * warped.light.view));
            CHECK((warped.strength >= 0 && warped.strength < 1));
        });
    };
    const auto plane = [&](const vec4& of) { return with([](auto&) {}, of); };
    const std::string name = "umbrage::fit_plane_optimal: ";
    CHECK(with([](auto&) {}) == "");
    CHECK(with([](auto& f) { f.casters.reset(); }) == "");
    CHECK(with([](auto& f) { f.casters->low = f.casters->high = {0, T(-0.5), -3}; }) == "");
    CHECK(with([](auto& f) { f.direction = -f.direction; }) == "");
    CHECK(plane({0, 0, 1, 5}) == "");
    CHECK(plane({0, 0, 0, 1}).starts_with(name + "plane "));
    CHECK(plane({nan, 1, 0, 1}).starts_with(name + "plane "));
    const auto is_seen = [](const vec4& of) {
        return fit_plane_optimal(
                   warp_fit<T>{.direction = {1, -2, T(0.5)}, .receivers = bounding_box<T>{}, .clip = cpu_clip_space},
                   of)
            .has_value();
    };
    CHECK(is_seen({0, 1, 0, 1}));
    CHECK(!is_seen({0, 0, 1, -5}));  // behind the camera
    CHECK(!is_seen({0, 1, 0, 0}));   // through it
    CHECK(!is_seen({2, 1, 0, 1}));   // along the light
    CHECK(with([](auto& f) { f.direction = {}; }).starts_with(name + "direction "));
    for (const T bad : {T(-1), T(1e19), nan})
        CHECK(with([=](auto& f) { f.margin = bad; }).starts_with(name + "margin must be from 0 to 1000; got "));
    CHECK(with([](auto& f) { f.camera.tan_half_x = 0; }).starts_with(name + "camera.tan_half_x "));
    CHECK(with([](auto& f) { f.casters->low.x = 2; }).starts_with(name + "casters.low "));
}
