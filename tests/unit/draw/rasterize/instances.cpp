// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include <umbrage/draw/rasterize.hpp>

#include "scene.hpp"

using namespace umbrage;
using namespace raster_scene;

namespace {

/// Cuts everything into pieces of one, last first.
constexpr auto backwards = [](int count, auto&& piece) {
    for (int i = count; i > 0; --i) piece(i - 1, i);
};

glm::mat4 placed(generator& random) {
    const glm::vec3 at(random.real(-2, 2), random.real(-2, 2), random.real(-6, 1));
    const float angle = random.real(0, 6);
    return glm::rotate(glm::translate(glm::mat4(1), at), angle, {0.6f, 0, 0.8f});
}

struct pictures {
    image<float> one_by_one, together, in_pieces;
};

pictures draw(glm::ivec2 size, const mesh_view& m, const std::vector<glm::mat4>& instances, clip_space clip,
              near_plane at_near) {
    const image<float> empty(size, cleared_depth(clip));
    pictures p{empty, empty, empty};
    for (const glm::mat4& i : instances)
        rasterize_depth(p.one_by_one, m, model_to_clip(perspective(), i), clip,
                        is_mirrored(i) ? cull_mode::front : cull_mode::back, {}, at_near);
    rasterize_depth(p.together, m, instances, perspective(), clip, cull_mode::back, {}, at_near);
    rasterize_depth(p.in_pieces, m, instances, perspective(), clip, cull_mode::back, backwards, at_near);
    return p;
}

}  // namespace

TEST_CASE("rasterize_depth: instances have the bits of one pass each, in any pieces") {
    generator random;
    mesh m = soup(random, 40);
    for (glm::vec3& p : m.positions) p *= 0.3f;
    std::vector<glm::mat4> instances;
    for (int i = 0; i < 60; ++i) {
        instances.push_back(placed(random));
        if (i % 3 == 0) instances.back()[0] *= -1.0f;
    }
    instances[7][3][1] = nan_value;
    instances[9][0][0] = infinity;
    for (const clip_space clip :
         {cpu_clip_space, clip_space{.range = depth_range::zero_to_one, .origin = texture_origin::top}})
        for (const near_plane at_near : {near_plane::clips, near_plane::clamps}) {
            const pictures p = draw({96, 80}, m, instances, clip, at_near);
            CHECK_FALSE(all(p.one_by_one, 1));
            CHECK(same_bits(p.one_by_one, p.together));
            CHECK(same_bits(p.one_by_one, p.in_pieces));
        }
}

TEST_CASE("rasterize_depth: more instances, or a larger mesh, than are drawn at a time") {
    generator random;
    std::vector<glm::mat4> instances;
    for (int i = 0; i < 1100; ++i) instances.push_back(placed(random));
    mesh small;
    small.add({0, 0, 0}, {0.3f, 0, 0}, {0, 0.3f, 0});
    small.positions.insert(small.positions.begin(), 5, glm::vec3(nan_value));
    small.triangles[0] += 5;
    const pictures many = draw({80, 64}, small, instances, cpu_clip_space, near_plane::clips);
    CHECK(same_bits(many.one_by_one, many.together));
    CHECK(same_bits(many.one_by_one, many.in_pieces));

    mesh large;
    for (int i = 0; i < 66000; ++i) {
        const glm::vec3 at(float(i % 257) / 256, float(i / 257) / 256, 0);
        large.add(at, at + glm::vec3(0.01f, 0, 0), at + glm::vec3(0, 0.01f, 0.1f));
    }
    instances.resize(3);
    const pictures few = draw({80, 64}, large, instances, cpu_clip_space, near_plane::clips);
    CHECK(same_bits(few.one_by_one, few.together));
    CHECK(same_bits(few.one_by_one, few.in_pieces));
}

