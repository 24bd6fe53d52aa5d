// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>

#include "../bodies.hpp"
#include "../clip_spaces.hpp"
#include "../reference_view.hpp"

using namespace umbrage;

namespace {

example::quality_report on_ground_of(const warped_light<double>& warped) {
    return reference_view::on_ground({texture_matrix(warped.light, reference_view::map_size)});
}

}  // namespace

TEST_CASE("fit_perspective: over a long ground, no worse than measured apart") {
    struct row {
        double p95, greatest;
        light_image seen_as;
    };
    using enum light_image;
    // of an implementation apart from this one, whose camera slides back behind all casters too
    constexpr std::array rows{row{0.84, 0.90, parallel}, row{1.30, 1.40, parallel}, row{2.35, 2.49, parallel},
                              row{1.83, 1.98, sink},     row{2.46, 2.74, source},   row{1.65, 1.94, sink},
                              row{5.31, 5.90, none},     row{45.0, 55.4, none}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CAPTURE(i);
        const auto warped = fit_perspective(reference_view::warp_under(reference_view::suns[i]));
        const example::quality_report report = on_ground_of(warped);
        CHECK(warped.seen_as == rows[i].seen_as);
        CHECK(report.p95 < rows[i].p95 * 1.01);
        CHECK(report.greatest < rows[i].greatest * 1.01);
        if (rows[i].seen_as == parallel || rows[i].seen_as == source) {
            CHECK(report.p95 == doctest::Approx(rows[i].p95).epsilon(0.01));
            CHECK(report.greatest == doctest::Approx(rows[i].greatest).epsilon(0.01));
        }
        if (i > 0) continue;
        CHECK(report.mean == doctest::Approx(0.74).epsilon(0.01));
        CHECK(report.storage_factor == doctest::Approx(2.65).epsilon(0.01));
    }
    CHECK(on_ground_of(fit_perspective(reference_view::warp_under({45, 180}))).greatest ==
          doctest::Approx(0.642).epsilon(0.01));
}

TEST_CASE("fit_perspective: overhead light by hand") {
    // slid back by 1, distances go from 2 to 4: halfway between their inverses is 8/3, a third of the way between 3
    const frustum<double> camera{.position = {0, 4, 0}, .direction = {0, 0, -1}};
    warp_fit<double> fit{.camera = camera,
                         .direction = {0, -1, 0},
                         .receivers = bounding_box<double>{{-1, 0, -3}, {1, 1, -1}},
                         .margin = 0,
                         .clip = cpu_clip_space};
    const auto warped = fit_perspective(fit);
    CHECK(warped.seen_as == light_image::parallel);
    CHECK(warped.strength == doctest::Approx(0.5));  // w is the distance
    const glm::dmat4 uv = texture_matrix(warped.light, {1, 1});
    CHECK(glm::length(through(uv, {-1, 0, -1}) - glm::dvec3(0, 0, through(uv, {-1, 0, -1}).z)) < 1e-12);
    CHECK(glm::length(glm::dvec2(through(uv, {1, 0.5, -3})) - glm::dvec2(0.75, 1)) < 1e-12);
    CHECK(through(uv, {0, 1, -5.0 / 3}).y == doctest::Approx(0.5));
    CHECK(through(uv, {0, 1, -2}).y == doctest::Approx(2.0 / 3));
    CHECK(through(uv, {0, 1, -3}).z == doctest::Approx(0));  // nearest to the camera's axis, far below which all lies
    CHECK(through(uv, {0, 0, -1}).z == doctest::Approx(1));
    const auto milder = fit_perspective(fit, 5.0);
    CHECK(milder.strength == doctest::Approx(0.25));  // 6 to 8
}

TEST_CASE("fit_perspective: of the eye on its near plane, by a slide too short for doubles and one too long") {
    for (const glm::dvec3 eye : {glm::dvec3(0), glm::dvec3(-46.3163, 0, 6.86243)}) {
        const frustum<double> camera{.position = eye, .direction = {0.137, -0.5, -0.875}, .z_near = 0, .z_far = 365};
        const warp_fit<double> fit{
            .camera = camera, .direction = {0.459, 0.459, 0.461}, .receivers = camera, .clip = cpu_clip_space};
        for (const double slide : {1e-30, 1e-16, 1e-15, 1e-13, 1e-10, 1e-3, 1.0, 1e8, 1e16, 1e30, 1e300}) {
            CAPTURE(slide);
            const auto warped = fit_perspective(fit, slide);
            const glm::dmat4 to_clip = warped.light.projection * warped.light.view;
            for (const glm::dvec3& p : fit.receivers->points) {
                const glm::dvec4 at = to_clip * glm::dvec4(p, 1);
                CHECK(at.w > 0);
                CHECK(glm::max(glm::abs(at.x), glm::abs(at.y)) < at.w * 1.0625);
            }
            if (slide < 1e8) continue;
            CHECK(warped.seen_as != light_image::none);
            CHECK(warped.strength < 1e-5);
        }
    }
}

