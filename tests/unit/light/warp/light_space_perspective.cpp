// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>

#include "../clip_spaces.hpp"
#include "../reference_view.hpp"

using namespace umbrage;

TEST_CASE("fit_light_space_perspective: over a long ground, as measured apart, at both distances") {
    struct row {
        double optimal_p95, optimal_greatest, p95, greatest;
    };
    // of an implementation apart from this one, by finite differences
    constexpr std::array rows{row{4.49, 5.05, 1.16, 1.27}, row{4.53, 5.17, 1.40, 1.58}, row{4.61, 5.40, 2.23, 2.46},
                              row{5.80, 6.49, 1.08, 1.13}, row{6.59, 7.50, 2.46, 2.75}, row{6.87, 8.92, 1.73, 2.10},
                              row{14.9, 16.8, 2.38, 2.58}, row{19.9, 23.4, 10.3, 13.3}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CAPTURE(i);
        const warp_fit<double> fit = reference_view::warp_under(reference_view::suns[i]);
        const auto report = [](const warped_light<double>& warped) {
            return reference_view::on_ground({texture_matrix(warped.light, reference_view::map_size)});
        };
        const auto optimal = report(fit_light_space_perspective<double>(fit, optimal_distance(fit)));
        const auto own = report(fit_light_space_perspective(fit));
        CHECK(optimal.p95 == doctest::Approx(rows[i].optimal_p95).epsilon(0.01));
        CHECK(optimal.greatest == doctest::Approx(rows[i].optimal_greatest).epsilon(0.01));
        CHECK(own.p95 == doctest::Approx(rows[i].p95).epsilon(0.01));
        CHECK(own.greatest == doctest::Approx(rows[i].greatest).epsilon(0.01));
        if (i > 0) continue;
        CHECK(optimal.mean == doctest::Approx(2.67).epsilon(0.01));
        CHECK(optimal.storage_factor == doctest::Approx(54).epsilon(0.05));
        CHECK(own.mean == doctest::Approx(0.91).epsilon(0.01));
        CHECK(own.storage_factor == doctest::Approx(4).epsilon(0.05));
    }
}

TEST_CASE("fit_light_space_perspective: overhead light and a bare frustum need the storage that theory says") {
    const reference_view::view whole(frustum<double>{.tan_half_x = 1, .tan_half_y = 1, .z_near = 1, .z_far = 1000});
    const warp_fit<double> fit{.camera = whole.seen,
                               .direction = {0, -1, 0},
                               .receivers = whole.seen,
                               .casters = {},
                               .margin = 0,
                               .clip = cpu_clip_space};
    CHECK(optimal_distance(fit) == doctest::Approx(1 + std::sqrt(1000.0)));
    const auto storage = [&](double n) {
        const glm::dmat4 texels =
            texture_matrix(fit_light_space_perspective<double>(fit, n).light, reference_view::map_size);
        return example::measure_quality({.screen = {1000, 1}, .map_size = reference_view::map_size},
                                        [&](glm::ivec2 p) {
                                            return pixels_per_texel(texels, whole.to_pixels,
                                                                    glm::dvec3(0, 0, -std::pow(1000.0, p.x / 999.0)),
                                                                    glm::dvec3(0, 1, 1));
                                        })
                   .storage_factor *
               1000 / (reference_view::screen.x * double(reference_view::screen.y));
    };
    for (const double n : {1.0, 5.0, optimal_distance(fit)}) CHECK(storage(n) == doctest::Approx(499.5).epsilon(0.01));
    CHECK(storage(1e9) == doctest::Approx(499500).epsilon(0.01));
}

TEST_CASE("fit_light_space_perspective: by hand, and without a warp") {
    // from above, y along -z: receivers from z = -1 to -3, 3 wide; the center 2 before them
    const frustum<double> camera{.position = {0.5, 4, 0}, .direction = {0, 0, -1}};
    warp_fit<double> fit{.camera = camera,
                         .direction = {0, -1, 0},
                         .receivers = bounding_box<double>{{-1, 0, -3}, {2, 1, -1}},
                         .margin = 0,
                         .clip = cpu_clip_space};
    const auto warped = fit_light_space_perspective<double>(fit, 2.0);
    CHECK(warped.strength == doctest::Approx(0.5));  // w from 1 to 2
    const glm::dmat4 uv = texture_matrix(warped.light, {1, 1});
    CHECK(glm::length(through(uv, {-1, 1, -1}) - glm::dvec3(0, 0, 0)) < 1e-12);
    CHECK(glm::length(through(uv, {2, 0, -1}) - glm::dvec3(1, 0, 1)) < 1e-12);
    CHECK(glm::length(glm::dvec2(through(uv, {2, 0, -3})) - glm::dvec2(0.75, 1)) < 1e-12);
    CHECK(through(uv, {0, 0, -2}).y == doctest::Approx(2.0 / 3));

    fit.margin = 0.1;
    CHECK(through(texture_matrix(fit_light_space_perspective<double>(fit, 2.0).light, {1, 1}), {-1, 1, -1}).x ==
          doctest::Approx(0.1 / 1.2));
    const double infinity = std::numeric_limits<double>::infinity();
    fit.margin = 0;
    const auto straight = fit_light_space_perspective<double>(fit, infinity);
    CHECK(straight.strength == 0);
    const auto uniform = fit_directional_light<double>({.direction = fit.direction,
                                                        .up = camera.direction,
                                                        .receivers = fit.receivers,
                                                        .margin = 0,
                                                        .clip = cpu_clip_space});
    CHECK(difference(straight.light.projection, uniform.projection) < 1e-15);
    CHECK(difference(straight.light.view, uniform.view) == 0);
}

