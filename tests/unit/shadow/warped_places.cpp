// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/shadow/frame.hpp>
#include <umbrage/shadow/warped_places.hpp>

#include "scene.hpp"

using namespace umbrage;

TEST_CASE("warped_places: a point lies in the map of its distance, where that map's light draws it") {
    for (const clip_space clip : {opengl_clip_space, direct3d_clip_space, unity_clip_space, cpu_clip_space}) {
        const warped_maps of = shadow_scene::warped<4>(clip);
        const auto u = of.make_uniforms({256, 128}, glm::dvec3(0));
        int met[4]{};
        for (int i = 0; i < 4000; ++i) {
            const glm::vec3 world(float(i % 11) - 5.2f, float(i % 3) * 0.6f, 14.4f - float(i) * 0.0085f);
            int looks = 0;
            static_cast<void>(
                detail::blended(warped_maps::places(u, {}, world, {1, 3, 2}), [&](const map_place& place) {
                    if (place.at.x == outside_all_maps) return ++looks, 1.0f;
                    const auto& c = of.cascades[static_cast<std::size_t>(place.number)];
                    const float depth = 15 - world.z, end = float(c.end), begin = float(c.begin);
                    CHECK(depth < end);
                    if (looks == 0 && place.number > 0) CHECK(depth >= begin);
                    if (looks == 1) CHECK(depth >= begin - 0.1f * (begin - float(of.cascades[0].begin)));
                    const glm::dmat4 to_texels = texture_matrix(c.light, {256, 128});
                    const glm::dvec4 h = to_texels * glm::dvec4(world, 1);
                    CHECK(glm::length(glm::dvec3(place.at) - glm::dvec3(h) / h.w) < 1e-2);
                    const glm::dvec2 slope =
                        plane_slope(plane_matrix(to_texels), glm::dvec3(1, 3, 2), glm::dvec3(world));
                    CHECK(glm::length(glm::dvec2(place.slope) - slope) < 1e-4);
                    ++looks, ++met[place.number];
                    return 1.0f;
                }));
            CHECK(looks >= 1);
        }
        for (const int n : met) CHECK(n > 50);
    }
}

TEST_CASE("warped_places: the next cascade takes over towards an end, without a step, and light after the last") {
    const auto u = shadow_scene::warped(cpu_clip_space).make_uniforms({256, 256}, glm::dvec3(0));
    float before = 0, most = 0;
    for (float z = 15; z > -46; z -= 0x1p-9f) {
        const float number = detail::blended(
            warped_maps::places(u, {}, {0, 0, z}, {0, 1, 0}),
            [](const map_place& place) { return place.at.x == outside_all_maps ? 1.0f : float(place.number); });
        const float step = glm::abs(number - before);
        if (z > -44) most = glm::max(most, step);
        before = number;
    }
    CHECK(most < 0.02f);
    CHECK(before == 1.0f);
}

TEST_CASE("warped_places: without a share one look-up") {
    const cascade_fit<float> fit = shadow_scene::range(cpu_clip_space);
    const auto two = make_warped_cascades<2>(fit, {0.5f, 5.0f, 60.0f},
                                             [](const auto& part) { return fit_light_space_perspective(part); });
    const auto u = warped_maps(two, fit.camera).make_uniforms({256, 256}, glm::dvec3(0));
    for (const float z : {16.0f, 12.0f, 10.0f, 0.0f, -50.0f}) {
        int looks = 0;
        static_cast<void>(
            detail::blended(warped_maps::places(u, {}, {0, 0, z}, {0, 1, 0}), [&](const map_place& place) {
                CHECK(place.number == (z > 10.0f ? 0 : 1));
                return ++looks, 1.0f;
            }));
        CHECK(looks == 1);
    }
}
