// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include <glm/gtc/matrix_access.hpp>

#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../clip_spaces.hpp"

using namespace umbrage;

TEST_CASE("fit_directional_light: a box's corners and the margin touch the sides, in every convention") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> coordinate(-5, 5), extent(0, 8);
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        double worst = 0;
        for (int i = 0; i < 100; ++i) {
            directional_fit<double> fit{.direction = {coordinate(random), coordinate(random), coordinate(random)},
                                        .receivers = bounding_box<double>{},
                                        .margin = i % 2 ? 0.01 : 0.2,
                                        .clip = clip};
            if (i % 7 == 0) fit.direction = {0, i % 2 ? 1 : -1, 0};
            bounding_box<double> box{{coordinate(random), coordinate(random), coordinate(random)}};
            box.high = box.low;
            box.high.x += extent(random), box.high.y += i % 3 ? extent(random) : 0.0;
            box.high.z += i % 5 ? extent(random) : 0.0;
            fit.receivers = box;
            const auto light = fit_directional_light(fit);
            glm::dvec3 low(2), high(-1);
            for (glm::dvec3 corner : corners(box)) {
                const glm::dvec3 p = through(texture_matrix(light, {1, 1}), corner);
                low = glm::min(low, p), high = glm::max(high, p);
            }
            // what the margin takes of the whole side: one and the same length in the world
            const double margin = fit.margin * glm::length(box.high - box.low);
            for (int k = 0; k < 3; ++k) {
                const double side = (clip.range == depth_range::zero_to_one && k == 2 ? 1 : 2) /
                                    glm::length(glm::dvec3(glm::row(light.projection * light.view, k)));
                worst = worse(worst, std::abs(low[k] * side - margin));
                worst = worse(worst, std::abs((1 - high[k]) * side - margin));
            }
        }
        CHECK(worst < 1e-12);
    }
}

TEST_CASE("fit_directional_light: the same point of the scene, the same texel and depth in every convention") {
    const bounding_box<double> box{{-1, 0, -3}, {4, 2, 5}}, above{{-9, 1, -9}, {9, 7, 9}};
    for (const glm::ivec2 snap_texels : {glm::ivec2(0), glm::ivec2(64, 64)}) {
        const directional_fit<double> fit{.direction = {1, -2, 0.5},
                                          .receivers = box,
                                          .casters = above,
                                          .snap_texels = snap_texels,
                                          .clip = cpu_clip_space};
        const glm::dmat4 plain = texture_matrix(fit_directional_light(fit), {300, 200});
        for (clip_space clip : all_clip_spaces()) {
            CAPTURE(to_string(clip));
            if (snap_texels.x && clip.hand == handedness::left) continue;  // the mirrored world's grid is another
            const auto mirrored = [&](const bounding_box<double>& b) {
                const glm::dvec3 low = in_world(b.low, clip), high = in_world(b.high, clip);
                return bounding_box<double>{glm::min(low, high), glm::max(low, high)};
            };
            auto same = fit;
            same.clip = clip;
            same.direction = in_world(fit.direction, clip);
            same.receivers = mirrored(box);
            same.casters = mirrored(above);
            const glm::dmat4 m = texture_matrix(fit_directional_light(same), {300, 200});
            for (glm::dvec3 corner : corners(box))
                CHECK(glm::length(through(m, in_world(corner, clip)) -
                                  in_convention(through(plain, corner), clip, 200)) < 1e-11);
        }
    }
}

