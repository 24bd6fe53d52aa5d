// SPDX-License-Identifier: MIT
#include "point_maps.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

#include <umbrage/light/point/cube_map.hpp>
#include <umbrage/light/point/dual_paraboloid.hpp>
#include <umbrage/light/point/point_light.hpp>
#include <umbrage/light/point/tetrahedron_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace example {
namespace {

/// Faces, of which a direction chooses one.
template <std::size_t N, class Face>
placed_maps faces(const lit_view& v, const std::array<umbrage::light_space<double>, N>& lights, int size, int maps,
                  Face face) {
    std::array<glm::dmat4, N> matrices;
    for (std::size_t i = 0; i < N; ++i) matrices[i] = umbrage::texture_matrix(lights[i], glm::ivec2(size));
    const auto at = [=, position = v.light.position](glm::dvec3 p) {
        return matrices[static_cast<std::size_t>(face(p - position))];
    };
    return {glm::ivec2(size), maps, {v.light.position, 1}, {matrices.begin(), matrices.end()}, at};
}

placed_maps cube(const lit_view& v) {
    const int size = static_cast<int>(v.map_size / std::sqrt(6.0));
    const auto lights = umbrage::make_point_light<double>(
        {.position = v.light.position, .map_size = size, .border = 0, .clip = umbrage::cpu_clip_space});
    return faces(v, lights, size, 6, [](glm::dvec3 d) { return umbrage::cube_face(d); });
}

placed_maps tetrahedron(const lit_view& v) {
    const auto lights = umbrage::make_tetrahedron_light<double>(
        {.position = v.light.position, .map_size = v.map_size, .border = 0, .clip = umbrage::cpu_clip_space});
    return faces(v, lights, v.map_size, 1, [](glm::dvec3 d) { return umbrage::tetrahedron_face(d); });
}

placed_maps dual_paraboloid(const lit_view& v) {
    const int size = static_cast<int>(v.map_size / std::sqrt(2.0));
    const auto at = [=, position = v.light.position](glm::dvec3 p) {
        // q is at texel + slope (q - p), of size (flip x / m + 1) / 2 and size (y / m + 1) / 2, m = |d| + |z|
        const glm::dvec3 d = p - position, towards(0, 0, d.z < 0 ? -1 : 1);
        const double m = glm::length(d) + std::abs(d.z), flip = -towards.z;
        const glm::dvec3 of_m = glm::normalize(d) + towards, x(flip, 0, 0), y(0, 1, 0);
        const glm::dvec3 slopes[]{(x * m - flip * d.x * of_m) * (size / 2.0 / (m * m)),
                                  (y * m - d.y * of_m) * (size / 2.0 / (m * m))};
        const glm::dvec2 texel = glm::dvec2(umbrage::dual_paraboloid_coordinate(d)) * double(size);
        glm::dmat4 matrix(1);
        for (glm::length_t row = 0; row < 2; ++row) {
            for (glm::length_t c = 0; c < 3; ++c) matrix[c][row] = slopes[row][c];
            matrix[3][row] = texel[row] - glm::dot(slopes[row], p);
        }
        return matrix;
    };
    return {glm::ivec2(size), 2, {v.light.position, 1}, {}, at};
}

}  // namespace

std::vector<setup> point_setups() {
    return {{"point, cube", cube}, {"point, dual paraboloid", dual_paraboloid}, {"point, tetrahedron", tetrahedron}};
}

}  // namespace example
