// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../clip_spaces.hpp"

using namespace umbrage;

namespace {

glm::dvec3 in_convention(glm::dvec3 p, clip_space clip, double height) {
    if (clip.origin == texture_origin::top) p.y = height - p.y;
    if (clip.direction == depth_direction::reversed) p.z = 1.0 - p.z;
    return p;
}

std::vector<glm::dvec3> corners(glm::dvec3 low, glm::dvec3 high) {
    std::vector<glm::dvec3> all;
    for (int i = 0; i < 8; ++i) all.push_back({(i & 1 ? high : low).x, (i & 2 ? high : low).y, (i & 4 ? high : low).z});
    return all;
}

}  // namespace

TEST_CASE(
    "fit_directional_light: holds all corners, and not a bit more than them and the margin, in every convention") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> coordinate(-5, 5), extent(0, 8);
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const double front = clip.hand == handedness::right ? -1 : 1;
        double worst = 0;
        int outside = 0;
        for (int i = 0; i < 300; ++i) {
            directional_fit<double> fit{.direction = {coordinate(random), coordinate(random), coordinate(random)},
                                        .clip = clip};
            if (i % 7 == 0) fit.direction = {0, i % 2 ? 1 : -1, 0};
            fit.low = {coordinate(random), coordinate(random), coordinate(random)};
            fit.high = fit.low + glm::dvec3(extent(random), i % 3 ? extent(random) : 0.0, i % 5 ? extent(random) : 0.0);
            fit.margin = i % 2 ? 0.01 : 0.2;
            const auto light = fit_directional_light(fit);
            glm::dvec3 low(1e9), high(-1e9);
            for (glm::dvec3 corner : corners(fit.low, fit.high)) {
                const glm::dvec3 p = through(texture_matrix_uv(light), corner);
                for (int k = 0; k < 3; ++k) outside += !(p[k] > 0 && p[k] < 1);
                const glm::dvec3 v = glm::dvec3(light.view * glm::dvec4(corner, 1)) * glm::dvec3(1, 1, front);
                low = glm::min(low, v);
                high = glm::max(high, v);
            }
            const double margin = fit.margin * glm::length(fit.high - fit.low);
            // from where the box's sides land, back to view space: they are the margin away from the outermost corners
            const glm::dmat4 back = glm::inverse(light.projection);
            const bool zo = clip.range == depth_range::zero_to_one,
                       reversed = clip.direction == depth_direction::reversed;
            const double shallow = zo ? 0 : -1;
            const glm::dvec3 first = through(back, {-1, -1, reversed ? 1 : shallow}) * glm::dvec3(1, 1, front);
            const glm::dvec3 last = through(back, {1, 1, reversed ? shallow : 1}) * glm::dvec3(1, 1, front);
            worst = worse(worst, worse(glm::length(first - (low - margin)), glm::length(last - (high + margin))));
        }
        CHECK(outside == 0);
        CHECK(worst < 1e-12);
    }
}

TEST_CASE("fit_directional_light: the same point of the scene, the same texel and depth in every convention") {
    const directional_fit<double> fit{.direction = {1, -2, 0.5}, .low = {-1, 0, -3}, .high = {4, 2, 5}};
    const glm::dmat4 plain = texture_matrix(fit_directional_light(fit), {300, 200});
    for (clip_space clip : all_clip_spaces()) {
        auto same = fit;
        same.clip = clip;
        same.direction = in_world(fit.direction, clip);
        const glm::dvec3 low = in_world(fit.low, clip), high = in_world(fit.high, clip);
        same.low = glm::min(low, high);
        same.high = glm::max(low, high);
        const glm::dmat4 m = texture_matrix(fit_directional_light(same), {300, 200});
        for (glm::dvec3 corner : corners(fit.low, fit.high))
            CHECK(glm::length(through(m, in_world(corner, clip)) - in_convention(through(plain, corner), clip, 200)) <
                  1e-11);
    }
}

TEST_CASE("fit_directional_light: by hand, and in float") {
    // looking down -z at a box of 2 x 4 x 4, diagonal 6, margin 0.6: half extents 1.6, 2.6, 2.6
    const auto light =
        fit_directional_light<double>({.direction = {0, 0, -1}, .low = {0, 0, 0}, .high = {2, 4, 4}, .margin = 0.1});
    const glm::dmat4 uv = texture_matrix_uv(light);
    CHECK(glm::length(through(uv, {1, 2, 2}) - 0.5) < 1e-15);
    CHECK(glm::length(through(uv, {0, 0, 4}) - glm::dvec3(0.6 / 3.2, 0.6 / 5.2, 0.6 / 5.2)) < 1e-15);

    std::mt19937 random(4);
    std::uniform_real_distribution<float> coordinate(-5, 5), extent(0.1f, 8);
    int outside = 0;
    for (int i = 0; i < 2000; ++i) {
        directional_fit<float> fit{.direction = {coordinate(random), coordinate(random), coordinate(random)},
                                   .margin = 1e-4f};
        fit.low = {coordinate(random), coordinate(random), coordinate(random)};
        fit.high = fit.low + glm::vec3(extent(random), extent(random), extent(random));
        const glm::mat4 m = texture_matrix_uv(fit_directional_light(fit));
        for (glm::dvec3 corner : corners(fit.low, fit.high)) {
            const glm::vec3 p = project_coordinate(shadow_coordinate(m, glm::vec3(corner)));
            for (int k = 0; k < 3; ++k) outside += !(p[k] > 0 && p[k] < 1);
        }
    }
    CHECK(outside == 0);
}

