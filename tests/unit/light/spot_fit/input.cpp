// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <umbrage/light/spot_fit.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../bodies.hpp"
#include "../clip_spaces.hpp"

using namespace umbrage;

TEST_CASE("fit_spot_light: of receivers all around it is make_spot_light, with an infinite far plane too") {
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const bounding_box<double> scene{{-50, -20, -50}, {50, 3, 50}};
        for (bool bounded : {true, false}) {
            const auto fitted = fit_spot_light<double>({.position = {1, 2, 3},
                                                        .direction = {0, -1, 0},
                                                        .outer_angle_radians = 0.7,
                                                        .z_near = 0.5,
                                                        .receivers = scene,
                                                        .casters = scene,
                                                        .margin = 0,
                                                        .has_far_plane = bounded,
                                                        .clip = clip});
            const auto plain = make_spot_light<double>({.position = {1, 2, 3},
                                                        .direction = {0, -1, 0},
                                                        .outer_angle_radians = 0.7,
                                                        .z_near = 0.5,
                                                        .z_far = bounded ? 22 : std::numeric_limits<double>::infinity(),
                                                        .clip = clip});
            CHECK(difference(fitted.value().view, plain.view) == 0);
            CHECK(difference(fitted.value().projection, plain.projection) < 1e-12);
        }
    }
}

TEST_CASE("make_spot_light, fit_spot_light: reversed without a far plane, depth is z_near over the distance") {
    const double infinity = std::numeric_limits<double>::infinity();
    for (clip_space clip : all_clip_spaces()) {
        if (clip.direction == depth_direction::forward) continue;
        CAPTURE(to_string(clip));
        const auto light =
            make_spot_light<double>({.direction = {0, 0, 1}, .z_near = 0.25, .z_far = infinity, .clip = clip});
        const glm::dmat4 uv = texture_matrix(light, {1, 1});
        for (double distance : {0.25, 1.0, 77.0, 1e6, 1e12})
            CHECK(std::abs(through(uv, {0, 0, distance}).z * distance / 0.25 - 1) <
                  (clip.range == depth_range::zero_to_one ? 1e-15 : 1e-2));
        if (clip.range == depth_range::zero_to_one) {
            CHECK(light.projection[2][2] == 0);
            CHECK(light.projection[3][2] == 0.25);
        }
    }
}

TEST_CASE_TEMPLATE("fit_spot_light: bad input", T, float, double) {
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    using vec = glm::vec<3, T>;
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const auto with = [&](auto change) {
            spot_fit<T> fit{
                .position = vec(0, 5, 0), .receivers = bounding_box<T>{}, .casters = bounding_box<T>{}, .clip = clip};
            return complaint([&] {
                change(fit);
                const auto space = fit_spot_light(fit).value();
                CHECK(detail::all_finite(space.projection * space.view));
            });
        };
        const auto lights = [&](auto change) {
            spot_fit<T> fit{
                .position = vec(0, 5, 0), .receivers = bounding_box<T>{}, .casters = bounding_box<T>{}, .clip = clip};
            change(fit);
            return fit_spot_light(fit).has_value();
        };
        const std::string name = "umbrage::fit_spot_light: ";
        CHECK(with([](auto&) {}).empty());
        CHECK(with([](auto& f) { f.position = vec(0); }).empty());  // within
        CHECK(with([](auto& f) { f.casters.reset(); }).empty());
        CHECK(with([](auto& f) { f.has_far_plane = false; }).empty());
        for (T angle : {T(0), T(-1), T(1.501), std::numbers::pi_v<T> / 2, T(2), nan, infinity})
            CHECK(with([&](auto& f) { f.outer_angle_radians = angle; }).starts_with(name + "outer_angle_radians "));
        for (T z_near : {T(0), T(-1), nan, infinity, std::numeric_limits<T>::denorm_min()})
            CHECK(with([&](auto& f) { f.z_near = z_near; }).starts_with(name + "z_near "));
        for (T margin : {T(-1e-3), T(0.6), nan})
            CHECK(with([&](auto& f) { f.margin = margin; }).starts_with(name + "margin "));
        CHECK(with([](auto& f) { f.direction = {}; }).starts_with(name + "direction "));
        CHECK(with([&](auto& f) { f.position.x = infinity; }).starts_with(name + "position "));
        CHECK(with([&](auto& f) { f.receivers = bounding_box<T>{vec(nan), vec(0)}; }).find("finite") != name.npos);
        const T far_away = T(4) / std::numeric_limits<T>::epsilon();
        for (const vec p : {vec(0, far_away, 0), vec(far_away, far_away, 0)}) {
            const std::string error = with([&](auto& f) { f.position = p, f.direction = -p; });
            CHECK(error == name + "position must be near enough to the receivers and the origin for its digits; got " +
                               detail::printed(p));
        }
        CHECK(with([](auto& f) { f.position.y = 1000; }).empty());
        const bool reversed = clip.direction == depth_direction::reversed;
        const std::string no_digits = with([](auto& f) { f.position = vec(0), f.z_near = T(1e-6); });
        CHECK((reversed ? no_digits.empty() : no_digits.starts_with(name + "z_near must be at least ")));
        CHECK(with([](auto& f) {
                  f.receivers = bounding_box<T>{vec(0), vec(-1)};
              }).starts_with(name + "receivers.low must be nowhere above high; got "));
        CHECK(lights([](auto&) {}));
        CHECK(!lights([](auto& f) { f.z_near = 7; }));  // behind all
        CHECK(!lights([](auto& f) { f.direction = vec(0, 1, 0); }));
        CHECK(!lights([](auto& f) { f.direction = vec(1, 0.2, 0); }));
        CHECK(!lights([](auto& f) { f.receivers = hull(); }));
        CHECK(!lights([](auto& f) { f.receivers = bounding_box<T>{vec(0), vec(0)}; }));
    }
}

TEST_CASE_TEMPLATE("fit_spot_light: whatever the numbers, finite matrices or a named argument", T, float, double) {
    std::mt19937 random(11);
    const int exponents = std::numeric_limits<T>::max_exponent + std::numeric_limits<T>::digits;
    std::uniform_int_distribution<int> exponent(-exponents, std::numeric_limits<T>::max_exponent - 1);
    const auto any = [&] {
        const T mantissa = T(bodies::real(-2, 2)(random));
        return std::ldexp(mantissa, exponent(random));
    };
    const auto vector = [&] {
        const T x = any(), y = any(), z = any();
        return glm::vec<3, T>(x, y, z);
    };
    int made = 0, wrong = 0;
    for (int i = 0; i < 10000; ++i) {
        spot_fit<T> fit{.receivers = bounding_box<T>{}, .clip = all_clip_spaces()[std::size_t(i % 16)]};
        const std::string error = complaint([&] {
            if (i & 16) fit.position = vector();
            if (i & 32) fit.direction = vector();
            if (i & 64) fit.outer_angle_radians = any();
            if (i & 128) fit.z_near = any();
            const glm::vec<3, T> a = vector(), b = vector();
            if (i & 256) fit.receivers = bounding_box<T>{glm::min(a, b), glm::max(a, b)};
            if (i & 512) fit.casters = bounding_box<T>{glm::min(a, b), glm::max(a, b)};
            const auto light = fit_spot_light(fit);
            if (!light) return;
            ++made;
            wrong += !detail::all_finite(light->view) || !detail::all_finite(light->projection * light->view);
        });
        wrong += !error.empty() && !error.starts_with("umbrage::fit_spot_light: ");
    }
    CHECK(wrong == 0);
    CHECK(made > 1000);
}
