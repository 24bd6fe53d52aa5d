// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>

#include "../clip_spaces.hpp"
#include "../reference_view.hpp"

using namespace umbrage;

TEST_CASE("fit_trapezoidal: over a long ground, as measured apart") {
    struct row {
        double p95, greatest;
    };
    // of an implementation apart from this one, by finite differences
    constexpr std::array rows{row{1.44, 1.59}, row{1.60, 1.84}, row{2.32, 2.61}, row{1.13, 1.18},
                              row{2.46, 2.76}, row{1.93, 2.38}, row{1.10, 1.14}, row{12.5, 15.9}};
    const auto report = [](std::size_t i, double focus) {
        const auto warped = fit_trapezoidal(reference_view::warp_under(reference_view::suns[i]), focus);
        return reference_view::on_ground({texture_matrix(warped.light, reference_view::map_size)});
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CAPTURE(i);
        const auto own = report(i, 20);
        CHECK(own.p95 == doctest::Approx(rows[i].p95).epsilon(0.01));
        CHECK(own.greatest == doctest::Approx(rows[i].greatest).epsilon(0.01));
        if (i > 0) continue;
        CHECK(own.mean == doctest::Approx(1.06).epsilon(0.01));
        CHECK(own.storage_factor == doctest::Approx(5.9).epsilon(0.05));
    }
    CHECK(report(0, 10).greatest == doctest::Approx(1.07).epsilon(0.01));
    CHECK(report(0, 50).greatest == doctest::Approx(3.20).epsilon(0.01));
    CHECK(report(0, 100).greatest == doctest::Approx(6.08).epsilon(0.01));
    CHECK(report(0, 200).greatest == doctest::Approx(12.8).epsilon(0.01));
}

TEST_CASE("fit_trapezoidal: the focus lies at four fifths, the trapezoid's corners in the map's") {
    // from above the frustum is a trapezoid
    const frustum<double> camera{
        .position = {3, 1, 2}, .direction = {1, 0, -1}, .tan_half_x = 0.7, .z_near = 1, .z_far = 50};
    for (const glm::dvec3 light : {glm::dvec3(0, -1, 0), glm::dvec3(0.5, -1, -0.5), glm::dvec3(-0.5, -1, 0.5)}) {
        const warp_fit<double> fit{
            .camera = camera, .direction = light, .receivers = camera, .margin = 0, .clip = cpu_clip_space};
        const glm::dvec3 way = glm::normalize(camera.direction);
        double before = 0;
        for (const double focus : {5.0, 10.0, 20.0}) {
            const auto warped = fit_trapezoidal(fit, focus);
            const glm::dmat4 uv = texture_matrix(warped.light, {1, 1});
            const glm::dvec3 at = through(uv, camera.position + focus * way);
            CHECK(at.x == doctest::Approx(0.5));
            CHECK(at.y == doctest::Approx(0.8));
            CHECK((before == 0 || warped.strength < before));
            before = warped.strength;
        }
        CHECK(before > 0);
    }
}

TEST_CASE("fit_trapezoidal: no warp for a focus far off, or light along the view; no jump before that") {
    warp_fit<double> fit = reference_view::warp_under({90, 0});
    CHECK(fit_trapezoidal(fit, 10.0).strength > 0.9);
    CHECK(fit_trapezoidal(fit, 0.0).strength < 1);
    CHECK(fit_trapezoidal(fit, 1000.0).strength == 0);
    double before = fit_trapezoidal(fit, 10.0).strength, step = 0;
    for (double focus = 10; focus < 1000; ++focus) {
        const double strength = fit_trapezoidal(fit, focus).strength;
        CHECK(strength <= before);
        step = std::max(step, before - strength);
        before = strength;
    }
    CHECK(step < 0.02);
    for (const double angle : {0.0, 0.01, 0.0199}) {
        fit.direction = {0, std::sin(angle), -std::cos(angle)};
        CHECK(fit_trapezoidal(fit, 10.0).strength == 0);
    }
    fit.direction = {0, std::sin(0.0201), -std::cos(0.0201)};
    CHECK(fit_trapezoidal(fit, 10.0).strength < 0.1);
    for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        CHECK(complaint([&] {
                  (void)fit_trapezoidal(fit, bad);
              }).starts_with("umbrage::fit_trapezoidal: focus must be finite, 0 or more; got "));
}

TEST_CASE("fit_trapezoidal: a focus before the receivers counts as a quarter of its distance behind their beginning") {
    const auto strength = [](double z_near, double focus) {
        const frustum<double> camera{
            .position = {3, 1, 2}, .direction = {1, 0, -1}, .tan_half_x = 0.7, .z_near = z_near, .z_far = 60};
        const warp_fit<double> fit{.camera = camera, .receivers = camera, .clip = cpu_clip_space};
        return fit_trapezoidal(fit, focus).strength;
    };
    CHECK(strength(20, 8) == doctest::Approx(60 / 60.8));   // as if it were 2 behind them, of 40
    CHECK(strength(20, 30) == doctest::Approx(44.0 / 48));  // 10 behind
}
