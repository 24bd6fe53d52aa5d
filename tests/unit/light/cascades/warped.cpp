// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/cascades/warped.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>

#include "../clip_spaces.hpp"
#include "../reference_view.hpp"

using namespace umbrage;

TEST_CASE("make_warped_cascades: four over a long ground, as measured apart") {
    struct row {
        double p95, greatest;
    };
    // of an implementation apart from this one, by finite differences
    constexpr std::array rows{row{2.38, 2.60}, row{2.92, 3.29}, row{4.44, 4.90}, row{2.62, 2.79},
                              row{4.86, 5.40}, row{3.68, 4.57}, row{5.88, 6.76}, row{15.1, 18.6}};
    std::array<double, 5> splits = practical_splits<4>(1.0, 1000.0, 0.9);
    splits[0] = 0.5;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CAPTURE(i);
        const auto [elevation, azimuth] = reference_view::suns[i];
        const cascade_fit<double> fit{.camera = reference_view::reference.seen,
                                      .direction = reference_view::sun(elevation, azimuth),
                                      .scene = reference_view::reference_scene,
                                      .margin = 0,
                                      .clip = cpu_clip_space};
        std::vector<glm::dmat4> to_texels;
        for (const auto& c : make_warped_cascades<4>(fit, splits, [](const auto& part) {
                 return fit_light_space_perspective<double>(part, optimal_distance(part));
             }))
            to_texels.push_back(texture_matrix(c.light, {1024, 1024}));
        const auto report = reference_view::on_ground(to_texels, {1024, 1024}, {splits[1], splits[2], splits[3]});
        CHECK(report.p95 == doctest::Approx(rows[i].p95).epsilon(0.01));
        CHECK(report.greatest == doctest::Approx(rows[i].greatest).epsilon(0.01));
        if (i > 0) continue;
        CHECK(report.mean == doctest::Approx(1.85).epsilon(0.01));
        CHECK(report.storage_factor == doctest::Approx(16).epsilon(0.05));
    }
}

TEST_CASE_TEMPLATE("make_warped_cascades: each holds its part and overlap, with the margin, its own convention", T,
                   float, double) {
    for (const clip_space clip : all_clip_spaces()) {
        const frustum<T> camera{.position = {1, 2, 0}, .direction = {T(0.3), T(-0.2), -1}};
        const cascade_fit<T> fit{.camera = camera,
                                 .direction = {1, -2, T(0.5)},
                                 .scene = {glm::vec<3, T>(-30), glm::vec<3, T>(30)},
                                 .map_size = {256, 256},
                                 .margin = 4,
                                 .overlap = T(0.5),
                                 .clip = clip};
        const auto cascades = make_warped_cascades<3>(
            fit, {T(1), T(4), T(10), T(20)}, [](const auto& part) { return fit_light_space_perspective(part); });
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(cascades[i].light.clip == clip);
            CHECK(cascades[i].strength > 0);
            frustum<T> part = camera;
            part.z_near = std::array{T(1), T(2.5), T(7)}[i], part.z_far = std::array{T(4), T(10), T(20)}[i];
            double least = 256;
            for (const glm::dvec3& p : hull(intersection(part, fit.scene)).points) {
                const glm::dvec3 at = through(texture_matrix(cascades[i].light, {256, 256}), p);
                for (const double edge : {at.x, 256 - at.x, at.y, 256 - at.y}) least = std::min(least, edge);
                CHECK((at.z >= 0 && at.z <= 1));
            }
            CHECK(least == doctest::Approx(4).epsilon(0.001));
        }
    }
}

TEST_CASE_TEMPLATE("make_cascade_uniforms: warped cascades of any number, chosen by depth, look up what their own do",
                   T, float, double) {
    const auto check = [&]<std::size_t Count>(const std::array<T, Count + 1>& splits) {
        const frustum<T> camera{.position = {1, 2, 0}, .direction = {0, 0, -1}};
        const cascade_fit<T> fit{.camera = camera,
                                 .direction = {1, -2, T(0.5)},
                                 .scene = {glm::vec<3, T>(-60), glm::vec<3, T>(60)},
                                 .map_size = {256, 256},
                                 .margin = 4,
                                 .overlap = T(0.25),
                                 .clip = cpu_clip_space};
        const auto cascades = make_warped_cascades<Count>(
            fit, splits, [](const auto& part) { return fit_light_space_perspective(part); });
        const auto u = make_cascade_uniforms(cascades, fit.map_size, T(0.25));
        for (T depth = splits[0]; depth < splits[Count]; depth += T(0.0625)) {
            std::size_t expected = 0;
            while (depth >= splits[expected + 1]) ++expected;
            T number = 0;
            for (const auto& ends : u.ends) number += cascade_by_depth(depth, ends);
            REQUIRE(static_cast<std::size_t>(number) == expected);
            const auto& c = cascades[expected];
            CHECK(c.begin == splits[expected]);
            CHECK(c.end == splits[expected + 1]);
            const T weight = cascade_fade(depth, u.fades[expected].x, u.fades[expected].y);
            const T share = (depth - c.begin) / (c.end - c.begin);
            CHECK(double(weight) == doctest::Approx(double(share <= T(0.75) ? T(0) : 4 * share - 3)).epsilon(0.01));
            // a point of the next cascade's share of this one lies in both maps
            const glm::vec<3, T> world = camera.position + depth * camera.direction;
            const std::size_t last = weight > 0 && expected + 1 < Count ? expected + 1 : expected;
            for (std::size_t i = expected; i <= last; ++i) {
                const glm::vec<3, T> at = project_coordinate(shadow_coordinate(u.to_texels[i], world));
                for (const T edge : {at.x, 256 - at.x, at.y, 256 - at.y}) CHECK(edge > T(3.9));
            }
        }
    };
    check.template operator()<1>({1, 20});
    check.template operator()<3>({1, 4, 10, 20});
    check.template operator()<4>({1, 4, 10, 20, 40});
    check.template operator()<5>({1, 4, 10, 20, 30, 40});
    check.template operator()<8>({1, 2, 4, 7, 10, 15, 20, 30, 40});
}

