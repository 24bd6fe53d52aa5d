// SPDX-License-Identifier: MIT
//
// The oracle goes from a world position to the camera's image and to the map, and asks for the way back.
#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <umbrage/images/receivers.hpp>

using namespace umbrage;

static_assert(receiver_image<image<glm::vec3>> && receiver_image<image_view<glm::vec3>> &&
              receiver_image<image_view<const glm::vec3>>);
static_assert(receiver_image<receiver_planes> && receiver_image<depth_receivers>);
static_assert(!receiver_image<sloped_receivers> && !receiver_image<image<float>> && !receiver_image<glm::vec3>);

TEST_CASE("receiver_at: a camera's texel and depth lead to what the map's matrix makes of the point seen there") {
    const glm::mat4 view = glm::lookAtRH(glm::vec3(3, 4, 5), glm::vec3(0), glm::vec3(0, 1, 0));
    const glm::mat4 projection = glm::perspectiveRH_NO(1.0f, 1.5f, 1.0f, 20.0f);
    const glm::mat4 to_map = glm::ortho(-3.0f, 3.0f, -3.0f, 3.0f, -9.0f, 9.0f);
    const glm::ivec2 size(96, 64);
    image<float> depth(size);
    for (const clip_space clip : {opengl_clip_space, direct3d_clip_space}) {
        const glm::mat4 ours =
            clip.range == depth_range::minus_one_to_one ? projection : glm::perspectiveRH_ZO(1.0f, 1.5f, 1.0f, 20.0f);
        const depth_receivers seen{depth.view(), receiver_matrix(glm::inverse(ours * view), to_map, size, clip),
                                   0.125f};
        for (const glm::ivec2 texel : {glm::ivec2(0), glm::ivec2(95, 63), glm::ivec2(40, 11)}) {
            const glm::vec2 ndc = (glm::vec2(texel) + 0.5f) / glm::vec2(size) * 2.0f - 1.0f;
            const float up = clip.origin == texture_origin::bottom ? 1.0f : -1.0f, z = 0.9f;
            const float clip_z = clip.range == depth_range::minus_one_to_one ? 2.0f * z - 1.0f : z;
            const glm::vec4 world = glm::inverse(ours * view) * glm::vec4(ndc.x, up * ndc.y, clip_z, 1.0f);
            const glm::vec4 expected = to_map * (world / world.w);
            depth[texel] = z;
            const glm::vec3 got = receiver_at(seen, texel);
            CHECK(got.x == doctest::Approx(expected.x).epsilon(1e-4));
            CHECK(got.y == doctest::Approx(expected.y).epsilon(1e-4));
            CHECK(got.z == doctest::Approx(expected.z - 0.125f).epsilon(1e-4));
        }
    }
}

TEST_CASE("receiver_matrix: no image, or a matrix that is not finite") {
    const glm::mat4 one(1.0f), broken(std::numeric_limits<float>::infinity());
    CHECK_THROWS_AS((void)receiver_matrix(one, one, {0, 1}, opengl_clip_space), std::invalid_argument);
    CHECK_THROWS_AS((void)receiver_matrix(one, one, {1, -1}, opengl_clip_space), std::invalid_argument);
    CHECK_THROWS_AS((void)receiver_matrix(broken, one, {1, 1}, opengl_clip_space), std::invalid_argument);
}
