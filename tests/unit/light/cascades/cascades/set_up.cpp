// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/light/cascades/cascades.hpp>

#include <cmath>
#include <limits>
#include <string>

#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/light/cascades/select.hpp>

#include "../../clip_spaces.hpp"

using namespace umbrage;

TEST_CASE("make_stable_cascades, make_tight_cascades: what is wrong is named") {
    using fit = cascade_fit<float>;
    const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
    const auto of = [](auto change, std::array<float, 3> splits = {1.0f, 10.0f, 100.0f}) {
        fit f{.scene = bounding_box<float>{}, .clip = cpu_clip_space};
        change(f);
        const std::string stable = complaint([&] { (void)make_stable_cascades<2>(f, splits); });
        const std::string tight = complaint([&] { (void)make_tight_cascades<2>(f, splits); });
        const auto argument = [](const std::string& message) {
            const auto begin = message.find(": ");
            return message.empty() ? message : message.substr(begin + 2, message.find(" must") - begin - 2);
        };
        CHECK(argument(stable) == argument(tight));
        return argument(stable);
    };
    const auto nothing = [](fit&) {};
    CHECK(of(nothing).empty());
    CHECK(of(nothing, {0.0f, 1.0f, 2.0f}).empty());
    for (const std::array<float, 3> splits :
         {std::array{-1.0f, 1.0f, 2.0f}, std::array{1.0f, 1.0f, 2.0f}, std::array{1.0f, 3.0f, 2.0f},
          std::array{nan, 1.0f, 2.0f}, std::array{1.0f, nan, 2.0f}, std::array{1.0f, 2.0f, infinity}})
        CHECK(of(nothing, splits).starts_with("splits"));
    for (const float bad : {0.0f, -1.0f, nan, infinity}) {
        CHECK(of([=](fit& f) { f.camera.tan_half_x = bad; }) == "camera.tan_half_x");
        CHECK(of([=](fit& f) { f.camera.tan_half_y = bad; }) == "camera.tan_half_y");
    }
    CHECK(of([&](fit& f) { f.camera.position.x = nan; }) == "camera.position");
    CHECK(of([&](fit& f) { f.camera.direction = glm::vec3(0); }) == "camera.direction");
    CHECK(of([](fit& f) { f.direction = glm::vec3(0); }) == "direction");
    const fit nowhere{.direction = {0, 0, 0}, .scene = bounding_box<float>{}, .clip = cpu_clip_space};
    CHECK(complaint([&] {
              (void)make_stable_cascades<1>(nowhere, std::array{1.0f, 2.0f});
          }) == "umbrage::make_stable_cascades: direction must be of a length above 0; got (0, 0, 0)");
    CHECK(of([&](fit& f) { f.direction.y = nan; }) == "direction");
    CHECK(of([&](fit& f) { f.up.y = infinity; }) == "up");
    CHECK(of([](fit& f) { f.scene.low.x = 2.0f; }) == "scene.low");
    CHECK(of([&](fit& f) { f.scene.high.x = infinity; }) == "scene.high");
    for (const glm::ivec2 bad : {glm::ivec2(0), glm::ivec2(5), glm::ivec2(5, 64), glm::ivec2(64, -64)})
        CHECK(of([=](fit& f) { f.map_size = bad; }) == "map_size");
    for (const float bad : {-1.0f, nan, infinity}) CHECK(of([=](fit& f) { f.margin = bad; }) == "margin");
    for (const float bad : {-0.1f, 1.1f, nan}) CHECK(of([=](fit& f) { f.overlap = bad; }) == "overlap");
}

