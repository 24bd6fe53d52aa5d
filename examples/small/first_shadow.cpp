// SPDX-License-Identifier: MIT
//
// Renders a shadow map on the CPU and prints the shadow that it finds on a floor.
#include <cstdio>
#include <vector>

#include <umbrage/umbrage.hpp>

int main() {
    const std::vector<glm::vec3> vertices{{-4, 0, -4}, {4, 0, -4}, {4, 0, 4}, {-4, 0, 4},   // a floor
                                          {-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};  // and a square
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};

    const auto light = umbrage::make_spot_light({.position = {2, 6, 3},
                                                 .direction = {-2, -6, -3},
                                                 .z_near = 1,
                                                 .z_far = 20,
                                                 .clip = umbrage::cpu_clip_space});  // or your API's
    const umbrage::shadow spot(light, {1024, 1024}, umbrage::filters::tent<3>);

    umbrage::image<float> map(spot.size(), spot.cleared());
    spot.draw(map, {vertices, triangles});

    int dark = 0;
    for (float z = -2; z < 2; z += 0.25f, std::puts(""))
        for (float x = -3; x < 3; x += 0.125f) {
            const float visibility = spot(map, {x, 0, z}, {0, 1, 0});  // point, normal: 1 lit
            std::putchar(visibility < 0.5f ? '#' : '.');
            dark += visibility < 0.5f;
        }
    std::printf("%d of 768 points are in shadow\n", dark);
}