TEST_CASE("rasterize_depth: where nothing rounds, instances are the meshes moved and put together") {
    generator random;
    const glm::ivec2 size(128, 96);
    const auto whole = [&](int low, int high) { return float(random(low, high)); };
    const glm::mat4 to_clip = glm::scale(glm::mat4(1), {0x1p-6f, 0x1p-6f, 0x1p-8f});
    mesh m, all_of_them;
    for (int i = 0; i < 6; ++i) {
        glm::vec3 corner[3];
        for (glm::vec3& c : corner) c.x = whole(-8, 8), c.y = whole(-8, 8), c.z = whole(0, 16);
        m.add(corner[0], corner[1], corner[2]);
    }
    std::vector<glm::mat4> instances;
    for (int i = 0; i < 50; ++i) {
        glm::vec3 at;
        at.x = whole(-64, 64), at.y = whole(-64, 64), at.z = whole(0, 240);
        glm::mat4 quarter_turns(1);
        quarter_turns[0] = glm::vec4(0, i % 2 == 0 ? 2 : -1, 0, 0), quarter_turns[1] = glm::vec4(1, 0, 0, 0);
        quarter_turns[3] = glm::vec4(at, 1);
        instances.push_back(quarter_turns);
        for (const glm::uvec3 t : m.triangles) {
            const auto moved = [&](glm::length_t k) {
                return glm::vec3(quarter_turns * glm::vec4(m.positions[t[k]], 1));
            };
            all_of_them.add(moved(0), moved(1), moved(2));
        }
    }
    image<float> got(size, 1.0f);
    rasterize_depth(got, m, instances, to_clip, cpu_clip_space);
    CHECK_FALSE(all(got, 1));
    CHECK(same_bits(got, render(size, all_of_them, to_clip)));
}

TEST_CASE("rasterize_depth: no instances, and bad meshes") {
    image<float> map({8, 8}, 1.0f);
    mesh m;
    m.add({-9, -9, 0.5f}, {9, -9, 0.5f}, {0, 9, 0.5f});
    const std::vector<glm::mat4> none, one(1, glm::mat4(1));
    rasterize_depth(map, m, none, glm::mat4(1), cpu_clip_space);
    CHECK(all(map, 1));
    glm::mat4 broken(1);
    broken[2][2] = nan_value;
    rasterize_depth(map, m, one, broken, cpu_clip_space);
    CHECK(all(map, 1));
    rasterize_depth(map, mesh(), one, glm::mat4(1), cpu_clip_space);
    CHECK(all(map, 1));
    rasterize_depth(map, m, one, glm::mat4(1), cpu_clip_space);
    CHECK_FALSE(all(map, 1));
    m.triangles.emplace_back(0, 1, 3);
    CHECK_THROWS_AS(rasterize_depth(map, m, one, glm::mat4(1), cpu_clip_space), std::invalid_argument);
    image<float> wide({16385, 1});
    CHECK_THROWS_AS(rasterize_depth(wide, m, none, glm::mat4(1), cpu_clip_space), std::invalid_argument);
}

TEST_CASE("rasterize_depth: a box and its mirror image are one body, whichever faces are left out") {
    mesh box;
    for (int i = 0; i < 8; ++i) box.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    for (const cull_mode cull : {cull_mode::none, cull_mode::back, cull_mode::front}) {
        const auto drawn = [&](const glm::vec3& scale) {
            glm::mat4 model = glm::scale(glm::translate(glm::mat4(1), {0.25f, 0, -4}), scale);
            image<float> map({64, 64}, 1.0f);
            rasterize_depth(map, box, std::span<const glm::mat4>(&model, 1), perspective(), cpu_clip_space, cull);
            return map;
        };
        const image<float> plain = drawn({1, 1, 1});
        CHECK_FALSE(all(plain, 1));
        for (const glm::vec3 scale : {glm::vec3(-1, 1, 1), glm::vec3(-1, -1, -1), glm::vec3(1, -1, -1)}) {
            const image<float> other = drawn(scale);
            CHECK(other[{36, 32}] == plain[{36, 32}]);  // squares have another diagonal, so slopes round otherwise
            int holes = 0;
            for (std::size_t i = 0; i < plain.texels().size(); ++i)
                holes += (plain.texels()[i] == 1) != (other.texels()[i] == 1);
            CHECK(holes == 0);
        }
    }
}
