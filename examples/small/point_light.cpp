// SPDX-License-Identifier: MIT
//
// A point light in a room: six maps in one image, soft edges by a rotated disc, a picture of the floor.
#include <cmath>
#include <cstdio>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "picture.hpp"

int main() {
    // A floor, and a fence of posts around the light.
    std::vector<glm::vec3> vertices{{-8, 0, -8}, {8, 0, -8}, {8, 0, 8}, {-8, 0, 8}};
    std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};
    for (int post = 0; post < 12; ++post) {
        const float angle = float(post) * 0.5236f;
        const glm::vec3 foot(3 * std::cos(angle), 0, 3 * std::sin(angle)), across(-foot.z * 0.06f, 0, foot.x * 0.06f);
        const auto k = unsigned(vertices.size());
        for (const glm::vec3 v : {foot - across, foot + across, foot + across, foot - across}) vertices.push_back(v);
        vertices[k + 2].y = vertices[k + 3].y = 1.5f;
        triangles.insert(triangles.end(), {{k, k + 1, k + 2}, {k, k + 2, k + 3}});
    }

    const glm::vec3 position(0.3f, 2, 0.2f);
    const umbrage::point_light<float> light{
        .position = position, .z_far = 20, .map_size = 512, .border = 6, .clip = umbrage::cpu_clip_space};
    const umbrage::shadow bulb(light, glm::ivec2(light.map_size), umbrage::filters::disc{});
    umbrage::image<float> map(bulb.size(), bulb.cleared());  // 3 x 2 maps
    bulb.draw(map, {vertices, triangles});

    umbrage::image<float> picture({512, 512});
    int dark = 0;
    for (int y = 0; y < picture.size().y; ++y)
        for (int x = 0; x < picture.size().x; ++x) {
            const glm::vec3 point(float(x) / 32 - 8, 0, float(y) / 32 - 8), way = position - point;
            const float visibility = bulb(map, point, {0, 1, 0}, {x, y});  // the disc turns from pixel to pixel
            dark += visibility < 0.5f;
            picture[{x, y}] = 0.02f + 5 * visibility * way.y / std::pow(glm::length(way), 3.0f);
        }
    write_picture("point_light.png", picture);
    std::printf("point_light.png: %d of %d pixels are in shadow\n", dark, picture.size().x * picture.size().y);
}
