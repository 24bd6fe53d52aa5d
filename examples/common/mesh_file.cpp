// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <glm/geometric.hpp>

#include "scene.hpp"

namespace example {
namespace {

glm::vec3 to_glm(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// Color of a material that says nothing.
constexpr glm::vec3 clay{0.72f, 0.52f, 0.38f};

glm::vec3 color_of(const aiMaterial& material) {
    aiColor3D color;
    aiString name;
    material.Get(AI_MATKEY_NAME, name);
    const bool given = std::string_view(name.C_Str()) != AI_DEFAULT_MATERIAL_NAME &&
                       material.GetTextureCount(aiTextureType_DIFFUSE) == 0 &&
                       material.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS && !color.IsBlack();
    return given ? glm::vec3(color.r, color.g, color.b) : clay;
}

}  // namespace

mesh load_mesh(const std::filesystem::path& path) {
    const auto fail = [&](std::string why) {
        return std::runtime_error(path.string() + ": " + why.substr(0, why.find_first_of("\r\n")));
    };
    std::error_code error;
    if (!std::filesystem::exists(path, error)) throw fail("no such file");
    if (!std::filesystem::is_regular_file(path, error)) throw fail("not a file");
    if (std::filesystem::file_size(path, error) == 0 || error) throw fail("the file is empty");

    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 50.0f);
    const aiScene* file =
        importer.ReadFile(path.string(), aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenSmoothNormals |
                                             aiProcess_JoinIdenticalVertices | aiProcess_PreTransformVertices |
                                             aiProcess_ValidateDataStructure);
    const std::string_view error_text = importer.GetErrorString();
    if (!file && error_text == "No meshes remaining") throw fail("no triangles in it, only points and lines");
    if (!file) throw fail(std::string(error_text));

    mesh out;
    for (const aiMesh* part : std::span(file->mMeshes, file->mNumMeshes)) {
        if (!part->HasNormals()) continue;  // points and lines only
        const auto base = static_cast<unsigned>(out.positions.size());
        const glm::vec3 color = color_of(*file->mMaterials[part->mMaterialIndex]);
        for (unsigned i = 0; i < part->mNumVertices; ++i) {
            out.positions.push_back(to_glm(part->mVertices[i]));
            out.normals.push_back(to_glm(part->mNormals[i]));
            const aiColor4D* painted = part->HasVertexColors(0) ? &part->mColors[0][i] : nullptr;
            out.colors.push_back(painted ? glm::vec3(painted->r, painted->g, painted->b) : color);
        }
        const auto inside = [&](unsigned index) { return index < part->mNumVertices; };
        for (const aiFace& face : std::span(part->mFaces, part->mNumFaces))
            if (face.mNumIndices == 3 && std::all_of(face.mIndices, face.mIndices + 3, inside))
                out.triangles.emplace_back(base + face.mIndices[0], base + face.mIndices[1], base + face.mIndices[2]);
    }
    if (out.triangles.empty()) throw fail("no triangles in it");
    std::size_t unbounded = 0;
    std::erase_if(out.triangles, [&](glm::uvec3 t) {
        const glm::dvec3 a = out.positions[t.x], b = out.positions[t.y], c = out.positions[t.z];
        const double twice_area = glm::length(glm::cross(b - a, c - a));
        const bool finite = std::isfinite(twice_area);  // NaN where a coordinate is missing
        unbounded += !finite;
        return !(finite && twice_area > 0.0);
    });
    if (out.triangles.empty())
        throw fail(unbounded ? "its triangles have coordinates that are infinite or no number"
                             : "none of its triangles has an area");
    return out;
}

}  // namespace example
