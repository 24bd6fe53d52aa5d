// SPDX-License-Identifier: MIT
//
// Leaves over a floor, their shadows soft at four texels a lookup: the map is blurred once, not at every pixel (EVSM).
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "picture.hpp"

int main() {
    std::vector<glm::vec3> vertices{{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}};
    std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};
    for (int leaf = 1; leaf < 200; ++leaf) {  // in the order of a sunflower's seeds
        const float angle = 2.39996f * float(leaf), away = 0.3f * std::sqrt(float(leaf));
        const glm::vec3 out(std::cos(angle), 0, std::sin(angle)), across(-out.z, 0, out.x);
        const glm::vec3 center = away * out + glm::vec3(-0.25f, 1, -0.2f);
        const auto k = unsigned(vertices.size());
        for (const glm::vec3 v : {-out * 0.36f, across * 0.13f, out * 0.36f, -across * 0.13f})
            vertices.push_back(center + v);
        triangles.insert(triangles.end(), {{k, k + 1, k + 2}, {k, k + 2, k + 3}});
    }

    // The map is wider than the view by more than the blur's reach: at its own edge there is less to blur.
    const auto light = umbrage::make_directional_light({.direction = {0.25f, -1, 0.2f},
                                                        .up = {0, 0, 1},
                                                        .map_size = {512, 512},
                                                        .texels_per_unit = 44,
                                                        .z_far = 20,
                                                        .clip = umbrage::cpu_clip_space});
    const umbrage::shadow hard(light, {512, 512}, umbrage::filters::hard{});
    umbrage::image<float> depths(hard.size(), hard.cleared());
    hard.draw(depths, {vertices, triangles});

    // Depths to four moments, whose means are those of all depths around.
    const umbrage::prefilters::evsm4 evsm{umbrage::make_evsm({.exponent = 40})};
    umbrage::image<glm::vec4> moments(hard.size()), map(hard.size());
    umbrage::encode_moments(depths, moments, evsm);
    umbrage::blur(moments, map, umbrage::make_gaussian_kernel(13, 2.5f));

    // Receivers in texels and depth. Their variance stands for a bias.
    const glm::ivec2 size(512, 512);
    const glm::mat4 to_texels = umbrage::texture_matrix(light, hard.size());
    umbrage::image<glm::vec3> points(size), normals(size, {0, 1, 0}), receivers(size);
    for (glm::ivec2 p{0, 0}; p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x) {
            points[p] = {float(p.x) / 51 - 4.75f, 0, float(p.y) / 51 - 4.75f};
            receivers[p] = umbrage::project_coordinate(umbrage::shadow_coordinate(to_texels, points[p]));
        }
    umbrage::image<float> soft(size), unfiltered(size), picture(size);
    umbrage::visibility(map, evsm, receivers, soft);
    hard.visibility(depths, points, normals, unfiltered);

    int dark = 0;
    double difference = 0;
    for (glm::ivec2 p{0, 0}; p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x) {
            dark += soft[p] < 0.5f;
            difference += double(soft[p] - unfiltered[p]) / (size.x * size.y);
            picture[p] = 0.08f + 0.8f * soft[p];
        }
    write_picture("prefiltered_map.png", picture);
    std::printf(
        "prefiltered_map.png: %d of %d pixels are in shadow; the blur lets %.1f %% more light through than a "
        "hard shadow\n",
        dark, size.x * size.y, 100 * difference);
    return std::abs(difference) < 0.03 ? 0 : 1;
}
