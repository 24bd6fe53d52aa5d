// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <umbrage/draw/instances.hpp>
#include <umbrage/light/directional_fit.hpp>

#include "rasterize/scene.hpp"

using namespace umbrage;
using namespace raster_scene;

namespace {

constexpr std::array<clip_space, 6> conventions{
    cpu_clip_space,
    opengl_clip_space,
    direct3d_clip_space,
    clip_space{.range = depth_range::zero_to_one, .direction = depth_direction::reversed},
    clip_space{.range = depth_range::minus_one_to_one, .direction = depth_direction::reversed},
    clip_space{
        .range = depth_range::zero_to_one, .direction = depth_direction::reversed, .origin = texture_origin::top}};

glm::mat4 ortho_to_clip(clip_space clip) {
    const auto space = fit_directional_light<float>(
        {.direction = {0, 0, -1}, .receivers = bounding_box<float>{}, .margin = 0, .clip = clip});
    return space.projection * space.view;
}

bounding_box<float> box_at(glm::vec3 middle) { return {middle - 0.5f, middle + 0.5f}; }
bounding_sphere<float> ball_at(glm::vec3 middle) { return {middle, 0.5f}; }

mesh tetrahedron(generator& random) {
    mesh m;
    m.positions = {{0, 0, 0}, {random.real(0, 1), 1, 0}, {0, 0, 1}, {1, random.real(-1, 0), 1}};
    m.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
    return m;
}

glm::mat4 placed(generator& random, float reach) {
    const glm::vec3 axis(random.real(-1, 1), 1, random.real(-1, 1)),
        size(random.real(0.1f, 1.0f), random.real(-1, 1), 1);
    const glm::vec3 at(random.real(-reach, reach), random.real(-reach, reach), random.real(-reach, reach));
    const float angle = random.real(0, 6);
    return glm::scale(glm::rotate(glm::translate(glm::mat4(1), at), angle, glm::normalize(axis)), size);
}

}  // namespace

TEST_CASE("bounds_of: what is finite") {
    mesh m;
    m.positions = {{1, 2, 3}, {-1, infinity, 0}, {nan_value, 9, 9}, {0, 5, -2}};
    CHECK(bounds_of(m).low == glm::vec3(0, 2, -2));
    CHECK(bounds_of(m).high == glm::vec3(1, 5, 3));
    const bounding_box<float> none = bounds_of({});
    CHECK(none.low.x > none.high.x);
    CHECK_FALSE(may_mark(none, glm::mat4(1), cpu_clip_space));
}

TEST_CASE("may_mark: beyond each side, by hand") {
    for (const clip_space clip : conventions) {
        const glm::mat4 to_clip = ortho_to_clip(clip);  // a map from -1 to 1, the light towards -z
        const auto kept = [&](glm::vec3 at, near_plane at_near = near_plane::clips) {
            const bool box = may_mark(box_at(at), to_clip, clip, at_near);
            CHECK(box == may_mark(ball_at(at), to_clip, clip, at_near));
            return box;
        };
        CHECK(kept({0, 0, 0}));
        for (const float side : {-1.0f, 1.0f}) {
            CHECK(kept({side * 1.49f, 0, 0}));
            CHECK(kept({0, side * 1.49f, 0}));
            CHECK_FALSE(kept({side * 1.51f, 0, 0}));
            CHECK_FALSE(kept({0, side * 1.51f, 0}));
        }
        CHECK(kept({0, 0, -1.49f}, near_plane::clamps));
        CHECK_FALSE(kept({0, 0, -1.51f}, near_plane::clamps));
        CHECK(kept({0, 0, 1.49f}));
        CHECK_FALSE(kept({0, 0, 1.51f}));
        CHECK(kept({0, 0, 1.51f}, near_plane::clamps));
        CHECK(kept({0, 0, 1e6f}, near_plane::clamps));
        CHECK_FALSE(kept({1.51f, 0, 1e6f}, near_plane::clamps));
        CHECK_FALSE(may_mark(box_at({1.4f, 1.4f, 0}), glm::translate(to_clip, {0.2f, 0, 0}), clip));
    }
    // a ball is smaller than its box where a side is slanted
    const glm::mat4 turned = glm::rotate(glm::mat4(1), glm::radians(45.0f), {0, 0, 1});
    const glm::vec3 at = glm::vec3(1.6f, 0, 0.5f) * glm::mat3(turned);
    CHECK(may_mark(box_at(at), turned, cpu_clip_space));
    CHECK_FALSE(may_mark(ball_at(at), turned, cpu_clip_space));
}