TEST_CASE("fit_directional_light: by hand") {
    // looking down -z at a box of 2 x 4 x 4, diagonal 6, margin 0.6: half extents 1.6, 2.6, 2.6
    const bounding_box<double> box{{0, 0, 0}, {2, 4, 4}};
    directional_fit<double> fit{.direction = {0, 0, -1}, .receivers = box, .margin = 0.1, .clip = cpu_clip_space};
    glm::dmat4 uv = texture_matrix(fit_directional_light(fit), {1, 1});
    CHECK(glm::length(through(uv, {1, 2, 2}) - 0.5) < 1e-15);
    CHECK(glm::length(through(uv, {0, 0, 4}) - glm::dvec3(0.6 / 3.2, 0.6 / 5.2, 0.6 / 5.2)) < 1e-15);

    // casters up to z = 8: the near plane is 4.6 before the box, the depth's 9.2 are from 8.6 to -0.6
    fit.casters = bounding_box<double>{{-9, -9, 5}, {9, 9, 8}};
    uv = texture_matrix(fit_directional_light(fit), {1, 1});
    CHECK(through(uv, {1, 2, 8.6}).z == doctest::Approx(0));
    CHECK(through(uv, {1, 2, -0.6}).z == doctest::Approx(1));
    fit.casters = bounding_box<double>{{3, -9, 5}, {9, 9, 8}};  // beside
    uv = texture_matrix(fit_directional_light(fit), {1, 1});
    CHECK(through(uv, {1, 2, 4.6}).z == doctest::Approx(0));

    // a square of 64 texels, of which 63 are 5.2 wide, at multiples of a texel
    fit.snap_texels = {64, 64};
    const glm::dvec3 low = through(glm::inverse(texture_matrix(fit_directional_light(fit), {64, 64})), {0, 0, 0});
    const glm::dvec3 high = through(glm::inverse(texture_matrix(fit_directional_light(fit), {64, 64})), {64, 64, 1});
    const double texel = 5.2 / 63;
    for (int k = 0; k < 2; ++k) {
        CHECK(std::abs(low[k] / texel - std::round(low[k] / texel)) < 1e-12);
        CHECK((high - low)[k] == doctest::Approx(64 * texel));
        CHECK((low[k] <= (k ? -0.6 : -1.6) && high[k] >= (k ? 4.6 : 3.6)));
    }
    CHECK((low.z >= 8 && high.z <= 0));  // all casters, not only those above
}

TEST_CASE("fit_directional_light: float keeps what is inside inside, far from the origin too") {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> coordinate(-5, 5), extent(0.1f, 8);
    int outside = 0;
    for (int i = 0; i < 2000; ++i) {
        directional_fit<float> fit{.receivers = bounding_box<float>{},
                                   .margin = i % 2 ? 1e-4f : 1e-2f,
                                   .snap_texels = glm::ivec2(i % 3 ? 0 : 1024),
                                   .clip = cpu_clip_space};
        fit.direction = {coordinate(random), coordinate(random), coordinate(random)};
        bounding_box<float> box{{coordinate(random), coordinate(random), coordinate(random)}};
        if (i % 2 == 0) box.low += glm::vec3(2000, -500, 1500);
        box.high = box.low + glm::vec3(extent(random), extent(random), extent(random));
        fit.receivers = box;
        const glm::mat4 m = texture_matrix(fit_directional_light(fit), {1, 1});
        for (glm::dvec3 corner : corners(box)) {
            const glm::vec3 p = project_coordinate(shadow_coordinate(m, glm::vec3(corner)));
            for (int k = 0; k < 3; ++k) outside += !(p[k] > 0 && p[k] < 1);
        }
    }
    CHECK(outside == 0);
}