TEST_CASE(
    "make_stable_cascades, make_tight_cascades: along the light, flat scenes, the ends of the numbers: finite, or a "
    "complaint") {
    const float greatest = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::min();
    int made = 0;
    for (const float z_far : {1.0f, 1e6f, greatest})
        for (const float extent : {0.0f, least, 1.0f, 1e20f, greatest})
            for (const float tangent : {least, 1e-3f, 1e3f, greatest})
                for (const glm::vec3 direction :
                     {glm::vec3(0, 0, -1), glm::vec3(0, 0, 1), glm::vec3(greatest), glm::vec3(least)}) {
                    const cascade_fit<float> fit{
                        .camera = {.tan_half_x = tangent},
                        .direction = direction,
                        .scene = {glm::vec3(-extent, 0, -extent), glm::vec3(extent, 0, extent)},
                        .clip = cpu_clip_space};
                    const auto check = [&](const auto& all) {
                        for (const cascade<float>& c : all) {
                            CHECK(umbrage::detail::all_finite(c.light.projection * c.light.view));
                            CHECK(umbrage::detail::all_finite(c.scale));
                            CHECK(umbrage::detail::all_finite(c.offset));
                            ++made;
                        }
                    };
                    const std::array splits{z_far / 2, z_far};
                    const std::string stable = complaint([&] { check(make_stable_cascades<1>(fit, splits)); });
                    const std::string tight = complaint([&] { check(make_tight_cascades<1>(fit, splits)); });
                    if (z_far > 1.0f || extent != 1.0f || tangent > 1e3f || tangent < 1e-3f) continue;
                    CHECK(stable.empty());
                    CHECK(tight.empty());
                }
    CHECK(made > 100);
}

TEST_CASE("make_tight_cascades: a camera that looks away from the scene has cascades of its frustum") {
    const cascade_fit<double> fit{.camera = {.position = {0, 0, -20}},
                                  .direction = {0, -1, 0.1},
                                  .scene = bounding_box<double>{},
                                  .clip = cpu_clip_space};
    for (const auto& c : make_tight_cascades<2>(fit, std::array{1.0, 10.0, 100.0})) {
        const glm::dvec3 ahead(0, 0, -20 - (c.begin + c.end) / 2);
        const glm::dvec3 at = cascade_coordinate(glm::dvec3(c.light.view * glm::dvec4(ahead, 1)), c.scale, c.offset);
        CHECK(inside_cascade(at, glm::dvec2(1024), 2.0));
    }
}

TEST_CASE_TEMPLATE("make_tight_cascades: a slice that touches the scene in a point has a map of its frustum", T, float,
                   double) {
    cascade_fit<T> fit{.camera = {.direction = {0, 0, -1}, .tan_half_x = 1, .tan_half_y = 1, .z_near = 1, .z_far = 8},
                       .direction = {-1, -2, -3},
                       .clip = cpu_clip_space};
    const auto scale_of = [&](glm::vec<3, T> corner) {
        fit.scene = {corner, corner + T(1)};
        return glm::vec<2, T>(make_tight_cascades<1>(fit, std::array{T(4), T(8)})[0].scale);
    };
    const glm::vec<2, T> missed = scale_of({9, 9, -8});
    CHECK(scale_of({8, 8, -8}) == missed);                       // the frustum's farthest corner
    CHECK(scale_of({T(8) - T(1e-5), 8, -8}).x > 10 * missed.x);  // an edge of a little length
}

TEST_CASE_TEMPLATE("make_cascade_uniforms: of five to nine cascades, in groups, each has what it has by itself", T,
                   float, double) {
    const auto check = [&]<std::size_t Count>() {
        const cascade_fit<T> fit{.scene = bounding_box<T>{glm::vec<3, T>(-50), glm::vec<3, T>(50)},
                                 .overlap = T(0.2),
                                 .clip = cpu_clip_space};
        std::array<T, Count + 1> splits;
        for (std::size_t i = 0; i <= Count; ++i) splits[i] = T(1 + i * i);
        const auto all = make_stable_cascades<Count>(fit, splits);
        const auto u = make_cascade_uniforms(all, T(0.2));
        CHECK(u.rotation == all[0].light.view);
        for (std::size_t i = 0; i < Count; ++i) {
            T number = 0;
            for (const auto& ends : u.ends) number += cascade_by_depth((splits[i] + splits[i + 1]) / 2, ends);
            CHECK(number == T(i));
            const auto column = static_cast<glm::length_t>(i % 4);
            const auto alone = make_cascade_uniforms(std::array{all[i]}, T(0.2));
            CHECK(u.scales[i / 4][column] == alone.scales[0]);
            CHECK(u.offsets[i / 4][column] == alone.offsets[0]);
        }
        for (std::size_t i = Count; i < 4 * u.scales.size(); ++i)
            CHECK(u.offsets[i / 4][static_cast<glm::length_t>(i % 4)].x == T(65536));
        const auto four = make_cascade_uniforms(std::array{all[0], all[1], all[2], all[3]}, T(0.2));
        CHECK(u.scales[0] == four.scales);
        CHECK(u.offsets[0] == four.offsets);
        T beyond = 0;
        for (const auto& ends : u.ends) beyond += cascade_by_depth(T(1e30), ends);
        CHECK(beyond == T(Count - 1));
    };
    check.template operator()<5>();
    check.template operator()<7>();
    check.template operator()<8>();
    check.template operator()<9>();
}

