// SPDX-License-Identifier: MIT
//
// Alternatives to this library's depth pass, each in a file of its own.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace peers {

/// Mesa's llvmpipe with one thread: a depth-only pass of OpenGL into 32-bit float depth.
class llvmpipe_pass {
public:
    llvmpipe_pass(glm::ivec2 size, std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
                  const glm::mat4& world_to_clip);
    ~llvmpipe_pass();

    void clear_and_draw() const;                    ///< finished on return
    [[nodiscard]] std::vector<float> read() const;  ///< rows from the bottom

private:
    struct state;
    std::unique_ptr<state> state_;
};

/// Embree with one thread: a scene, and for each point whether the way in a direction is free.
class embree_scene {
public:
    embree_scene();
    ~embree_scene();

    void build(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles);

    /// 1 = lit; coherent packets of 16.
    void visibility(std::span<const glm::vec3> points, glm::vec3 to_light, std::span<float> lit) const;

private:
    struct state;
    std::unique_ptr<state> state_;
};

}  // namespace peers
