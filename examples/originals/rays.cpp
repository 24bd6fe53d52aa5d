// SPDX-License-Identifier: MIT
#include "rays.hpp"

#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <umbrage/light/texture_matrix.hpp>

#include <ray_tracer.hpp>

namespace example {

umbrage::image<by_rays> traced(const stage& on, const light& l, glm::ivec2 map_size, float reach) {
    const ray_tracer rays(on.scene.geometry);
    const glm::mat4 to_texels = umbrage::texture_matrix(l.space, map_size);
    umbrage::image<by_rays> out(on.seen.size(), by_rays::unknown);
    on.for_each_surface([&](glm::ivec2 pixel, const surface& s) {
        const glm::vec3 way = l.to_light(s.position);
        const float facing = glm::dot(s.face_normal, way);
        if (facing < 0.05f || l.cone(s.position) == 0) return;  // dark without any shadow
        const glm::vec3 place = umbrage::project_coordinate(umbrage::shadow_coordinate(to_texels, s.position));
        const auto inside = [&](float at, int size) { return at > reach && at < static_cast<float>(size) - reach; };
        if (!inside(place.x, map_size.x) || !inside(place.y, map_size.y))
            return;  // the map knows only one side of what is there
        const float step = reach * l.texel_world(s.position);
        const glm::vec3 side = glm::normalize(glm::cross(way, s.face_normal + glm::vec3(0.1f, 0.2f, 0.3f)));
        const glm::vec3 across = glm::cross(way, side);
        // Beside the surface in its plane, as a texel beside has it; and as far above as the bias may lift it.
        const auto blocked = [&](float i, float j, float above) {
            const glm::vec3 aside = step * (i * side + j * across);
            const glm::vec3 start =
                s.position + aside - way * (glm::dot(s.face_normal, aside) / facing) + 0.001f * s.face_normal;
            const glm::vec3 to_light = l.to_light(start);
            const float distance = l.spot ? glm::length(l.position - start) : 1e3f;
            return rays.blocked(start + above * to_light, to_light, distance - above);
        };
        const bool dark = blocked(0, 0, 0);
        for (float i = -1; i <= 1; i += 0.5f)
            for (float j = -1; j <= 1; j += 0.5f)
                if (blocked(i, j, dark ? step : 0) != dark) return;  // near an edge
        out[pixel] = dark ? by_rays::shadow : by_rays::lit;
    });
    return out;
}

void compare_with_rays(const stage& on, const light& l, const umbrage::image<float>& visibility, glm::ivec2 map_size,
                       float reach) {
    const umbrage::image<by_rays> expected = traced(on, l, map_size, reach);
    int lit = 0, shadow = 0, leaks = 0, acne = 0;
    for (std::size_t i = 0; i < expected.texels().size(); ++i) {
        lit += expected.texels()[i] == by_rays::lit;
        shadow += expected.texels()[i] == by_rays::shadow;
        acne += expected.texels()[i] == by_rays::lit && visibility.texels()[i] < 0.5f;
        leaks += expected.texels()[i] == by_rays::shadow && visibility.texels()[i] > 0.5f;
    }
    const int certain = lit + shadow;
    std::printf("rays: %d pixels away from edges, %d of them in shadow; lit there %d, dark elsewhere %d\n", certain,
                shadow, leaks, acne);
    if ((leaks + acne) * 500 > certain) throw std::runtime_error("the shadow map disagrees with rays to the light");
    if (shadow == 0 || lit == 0)
        throw std::runtime_error("rays tell nothing: with " + std::to_string(map_size.x) + " x " +
                                 std::to_string(map_size.y) + " texels no " + (shadow == 0 ? "shadow" : "light") +
                                 " is wider than what filter and bias reach");
}

}  // namespace example
