// SPDX-License-Identifier: MIT
//
// Light that filtered maps leave in a shadow: a plate half a unit above a floor, under a spot light 10 units above it,
// whose planes are far from the scene or near it. The page of filter/prefiltered has these figures.
#include <doctest/doctest.h>

#include <cmath>
#include <type_traits>
#include <vector>

#include <umbrage/umbrage.hpp>

using namespace umbrage;

namespace {

/// Visibility on the floor, below the middle of the plate, in percent.
template <class Prefilter>
float light_below(float z_near, float z_far) {
    const auto light = make_spot_light<double>({.position = {0, 10, 0},
                                                .direction = {0, -1, 0},
                                                .up = {0, 0, -1},
                                                .z_near = z_near,
                                                .z_far = z_far,
                                                .clip = cpu_clip_space});
    const std::vector<glm::vec3> positions{{-4, 0, -4},    {4, 0, -4},    {4, 0, 4},    {-4, 0, 4},
                                           {-1, 0.5f, -1}, {1, 0.5f, -1}, {1, 0.5f, 1}, {-1, 0.5f, 1}};
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
    const shadow spot(light, {512, 512}, Prefilter{});
    image<float> depths(spot.size(), cleared_depth(light.clip.direction));
    spot.draw(depths, {positions, triangles});
    using texel = std::decay_t<decltype(spot.cleared())>;
    image<texel> moments(spot.size()), blurred(spot.size());
    spot.store(depths, moments);
    blur(moments, blurred, make_gaussian_kernel(7, 1.5f));
    return 100 * spot(blurred, {0, 0, 0}, {0, 1, 0});
}

/// Checks what that page says of one of them, in whole percent.
template <class Prefilter>
void check_page(float by_far_planes, float by_near_planes) {
    CAPTURE(Prefilter{}.name);
    CHECK(std::round(light_below<Prefilter>(0.1f, 100)) == by_far_planes);
    CHECK(std::round(light_below<Prefilter>(3, 11)) == by_near_planes);
}

}  // namespace

TEST_CASE("prefiltered maps: light in a shadow, by planes far from the scene and near it") {
    check_page<prefilters::vsm>(80, 0);
    check_page<prefilters::msm>(27, 0);
    check_page<prefilters::evsm4>(4, 0);
    check_page<prefilters::esm>(97, 32);
}
