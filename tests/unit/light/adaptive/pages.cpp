// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <umbrage/light/adaptive/pages.hpp>
#include <umbrage/light/adaptive/root.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/pixels_per_texel.hpp>

#include "../../rounds.hpp"
#include "../clip_spaces.hpp"
#include "../reference_view.hpp"

namespace {

using reference_view::view;
using umbrage::page;
using umbrage::page_receiver;

/// Receivers of a camera over the ground, at every few pixels.
std::vector<page_receiver> ground_receivers(const view& v, const glm::dmat4& to_root, int step) {
    glm::dmat4 to_texels(1);  // of a map of one page
    to_texels[0][0] = to_texels[1][1] = 128;
    to_texels = to_texels * to_root;
    std::vector<page_receiver> all;
    for (glm::ivec2 pixel(0); pixel.y < reference_view::screen.y; pixel.y += step)
        for (pixel.x = 0; pixel.x < reference_view::screen.x; pixel.x += step)
            if (const auto p = reference_view::ground_at(v, glm::dvec2(pixel) + 0.5)) {
                const auto pixels = umbrage::pixels_per_texel(to_texels, v.to_pixels, *p, glm::dvec3(0, 1, 0));
                all.push_back({glm::vec2(umbrage::shadow_coordinate(to_root, *p)),
                               static_cast<float>(umbrage::longest_extent(pixels))});
            }
    return all;
}

glm::dmat4 ground_root(glm::dvec3 direction) {
    return umbrage::page_matrix(umbrage::make_page_root<double>({.direction = direction,
                                                                 .up = {0, 0, -1},
                                                                 .side = 2400,
                                                                 .scene = reference_view::reference_scene,
                                                                 .clip = umbrage::cpu_clip_space}));
}

}  // namespace

TEST_CASE("wanted_pages: the least level that resolves, each page once, coarse ones first") {
    const float inf = std::numeric_limits<float>::infinity();
    const std::vector<page_receiver> seen{{{1.3f, 1.9f}, 8.5f}, {{1.3f, 1.9f}, 8.0f}, {{1.99f, 1.0f}, 1.0f},
                                          {{1.3f, 1.9f}, 7.0f}, {{1.1f, 1.6f}, 0.1f}, {{1.9f, 1.9f}, 1e30f},
                                          {{2.0f, 1.5f}, 4.0f}, {{0.9f, 1.5f}, 4.0f}, {{1.5f, 1.5f}, inf},
                                          {{1.5f, 1.5f}, 0.0f}, {{1.5f, 1.5f}, -inf}};
    CHECK(umbrage::wanted_pages(seen, 1.0, 5) == std::vector<page>{{0, 0, 0}, {3, 2, 7}, {4, 4, 14}, {5, 28, 28}});
    CHECK(umbrage::wanted_pages(seen, 100.0, 5) == std::vector<page>{{0, 0, 0}, {5, 28, 28}});
    CHECK(umbrage::wanted_pages({}, 1.0, 5).empty());
}

TEST_CASE("page_cache: slots of pages stay, those least recently needed are given up, finer ones first") {
    umbrage::page_cache cache({.slots = {2, 2}, .deepest_level = 4});
    const auto update = [&](std::vector<page_receiver> seen) { return cache.update(seen); };
    const page_receiver a{{1.1f, 1.1f}, 2.0f}, b{{1.9f, 1.9f}, 2.0f}, c{{1.9f, 1.1f}, 2.0f}, d{{1.1f, 1.9f}, 2.0f};
    const auto first = update({a, b});
    REQUIRE(first.drawn.size() == 3);
    CHECK(first.drawn[0].page == page{});
    CHECK(first.drawn[2].page == page{1, 1, 1});
    CHECK(first.kept == 0);
    CHECK(update({c}).drawn.size() == 1);
    CHECK(cache.level_at({1.9, 1.9}) == 1);
    const auto third = update({d});
    REQUIRE(third.drawn.size() == 1);
    CHECK(third.drawn[0].page == page{1, 0, 1});
    CHECK(third.drawn[0].slot == first.drawn[2].slot);
    CHECK(third.kept == 1);
    CHECK(third.given_up == 1);
    CHECK(third.forced == 0);
    CHECK(cache.level_at({1.9, 1.9}) == 0);
    CHECK(cache.level_at({1.1, 1.1}) == 1);
    CHECK(update({a, d}).drawn.empty());
    CHECK(cache.size() == 4);
    cache.forget();
    CHECK(cache.level_at({1.1, 1.1}) == -1);
    CHECK(update({a, d}).drawn.size() == 3);
}

