// SPDX-License-Identifier: MIT
//
// Writes the scenes of the examples as files for a page:  node write_scenes.js FOLDER
//
// A file is, in little endian: the point that cameras look at, as three floats; the number of parts, as a 32-bit
// integer; for each part its numbers of vertices, triangles and places, as 32-bit integers; the vertices' positions as
// three floats each, their normals as four signed bytes, their colors as four bytes, square roots of linear ones; three
// indices a triangle, of 32 bits; a 4 x 4 matrix a place, column by column.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "common/scene.hpp"

namespace {

template <class T>
void put(std::FILE* file, const std::vector<T>& all) {
    std::fwrite(all.data(), sizeof(T), all.size(), file);
}

void put(std::FILE* file, const example::copies& part) {
    const example::mesh& m = part.shape;
    std::vector<std::int8_t> normals;
    std::vector<std::uint8_t> colors;
    for (std::size_t i = 0; i < m.positions.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            normals.push_back(static_cast<std::int8_t>(std::lround(m.normals[i][c] * 127.0f)));
            colors.push_back(static_cast<std::uint8_t>(std::lround(std::sqrt(m.colors[i][c]) * 255.0f)));
        }
        normals.push_back(0), colors.push_back(255);
    }
    put(file, std::vector{std::uint32_t(m.positions.size()), std::uint32_t(m.triangles.size()),
                          std::uint32_t(part.places.size())});
    put(file, m.positions);
    put(file, normals);
    put(file, colors);
    put(file, m.triangles);
    put(file, part.places);
}

bool write(const example::scene& scene, const std::string& path) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (!file) return false;
    const auto parts = scene.parts.empty() ? std::vector{example::copies{scene.geometry, {glm::mat4(1)}}} : scene.parts;
    put(file, std::vector{scene.target});
    put(file, std::vector{std::uint32_t(parts.size())});
    for (const example::copies& part : parts) put(file, part);
    return std::fclose(file) == 0;
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return 2;
    const std::string folder = arguments[1];
    const bool written = write(example::default_scene(), folder + "/garden.scene") &&
                         write(example::outdoor_scene(), folder + "/outdoor.scene");
    return written ? 0 : 1;
}