TEST_CASE("make_cascade_uniforms: the next cascade fades in over the last share of each") {
    const auto all = make_stable_cascades<3>(
        cascade_fit<double>{.scene = bounding_box<double>{}, .overlap = 0.2, .clip = cpu_clip_space},
        std::array{1.0, 11.0, 31.0, 91.0});
    const auto u = make_cascade_uniforms(all, 0.2);
    CHECK(u.rotation == all[0].light.view);
    for (glm::length_t i = 0; i < 3; ++i) {
        const auto& c = all[static_cast<std::size_t>(i)];
        const auto weight = [&](double share) {
            return cascade_fade(c.begin + share * (c.end - c.begin), u.scales[i].w, u.offsets[i].w);
        };
        CHECK(weight(0.0) == 0.0);
        CHECK(weight(0.799) == 0.0);
        CHECK(std::abs(weight(0.9) - 0.5) <= 1.0 / 256);
        CHECK(weight(1.0001) == 1.0);
        CHECK(glm::dvec3(u.scales[i]) == glm::dvec3(c.scale));
        CHECK(glm::dvec3(u.offsets[i]) == glm::dvec3(c.offset));
    }
    CHECK(cascade_by_depth(5.0, u.ends) == 0.0);
    CHECK(cascade_by_depth(11.0, u.ends) == 1.0);
    CHECK(cascade_by_depth(1e30, u.ends) == 2.0);
    const glm::dmat4 nothing(u.offsets[3], u.offsets[3], u.offsets[3], u.offsets[3]);
    CHECK(cascade_by_projection(glm::dvec3(0), glm::dmat4(0), nothing, glm::dvec2(1024), 0.0).w == 4.0);
    const auto sharp = make_cascade_uniforms(all, 0.0);
    CHECK(cascade_fade(1000.0, sharp.scales[0].w, sharp.offsets[0].w) == 0.0);
    for (const double fade : {-0.1, 1.1, std::nan("")})
        CHECK(complaint([&] {
                  (void)make_cascade_uniforms(all, fade);
              }).starts_with("umbrage::make_cascade_uniforms: fade must be from 0 to 1; got "));
}

TEST_CASE_TEMPLATE("make_cascade_uniforms: finite, or no uniforms", T, float, double) {
    const auto all =
        make_stable_cascades<5>(cascade_fit<T>{.scene = bounding_box<T>{}, .overlap = T(0.2), .clip = cpu_clip_space},
                                std::array{T(1), T(11), T(31), T(91), T(191), T(391)});
    const std::array three{all[0], all[1], all[2]};
    for (const T fade : {std::numeric_limits<T>::denorm_min(), std::numeric_limits<T>::min() / 1024}) {
        const std::string begin = "umbrage::make_cascade_uniforms: fade must be 0, or large enough";
        CHECK(complaint([&] { (void)make_cascade_uniforms(three, fade); }).starts_with(begin));
        CHECK(complaint([&] { (void)make_cascade_uniforms(all, fade); }).starts_with(begin));
    }
    const auto u = make_cascade_uniforms(three, std::numeric_limits<T>::min());
    CHECK((umbrage::detail::all_finite(u.scales) && umbrage::detail::all_finite(u.offsets)));
}
