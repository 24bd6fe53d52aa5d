// SPDX-License-Identifier: MIT
//
// visibility of points in the world from lights of several maps, against the primitives called for each point.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include <umbrage/depth/rg.hpp>
#include <umbrage/images/dual_paraboloid_pass.hpp>
#include <umbrage/images/light_visibility.hpp>
#include <umbrage/images/rasterize.hpp>
#include <umbrage/images/tessellate.hpp>
#include <umbrage/images/tetrahedron_pass.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/point/tetrahedron.hpp>

#include "../fusing.hpp"
#include "last_piece_first.hpp"

using namespace umbrage;

namespace {

constexpr glm::vec3 lamp(0.5f, 2, -0.25f);
constexpr clip_space forward_clip = cpu_clip_space;
constexpr clip_space reversed_clip = [] {
    clip_space clip = forward_clip;
    clip.direction = depth_direction::reversed;
    return clip;
}();

image<glm::vec3> points() {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> anywhere(-6, 6);
    image<glm::vec3> all({97, 31});
    for (glm::vec3& p : all.texels()) p = {anywhere(random), anywhere(random), anywhere(random)};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    all[{3, 1}] = glm::vec3(nan), all[{4, 1}] = lamp, all[{5, 1}].x = nan, all[{6, 1}] = glm::vec3(1e30f);
    return all;
}

template <class Texel, class Encoding>
image<Texel> any_depths(glm::ivec2 size, const Encoding& encoding) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> depth(0, 1);
    image<Texel> map(size);
    for (Texel& t : map.texels()) t = encoding.encode(depth(random));
    return map;
}

/// That whole images have the bits of alone(fetch of a tile, ...), split or not, of floats and of codes.
/// @param tiles   of the light's size
/// @param alone   (world, filter, tile -> fetch) -> visibility
template <class Light, class Alone>
void check(const Light& light, glm::ivec2 size, glm::ivec2 tiles, depth_direction direction, const Alone& alone) {
    const image<glm::vec3> at = points();
    const auto with = [&](const auto& encoding, const auto& filter) {
        auto directed = filter;
        directed.is_lit = {direction};
        using texel = typename std::decay_t<decltype(encoding)>::texel;
        const image<texel> texels = any_depths<texel>(tiles * size, encoding);
        image<float> out(at.size()), split(at.size());
        visibility(light_map{texels, light}, encoding, at, filter, out);
        visibility(light_map{texels, light}, encoding, at, filter, split, last_piece_first{7});
        int differ = 0, dark = 0;
        for (glm::ivec2 p{0}; p.y < at.size().y; ++p.y)
            for (p.x = 0; p.x < at.size().x; ++p.x) {
                const float wanted = alone(at[p], directed, [&](glm::ivec2 tile) {
                    return decoded(umbrage::clamped(texels.view().region(tile, size)), encoding);
                });
                differ += std::bit_cast<std::uint32_t>(wanted) != std::bit_cast<std::uint32_t>(out[p]);
                differ += std::bit_cast<std::uint32_t>(wanted) != std::bit_cast<std::uint32_t>(split[p]);
                dark += out[p] < 1;
            }
        CHECK(differ <= (may_fuse ? 60 : 0));  // fused, coordinates are off by their last bits
        CHECK(dark > 500);
    };
    with(depth32f{.direction = direction}, filters::pcf_2x2{});
    with(rg<11>{.direction = direction}, filters::box{.radius = 2});
    with(depth32f{.direction = direction}, filters::hard{.is_lit = {depth_direction::reversed}});
}

/// A box above a floor, seen by a light: shadow below the box, light beside it.
template <class Encoding, class Light>
void check_shadow(const image<float>& texels, const Light& light, const Encoding& encoding) {
    image<glm::vec3> at({2, 1});
    at[{0, 0}] = lamp + glm::vec3(0, -3.5f, 0), at[{1, 0}] = lamp + glm::vec3(2.5f, -3.5f, 0.5f);
    image<float> out(at.size());
    visibility(light_map{texels, light}, encoding, at, filters::pcf_2x2{}, out);
    CHECK(out[{0, 0}] == 0);
    CHECK(out[{1, 0}] == 1);
}

