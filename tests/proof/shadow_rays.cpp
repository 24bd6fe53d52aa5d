// SPDX-License-Identifier: MIT
//
// Every setup of a shadow in every convention over some random scenes: its places, to a 64th of a texel, and how far
// its bias detaches shadows. Other sizes, encodings, places and scales are those of joints/.
#include "shadow_rays.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>

TEST_CASE("shadows of every setup agree with rays, away from edges and beyond their own bias") {
    std::map<std::string_view, proof::traced> setups;
    for (std::uint64_t n = 0; n < proof::clip_space_count; ++n) {
        proof::shadowed_scene scene(n);
        proof::for_each_traced(scene, [&](std::string_view name, std::string_view filter, const auto& s,
                                          const auto& light, const auto& mesh) {
            const proof::traced found = proof::trace_receivers(scene, name, s, light, mesh, 120);
            CAPTURE(n);
            CAPTURE(name);
            CAPTURE(filter);
            CHECK(found.acne == 0);
            CHECK(found.leaks == 0);
            CHECK(found.outside == 0);
            CHECK(found.misplaced == 0);
            setups[name] += found;
        });
    }
    CHECK(setups.size() == 10);
    for (const auto& [key, found] : setups) {
        const std::string_view name = key;  // clang 14 captures no structured binding
        CAPTURE(name);
        CHECK(found.lit > 1200);
        CHECK(found.shadowed > 40);
        CHECK(found.faded * 20 < found.lit);
    }
}

TEST_CASE("a caster's shadow is lost up to the distance that is stated, and hardly less") {
    std::map<std::string_view, int> planes;
    for (std::uint64_t n = 0; n < proof::clip_space_count; n += 5) {
        proof::shadowed_scene scene(n);
        proof::for_each_traced(
            scene, [&](std::string_view name, std::string_view filter, const auto& s, const auto& light, const auto&) {
                const auto [point, normal] = scene.plane_of(name, light);
                const auto found = proof::detach(s, light, point, normal, scene.random());
                if (!found) return;
                CAPTURE(n);
                CAPTURE(name);
                CAPTURE(filter);
                CHECK(found->measured <= found->bound);
                CHECK(found->measured >= found->bound * proof::least_share(name));
                CHECK(found->stated <= found->bound * 1.2);
                CHECK(found->stated >= found->bound * 0.8);
                ++planes[name];
            });
    }
    CHECK(planes.size() == 10);
}

TEST_CASE("rays see acne where the bias has no normal to go by, and leaks where receivers are nearer to the light") {
    proof::traced flat, moved;
    for (std::uint64_t n = 0; n < 4; ++n) {
        proof::shadowed_scene scene(n);
        proof::for_each_traced(
            scene, [&](std::string_view name, std::string_view, const auto& s, const auto& light, const auto& mesh) {
                proof::any_shadow without = s, raised = s;
                without.visibility = [&](glm::vec3 p, glm::vec3) { return s.visibility(p, glm::vec3(0)); };
                raised.visibility = [&](glm::vec3 p, glm::vec3 normal) {
                    return s.visibility(p + glm::vec3(0.5 * glm::normalize(light.way(p))), normal);
                };
                flat += proof::trace_receivers(scene, name, without, light, mesh, 100);
                moved += proof::trace_receivers(scene, name, raised, light, mesh, 100);
            });
    }
    CHECK(flat.acne > 1000);
    CHECK(moved.leaks > 20);
}