TEST_CASE("page_cache: the root alone where nothing is seen, and where there is one slot") {
    umbrage::page_cache cache({.slots = {1, 1}, .deepest_level = 15});
    CHECK(cache.update({}).drawn.size() == 1);
    const std::vector<page_receiver> seen{{{1.1f, 1.1f}, 1000.0f}};
    const auto update = cache.update(seen);
    CHECK(update.drawn.empty());
    CHECK(update.target >= 1000.0);
    CHECK(cache.level_at({1.1, 1.1}) == 0);
}

TEST_CASE("page_cache: 256 pages of 128 x 128 over a long ground, for suns all around") {
    // of an implementation apart from this one
    constexpr double known[][2]{{1.98, 2.06}, {2.14, 2.20}, {2.44, 2.55}, {2.11, 2.18},
                                {2.11, 2.18}, {2.20, 2.28}, {3.46, 3.58}, {3.46, 3.58}};
    for (std::size_t i = 0; i < reference_view::suns.size(); ++i) {
        CAPTURE(i);
        const glm::dvec3 direction = reference_view::sun(reference_view::suns[i][0], reference_view::suns[i][1]);
        const auto seen = ground_receivers(reference_view::reference, ground_root(direction), 2 * one_round_in);
        umbrage::page_cache cache({.slots = {16, 16}, .deepest_level = 15});
        CHECK(cache.update(seen).drawn.size() <= 256);
        std::vector<double> extents;
        for (const page_receiver& r : seen) extents.push_back(r.extent / std::exp2(cache.level_at(r.coord)));
        std::sort(extents.begin(), extents.end());
        const double p95 = extents[extents.size() * 95 / 100];
        CHECK(p95 < 1.1 * known[i][0]);
        CHECK(extents.back() < 1.1 * known[i][1]);
        const auto uniform = umbrage::fit_directional_light<double>(
            {.direction = direction,
             .up = reference_view::reference.seen.direction,
             .receivers = intersection(reference_view::reference.seen, reference_view::reference_scene),
             .casters = reference_view::reference_scene,
             .margin = 0,
             .clip = umbrage::cpu_clip_space});
        const auto report = reference_view::on_ground({umbrage::texture_matrix(uniform, reference_view::map_size)});
        CHECK(report.p95 > 20 * p95);
    }
}

TEST_CASE("page_cache: pages pop under a moving camera only where the budget forces it, and are counted") {
    const glm::dmat4 to_root = ground_root({-0.5, -1, 0.3});
    for (const int side : {24, 7}) {
        CAPTURE(side);
        const umbrage::page_budget budget{.slots = glm::ivec2(side), .deepest_level = 14, .target = 2};
        umbrage::page_cache cache(budget);
        std::size_t forced = 0, drawn = 0, needed = 0;
        for (int frame = 0; frame < 40; ++frame) {
            umbrage::frustum<double> camera = reference_view::reference.seen;
            camera.position += glm::dvec3(0, 0, -0.75 * frame);
            camera.direction = {0.02 * frame, 0, -1};
            const auto seen = ground_receivers(view(camera), to_root, 16);
            const umbrage::page_cache before = cache;
            const auto update = cache.update(seen);
            std::set<page> popped;
            for (const page_receiver& r : seen) {
                const double at_most = r.extent / std::exp2(cache.level_at(r.coord));
                if (!(at_most <= update.target * 1.000001)) CHECK(at_most <= update.target);
                const int was = before.level_at(r.coord);
                if (cache.level_at(r.coord) < was && at_most > budget.target)
                    popped.insert(umbrage::page_at(r.coord, was));
            }
            CHECK(update.forced == popped.size());
            before.for_each([&](const page& p, glm::ivec2 slot) {
                cache.for_each([&](const page& q, glm::ivec2 other) {
                    if (p == q && slot != other) CHECK(slot == other);
                });
            });
            const auto again = cache.update(seen);
            CHECK(again.drawn.empty());
            CHECK(again.target == update.target);
            forced += update.forced, drawn += update.drawn.size(), needed += update.kept + update.drawn.size();
        }
        CHECK((forced == 0) == (side == 24));
        CHECK(drawn * 4 < needed);
    }
}