TEST_CASE_TEMPLATE("fit_directional_light: bad input", T, float, double) {
    const auto with = [](auto change) {
        directional_fit<T> fit;
        change(fit);
        (void)fit_directional_light(fit);
    };
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    CHECK_NOTHROW(with([](auto&) {}));
    CHECK_NOTHROW(with([](auto& f) { f.high.y = f.low.y; }));                      // a plane
    CHECK_NOTHROW(with([](auto& f) { f.high.y = f.low.y, f.high.x = f.low.x; }));  // a line
    CHECK_THROWS_AS(with([](auto& f) { f.high = f.low; }), std::invalid_argument);
    for (int i = 0; i < 3; ++i) {
        CHECK_THROWS_AS(with([&](auto& f) { f.high[i] = -2; }), std::invalid_argument);
        for (T bad : {nan, -nan, infinity, -infinity}) {
            CHECK_THROWS_AS(with([&](auto& f) { f.low[i] = bad; }), std::invalid_argument);
            CHECK_THROWS_AS(with([&](auto& f) { f.high[i] = bad; }), std::invalid_argument);
            CHECK_THROWS_AS(with([&](auto& f) { f.direction[i] = bad; }), std::invalid_argument);
        }
    }
    for (T margin : {T(0), T(-1), nan, infinity})
        CHECK_THROWS_AS(with([&](auto& f) { f.margin = margin; }), std::invalid_argument);
    CHECK_THROWS_AS(with([](auto& f) { f.direction = {0, 0, 0}; }), std::invalid_argument);
}

TEST_CASE("fit_directional_light: bounds from 1e-30 to 1e37, and what it says of others") {
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const auto with = [&](auto change) {
            directional_fit<float> fit{.direction = {1, -2, 0.5f}, .clip = clip};
            change(fit);
            return complaint([&] {
                const auto space = fit_directional_light(fit);
                CHECK(detail::all_finite(space.projection * space.view));
                const glm::dmat4 m = glm::dmat4(space.projection) * glm::dmat4(space.view);
                const double low = clip.range == depth_range::zero_to_one ? 0 : -1;
                for (glm::dvec3 corner : corners(fit.low, fit.high)) {
                    const glm::dvec3 p = through(m, corner);
                    CHECK((std::abs(p.x) < 1 && std::abs(p.y) < 1 && p.z > low && p.z < 1));
                }
            });
        };
        for (float extent : {1e-30f, 1e-20f, 1e19f, 1e20f, 1e37f})
            CHECK(with([&](auto& f) { f.low = glm::vec3(-extent), f.high = glm::vec3(extent); }).empty());
        const std::string name = "umbrage::fit_directional_light: ";
        const auto flat = [](directional_fit<float>& f) { f.direction = {0, -1, 0}, f.low.y = f.high.y = 0; };
        CHECK(with([&](auto& f) { flat(f), f.margin = 1e-45f; }).starts_with(name + "low, high and margin "));
        directional_fit<float> thin{.clip = clip};
        flat(thin), thin.margin = 1e-37f;
        CHECK(complaint([&] { (void)fit_directional_light(thin); }).empty());
        CHECK(with([](auto& f) { f.margin = 3e38f; }).starts_with(name + "low, high and margin "));
        CHECK(with([](auto& f) {
                  f.low = glm::vec3(-3e38f), f.high = glm::vec3(3e38f);
              }).starts_with(name + "low, high and margin "));
        CHECK(with([](auto& f) {
                  f.high = glm::vec3(3.1e38f), f.low = glm::vec3(3e38f);
              }).starts_with(name + "low, high and margin "));  // their place in view space
        CHECK(with([](auto& f) { f.high = f.low; }).starts_with(name + "low and high must have some extent"));
        CHECK(with([](auto& f) { f.low.x = 2; }).starts_with(name + "low must not be above high"));
        CHECK(with([](auto& f) { f.margin = 0; }).starts_with(name + "margin "));
        CHECK(with([](auto& f) { f.direction = {}; }).starts_with(name + "direction "));
        const float infinity = std::numeric_limits<float>::infinity();
        CHECK(with([&](auto& f) { f.high.x = infinity; }).starts_with(name + "low and high must be finite"));
    }
}
