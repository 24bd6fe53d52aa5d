// SPDX-License-Identifier: MIT
//
// Scene of the examples: triangles on a floor, made here or read from a file. World units, y is up.
//
//     example::scene scene = example::default_scene();
//     example::scene scene = example::on_floor(example::load_mesh("bunny.obj"), example::up_axis::y);
//
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/draw/mesh.hpp>

namespace example {

/// Triangles with what shading wants to know about each vertex; the three vectors of vertices are equally long.
struct mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  ///< normals of length 1
    std::vector<glm::vec3> colors;   ///< linear, 0..1
    std::vector<glm::uvec3> triangles;
};

/// The mesh, moved, turned about and scaled evenly by a matrix, added to another.
void append(mesh& to, const mesh& of, const glm::mat4& place);

/// One shape in many places.
struct copies {
    mesh shape;
    std::vector<glm::mat4> places;  ///< shape to world: moves, turns and scales evenly
};

/// A mesh whose first `floor_triangles` are the tiled floor at y = 0, and the box around everything.
struct scene {
    mesh geometry;  ///< all of it
    std::size_t floor_triangles = 0;
    glm::vec3 low{0}, high{0};            ///< bounds of everything
    glm::vec3 target{0, 0.7f, 0};         ///< point that lights and cameras look at
    float z_near = 0.1f, z_far = 200.0f;  ///< between which cameras see
    std::vector<copies> parts{};  ///< the same once more in the same order, as what it is made of; none: of one part
};

/// Sets low and high.
void find_bounds(scene& s);

[[nodiscard]] inline umbrage::mesh_view view_of(const mesh& m) { return {m.positions, m.triangles}; }

enum class up_axis { y, z };  ///< up axis of a mesh from a file

/// A kilometre of hills with a village, woods and rocks: a sun's cascades have something to do.
[[nodiscard]] scene outdoor_scene();

/// A kilometre of plain with a few posts on it, seen from two metres above: what papers on warps draw their lights for.
[[nodiscard]] scene plain_scene();

/// A garden before a wall: a mast, steps, a fence, a tree and a knot, whose shadows are hard to draw.
[[nodiscard]] scene default_scene();

/// A tiled floor, and on it a ball on a pillar that throws its shadow on a box, and a torus: as simple as the scenes
/// that the original systems came with.
[[nodiscard]] scene solids_scene();

/// The mesh stood upright on a floor, centered, and scaled to fit into the view whatever its units were.
/// @param object   at least one triangle, each with an area, as load_mesh gives it
[[nodiscard]] scene on_floor(mesh object, up_axis up);

/// OBJ, glTF, PLY and whatever else assimp reads, flattened into one mesh without triangles that cannot be drawn.
/// @throws std::runtime_error  missing, empty or broken file; the message is one line and names the file
[[nodiscard]] mesh load_mesh(const std::filesystem::path& path);

}  // namespace example