TEST_CASE(
    "fit_light_space_perspective: turns into the camera's view and out of it again, no faster than without a warp") {
    warp_fit<double> fit = reference_view::warp_under({45, 0});
    double least = 1, greatest = 0;
    const auto greatest_step = [&](auto warp) {
        std::optional<glm::dmat4> before;
        double step = 0;
        for (int i = 0; i <= 1000; ++i) {
            const double angle = 0.0105 + 0.3 * i / 1000;
            fit.direction = {0, std::sin(angle), -std::cos(angle)};
            const warped_light<double> warped = warp(fit);
            if (std::sin(angle) <= 0.02) CHECK(warped.strength == 0);
            least = std::min(least, warped.strength), greatest = std::max(greatest, warped.strength);
            const glm::dmat4 uv = texture_matrix(warped.light, {1, 1});
            for (const glm::dvec3& p : fit.receivers->points)
                if (before)
                    step = std::max(step, glm::length(glm::dvec2(through(uv, p)) - glm::dvec2(through(*before, p))));
            before = uv;
        }
        return step;
    };
    const double uniform = greatest_step([](const auto& f) { return umbrage::detail::unwarped(f, "test"); });
    CHECK(greatest == 0);
    CHECK(greatest_step([](const auto& f) { return fit_light_space_perspective(f); }) < 1.01 * uniform);
    CHECK(least == 0);
    CHECK(greatest > 0.9);
}

TEST_CASE_TEMPLATE("fit_light_space_perspective: at the optimal distance, for a camera without a near plane too", T,
                   float, double) {
    warp_fit<T> fit{.direction = {1, -2, T(0.5)},
                    .receivers = bounding_box<T>{},
                    .casters = bounding_box<T>{},
                    .clip = cpu_clip_space};
    CHECK(fit_light_space_perspective(fit, optimal_distance(fit)).strength > 0);
    fit.camera.z_near = 0;
    CHECK(optimal_distance(fit) > 0);
    CHECK(fit_light_space_perspective(fit, optimal_distance(fit)).strength > 0);
    CHECK(fit_light_space_perspective(fit, 1e-30f).strength > 0);
}

TEST_CASE_TEMPLATE("fit_light_space_perspective: bad input, and cameras inside and along", T, float, double) {
    const T nan = std::numeric_limits<T>::quiet_NaN();
    const auto with = [](auto change, std::optional<T> distance = {}) {
        return complaint([&] {
            warp_fit<T> fit{.direction = {1, -2, T(0.5)},
                            .receivers = bounding_box<T>{},
                            .casters = bounding_box<T>{},
                            .clip = cpu_clip_space};
            change(fit);
            const auto warped = fit_light_space_perspective(fit, distance);
            CHECK(umbrage::detail::all_finite(warped.light.projection * warped.light.view));
            CHECK((warped.strength >= 0 && warped.strength < 1));
        });
    };
    const std::string name = "umbrage::fit_light_space_perspective: ";
    CHECK(with([](auto&) {}) == "");
    CHECK(with([](auto& f) { f.camera.z_near = 0; }) == "");
    CHECK(with([](auto&) {}, T(1e-30)) == "");
    CHECK(with([](auto&) {}, T(1e30)) == "");
    for (const T bad : {T(0), T(-1), nan}) CHECK(with([](auto&) {}, bad).starts_with(name + "distance "));
    CHECK(with([](auto& f) { f.direction = {}; }).starts_with(name + "direction "));
    CHECK(with([](auto& f) { f.receivers->points.clear(); }) == "");  // the camera sees nothing of the scene
    for (const T bad : {T(-1), T(1e19), nan})
        CHECK(with([=](auto& f) { f.margin = bad; }).starts_with(name + "margin must be from 0 to 1000; got "));
    CHECK(with([](auto& f) { f.camera.tan_half_x = 0; }).starts_with(name + "camera.tan_half_x "));
    CHECK(with([](auto& f) { f.casters->low.x = 2; }).starts_with(name + "casters.low "));
    CHECK(with([&](auto& f) {
              f.receivers = bounding_box<T>{glm::vec<3, T>(1), glm::vec<3, T>(1)};
          }).starts_with(name + "receivers, casters and margin "));
    CHECK(with([](auto& f) { f.camera.direction = f.direction; }) == "");
    CHECK(with([](auto& f) { f.camera.direction = -f.direction; }) == "");
    CHECK(with([](auto& f) { f.camera.position = {5, 5, 5}; }) == "");
}
