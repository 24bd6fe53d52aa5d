// SPDX-License-Identifier: MIT
//
// A shared library for programs in other languages: texts once, blocks and matrices in each frame.
#include <cstring>
#include <string>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "scene.hpp"

namespace {

namespace glsl = umbrage::glsl;
constexpr auto clip = umbrage::opengl_clip_space;

auto make_spot() { return umbrage::shadow(scene::make_spot(clip), {1024, 1024}, umbrage::filters::tent<3>); }
auto make_sun() { return umbrage::shadow(scene::make_cascades(clip), {1024, 1024}, umbrage::filters::tent<3>); }

int give(const auto& shadow, float* block, float* to_clip) {
    const auto uniforms = shadow.uniforms();
    constexpr int floats = sizeof uniforms / sizeof(float);
    if (!block) return floats;
    std::memcpy(block, &uniforms, sizeof uniforms);
    for (const auto& light : shadow.setup().lights()) {
        const glm::mat4 matrix(light.projection * light.view);
        std::memcpy(to_clip, &matrix, sizeof matrix), to_clip += 16;
    }
    return floats;
}

}  // namespace

extern "C" {

/// GLSL of both shadows: umbrage_spot, umbrage_sun.
const char* shadow_text() {
    static const std::string text =
        glsl::source(glsl::version::v330, {glsl::bind(make_spot(), "spot", {.map = glsl::texture::depth}),
                                           glsl::bind(make_sun(), "sun", {.map = glsl::texture::atlas})});
    return text.c_str();
}

// Blocks, one matrix and three. The result is a block's floats, without a block that alone. Take what moves as
// arguments: here nothing does.
int spot_values(float* block, float* to_clip) { return give(make_spot(), block, to_clip); }
int sun_values(float* block, float* to_clip) { return give(make_sun(), block, to_clip); }

// The scene, which is yours.
const char* shading_text() { return scene::shading.c_str(); }
void camera_values(float* to_clip) { std::memcpy(to_clip, &scene::camera_matrix(clip)[0][0], 64); }
int mesh_values(float* floats) {
    const std::vector<scene::vertex> mesh = scene::make_mesh();
    if (floats != nullptr) std::memcpy(floats, mesh.data(), sizeof mesh[0] * mesh.size());
    return static_cast<int>(8 * mesh.size());
}
}
