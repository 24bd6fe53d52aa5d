// SPDX-License-Identifier: MIT
//
// A spot light among columns, with depth forward and reversed: only the clip space says which, and both agree.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "picture.hpp"

namespace {

const glm::vec3 position(-0.4f, 5, 0.8f), direction = glm::normalize(glm::vec3(0.08f, -1, -0.16f));

/// Visibility under a light of this clip space, of a floor of 512 x 512 points, seen from above.
umbrage::image<float> lit_floor(umbrage::clip_space clip, const umbrage::mesh_view& mesh) {
    const auto light = umbrage::make_spot_light({.position = position,
                                                 .direction = direction,
                                                 .outer_angle_radians = 0.75f,
                                                 .z_near = 0.05f,
                                                 .z_far = 500,
                                                 .clip = clip});
    const umbrage::shadow spot(light, {1024, 1024}, umbrage::filters::tent<7>);
    umbrage::image<float> map(spot.size(), spot.cleared());  // to 1, or to 0 where depth is reversed
    spot.draw(map, mesh);

    umbrage::image<glm::vec3> points({512, 512}), normals({512, 512}, {0, 1, 0});
    for (glm::ivec2 p{0, 0}; p.y < 512; ++p.y)
        for (p.x = 0; p.x < 512; ++p.x) points[p] = {float(p.x) / 64 - 4, 0, float(p.y) / 64 - 4};
    umbrage::image<float> visibility({512, 512});
    spot.visibility(map, points, normals, visibility);
    return visibility;
}

}  // namespace

int main() {
    std::vector<glm::vec3> vertices{{-40, 0, -40}, {40, 0, -40}, {40, 0, 40}, {-40, 0, 40}};
    std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};
    for (int column = 0; column < 8; ++column) {
        const float turn = (float(column) + 0.5f) * 0.7854f;
        const glm::vec3 foot(1.9f * std::cos(turn), 0, 1.9f * std::sin(turn));
        for (unsigned side = 0; side < 24; ++side) {
            const auto k = unsigned(vertices.size()), first = k - 2 * side;
            const glm::vec3 out(0.2f * std::cos(float(side) * 0.2618f), 0, 0.2f * std::sin(float(side) * 0.2618f));
            vertices.push_back(foot + out), vertices.push_back(foot + out + glm::vec3(0, 1.3f, 0));
            const unsigned next = side == 23 ? first : k + 2;
            triangles.insert(triangles.end(),
                             {{k, next, k + 1}, {k + 1, next, next + 1}, {first + 1, k + 1, next + 1}});
        }
    }
    constexpr umbrage::clip_space forward = umbrage::cpu_clip_space;
    constexpr umbrage::clip_space reversed{.range = forward.range, .direction = umbrage::depth_direction::reversed};
    const auto left = lit_floor(forward, {vertices, triangles}), right = lit_floor(reversed, {vertices, triangles});

    int dark = 0;
    float apart = 0;
    umbrage::image<float> picture({512, 512});  // the left half forward, the right half reversed
    for (glm::ivec2 p{0, 0}; p.y < 512; ++p.y)
        for (p.x = 0; p.x < 512; ++p.x) {
            const float visibility = p.x < 256 ? left[p] : right[p];
            dark += visibility < 0.5f;
            apart = std::max(apart, std::abs(left[p] - right[p]));
            const glm::vec3 way = glm::vec3(float(p.x) / 64 - 4, 0, float(p.y) / 64 - 4) - position;
            const float distance = glm::length(way), cosine = glm::dot(direction, way) / distance;
            const float cone = std::clamp(20 * (cosine - 0.732f), 0.0f, 1.0f);  // within 0.75 radians
            picture[p] = p.x == 256 ? 1 : 0.02f + 0.8f * cone * visibility * 25 * -way.y / std::pow(distance, 3.0f);
        }
    write_picture("reversed_depth.png", picture);
    std::printf("reversed_depth.png: %d of %d pixels are in shadow; the two differ by %.3f at most\n", dark, 512 * 512,
                apart);
    return apart < 0.1f ? 0 : 1;
}
