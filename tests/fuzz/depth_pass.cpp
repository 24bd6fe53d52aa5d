// SPDX-License-Identifier: MIT
//
// The depth pass: no order of triangles, pieces of work or threads change a bit, and depths lie between near and far.
#include <algorithm>
#include <vector>

#include <glm/mat4x4.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/light/spot_light.hpp>

#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace umbrage;
    fuzz::input in(bytes, size);
    const clip_space clip = in.clip();
    const auto light = make_spot_light<float>(
        {.position = {0, 0, 10}, .direction = {0, 0, -1}, .z_near = 1, .z_far = 30, .clip = clip});
    glm::mat4 to_clip = light.projection * light.view;
    if (in.chance(4))
        for (glm::length_t i = 0; i < 16; ++i) to_clip[i / 4][i % 4] = in.number(-4, 4);
    std::vector<glm::vec3> positions(static_cast<std::size_t>(in.within(0, 24)));
    for (glm::vec3& p : positions) p = in.vec3(-8, 8);
    std::vector<glm::uvec3> triangles(static_cast<std::size_t>(in.within(0, 16)));
    const int most = static_cast<int>(positions.size()) - (in.chance(16) ? 0 : 1);
    for (glm::uvec3& t : triangles)
        for (glm::length_t i = 0; i < 3; ++i) t[i] = static_cast<unsigned>(in.within(0, std::max(most, 0)));
    const glm::ivec2 map_size(in.within(0, 70), in.within(0, 70));
    const auto cull = static_cast<cull_mode>(in.within(0, 2));
    const auto at_near = in.chance(2) ? near_plane::clips : near_plane::clamps;
    const float cleared = cleared_depth(clip.direction);

    image<float> once(map_size, cleared), turned(map_size, cleared), in_two(map_size, cleared);
    fuzz::answered([&] {
        rasterize_depth(once, {positions, triangles}, to_clip, clip, cull, serial{}, at_near);
        for (const float depth : once.texels())
            fuzz::must(depth >= 0.0f && depth <= 1.0f, "a depth lies within 0 and 1");

        std::vector<glm::uvec3> other(triangles.rbegin(), triangles.rend());
        rasterize_depth(turned, {positions, other}, to_clip, clip, cull, fuzz::pieces(in), at_near);
        fuzz::must(std::ranges::equal(once.texels(), turned.texels()), "neither order nor pieces change a depth");

        const auto half = static_cast<std::ptrdiff_t>(triangles.size() / 2);
        const std::vector<glm::uvec3> first(triangles.begin(), triangles.begin() + half),
            rest(triangles.begin() + half, triangles.end());
        rasterize_depth(in_two, {positions, first}, to_clip, clip, cull, serial{}, at_near);
        rasterize_depth(in_two, {positions, rest}, to_clip, clip, cull, serial{}, at_near);
        fuzz::must(std::ranges::equal(once.texels(), in_two.texels()), "two passes are one");
    });
    return 0;
}