const std::vector<glm::vec3> scene_points{lamp + glm::vec3(-0.5f, -2, -0.5f), lamp + glm::vec3(0.5f, -2, -0.5f),
                                          lamp + glm::vec3(0.5f, -2, 0.5f),   lamp + glm::vec3(-0.5f, -2, 0.5f),
                                          lamp + glm::vec3(-6, -4, -6),       lamp + glm::vec3(6, -4, -6),
                                          lamp + glm::vec3(6, -4, 6),         lamp + glm::vec3(-6, -4, 6)};
const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};

}  // namespace

TEST_CASE("visibility of a light's maps: cascades") {
    for (const clip_space clip : {forward_clip, reversed_clip}) {
        const glm::ivec2 size = clip == forward_clip ? glm::ivec2(64) : glm::ivec2(96, 64);
        const cascade_fit<float> fit{.camera = {.position = {0, 1, 6}, .direction = {0, 0, -1}},
                                     .direction = {0.3f, -1, -0.2f},
                                     .scene = {glm::vec3(-6), glm::vec3(6)},
                                     .map_size = size,
                                     .clip = clip};
        const auto splits = practical_splits<3>(0.5f, 14.0f, 0.8f);
        const auto u = make_cascade_uniforms(make_stable_cascades<3>(fit, splits), 0.0f);
        check(u, size, {2, 2}, clip.direction, [&](glm::vec3 world, const auto& filter, const auto& tile) {
            const glm::vec3 light(shadow_coordinate(u.rotation, world));
            const glm::vec4 at = cascade_by_projection(light, u.scales, u.offsets, glm::vec2(size), filter.reach());
            const int number = std::min(static_cast<int>(at.w), 3);
            return filter(tile(cascade_tile(number, size)), glm::vec2(at), at.z);
        });
    }
}

TEST_CASE("visibility of a light's maps: more than four cascades") {
    for (const clip_space clip : {forward_clip, reversed_clip}) {
        const glm::ivec2 size(64, 48);
        const cascade_fit<float> fit{.camera = {.position = {0, 1, 6}, .direction = {0, 0, -1}},
                                     .direction = {0.3f, -1, -0.2f},
                                     .scene = {glm::vec3(-6), glm::vec3(6)},
                                     .map_size = size,
                                     .clip = clip};
        const auto u =
            make_cascade_uniforms(make_stable_cascades<7>(fit, practical_splits<7>(0.5f, 14.0f, 0.5f)), 0.0f);
        check(u, size, {2, 4}, clip.direction, [&](glm::vec3 world, const auto& filter, const auto& tile) {
            const glm::vec3 light(shadow_coordinate(u.rotation, world));
            const glm::vec4 at = cascade_by_projection_8(light, u.scales[0], u.offsets[0], u.scales[1], u.offsets[1],
                                                         glm::vec2(size), filter.reach());
            return filter(tile(cascade_tile(std::min(static_cast<int>(at.w), 6), size)), glm::vec2(at), at.z);
        });
    }
}

TEST_CASE("visibility of a light's maps: a cube") {
    for (const clip_space clip : {forward_clip, reversed_clip}) {
        const point_light<float> light{
            .position = lamp, .z_near = 0.1f, .z_far = 20, .map_size = 48, .border = 3, .clip = clip};
        const auto faces = make_point_light(light);
        check(light, glm::ivec2(48), {3, 2}, clip.direction,
              [&](glm::vec3 world, const auto& filter, const auto& tile) {
                  const int face = cube_face(world - lamp);
                  const glm::mat4 to_texels = texture_matrix(faces[static_cast<std::size_t>(face)], glm::ivec2(48));
                  const glm::vec3 at = project_coordinate(shadow_coordinate(to_texels, world));
                  return filter(tile(cube_tile(face, 48)), glm::vec2(at), at.z);
              });
        image<float> texels({144, 96}, cleared_depth(clip));
        for (int i = 0; i < 6; ++i) {
            const auto& face = faces[static_cast<std::size_t>(i)];
            rasterize_depth(texels.view().region(cube_tile(i, 48), glm::ivec2(48)), {scene_points, triangles},
                            face.projection * face.view, clip);
        }
        check_shadow(texels, light, depth32f{.direction = clip.direction});
    }
}

