// SPDX-License-Identifier: MIT
//
// Setup functions of lights. Their matrices have no tier, so that builds need not agree on bits. Each build is tested
// by geometry: the receivers lie in the map and fill it. A line's digest is that of the number of setups that fail: 0.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <span>
#include <string>
#include <vector>

#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/light_choice.hpp>
#include <umbrage/light/spot_fit.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/plane_optimal.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>

#include "hostile.hpp"

namespace {

using namespace umbrage;

constexpr int setups = 200;
constexpr double slack = 1e-4;  // slack of the map, for matrices of float in any order of operations

bool all_hold = true;

/// A camera over a scene on the ground, and a light above the horizon.
struct scene {
    frustum<float> camera;
    bounding_box<float> box;
    glm::vec3 direction;

    explicit scene(hostile::source& s) {
        const auto between = [&](int low, int high) { return float(low + int(s.below(std::uint32_t(high - low)))); };
        camera.position = {between(-20, 20), between(2, 12), between(-20, 20)};
        camera.direction = {between(-8, 9), between(-4, -1), between(1, 9)};
        camera.tan_half_x = between(4, 12) / 8.0f, camera.tan_half_y = between(4, 12) / 8.0f;
        camera.z_near = 0.5f, camera.z_far = between(20, 60);
        box.low = {-40.0f, 0.0f, -40.0f}, box.high = {40.0f, between(4, 20), 40.0f};
        direction = {between(-6, 7), between(-9, -3), between(-6, 7)};
    }
    [[nodiscard]] hull receivers() const { return intersection(camera, box); }
};

/// Bounds of points in a map, in normalized device coordinates from -1 to 1. Depth has this range too.
struct bounds {
    double low[3]{9, 9, 9}, high[3]{-9, -9, -9};
    bool in_front = true;

    bounds(const light_space<float>& light, const std::vector<glm::dvec3>& points) {
        const glm::dmat4 m = glm::dmat4(light.projection) * glm::dmat4(light.view);
        for (const glm::dvec3& p : points) {
            const glm::dvec4 h = m * glm::dvec4(p, 1.0);
            in_front = in_front && h.w > 0.0;
            for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], h[i] / h.w), high[i] = std::max(high[i], h[i] / h.w);
        }
    }
    [[nodiscard]] bool held() const {
        bool all = in_front;
        for (const double v : low) all = all && v >= -1.0 - slack;
        for (const double v : high) all = all && v <= 1.0 + slack;
        return all;
    }
    /// @param share  of the map's sides
    [[nodiscard]] bool filled(double share) const {
        return high[0] - low[0] >= 2.0 * share - slack && high[1] - low[1] >= 2.0 * share - slack;
    }
};

/// Counts setups for which check(scene) does not hold, and prints them as a line.
template <class Check>
void run(const char* name, Check check) {
    hostile::source s{hostile::kind::ordinary, false};
    std::uint32_t wrong = 0;
    for (int i = 0; i < setups; ++i) {
        const scene of(s);
        try {
            wrong += !check(of);
        } catch (const std::exception&) { ++wrong; }
    }
    hostile::digest sum;
    sum(wrong);
    hostile::setting{hostile::kind::ordinary, false, "nearest"}.print(name, setups, sum);
    if (wrong) std::fprintf(stderr, "%s: %u of %d setups fail\n", name, wrong, setups);
    all_hold = all_hold && !wrong;
}

constexpr clip_space clip{.range = depth_range::minus_one_to_one};
constexpr float margin = 0.01f;
constexpr double with_margin = 1.0 / (1.0 + 2.0 * margin);

/// A warp of the camera's receivers fills its map.
template <class Fit>
void run_warp(const char* name, Fit fit) {
    run(name, [&](const scene& of) {
        const warp_fit<float> terms{of.camera, of.direction, of.receivers(), of.box, margin, clip};
        const bounds seen(fit(terms).light, detail::corners_of(*terms.receivers));
        return seen.held() && seen.filled(with_margin);
    });
}

}  // namespace