TEST_CASE("make_cascade_uniforms: bad input, of warped cascades") {
    const auto complain = [](glm::ivec2 map_size, float fade) {
        return complaint([&] { (void)make_cascade_uniforms(std::array<warped_cascade<float>, 2>{}, map_size, fade); });
    };
    CHECK(complain({64, 0}, 0).starts_with("umbrage::make_cascade_uniforms: map_size "));
    for (const float fade : {-0.1f, 1.1f, std::numeric_limits<float>::quiet_NaN()})
        CHECK(complain({64, 64}, fade).starts_with("umbrage::make_cascade_uniforms: fade "));
    const std::array one{warped_cascade<float>{.light = {.clip = cpu_clip_space}, .begin = 1, .end = 10}};
    CHECK(complaint([&] { (void)make_cascade_uniforms(one, {64, 64}, 0.1f); }).empty());
    CHECK(complaint([&] {
              (void)make_cascade_uniforms(one, {64, 64}, 1e-41f);
          }).starts_with("umbrage::make_cascade_uniforms: fade must be 0, or large enough"));
}

TEST_CASE("make_warped_cascades: far from the origin, float matrices keep a slice before the far plane") {
    int tried = 0, beyond = 0;
    for (const clip_space clip : all_clip_spaces())
        for (const float away : {1e2f, 1e3f, 1e4f})
            for (int k = 0; k < 8; ++k) {
                const glm::vec3 middle = away * glm::vec3(std::cos(float(k)), 0.3f, std::sin(float(k)));
                const frustum<float> camera{.position = middle + glm::vec3(1, 2, 4), .direction = {-0.2f, -0.4f, -1}};
                const cascade_fit<float> fit{.camera = camera,
                                             .direction = {std::sin(2.0f * float(k)), -1, 0.4f},
                                             .scene = {middle - 1e4f, middle + 1e4f},
                                             .map_size = {256, 256},
                                             .clip = clip};
                const auto cascades = make_warped_cascades<2>(
                    fit, {0.2f, 3.0f, 9.0f}, [](const auto& part) { return fit_light_space_perspective(part); });
                for (const warped_cascade<float>& c : cascades) {
                    frustum<float> slice = camera;
                    slice.z_near = c.begin, slice.z_far = c.end;
                    const light_space<double> exact{glm::dmat4(c.light.view), glm::dmat4(c.light.projection), clip};
                    const glm::dmat4 to_map = texture_matrix(exact, fit.map_size);
                    for (const glm::dvec3& p : hull(slice).points) {
                        const double depth = through(to_map, p).z;
                        ++tried, beyond += !(depth >= 0 && depth <= 1);
                    }
                }
            }
    CHECK(tried > 1000);
    CHECK(beyond == 0);
}

TEST_CASE("make_warped_cascades: bad input") {
    const std::string name = "umbrage::make_warped_cascades: ";
    const auto with = [](auto change, std::array<double, 3> splits = {1, 2, 3}) {
        return complaint([&] {
            cascade_fit<double> fit{.scene = bounding_box<double>{}, .clip = cpu_clip_space};
            change(fit);
            (void)make_warped_cascades<2>(fit, splits,
                                          [](const auto& part) { return fit_light_space_perspective(part); });
        });
    };
    CHECK(with([](auto&) {}).empty());
    CHECK(with([](auto&) {}, {1, 1, 3}).starts_with(name + "splits "));
    CHECK(with([](auto& f) { f.map_size = {64, 5}; }).starts_with(name + "map_size "));
    CHECK(with([](auto& f) { f.overlap = 2; }).starts_with(name + "overlap "));
    CHECK(with([](auto& f) { f.margin = -1; }).starts_with(name + "margin "));
    CHECK(with([](auto& f) { f.direction = {}; }).starts_with("umbrage::fit_light_space_perspective: direction "));
}