TEST_CASE("visibility of a light's maps: a tetrahedron") {
    const tetrahedron_light<float> light{
        .position = lamp, .z_near = 0.1f, .z_far = 20, .map_size = 128, .border = 3, .clip = forward_clip};
    const auto faces = make_tetrahedron_light(light);
    check(light, glm::ivec2(128), {1, 1}, depth_direction::forward,
          [&](glm::vec3 world, const auto& filter, const auto& tile) {
              const auto face = static_cast<std::size_t>(tetrahedron_face(world - lamp));
              const glm::vec3 at =
                  project_coordinate(shadow_coordinate(texture_matrix(faces[face], glm::ivec2(128)), world));
              return filter(tile(glm::ivec2(0)), glm::vec2(at), at.z);
          });
    image<float> texels({128, 128}, 1.0f);
    rasterize_tetrahedron(texels, {scene_points, triangles}, faces);
    check_shadow(texels, light, depth32f{});
}

TEST_CASE("visibility of a light's maps: two paraboloids") {
    for (const clip_space clip : {forward_clip, reversed_clip}) {
        const dual_paraboloid_light<float> light{
            .position = lamp, .range = 20, .map_size = 96, .border = 3, .clip = clip};
        check(light, glm::ivec2(96), {2, 1}, clip.direction,
              [&](glm::vec3 world, const auto& filter, const auto& tile) {
                  const glm::vec3 at = dual_paraboloid_coordinate(world - lamp);
                  const float depth = distance_depth(world - lamp, 1.0f / 20);
                  return filter(tile({at.z > 0.5f ? 96 : 0, 0}), glm::vec2(at) * 90.0f + 3.0f,
                                clip.direction == depth_direction::forward ? depth : 1.0f - depth);
              });
        const auto space = make_dual_paraboloid_light(light);
        const auto cut = tessellate({scene_points, triangles}, {lamp, paraboloid_edge_angle(96, 3), 20});
        image<float> texels({192, 96}, cleared_depth(clip));
        for (const int map : {0, 1})
            rasterize_dual_paraboloid(texels.view().region({map * 96, 0}, glm::ivec2(96)), cut.view(), space, map);
        check_shadow(texels, light, depth32f{.direction = clip.direction});
    }
}

TEST_CASE("visibility of a light's maps: bad input") {
    const point_light<float> light{.position = lamp, .map_size = 16, .clip = forward_clip};
    const auto complaint = [&](glm::ivec2 texels, glm::ivec2 out_size, const point_light<float>& of) -> std::string {
        const image<float> map(texels);
        const image<glm::vec3> at({4, 4});
        image<float> out(out_size);
        try {
            visibility(light_map{map, of}, depth32f{}, at, filters::hard{}, out);
        } catch (const std::invalid_argument& error) { return error.what(); }
        return "";
    };
    CHECK(complaint({48, 32}, {4, 4}, light).empty());
    CHECK(complaint({48, 48}, {4, 4}, light).starts_with("umbrage::visibility: map.texels.size "));
    CHECK(complaint({48, 32}, {4, 5}, light).starts_with("umbrage::visibility: out.size "));
    CHECK(complaint({48, 32}, {4, 4}, {.position = lamp, .map_size = 16, .border = 8, .clip = forward_clip})
              .starts_with("umbrage::make_point_light: "));
}
