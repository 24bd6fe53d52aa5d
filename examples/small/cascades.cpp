// SPDX-License-Identifier: MIT
//
// A sun with three cascades over hills: a picture from above, the map that the GPU would draw, and its shader.
#include <cmath>
#include <cstdio>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "picture.hpp"

namespace {

constexpr int side = 257;  // vertices of the hills, half a unit apart

/// Hills with a tower on each sixteen units squared.
float height(float x, float z) {
    const bool tower = std::abs(std::remainder(x, 16.0f)) < 1 && std::abs(std::remainder(z, 16.0f)) < 1;
    return 1.5f * std::sin(x * 0.2f) * std::cos(z * 0.17f) + (tower ? 5.0f : 0.0f);
}
glm::vec3 hill(int i, int j) {
    const float x = float(i - side / 2) * 0.5f, z = float(j - side / 2) * 0.5f;
    return {x, height(x, z), z};
}

}  // namespace

int main() {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            vertices.push_back(hill(i, j));
            const auto k = unsigned(j * side + i);
            if (i + 1 < side && j + 1 < side)
                triangles.insert(triangles.end(), {{k, k + side, k + 1}, {k + 1, k + side, k + side + 1}});
        }

    // The sun: its cascades follow the camera, its texels stay where they are.
    const umbrage::cascade_fit<float> fit{
        .camera = {.position = {0, 12, 64}, .direction = {0, -0.2f, -1}, .tan_half_x = 1, .tan_half_y = 0.6f},
        .direction = {1, -0.6f, 0.3f},
        .scene = {{-64, -2, -64}, {64, 7, 64}},
        .overlap = 0.1f,
        .clip = umbrage::opengl_clip_space};
    const auto cascades = umbrage::make_stable_cascades<3>(fit, umbrage::practical_splits<3>(1.0f, 140.0f, 0.8f));
    const umbrage::shadow sun(cascades, fit.map_size, umbrage::filters::tent<3>);
    umbrage::image<float> map(sun.size(), sun.cleared());
    sun.draw(map, {vertices, triangles});

    // On the GPU: draw with lights()[i], upload uniforms(), and call umbrage_sun.
    namespace glsl = umbrage::glsl;
    const std::string fragment = glsl::source(glsl::version::v330, {glsl::bind(sun, "sun")}) + R"GLSL(
in vec3 world, normal;
out vec4 color;
void main() { color = vec4(vec3(umbrage_sun(world, normal)), 1.0); }
)GLSL";

    umbrage::image<float> picture({512, 512});
    int dark = 0;
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) {
            const int i = x / 2, j = y / 2;  // a triangle's own normal, as bias wants it
            const glm::vec3 a = hill(i, j), normal = glm::cross(hill(i, j + 1) - a, hill(i + 1, j) - a);
            const glm::vec3 point = a + ((hill(i, j + 1) - a) + (hill(i + 1, j) - a)) / 3.0f;
            const float visibility = sun(map, point, normal);
            dark += visibility < 0.5f;
            picture[{x, y}] =
                0.1f + 0.9f * visibility * glm::dot(glm::normalize(normal), glm::normalize(-fit.direction));
        }
    write_picture("cascades.png", picture);
    std::printf("cascades.png: %d of %d pixels are in shadow; the shader has %zu bytes, its block %zu\n", dark,
                512 * 512, fragment.size(), sizeof(sun.uniforms()));
}
