// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>

#include <umbrage/images/page_atlas.hpp>
#include <umbrage/shadow/frame.hpp>
#include <umbrage/shadow/page_places.hpp>

#include "scene.hpp"

using namespace umbrage;

namespace {

/// A root of 32 units, of which some pages are there: the root, a quarter, a sixteenth, and two of the finest.
struct few_pages {
    light_space<double> root;
    page_cache cache{{.slots = {3, 2}, .deepest_level = 4}};
    page_size size{.texels = 32, .gutter = 4};

    explicit few_pages(clip_space clip)
        : root(make_page_root<double>(
              {.direction = {0.2, -1, 0.1}, .side = 32, .scene = {{-20, 0, -20}, {20, 2, 20}}, .clip = clip})) {
        const std::array<page_receiver, 4> seen{
            {{{1.1f, 1.1f}, 2}, {{1.6f, 1.1f}, 4}, {{1.97f, 1.99f}, 16}, {{1.28f, 1.03f}, 16}}};
        static_cast<void>(cache.update(seen));
    }
};

}  // namespace

TEST_CASE("page_places: a point lies in the page that the table of texels names, where its light draws it") {
    for (const clip_space clip : {opengl_clip_space, direct3d_clip_space, unity_clip_space, cpu_clip_space}) {
        const few_pages few(clip);
        const adaptive_maps of(few.root, few.cache, few.size);
        const auto u = of.make_uniforms(glm::ivec2(40), glm::dvec3(0));
        const auto lights = of.lights();
        CHECK(lights.size() == 5 + 8 - 3);  // slots 0 .. 2, 8 and 9
        image<glm::u8vec4> table(page_table_size(few.cache));
        write_page_table(few.cache, table);
        std::array<int, 10> met{};
        for (float x = -24.9f; x < 25; x += 0.23f)
            for (float z = -24.9f; z < 25; z += 0.23f) {
                const glm::vec3 world(x, 0, z), in_root(shadow_coordinate(u.to_root, world - glm::vec3(u.anchor)));
                if (glm::any(glm::lessThan(glm::vec2(in_root), glm::vec2(1))) ||
                    glm::any(glm::greaterThanEqual(glm::vec2(in_root), glm::vec2(2))))
                    continue;
                const glm::vec4 at = page_coordinate(clamped(table), 18.0f, glm::vec2(in_root), 32.0f, 4.0f);
                static_cast<void>(
                    detail::blended(adaptive_maps::places(u, {}, world, {1, 3, 2}), [&](const map_place& place) {
                        CHECK(glm::vec2(place.at) == glm::vec2(at));
                        CHECK(page_tile(place.number, 40) == glm::ivec2(at.z, at.w));
                        const auto n = static_cast<std::size_t>(place.number);
                        const glm::dmat4 to_page = texture_matrix(lights[n], glm::ivec2(40));
                        CHECK(glm::length(glm::dvec3(place.at) - glm::dvec3(to_page * glm::dvec4(world, 1))) < 1e-3);
                        const glm::vec2 slope = plane_slope(glm::mat4(plane_matrix(to_page)), {1, 3, 2}, world);
                        CHECK(glm::length(place.slope - slope) < 1e-4f * glm::length(slope));
                        ++met[n];
                        return 1.0f;
                    }));
            }
        for (const std::size_t n : {0u, 1u, 2u, 8u, 9u}) CHECK(met[n] > 10);
    }
}

TEST_CASE("page_places: a plane that the light sees edge-on stays so in coarse pages") {
    const adaptive_maps of = shadow_scene::pages(cpu_clip_space);
    const auto u = of.make_uniforms({80, 80}, glm::dvec3(0));
    for (const float x : {0.0f, 15.0f})
        static_cast<void>(
            detail::blended(adaptive_maps::places(u, {}, {x, 0, x}, {1, 0.1f, 0}), [](const map_place& place) {
                CHECK(!detail::is_seen(place));
                return 1.0f;
            }));
}