TEST_CASE("fit_perspective: no jump while the light passes from before the camera over it and behind it") {
    std::optional<glm::dmat4> before;
    double greatest_step = 0;
    int images[4]{};
    constexpr int steps = 2000;
    for (int i = 0; i <= steps; ++i) {
        warp_fit<double> fit = reference_view::warp_under({60 + 60.0 * i / steps, 0});
        const auto warped = fit_perspective(fit);
        ++images[int(warped.seen_as)];
        const glm::dmat4 uv = texture_matrix(warped.light, {1, 1});
        if (before)
            for (const glm::dvec3& p : fit.receivers->points)
                greatest_step =
                    std::max(greatest_step, glm::length(glm::dvec2(through(uv, p)) - glm::dvec2(through(*before, p))));
        before = uv;
    }
    CHECK(images[int(light_image::source)] > 900);
    CHECK(images[int(light_image::sink)] > 900);
    CHECK(images[int(light_image::parallel)] > 0);
    CHECK(images[int(light_image::none)] == 0);
    CHECK(greatest_step < 0.01);
    for (const auto& [elevation, p95] : {std::pair(89.99, 0.8447), {90.0, 0.8446}, {90.01, 0.8445}})
        CHECK(on_ground_of(fit_perspective(reference_view::warp_under({elevation, 0}))).p95 ==
              doctest::Approx(p95).epsilon(1e-4));
}

TEST_CASE("fit_perspective: turns into light-space perspective, and back again, without a jump") {
    int hand_overs = 0;
    for (const double pitch : {0.0, -25.0})
        for (const double azimuth : {0.0, 20.0, -35.0}) {
            CAPTURE(pitch);
            CAPTURE(azimuth);
            const auto under = [&](double elevation) {
                warp_fit<double> fit = reference_view::warp_under({elevation, azimuth});
                fit.camera.direction = {0, std::sin(glm::radians(pitch)), -std::cos(glm::radians(pitch))};
                fit.receivers = intersection(fit.camera, reference_view::reference_scene);
                return fit;
            };
            const auto replaced = [&](double elevation) {
                return fit_perspective(under(elevation)).seen_as == light_image::none;
            };
            for (double elevation = 4; elevation < 176; elevation += 4) {
                double first = elevation, last = elevation + 4;
                const bool before = replaced(first);
                if (replaced(last) == before) continue;
                ++hand_overs;
                for (int halvings = 0; halvings < 40; ++halvings) {
                    const double middle = (first + last) / 2;
                    (replaced(middle) == before ? first : last) = middle;
                }
                const auto fit = under(first);
                const glm::dmat4 one = texture_matrix(fit_perspective(fit).light, {1, 1}),
                                 other = texture_matrix(fit_perspective(under(last)).light, {1, 1});
                for (const glm::dvec3& p : fit.receivers->points)
                    CHECK(glm::length(through(one, p) - through(other, p)) < 1e-7);
            }
        }
    CHECK(hand_overs == 12);
}

TEST_CASE("fit_perspective: rays are texels, however nearly abreast of the camera the light is") {
    for (const double off : {0.0, 1e-12, -1e-9, 1e-7, -1e-5, 1e-4, -1e-3, 0.005, -0.006, 0.1}) {
        CAPTURE(off);
        const warp_fit<double> fit = reference_view::warp_under({90 + off, 0});
        const glm::dmat4 m = texture_matrix(fit_perspective(fit).light, reference_view::map_size);
        for (const double z : {-3.0, -30.0, -300.0, -900.0}) {
            const glm::dvec3 p(z / 10, 0, z), caster = through(m, p + fit.direction * (10 / fit.direction.y));
            CHECK(glm::length(glm::dvec2(caster) - glm::dvec2(through(m, p))) < 1e-8);
            CHECK(caster.z < through(m, p).z);
        }
    }
}

