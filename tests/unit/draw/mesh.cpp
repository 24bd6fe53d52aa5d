// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/core/scalar.hpp>
#include <umbrage/draw/instances.hpp>
#include <umbrage/draw/mesh.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/draw/tessellate.hpp>

#include "rasterize/scene.hpp"

using namespace umbrage;

namespace {

struct vertex {
    glm::vec3 normal, position;
    glm::vec2 uv;
};

template <class Make>
std::string refused(const Make& make) {
    try {
        static_cast<void>(make());
    } catch (const std::invalid_argument& e) { return e.what(); }
    return "accepted";
}

}  // namespace

TEST_CASE("model_to_clip: the product in double, rounded once") {
    glm::mat4 camera(1), model(1);
    camera[3][0] = -1e6f;
    camera[0][0] = 3;
    model[3][0] = 333333.375f;
    CHECK(model_to_clip(camera, model)[3][0] == 0.125f);  // 3 * 333333.375 is no float
    model[1][1] = 1e30f;
    camera[1][1] = 1e30f;
    CHECK_FALSE(is_finite(model_to_clip(camera, model)[1][1]));
}

TEST_CASE("is_mirrored: one or three negative scales mirror, two turn") {
    const auto scaled = [](float x, float y, float z) {
        glm::mat4 model(1);
        model[0] *= x, model[1] *= y, model[2] *= z;
        model[3] = {-5, 6, -7, 1};
        return model;
    };
    CHECK_FALSE(is_mirrored(scaled(1, 1, 1)));
    CHECK(is_mirrored(scaled(-1, 1, 1)));
    CHECK(is_mirrored(scaled(2, 1, -1e-30f)));
    CHECK(is_mirrored(scaled(-3e38f, -3e38f, -3e38f)));
    CHECK_FALSE(is_mirrored(scaled(-1, 2, -1)));
    CHECK_FALSE(is_mirrored(scaled(-1, 0, 1)));
    glm::mat4 exchanged(1);
    exchanged[0] = {0, 1, 0, 0}, exchanged[1] = {1, 0, 0, 0};
    CHECK(is_mirrored(exchanged));
}

TEST_CASE("mesh_view: interleaved vertices and 16-bit indices are drawn as packed ones") {
    raster_scene::generator random;
    const raster_scene::mesh soup = raster_scene::soup(random, 400);
    std::vector<vertex> vertices;
    for (const glm::vec3& p : soup.positions) vertices.push_back({glm::vec3(raster_scene::nan_value), p, {}});
    std::vector<std::uint16_t> shorts;
    std::vector<std::uint32_t> words;
    for (const glm::uvec3& t : soup.triangles)
        for (glm::length_t k = 0; k < 3; ++k) shorts.push_back(std::uint16_t(t[k])), words.push_back(t[k]);
    const position_view interleaved(&vertices[0].position.x, vertices.size(), sizeof(vertex));
    const glm::ivec2 size(200, 100);
    const glm::mat4 to_clip = raster_scene::perspective();
    const image<float> expected = raster_scene::render(size, soup, to_clip);
    CHECK_FALSE(raster_scene::all(expected, 1));
    for (const mesh_view& same : {mesh_view{interleaved, soup.triangles}, mesh_view{soup.positions, shorts},
                                  mesh_view{soup.positions, words}, mesh_view{interleaved, shorts}}) {
        CHECK(raster_scene::same_bits(raster_scene::render(size, same, to_clip), expected));
        CHECK(barycentrics(size, same, to_clip, cpu_clip_space, {5, 5}, 7) ==
              barycentrics(size, soup, to_clip, cpu_clip_space, {5, 5}, 7));
        CHECK(bounds_of(same).low == bounds_of(soup).low);
        CHECK(tessellate(same, {.range = 9}).triangles == tessellate(soup, {.range = 9}).triangles);
    }
}

TEST_CASE("mesh_view: spans, vectors and arrays, of their elements in order") {
    const glm::vec3 corners[]{{1, 2, 3}, {4, 5, 6}};
    const std::array<glm::uvec3, 2> both{{{0, 1, 0}, {1, 0, 1}}};
    const mesh_view mesh{corners, both};
    CHECK(mesh.positions.size() == 2);
    CHECK(mesh.positions[1] == corners[1]);
    CHECK(mesh.triangles.size() == 2);
    CHECK(mesh.triangles[1] == both[1]);
    const mesh_view part{std::span(corners).first(1), std::span(both).last(1)};
    for (const glm::vec3& p : part.positions) CHECK(p == corners[0]);
    for (const glm::uvec3& t : part.triangles) CHECK(t == both[1]);
    CHECK(mesh_view{}.positions.empty());
    CHECK(mesh_view{}.triangles.empty());
}

TEST_CASE("mesh_view: bad strides and numbers of indices") {
    const float numbers[12]{};
    const auto strided = [&](std::size_t stride) { return refused([&] { return position_view(numbers, 2, stride); }); };
    CHECK(strided(12) == "accepted");
    CHECK(strided(24) == "accepted");
    CHECK(strided(3) == "umbrage::position_view: stride must be a multiple of 4 bytes, 12 or more; got 3");
    CHECK(strided(14).ends_with("got 14"));
    CHECK(strided(0).ends_with("got 0"));
    CHECK(refused([] { return position_view(nullptr, 0, 12); }) == "accepted");
    CHECK(refused([] { return position_view(nullptr, 5, 12); }) ==
          "umbrage::position_view: count must be 0 where first is null; got 5");
    const std::vector<std::uint16_t> seven(7);
    CHECK(refused([&] { return triangle_view(seven); }) ==
          "umbrage::triangle_view: indices.size() must be a multiple of 3; got 7");
    const std::vector<std::uint16_t> beyond{0, 1, 9};
    image<float> map({4, 4}, 1.0f);
    CHECK(refused([&] {
              rasterize_depth(map, {position_view(numbers, 2, 12), beyond}, glm::mat4(1), cpu_clip_space);
              return 0;
          }) == "umbrage::rasterize_depth: mesh.triangles must be indices of positions; got 9");
}
