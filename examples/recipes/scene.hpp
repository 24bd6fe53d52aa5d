// SPDX-License-Identifier: MIT
//
// Scene of every recipe in C++: a mesh with a fence, its camera and lights, their shading, and a picture's file.
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/spot_light.hpp>

namespace scene {

struct vertex {
    glm::vec3 position, normal;
    glm::vec2 uv;  ///< coordinates on the fence, whose pickets are half of each unit; 0 is solid
};

inline constexpr glm::ivec2 picture_size(480, 320);
inline constexpr umbrage::frustum<float> camera{
    .position = {0, 5, 9}, .direction = {0, -0.4f, -1}, .tan_half_x = 0.75f, .tan_half_y = 0.5f, .z_far = 60};
inline constexpr glm::vec4 sky(0.53f, 0.69f, 0.87f, 1);

inline glm::mat4 camera_matrix(umbrage::clip_space clip) {
    return umbrage::perspective(camera.tan_half_x, camera.tan_half_y, camera.z_near, camera.z_far, clip) *
           umbrage::look_along(camera.position, camera.direction, camera.up, clip.hand);
}
inline auto make_spot(umbrage::clip_space clip) {
    return umbrage::make_spot_light<float>({.position = {5, 8, 4},
                                            .direction = {-5, -8, -4},
                                            .outer_angle_radians = 0.5f,
                                            .z_near = 1,
                                            .z_far = 30,
                                            .clip = clip});
}
inline auto make_cascades(umbrage::clip_space clip) {
    const umbrage::cascade_fit<float> fit{
        .camera = camera, .direction = {1, -1.2f, -0.7f}, .scene = {{-16, 0, -30}, {16, 4, 6}}, .clip = clip};
    return umbrage::make_stable_cascades<3>(fit, umbrage::practical_splits<3>(2.0f, 40.0f, 0.8f));
}

/// Triangles of the scene: floor, pillars, a plate in the air, and a fence as its last two.
inline std::vector<vertex> make_mesh() {
    std::vector<vertex> mesh;
    const auto quad = [&](glm::vec3 corner, glm::vec3 a, glm::vec3 b, glm::vec3 normal, float pickets = 0) {
        for (const glm::vec2 at : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
            mesh.push_back({corner + a * at.x + b * at.y, normal, {at.x * pickets, at.y}});
    };
    const auto box = [&](glm::vec3 low, glm::vec3 size) {
        const glm::vec3 high = low + size, x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
        quad(low, y, z, {-1, 0, 0}), quad(high, -z, -y, {1, 0, 0});
        quad(low, z, x, {0, -1, 0}), quad(high, -x, -z, {0, 1, 0});
        quad(low, x, y, {0, 0, -1}), quad(high, -y, -x, {0, 0, 1});
    };
    quad({-16, 0, -30}, {32, 0, 0}, {0, 0, 36}, {0, 1, 0});
    for (int i = 0; i < 5; ++i) box({-4, 0, float(-6 * i)}, {1, 3, 1}), box({4, 0, float(-6 * i - 3)}, {1, 4, 1});
    box({-1, 0, -1}, {1.4f, 1.2f, 1.4f});
    box({1, 1.5f, -3}, {1.5f, 0.2f, 1.5f});
    quad({-2.5f, 0, 3}, {3, 0, 0}, {0, 1, 0}, {0, 0, 1}, 8);
    return mesh;
}

/// GLSL of any version: holes of the fence, and light from a spot and a sun of given visibilities.
inline const std::string shading = R"(
bool is_hole(vec2 uv) { return fract(uv.x) > 0.5; }
vec3 shade(vec3 world, vec3 normal, float spot, float sun) {
    vec3 to_spot = normalize(vec3(5.0, 8.0, 4.0) - world), to_sun = normalize(vec3(-1.0, 1.2, 0.7));
    float cone = smoothstep(0.88, 0.9, dot(to_spot, normalize(vec3(5.0, 8.0, 4.0))));
    return vec3(0.2, 0.22, 0.27) + vec3(0.3, 0.17, 0.0) * spot * cone * max(dot(normal, to_spot), 0.0) +
           vec3(0.52, 0.46, 0.36) * sun * max(dot(normal, to_sun), 0.0);
}
)";
/// Writes texels as bytes, for tests.
inline void write_floats(const char* file, const std::vector<float>& texels) {
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(texels.data()), std::streamsize(4 * texels.size()));
}

/// Writes RGBA as a PNG.
/// @param bottom_first   of its rows, as OpenGL has them
inline void write_picture(const char* file, const std::vector<glm::u8vec4>& pixels, bool bottom_first) {
    stbi_flip_vertically_on_write(bottom_first);
    stbi_write_png(file, picture_size.x, picture_size.y, 4, pixels.data(), 4 * picture_size.x);
}

}  // namespace scene
