// SPDX-License-Identifier: MIT
//
// Warps of cameras farther and farther from the origin: each map holds its receivers, or is refused.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>

#include "../../clip_spaces.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("warps: far from the origin a weaker one, and then a named argument", T, float, double) {
    using warp = std::function<warped_light<T>(const warp_fit<T>&)>;
    const std::vector<warp> warps{[](const auto& fit) { return fit_light_space_perspective(fit); },
                                  [](const auto& fit) { return fit_light_space_perspective(fit, T(1e-9)); },
                                  [](const auto& fit) { return fit_trapezoidal(fit, T(0.01)); },
                                  [](const auto& fit) { return fit_perspective(fit); }};
    int plain = 0;
    for (const clip_space clip : all_clip_spaces())
        for (const auto& warped_by : warps) {
            int warped = 0, refused = 0;
            for (int k = 0; k < 24; ++k) {
                CAPTURE(k);
                const frustum<T> camera{.position = std::pow(T(10), T(k)) * glm::vec<3, T>(T(0.6), T(-0.2), T(0.7)),
                                        .direction = {T(-0.4), T(-0.2), T(-0.5)},
                                        .z_near = T(0.01)};
                const warp_fit<T> fit{
                    .camera = camera, .direction = {T(0.4), T(-0.8), T(-0.2)}, .receivers = camera, .clip = clip};
                warped_light<T> light;
                const std::string error = complaint([&] { light = warped_by(fit); });
                CAPTURE(error);
                if (!error.empty()) {
                    CHECK((error.find(": receivers") != error.npos && error.find(" the origin") != error.npos));
                    ++refused;
                    continue;
                }
                ++(light.strength > T(0) ? warped : plain);
                const glm::mat<4, 4, T> to_clip = light.light.projection * light.light.view;
                int lost = 0;
                for (const glm::dvec3& p : fit.receivers->points) {
                    const glm::vec<4, T> at = to_clip * glm::vec<4, T>(glm::vec<3, T>(p), T(1));
                    const T most = at.w * T(1.0625);
                    lost += !(at.w > T(0) && glm::abs(at.x) <= most && glm::abs(at.y) <= most && at.z <= most);
                }
                CHECK(lost == 0);
            }
            CHECK(warped > 0);
            CHECK(refused > 0);
        }
    CHECK(plain > 0);
}

TEST_CASE(
    "warps: far from the origin, over a deep box of casters, float matrices keep receivers before the far plane") {
    int tried = 0, beyond = 0;
    for (const clip_space clip : all_clip_spaces())
        for (const float away : {1e2f, 1e3f, 1e4f})
            for (int k = 0; k < 8; ++k) {
                const glm::vec3 middle = away * glm::vec3(std::cos(float(k)), 0.3f, std::sin(float(k)));
                const bounding_box<float> scene{middle - 5.0f, middle + 5.0f}, deep{middle - 1e4f, middle + 1e4f};
                const frustum<float> camera{.position = middle + glm::vec3(1, 2, 4),
                                            .direction = {-0.2f, -0.4f, -1},
                                            .z_near = 0.2f,
                                            .z_far = 9};
                const warp_fit<float> fit{.camera = camera,
                                          .direction = {std::sin(2.0f * float(k)), -1, 0.4f},
                                          .receivers = intersection(camera, scene),
                                          .casters = deep,
                                          .clip = clip};
                for (const warped_light<float>& warped : {fit_light_space_perspective(fit), fit_trapezoidal(fit, 2.0f),
                                                          static_cast<warped_light<float>>(fit_perspective(fit))}) {
                    const glm::dmat4 to_clip = glm::dmat4(warped.light.projection) * glm::dmat4(warped.light.view);
                    const auto [at_near, at_far] = umbrage::detail::ends<double>(clip);
                    for (const glm::dvec3& p : fit.receivers->points) {
                        const glm::dvec4 h = to_clip * glm::dvec4(p, 1);
                        const double depth = (h.z / h.w - at_near) / (at_far - at_near);
                        ++tried, beyond += !(depth >= 0 && depth <= 1);
                    }
                }
            }
    CHECK(tried > 1000);
    CHECK(beyond == 0);
}
