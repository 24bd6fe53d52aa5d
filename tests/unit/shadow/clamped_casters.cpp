// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/clamped_casters.hpp>
#include <umbrage/shadow/shadow.hpp>

#include "texts.hpp"

using namespace umbrage;
using shadow_texts::refusal;

namespace {

/// A sun straight above that knows receivers alone: its near plane stands near y = 1.
light_space<double> sun(clip_space clip, bool knows_casters = false) {
    directional_fit<double> fit{.direction = {0, -1, 0},
                                .up = {0, 0, 1},
                                .receivers = bounding_box<double>{{-5, 0, -5}, {5, 1, 5}},
                                .clip = clip};
    if (knows_casters) fit.casters = bounding_box<double>{{-20, 0, -20}, {20, 9, 20}};
    return fit_directional_light<double>(fit);
}

/// Whether a square at these x, of this height, is clamped.
bool clamps(const light_space<double>& light, float x0, float x1, float y, const glm::mat4& model = glm::mat4(1)) {
    const std::vector<glm::vec3> positions{{x0, y, -1}, {x1, y, -1}, {x1, y, 1}, {x0, y, 1}};
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};
    return detail::has_clamped_casters({positions, triangles}, std::span(&model, 1), light);
}

}  // namespace

TEST_CASE("clamped_casters: those above the near plane, within the map") {
    for (const named_clip_space& clip : clip_spaces) {
        const light_space<double> light = sun(clip.value);
        CAPTURE(clip.name);
        CHECK(clamps(light, -1, 1, 8));
        CHECK(clamps(light, -200, 200, 8));  // covers the map, with all corners outside
        CHECK_FALSE(clamps(light, -1, 1, 0.5f));
        CHECK_FALSE(clamps(light, 30, 40, 8));
        CHECK_FALSE(clamps(sun(clip.value, true), -1, 1, 8));
        glm::mat4 raised(1);
        raised[3].y = 7.5f;
        CHECK(clamps(light, -1, 1, 0.5f, raised));
        raised[0].x = -1;  // mirrored
        CHECK(clamps(light, -1, 1, 0.5f, raised));
    }
}

TEST_CASE("clamped_casters: a caster at the near plane itself is none") {
    directional_fit<double> fit{.direction = {0, -1, 0},
                                .up = {0, 0, 1},
                                .receivers = bounding_box<double>{{-5, 0, -5}, {5, 1, 5}},
                                .margin = 0,
                                .clip = cpu_clip_space};
    CHECK_FALSE(clamps(fit_directional_light<double>(fit), -1, 1, 1));
}

TEST_CASE("clamped_casters: under contact hardening a depth pass refuses them") {
    const std::vector<glm::vec3> positions{{-1, 8, -1}, {1, 8, -1}, {1, 8, 1}};
    const std::vector<glm::uvec3> triangles{{0, 1, 2}};
    const auto draws = [&](bool knows_casters, const auto& filter) {
        const shadow s(sun(cpu_clip_space, knows_casters), {256, 256}, filter);
        image<float> map(s.size(), s.cleared());
        return refusal([&] { s.draw(map, {positions, triangles}); });
    };
    const filters::pcss soft{.softness = make_penumbra_params(0.1f)};
    CHECK(draws(false, soft) ==
          "umbrage::shadow::draw: mesh must be behind the light's near plane, as contact hardening needs its distance; "
          "got casters before it. Give the fit its casters, or move the near plane.");
    CHECK(draws(true, soft) == "accepted");
    CHECK(draws(false, filters::tent<3>) == "accepted");
}

TEST_CASE("clamped_casters: none where a fit got all casters, whichever way the camera looks") {
    const bounding_box<float> scene{{-10, 0, -10}, {10, 20, 10}}, ground{{-10, 0, -10}, {10, 1, 10}};
    std::vector<glm::vec3> positions;  // of thin masts
    std::vector<glm::uvec3> triangles;
    for (float x = -9; x <= 9; ++x)
        for (float z = -9; z <= 9; ++z) {
            const auto n = glm::uint(positions.size());
            positions.insert(positions.end(), {{x - 0.05f, 0, z}, {x + 0.05f, 0, z}, {x, 20, z}});
            triangles.push_back({n, n + 1, n + 2});
        }
    const filters::pcss soft{.softness = make_penumbra_params(0.02f)};
    const auto draws = [&](const auto& light) {
        const shadow s(light, {64, 64}, soft);
        image<float> map(s.size(), s.cleared());
        return refusal([&] { s.draw(map, {positions, triangles}); });
    };
    for (float angle = 0; angle < 6.2f; angle += 0.1f) {
        CAPTURE(angle);
        const glm::vec3 direction(-1, -1, 0.6f), ahead(std::cos(angle), -0.3f, std::sin(angle));
        const frustum<float> camera{.position = {0, 2, 0},
                                    .direction = ahead,
                                    .tan_half_x = 0.5f,
                                    .tan_half_y = 0.3f,
                                    .z_near = 0.2f,
                                    .z_far = 12};
        CHECK(draws(fit_directional_light<float>({.direction = direction,
                                                  .receivers = intersection(camera, ground),
                                                  .casters = scene,
                                                  .clip = cpu_clip_space})) == "accepted");
        CHECK(draws(make_tight_cascades<3>({.camera = camera,
                                            .direction = direction,
                                            .scene = scene,
                                            .map_size = {64, 64},
                                            .margin = 15,
                                            .clip = cpu_clip_space},
                                           std::array<float, 4>{0.2f, 2, 5, 12})) == "accepted");
    }
}