TEST_CASE("may_mark: behind a perspective's eye") {
    CHECK(may_mark(box_at({0, 0, -1}), perspective(), cpu_clip_space));
    for (const near_plane at_near : {near_plane::clips, near_plane::clamps})
        CHECK_FALSE(may_mark(box_at({0, 0, 1}), perspective(), cpu_clip_space, at_near));
    CHECK(may_mark(box_at({0, 0, 0.4f}), perspective(), cpu_clip_space, near_plane::clamps));
}

TEST_CASE("may_mark: nothing, and what is not finite") {
    const glm::mat4 all(1);
    CHECK_FALSE(may_mark(bounding_box<float>{{1, 0, 0}, {0, 1, 1}}, all, cpu_clip_space));
    CHECK_FALSE(may_mark(bounding_sphere<float>{{0, 0, 0}, -1}, all, cpu_clip_space));
    CHECK(may_mark(bounding_sphere<float>{{0, 0, 0.5f}, 0}, all, cpu_clip_space));
    CHECK(may_mark(bounding_box<float>{{5, 5, nan_value}, {6, 6, 6}}, all, cpu_clip_space));
    CHECK(may_mark(bounding_box<float>{glm::vec3(-infinity), glm::vec3(infinity)}, all, cpu_clip_space));
    CHECK(may_mark(bounding_sphere<float>{{9, 9, 9}, infinity}, all, cpu_clip_space));
    glm::mat4 broken(1);
    broken[3][0] = nan_value;
    CHECK_FALSE(may_mark(bounding_box<float>{}, broken, cpu_clip_space));
    broken[3][0] = infinity;
    CHECK_FALSE(may_mark(bounding_sphere<float>{}, broken, cpu_clip_space));
    const float most = std::numeric_limits<float>::max();
    CHECK(may_mark(bounding_box<float>{glm::vec3(-most), glm::vec3(most)}, all, cpu_clip_space));
}

TEST_CASE("may_mark: says no only of what marks no texel, and of most of that") {
    generator random;
    const glm::ivec2 size(64, 48);
    for (const clip_space clip : conventions)
        for (const near_plane at_near : {near_plane::clips, near_plane::clamps})
            for (const bool eye : {false, true}) {
                if (eye && clip != cpu_clip_space) continue;
                CAPTURE(eye);
                const glm::mat4 to_clip = eye ? perspective() : ortho_to_clip(clip);
                const mesh tree = tetrahedron(random);
                const bounding_box<float> box = bounds_of(tree);
                const bounding_sphere<float> ball{(box.low + box.high) * 0.5f,
                                                  glm::length(box.high - box.low) * 0.5f * 1.0001f};
                const float cleared = cleared_depth(clip);
                int marking = 0, by_box = 0, by_ball = 0;
                for (int i = 0; i < 300; ++i) {
                    const glm::mat4 to_map = model_to_clip(to_clip, placed(random, 2.5f));
                    image<float> map(size, cleared);
                    rasterize_depth(map, tree, to_map, clip, cull_mode::none, {}, at_near);
                    const bool marks = !all(map, cleared), box_says = may_mark(box, to_map, clip, at_near),
                               ball_says = may_mark(ball, to_map, clip, at_near);
                    CHECK(marks <= box_says);
                    CHECK(marks <= ball_says);
                    marking += marks, by_box += box_says, by_ball += ball_says;
                }
                CHECK(marking > 10);
                CHECK(by_box < 2 * marking + 10);
                CHECK(by_ball < 3 * marking + 10);
                CHECK(by_ball < 250);
            }
}

TEST_CASE("instances_in_map: the map of those that are kept is the map of all") {
    generator random;
    const mesh tree = tetrahedron(random);
    for (const clip_space clip : conventions) {
        std::vector<glm::mat4> trees;
        for (int i = 0; i < 500; ++i) trees.push_back(placed(random, 6));
        const glm::mat4 to_clip = ortho_to_clip(clip);
        const auto kept = instances_in_map(bounds_of(tree), trees, to_clip, clip, near_plane::clamps);
        CHECK(kept.size() > 5);
        CHECK(kept.size() < 100);
        image<float> expected({64, 48}, cleared_depth(clip)), got = expected;
        rasterize_depth(expected, tree, trees, to_clip, clip, cull_mode::none, {}, near_plane::clamps);
        rasterize_depth(got, tree, kept, to_clip, clip, cull_mode::none, {}, near_plane::clamps);
        CHECK_FALSE(all(got, cleared_depth(clip)));
        CHECK(same_bits(got, expected));
    }
}