TEST_CASE("wanted_pages, page_cache: bad input") {
    const auto wanted = [](double target, int deepest) {
        return complaint([&] { (void)umbrage::wanted_pages({}, target, deepest); });
    };
    CHECK(wanted(1, 15).empty());
    for (const double target : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
        CHECK(wanted(target, 0).starts_with("umbrage::wanted_pages: target "));
    for (const int deepest : {-1, 16}) CHECK(wanted(1, deepest).starts_with("umbrage::wanted_pages: deepest_level "));
    const auto cache = [](const umbrage::page_budget& budget) {
        return complaint([&] { (void)umbrage::page_cache(budget); });
    };
    CHECK(cache({.slots = {0, 4}}).starts_with("umbrage::page_cache: slots "));
    CHECK(cache({.slots = {4, 257}}).starts_with("umbrage::page_cache: slots "));
    CHECK(cache({.deepest_level = 16}).starts_with("umbrage::page_cache: deepest_level "));
    for (const double target : {0.0, 5e-324, 1e-308, std::numeric_limits<double>::infinity()})
        CHECK(cache({.target = target}).starts_with("umbrage::page_cache: target "));
}

TEST_CASE("page_cache: the least target that it takes rises until the pages fit") {
    umbrage::page_cache cache({.slots = {1, 1}, .deepest_level = 3, .target = 0x1p-1022});
    const std::vector<page_receiver> seen{{{1.2f, 1.7f}, 4.0f}};
    CHECK(cache.update(seen).target >= 4.0);
    CHECK(cache.level_at({1.2, 1.7}) == 0);
}

TEST_CASE("page_at, level_at: outside the root there is no page") {
    constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    umbrage::page_cache cache({.slots = {2, 2}, .deepest_level = 3});
    CHECK(cache.level_at({1.5, 1.5}) == -1);
    (void)cache.update({});
    CHECK(cache.level_at({1.0, 1.0}) == 0);
    CHECK(cache.level_at({1.5, 2.0 - 0x1p-52}) == 0);
    CHECK(umbrage::page_at({2.0 - 0x1p-52, 1.0}, 15) == page{15, 32767, 0});
    for (const double beside : {nan, inf, -inf, 1e12, -1e300, 2.0, 1.0 - 0x1p-53, 0.0}) {
        CHECK(cache.level_at({beside, 1.5}) == -1);
        CHECK(cache.level_at({1.5, beside}) == -1);
        CHECK(umbrage::page_at({1.5, beside}, 3) == page{3, -1, -1});
        CHECK(umbrage::page_at({beside, 1.5}, 0) == page{0, -1, -1});
    }
}

TEST_CASE("page_cache: one that was moved from is empty, and fills again") {
    umbrage::page_cache cache({.slots = {2, 2}, .deepest_level = 3});
    const std::vector<page_receiver> seen{{{1.9f, 1.9f}, 2.0f}};
    const auto first = cache.update(seen);
    const umbrage::page_cache moved = std::move(cache);
    CHECK(moved.level_at({1.9, 1.9}) == 1);
    CHECK(cache.level_at({1.9, 1.9}) == -1);
    const auto again = cache.update(seen);
    REQUIRE(again.drawn.size() == first.drawn.size());
    CHECK(again.drawn.back().page == first.drawn.back().page);
    CHECK(again.drawn.back().slot == first.drawn.back().slot);
}
