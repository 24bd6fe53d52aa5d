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

/// Visibility of points of a floor under a light.
umbrage::image<float> lit_floor(const umbrage::spot_light<float>& light, const umbrage::mesh_view& mesh,
                                const umbrage::image<glm::vec3>& points) {
    const umbrage::shadow spot(umbrage::make_spot_light(light), {1024, 1024}, umbrage::filters::tent<7>);
    umbrage::image<float> map(spot.size(), spot.cleared());  // to 1, or to 0 where depth is reversed
    spot.draw(map, mesh);

    const umbrage::image<glm::vec3> normals(points.size(), {0, 1, 0});
    umbrage::image<float> visibility(points.size());
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
    umbrage::image<glm::vec3> points({512, 512});  // of the floor, seen from above
    for (glm::ivec2 p{0, 0}; p.y < points.size().y; ++p.y)
        for (p.x = 0; p.x < points.size().x; ++p.x) points[p] = {float(p.x) / 64 - 4, 0, float(p.y) / 64 - 4};

    umbrage::spot_light<float> light{.position = {-0.4f, 5, 0.8f},
                                     .direction = glm::normalize(glm::vec3(0.08f, -1, -0.16f)),
                                     .outer_angle_radians = 0.75f,
                                     .z_near = 0.05f,
                                     .z_far = 500,
                                     .clip = umbrage::cpu_clip_space};
    const umbrage::image<float> left = lit_floor(light, {vertices, triangles}, points);
    light.clip.direction = umbrage::depth_direction::reversed;
    const umbrage::image<float> right = lit_floor(light, {vertices, triangles}, points);

    int dark = 0;
    float apart = 0;
    umbrage::image<float> picture(points.size());  // the left half forward, the right half reversed
    const int middle = picture.size().x / 2;
    for (glm::ivec2 p{0, 0}; p.y < picture.size().y; ++p.y)
        for (p.x = 0; p.x < picture.size().x; ++p.x) {
            const float visibility = p.x < middle ? left[p] : right[p];
            dark += visibility < 0.5f;
            apart = std::max(apart, std::abs(left[p] - right[p]));
            const glm::vec3 way = points[p] - light.position;
            const float distance = glm::length(way), cosine = glm::dot(light.direction, way) / distance;
            const float cone = std::clamp(20 * (cosine - 0.732f), 0.0f, 1.0f);  // within 0.75 radians
            picture[p] = p.x == middle ? 1 : 0.02f + 0.8f * cone * visibility * 25 * -way.y / std::pow(distance, 3.0f);
        }
    write_picture("reversed_depth.png", picture);
    std::printf("reversed_depth.png: %d of %d pixels are in shadow; the two differ by %.3f at most\n", dark,
                picture.size().x * picture.size().y, apart);
    return apart < 0.1f ? 0 : 1;
}