int main() {
    run("fit_directional_light", [](const scene& of) {
        const auto light = fit_directional_light<float>(
            {.direction = of.direction, .receivers = of.receivers(), .casters = of.box, .margin = 0, .clip = clip});
        const bounds seen(light, detail::corners_of(of.receivers()));
        return seen.held() && seen.filled(1.0);
    });
    run("fit_spot_light", [](const scene& of) {
        const glm::vec3 eye = of.camera.position - 150.0f * glm::normalize(of.direction);
        for (const bool far_plane : {true, false}) {
            const auto light = fit_spot_light<float>({.position = eye,
                                                      .direction = of.direction,
                                                      .outer_angle_radians = 1.5f,
                                                      .receivers = of.receivers(),
                                                      .casters = of.box,
                                                      .margin = 0,
                                                      .has_far_plane = far_plane,
                                                      .clip = clip});
            if (!light) return false;
            const bounds seen(*light, detail::corners_of(of.receivers()));
            if (!seen.held() || !seen.filled(1.0)) return false;
        }
        return true;
    });
    const auto cascades_of = [](const scene& of, auto make) {
        const std::array splits{0.5f, 4.0f, 12.0f, of.camera.z_far};
        const cascade_fit<float> fit{.camera = of.camera, .direction = of.direction, .scene = of.box, .clip = clip};
        const auto all = make(fit, splits);
        bool good = true;
        for (std::size_t i = 0; i < all.size(); ++i) {
            frustum<float> part = of.camera;
            part.z_near = splits[i], part.z_far = splits[i + 1];
            good = good && bounds(all[i].light, detail::corners_of(intersection(part, of.box))).held();
        }
        return good;
    };
    run("make_stable_cascades", [&](const scene& of) {
        return cascades_of(of, [](auto& fit, auto& splits) { return make_stable_cascades<3>(fit, splits); });
    });
    run("make_tight_cascades", [&](const scene& of) {
        return cascades_of(of, [](auto& fit, auto& splits) { return make_tight_cascades<3>(fit, splits); });
    });
    run_warp("fit_light_space_perspective", [](const auto& fit) { return fit_light_space_perspective(fit); });
    run_warp("optimal_distance",
             [](const auto& fit) { return fit_light_space_perspective<float>(fit, optimal_distance(fit)); });
    run_warp("fit_perspective", [](const auto& fit) { return fit_perspective(fit); });
    run_warp("fit_trapezoidal", [](const auto& fit) { return fit_trapezoidal(fit, 10.0f); });
    run("fit_plane_optimal", [](const scene& of) {
        const glm::vec4 ground(0, 1, 0, 0);
        const warp_fit<float> terms{of.camera, of.direction, of.receivers(), of.box, margin, clip};
        std::vector<glm::dvec3> on_ground;
        for (const glm::dvec3& p : detail::crossings(of.camera, glm::dvec4(ground))) on_ground.push_back(p);
        return bounds(fit_plane_optimal(terms, ground)->light, on_ground).held();
    });
    run("choose_light", [](const scene& of) {
        const hull receivers = of.receivers();
        const warp_fit<float> terms{of.camera, of.direction, receivers, of.box, margin, clip};
        const auto elsewhere =
            fit_directional_light<float>({.direction = of.direction,
                                          .receivers = bounding_box<float>{glm::vec3(900), glm::vec3(901)},
                                          .clip = clip});
        const light_space<float> lights[]{elsewhere, fit_light_space_perspective(terms).light};
        std::vector<seen_point> seen;
        for (const glm::dvec3& p : receivers.points) seen.push_back({p, glm::dvec3(0, 1, 0)});
        const light_space<float> camera{
            detail::look_along(of.camera.position, of.camera.direction, of.camera.up, clip.hand, "camera", ""),
            perspective(of.camera.tan_half_x, of.camera.tan_half_y, 0.5f, of.camera.z_far, clip), clip};
        const choice_terms choice{glm::dmat4(texture_matrix(camera, glm::ivec2(1024))), glm::ivec2(1024)};
        return choose_light(std::span<const light_space<float>>(lights), std::span<const seen_point>(seen), choice)
                   .kept == 1;
    });
    return all_hold ? 0 : 1;
}
