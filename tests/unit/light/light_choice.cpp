// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/light_choice.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>

#include "clip_spaces.hpp"
#include "reference_view.hpp"

using namespace umbrage;

namespace {

/// The long ground, from 36 by 20 pixels.
std::vector<seen_point> ground_points() {
    std::vector<seen_point> all;
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 36; ++x)
            if (const auto p = reference_view::ground_at(reference_view::reference, glm::dvec2(x, y) * 36.0 + 0.5))
                all.push_back({*p, {0, 1, 0}});
    return all;
}

const choice_terms over_ground{.to_pixels = reference_view::reference.to_pixels, .map_size = {2048, 2048}};

}  // namespace

TEST_CASE("choose_light: a warp over the ground, by what a full measurement says") {
    const std::vector<seen_point> seen = ground_points();
    REQUIRE(seen.size() > 300);
    for (const auto& sun : reference_view::suns) {
        const warp_fit<double> fit = reference_view::warp_under(sun);
        const std::array lights{fit_directional_light<double>({.direction = fit.direction,
                                                               .up = fit.camera.direction,
                                                               .receivers = fit.receivers,
                                                               .margin = 0,
                                                               .clip = cpu_clip_space}),
                                fit_light_space_perspective<double>(fit, optimal_distance(fit)).light,
                                fit_light_space_perspective(fit).light};
        const light_choice choice = choose_light<double>(lights, seen, over_ground);
        CHECK(choice.kept == 2);
        REQUIRE(choice.p95.size() == 3);
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const auto all = reference_view::on_ground({texture_matrix(lights[i], reference_view::map_size)});
            CHECK(choice.p95[i] == doctest::Approx(all.p95).epsilon(0.1));
        }
    }
}

TEST_CASE("choose_light: uniform where a strong warp leaves a wall with too few texels") {
    for (const double distance : {15.0, 40.0}) {  // so that it takes a fifth and less than a tenth of the screen
        std::vector<seen_point> seen = ground_points();
        const glm::dvec3 eye(0, 2, 0);
        for (seen_point& p : seen)
            if (p.position.z < -distance) p = {eye + (p.position - eye) * (-distance / p.position.z), {0, 0, 1}};
        const bounding_box<double> scene{{-2 * distance, 0, -distance}, {2 * distance, 2, 0}};
        const warp_fit<double> fit{.camera = reference_view::reference.seen,
                                   .direction = reference_view::sun(40, 180),
                                   .receivers = intersection(reference_view::reference.seen, scene),
                                   .margin = 0,
                                   .clip = cpu_clip_space};
        const std::array lights{fit_light_space_perspective<double>(fit, 0.3).light,
                                fit_light_space_perspective<double>(fit, 1e9).light};
        CHECK(choose_light<double>(lights, seen, over_ground, 0).kept == (distance < 20 ? 1 : 0));
        CHECK(choose_light<double>(lights, seen, over_ground, 1).kept == (distance < 20 ? 1 : 0));
    }
}

TEST_CASE("choose_light: another light has to be better by a tenth, so that noise changes nothing") {
    const std::vector<seen_point> seen(5, seen_point{{0, 0, -5}, {0, 1, 0}});
    std::size_t kept = 0, nearest = 0;
    int changes = 0, loose_changes = 0;
    for (int i = 0; i < 628; ++i) {
        const double side = 10 * (1 + 0.2 * std::sin(i * 0.01) + 0.05 * std::sin(i * 1.3));
        const auto light = [](double width) {
            return fit_directional_light<double>(
                {.receivers = bounding_box<double>{glm::dvec3(-width), glm::dvec3(width)}, .clip = cpu_clip_space});
        };
        const std::array lights{light(10), light(side)};
        const light_choice choice = choose_light<double>(lights, seen, over_ground, kept);
        CHECK(choice.p95[1] / choice.p95[0] == doctest::Approx(side / 10));
        CHECK(choice.p95[choice.kept] <= choice.p95[1 - choice.kept] / 0.9 * (1 + 1e-12));
        choice_terms any = over_ground;
        any.better = 0;
        const std::size_t best = choose_light<double>(lights, seen, any, nearest).kept;
        changes += choice.kept != kept, loose_changes += best != nearest;
        kept = choice.kept, nearest = best;
    }
    CHECK(changes == 1);
    CHECK(loose_changes > 10);
}

TEST_CASE("choose_light: points that a map does not hold, or that see it edge on, and none; bad input") {
    const std::array lights{fit_directional_light<float>({.receivers = bounding_box<float>{}, .clip = cpu_clip_space}),
                            fit_directional_light<float>(
                                {.receivers = bounding_box<float>{{-9, -9, -9}, {9, 9, 9}}, .clip = cpu_clip_space})};
    const std::vector<seen_point> inside(20, seen_point{{0, 0, -0.9}}), outside(20, seen_point{{0, 0, -5}}),
        edge_on(20, seen_point{{0, 0, -0.9}, {1, 0, 0}});
    const auto with = [&](const auto& seen) { return choose_light<float>(lights, seen, over_ground, 1); };
    CHECK(with(inside).kept == 0);
    CHECK(with(outside).kept == 1);
    CHECK(with(outside).p95[0] == detail::highest<double>);
    for (const auto& none : {with(edge_on), with(std::vector<seen_point>())}) {
        CHECK(none.kept == 1);
        CHECK(none.p95 == std::vector<double>{0, 0});
    }
    const std::string name = "umbrage::choose_light: ";
    const auto refused = [&](auto change, std::size_t before = 0) {
        choice_terms terms = over_ground;
        change(terms);
        return complaint([&] { (void)choose_light<float>(lights, inside, terms, before); });
    };
    CHECK(refused([](auto&) {}).empty());
    CHECK(refused([](auto&) {}, 2).starts_with(name + "before "));
    CHECK(refused([](auto& t) { t.better = -1; }).starts_with(name + "better "));
    CHECK(refused([](auto& t) { t.to_pixels[0][0] = NAN; }).starts_with(name + "to_pixels "));
    CHECK(refused([](auto& t) { t.map_size.x = 0; }).starts_with(name + "map_size "));
    CHECK(complaint([&] { (void)choose_light<float>({}, inside, over_ground); }).starts_with(name + "lights "));
}
