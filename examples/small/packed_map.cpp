// SPDX-License-Identifier: MIT
//
// A map of two bytes a texel, as the cards of 2002 drew it: depth through a table of 2048 texels, 11 bits of it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "picture.hpp"

namespace {

/// Towers, a unit wide, in a city of 16 x 16 units.
float height(int x, int z) {
    const bool tower = x % 3 == 1 && z % 3 == 1;
    return tower ? 0.5f + float((x * 5 + z * 7) % 8) * 0.4f : 0.0f;
}

}  // namespace

int main() {
    std::vector<glm::vec3> vertices{{0, 0, 0}, {16, 0, 0}, {16, 0, 16}, {0, 0, 16}};
    std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};
    for (int z = 0; z < 16; ++z)
        for (int x = 0; x < 16; ++x) {
            if (height(x, z) == 0) continue;
            const auto k = unsigned(vertices.size());
            for (int i = 0; i < 8; ++i)  // a box: roof and four walls
                vertices.emplace_back(x + i % 2, i < 4 ? 0.0f : height(x, z), z + i / 2 % 2);
            for (const glm::uvec4 q : {glm::uvec4(4, 5, 7, 6), {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}})
                triangles.insert(triangles.end(), {k + glm::uvec3(q), k + glm::uvec3(q.x, q.z, q.w)});
        }

    const auto light =
        umbrage::fit_directional_light<float>({.direction = {1, -1.2f, 0.7f},
                                               .receivers = umbrage::bounding_box<float>{{0, 0, 0}, {16, 3.5f, 16}},
                                               .clip = umbrage::cpu_clip_space});
    const glm::ivec2 map_size(512, 512);
    const umbrage::shadow packed(light, map_size, umbrage::filters::tent<3>, umbrage::rg<11>{});
    const umbrage::shadow exact(light, map_size, umbrage::filters::tent<3>);  // 32-bit floats
    umbrage::image<float> depths(map_size, exact.cleared());
    exact.draw(depths, {vertices, triangles});

    // A shader without integers looked each depth up in a texture. The library's own loops give the same bytes.
    constexpr auto table = umbrage::make_rg_table<11>();
    umbrage::image<glm::u8vec2> map(map_size), computed(map_size);
    for (glm::ivec2 t{0, 0}; t.y < map_size.y; ++t.y)
        for (t.x = 0; t.x < map_size.x; ++t.x)
            map[t] = umbrage::encode_rg_table<11>([&](int x) { return table[std::size_t(x)]; }, depths[t]);
    umbrage::encode(depths, computed, packed.encoding());
    const bool same = std::ranges::equal(map.texels(), computed.texels());

    float error = 0;
    int dark = 0, differ = 0;
    const glm::ivec2 part = map_size / 2;
    umbrage::image<float> picture(part + part);  // above low and high bytes, below depths and shadows
    for (int y = 0; y < part.y; ++y)
        for (int x = 0; x < part.x; ++x) {
            const glm::ivec2 p(x, y), t = p * map_size / part;
            picture[{x, y}] = float(map[t].x) / 255, picture[{x + part.x, y}] = float(map[t].y) / 255;
            picture[{x, y + part.y}] = depths[t];
            error = std::max(error, std::abs(packed.encoding().decode(map[t]) - depths[t]));
            const glm::vec2 ground = 16.0f * glm::vec2(p) / glm::vec2(part);
            const glm::vec3 point(ground.x, height(int(ground.x), int(ground.y)), ground.y);
            const float visibility = packed(map, point, {0, 1, 0});
            picture[p + part] = (point.y > 0 ? 0.95f : 0.5f) * (0.1f + 0.9f * visibility);
            dark += visibility < 0.5f;
            differ += (visibility < 0.5f) != (exact(depths, point, {0, 1, 0}) < 0.5f);
        }
    write_picture("packed_map.png", picture);
    std::printf(
        "packed_map.png: %d of %d pixels are in shadow, %d other than with 32-bit floats; a depth is off by %.2f "
        "of a code, %.4f units\n",
        dark, part.x * part.y, differ, error * 2048, error / umbrage::make_light_units(light, map_size).y);
    return same && error <= 1.0f / 2048 ? 0 : 1;
}
