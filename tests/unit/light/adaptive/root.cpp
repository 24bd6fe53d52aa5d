// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <limits>
#include <random>

#include <umbrage/light/adaptive/root.hpp>

#include "../bodies.hpp"
#include "../clip_spaces.hpp"

TEST_CASE("page_light: what the root's coordinates say of a page, in every convention") {
    std::mt19937 random(5);
    for (int i = 0; i < 320; ++i) {
        const umbrage::clip_space clip = all_clip_spaces()[std::size_t(i % 16)];
        umbrage::page_root<double> fit{.side = 60, .scene = {{-9, -9, -9}, {9, 9, 9}}, .clip = clip};
        fit.direction = bodies::random_vector(random, -1, 1), fit.center = bodies::random_vector(random, -5, 5);
        const auto root = umbrage::make_page_root(fit);
        const glm::dvec3 p = bodies::random_vector(random, -9, 9);
        const glm::dvec4 at = umbrage::shadow_coordinate(umbrage::page_matrix(root), p);
        CHECK(at.w == 1);
        CHECK((at.x > 1 && at.x < 2 && at.y > 1 && at.y < 2 && at.z > 0 && at.z < 1));
        const umbrage::page page = umbrage::page_at(glm::dvec2(at), i % 12);
        const umbrage::page_size size{.texels = 32, .gutter = i % 17};
        const auto to_texels = umbrage::texture_matrix(umbrage::page_light(root, page, size), glm::ivec2(size.pitch()));
        const glm::dvec3 found(umbrage::shadow_coordinate(to_texels, p));
        const auto table = [&](glm::ivec2) { return umbrage::page_entry({0, 0}, page.level); };
        const auto expected = umbrage::page_coordinate(table, 2050.0, glm::dvec2(at), 32.0, double(size.gutter));
        CHECK(glm::length(glm::dvec2(found) - glm::dvec2(expected)) < 1e-6);
        CHECK(std::abs(found.z - at.z) < 1e-12);
    }
}

TEST_CASE("make_page_root: its square around its center, along the hint") {
    const auto root = umbrage::make_page_root<double>({.direction = {0, -1, 0},
                                                       .up = {0, 0, -1},
                                                       .center = {10, 0, 20},
                                                       .side = 8,
                                                       .scene = {{0, -1, 0}, {9, 3, 9}},
                                                       .clip = umbrage::cpu_clip_space});
    const glm::dmat4 m = umbrage::page_matrix(root);
    const auto at = [&](double x, double y, double z) { return umbrage::shadow_coordinate(m, glm::dvec3(x, y, z)); };
    CHECK(glm::length(glm::dvec2(at(10, 0, 20)) - glm::dvec2(1.5)) < 1e-12);
    CHECK(glm::length(glm::dvec2(at(14, 0, 16)) - glm::dvec2(2.0)) < 1e-12);
    CHECK(at(0, 3, 0).z < at(0, -1, 0).z);
}

TEST_CASE("make_page_root, page_light: bad input") {
    const double inf = std::numeric_limits<double>::infinity();
    const auto with = [](auto change) {
        umbrage::page_root<double> r{
            .side = 1000, .scene = umbrage::bounding_box<double>{}, .clip = umbrage::cpu_clip_space};
        change(r);
        return complaint([&] { (void)umbrage::make_page_root(r); });
    };
    CHECK(with([](auto&) {}).empty());
    CHECK(with([](auto& r) { r.direction = {0, 0, 0}; }).starts_with("umbrage::make_page_root: direction "));
    CHECK(with([&](auto& r) { r.center = {0, inf, 0}; }).starts_with("umbrage::make_page_root: center "));
    CHECK(with([](auto& r) {
              r.side = umbrage::page_root<double>{}.side;
          }).starts_with("umbrage::make_page_root: side "));
    CHECK(with([](auto& r) { r.side = 0; }).starts_with("umbrage::make_page_root: side "));
    CHECK(with([&](auto& r) { r.side = inf; }).starts_with("umbrage::make_page_root: side "));
    CHECK(with([](auto& r) { r.side = 1e-8, r.center = {1e7, 0, 0}; }).starts_with("umbrage::make_page_root: side "));
    CHECK(with([](auto& r) { r.side = 1e-8, r.scene.low.z = -1e7; }).starts_with("umbrage::make_page_root: side "));
    CHECK(with([](auto& r) { r.side = 1e-7, r.center = {1e7, 0, 0}; }).empty());
    CHECK(with([&](auto& r) { r.scene = {{0, 0, 0}, {0, inf, 0}}; }).starts_with("umbrage::make_page_root: scene."));
    const auto light = [](const umbrage::page& p, const umbrage::page_size& size = {}) {
        return complaint([&] {
            (void)umbrage::page_light(
                umbrage::make_page_root<float>(
                    {.side = 1000, .scene = umbrage::bounding_box<float>{}, .clip = umbrage::cpu_clip_space}),
                p, size);
        });
    };
    CHECK(light({15, 0, 32767}).empty());
    CHECK(light({16, 0, 0}).starts_with("umbrage::page_light: level "));
    CHECK(light({3, 8, 0}).starts_with("umbrage::page_light: x and y "));
    CHECK(light({3, 0, -1}).starts_with("umbrage::page_light: x and y "));
    for (const int texels : {48, 0, 1 << 15, 1 << 30, std::numeric_limits<int>::min()})
        CHECK(light({}, {.texels = texels}).starts_with("umbrage::page_light: texels "));
    CHECK(light({}, {.texels = 16384, .gutter = 8192}).empty());
    CHECK(light({}, {.texels = 8, .gutter = 5}).starts_with("umbrage::page_light: gutter "));
}