TEST_CASE_TEMPLATE("fit_directional_light: bad input", T, float, double) {
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    using vec = glm::vec<3, T>;
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const auto with = [&](auto change) {
            directional_fit<T> fit{.direction = {1, -2, T(0.5)},
                                   .receivers = bounding_box<T>{},
                                   .casters = bounding_box<T>{},
                                   .clip = clip};
            return complaint([&] {
                change(fit);
                const auto space = fit_directional_light(fit);
                CHECK(detail::all_finite(space.projection * space.view));
            });
        };
        const auto box = [](vec low, vec high) { return bounding_box<T>{low, high}; };
        const std::string name = "umbrage::fit_directional_light: ";
        CHECK(with([](auto&) {}).empty());
        CHECK(with([&](auto& f) { f.receivers = box(vec(-1), vec(1, -1, 1)); }).empty());   // a plane
        CHECK(with([&](auto& f) { f.receivers = box(vec(-1), vec(-1, -1, 1)); }).empty());  // a line
        CHECK(with([&](auto& f) { f.receivers = box(vec(2), vec(2)); }).starts_with(name + "receivers and margin "));
        CHECK(with([](auto& f) { f.receivers = hull(); }) == "");
        CHECK(with([](auto& f) {
                  f.receivers = intersection(bounding_box<T>{}, bounding_box<T>{vec(2), vec(3)});
              }) == "");  // the camera sees nothing of the scene
        CHECK(with([&](auto& f) { f.receivers = box(vec(-1), vec(1, -2, 1)); }).starts_with(name + "receivers.low "));
        CHECK(with([&](auto& f) { f.casters = box(vec(-1), vec(1, -2, 1)); }).starts_with(name + "casters.low "));
        CHECK(with([](auto& f) { f.receivers = bounding_sphere<T>{vec(1), T(-1)}; }).starts_with(name + "receivers "));
        for (T bad : {nan, -nan, infinity, -infinity}) {
            CHECK(with([&](auto& f) {
                      f.receivers = box(vec(0, bad, 0), vec(1));
                  }).starts_with(name + "receivers.low must be finite; got "));
            CHECK(with([&](auto& f) {
                      f.receivers = std::vector<vec>{vec(0), vec(1, 0, bad)};
                  }).starts_with(name + "receivers must be finite"));
            CHECK(with([&](auto& f) {
                      f.receivers = bounding_sphere<T>{vec(1), bad};
                  }).starts_with(name + "receivers "));
            CHECK(with([&](auto& f) { f.direction.x = bad; }).starts_with(name + "direction "));
            CHECK(with([&](auto& f) { f.up.x = bad; }).starts_with(name + "up "));
            CHECK(with([&](auto& f) { f.margin = bad; }).starts_with(name + "margin "));
        }
        CHECK(with([](auto& f) { f.margin = T(-1e-3); }).starts_with(name + "margin "));
        CHECK(with([](auto& f) { f.margin = 0; }).empty());
        CHECK(with([](auto& f) { f.direction = {}; }).starts_with(name + "direction "));
        for (int texels : {-1, 1, std::numeric_limits<int>::min()})
            CHECK(with([&](auto& f) { f.snap_texels = {64, texels}; }).starts_with(name + "snap_texels "));
    }
}

TEST_CASE_TEMPLATE("fit_directional_light: whatever the numbers, finite matrices or a named argument", T, float,
                   double) {
    std::mt19937 random(11);
    const int exponents = std::numeric_limits<T>::max_exponent + std::numeric_limits<T>::digits;
    std::uniform_int_distribution<int> exponent(-exponents, std::numeric_limits<T>::max_exponent - 1);
    std::uniform_real_distribution<double> mantissa(1, 2), sign(-1, 1);
    const auto any = [&] { return std::ldexp(T(mantissa(random)), exponent(random)); };
    const auto vector = [&] {
        const T x = any() * T(sign(random)), y = any() * T(sign(random)), z = any();
        return glm::vec<3, T>(x, y, z);
    };
    int made = 0, refused = 0, wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        directional_fit<T> fit{.receivers = bounding_box<T>{}, .clip = all_clip_spaces()[std::size_t(i % 16)]};
        const std::string error = complaint([&] {
            if (i & 16) fit.direction = vector();
            if (i & 32) fit.up = vector();
            if (i & 64) fit.margin = any();
            if (i & 128) fit.snap_texels = {2 << i % 13, 2 << i % 7};
            if (i & 256) fit.receivers = std::vector{vector(), vector(), vector()};
            if (i & 512) fit.receivers = bounding_sphere<T>{vector(), any()};
            if (i & 1024) {
                const glm::vec<3, T> a = vector(), b = vector();
                fit.casters = bounding_box<T>{glm::min(a, b), glm::max(a, b)};
            }
            const light_space<T> space = fit_directional_light(fit);
            wrong += !detail::all_finite(space.view) || !detail::all_finite(space.projection * space.view);
        });
        wrong += !error.empty() && !error.starts_with("umbrage::fit_directional_light: ");
        ++(error.empty() ? made : refused);
    }
    CHECK(wrong == 0);
    CHECK(made > 5000);
    CHECK(refused > 1000);
}
