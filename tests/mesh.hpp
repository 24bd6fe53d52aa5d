// SPDX-License-Identifier: MIT
//
// Mesh that owns its vertices and triangles, for tests that make their own.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include <umbrage/draw/mesh.hpp>

namespace tests {

struct mesh {
    std::vector<glm::vec3> positions{};
    std::vector<glm::uvec3> triangles{};
    [[nodiscard]] umbrage::mesh_view view() const { return {positions, triangles}; }
};

}  // namespace tests