TEST_CASE("fit_perspective: how many lights stand amid what the camera sees, by its pitch") {
    constexpr double radians = std::numbers::pi / 180;
    std::mt19937 random(7);
    struct row {
        double pitch, share;
    };
    for (const row& seen : {row{0, 0.155}, row{-25, 0.07}, row{-60, 0}}) {
        warp_fit<double> fit = reference_view::warp_under({90, 0});
        fit.camera.direction = {0, std::sin(seen.pitch * radians), -std::cos(seen.pitch * radians)};
        fit.receivers = intersection(fit.camera, reference_view::reference_scene);
        int none = 0;
        constexpr int lights = 1200;
        for (int i = 0; i < lights; ++i) {
            const double sine = bodies::real(std::sin(3 * radians), 1)(random), azimuth = bodies::real(0, 360)(random);
            fit.direction = reference_view::sun(std::asin(sine) / radians, azimuth);
            none += fit_perspective(fit).seen_as == light_image::none;
        }
        CAPTURE(seen.pitch);
        CHECK(none <= seen.share * lights);
        CHECK(none >= seen.share * 0.7 * lights);
    }
}

TEST_CASE("fit_perspective: shows what the light sees as another warp does, in every convention") {
    for (const clip_space clip : all_clip_spaces())
        for (const auto& s : {reference_view::suns[0], reference_view::suns[3], reference_view::suns[4]}) {
            warp_fit<double> fit = reference_view::warp_under(s);
            fit.clip = clip;
            const auto turn = [&](const warped_light<double>& warped) {
                const glm::dmat4 uv = texture_matrix(warped.light, {1, 1});
                const glm::dvec3 p(1, 0, -20);
                const glm::dvec2 at(through(uv, p)), x = glm::dvec2(through(uv, p + glm::dvec3(0.1, 0, 0))) - at,
                                                     z = glm::dvec2(through(uv, p + glm::dvec3(0, 0, 0.1))) - at;
                return x.x * z.y - x.y * z.x > 0;
            };
            const auto warped = fit_perspective(fit);
            CHECK(warped.seen_as != light_image::none);
            CHECK(turn(warped) == turn(fit_light_space_perspective(fit)));
        }
}

TEST_CASE_TEMPLATE("fit_perspective: bad input, and cameras inside and along", T, float, double) {
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    const auto with = [](auto change, T slide = 1) {
        return complaint([&] {
            warp_fit<T> fit{.direction = {1, -2, T(0.5)},
                            .receivers = bounding_box<T>{},
                            .casters = bounding_box<T>{},
                            .clip = cpu_clip_space};
            change(fit);
            const auto warped = fit_perspective(fit, slide);
            CHECK(umbrage::detail::all_finite(warped.light.projection * warped.light.view));
            CHECK((warped.strength >= 0 && warped.strength < 1));
        });
    };
    const std::string name = "umbrage::fit_perspective: ";
    CHECK(with([](auto&) {}) == "");
    CHECK(with([](auto& f) { f.camera.z_near = 0; }) == "");
    for (const T slide : {T(1e-6), T(1e6)}) CHECK(with([](auto&) {}, slide) == "");
    for (const T bad : {T(0), T(-1), nan, infinity}) CHECK(with([](auto&) {}, bad).starts_with(name + "slide "));
    CHECK(with([](auto& f) { f.direction = {}; }).starts_with(name + "direction "));
    CHECK(with([](auto& f) { f.receivers->points.clear(); }) == "");  // the camera sees nothing of the scene
    for (const T bad : {T(-1), T(1e19), nan})
        CHECK(with([=](auto& f) { f.margin = bad; }).starts_with(name + "margin must be from 0 to 1000; got "));
    CHECK(with([](auto& f) { f.camera.tan_half_x = 0; }).starts_with(name + "camera.tan_half_x "));
    CHECK(with([](auto& f) { f.casters->low.x = 2; }).starts_with(name + "casters.low "));
    CHECK(with([](auto& f) {
              f.receivers = bounding_box<T>{glm::vec<3, T>(1), glm::vec<3, T>(1)};
          }).find("receivers, casters and margin ") != std::string::npos);
    const std::string distant = with([](auto& f) { f.camera.position.z = T(0.8) * std::numeric_limits<T>::max(); });
    CHECK((distant.empty() || distant.starts_with(name + "receivers must be near enough to the camera ")));
    CHECK(with([](auto& f) { f.camera.direction = f.direction; }) == "");
    CHECK(with([](auto& f) { f.camera.direction = -f.direction; }) == "");
    CHECK(with([](auto& f) { f.camera.position = {5, 5, 5}; }) == "");
}
