// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/shadow/set_up.hpp>

#include "scene.hpp"

using namespace umbrage;

namespace {

/// A setup of a user's own: what stands on the floor is looked up straight from above.
struct from_above {
    struct uniforms {
        glm::vec4 scale;
    };
    static constexpr uniform_field fields[]{{"scale", false}};
    static constexpr map_grid grid{1, 1};
    static constexpr outside_map outside = outside_map::bordered;
    static constexpr glsl::map_choice tiles{};

    [[nodiscard]] clip_space clip() const { return cpu_clip_space; }
    [[nodiscard]] std::vector<light_space<double>> lights() const {
        return {{look_along(glm::dvec3(0, 8, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1), handedness::right),
                 orthographic(glm::dvec2(-8), glm::dvec2(8), 0.0, 8.0, cpu_clip_space), cpu_clip_space}};
    }
    [[nodiscard]] uniforms make_uniforms(glm::ivec2 size, glm::dvec3) const { return {glm::vec4(size, 0, 0)}; }
    template <class Look>
    [[nodiscard]] static float visibility(const uniforms& u, const shadow_terms&, glm::vec3 world, glm::vec3,
                                          const Look& look) {
        return look(map_place{
            0, {(0.5f - world.x / 16) * u.scale.x, (world.z / 16 + 0.5f) * u.scale.y, 1 - world.y / 8}, glm::vec2(0)});
    }
    [[nodiscard]] static std::string text(const glsl::map_choice&) { return "\n    return 1.0;\n"; }
    static constexpr const auto& needs = glsl::list<&glsl::saturate>;
};

}  // namespace

TEST_CASE("set_up: a shadow takes one of a user's own") {
    static_assert(shadow_set_up<from_above>);
    const shadow s(from_above{}, {64, 64}, filters::hard{});
    const auto map = shadow_scene::drawn(s);
    CHECK(s(map, {0, 0, 0}, {0, 1, 0}) == 0.0f);
    CHECK(s(map, {3, 0, 0}, {0, 1, 0}) == 1.0f);
    CHECK(s(map, {0, 2, 0}, {0, 1, 0}) == 1.0f);
}

TEST_CASE("set_up: blocks are mat4s and vec4s without gaps, as all languages lay them out") {
    shadow_scene::for_each_shadow(cpu_clip_space, filters::hard{}, depth32f{}, [](const auto& s) {
        using set_up = std::remove_cvref_t<decltype(s.set_up())>;
        std::size_t vectors = 0;
        for (const uniform_field& f : set_up::fields) vectors += f.vectors();
        for (const uniform_field& f : shadow_terms::fields) vectors += f.vectors();
        CHECK(sizeof(s.uniforms()) == vectors * sizeof(glm::vec4));
    });
}

TEST_CASE("set_up: a map is chosen as a layer or as a tile") {
    const glsl::map_choice layer{}, tile{true, "cube_tile"};
    CHECK(layer.first("n") == "    UMBRAGE_HIGHP float layer = n;\n");
    CHECK(layer.again("n") == "    layer = n;\n");
    CHECK(tile.first("n") == "    UMBRAGE_HIGHP vec2 origin = umbrage_cube_tile(n, terms.x);\n");
    CHECK(tile.again("n") == "    origin = umbrage_cube_tile(n, terms.x);\n");
}
