// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/shadow/anchored_map.hpp>

#include "scene.hpp"
#include "../rounds.hpp"

using namespace umbrage;
using glm::dmat4, glm::dvec2, glm::dvec3, glm::dvec4, glm::vec3;

namespace {

constexpr double one_rounding = 0x1p-24;
constexpr int map_side = 512;

class chance {
public:
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(bits_); }
    dvec3 way() {
        const double z = between(-1, 1), t = between(0, 6.283185307), r = std::sqrt(1 - z * z);
        return {r * std::cos(t), r * std::sin(t), z};
    }
    /// Any direction at a right angle to another.
    dvec3 beside(dvec3 to) { return glm::normalize(glm::cross(to, way())); }

private:
    std::mt19937 bits_{11};
};

/// What was seen of lone tiles: receivers on them, those that their own tile darkens, and the need for a bias that
/// remains after that of the slope, over the bound of rounding in the place's slack. On a GPU vertices are rounded too.
struct seen_tiles {
    int receivers = 0, dark = 0, beyond_bound = 0;
    double need = 0, bound = 0;  ///< the largest of tiles that face the light, in 2^-24; over depth if reversed
};

/// A square tile, and receivers on it.
template <class Shadow>
void try_tile(const Shadow& s, dvec3 at, dvec3 normal, double half, bool faces, chance& any, seen_tiles& out) {
    using Setup = std::remove_cvref_t<decltype(s.setup())>;
    const dvec3 side = any.beside(normal), up = glm::cross(normal, side);
    const auto point = [&](double x, double y) { return vec3(at + (side * x + up * y) * half); };
    const std::vector<vec3> corners{point(-1, -1), point(1, -1), point(1, 1), point(-1, 1)};
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};
    const clip_space clip = s.setup().clip();
    image<float> map(s.size(), cleared_depth(clip));
    s.draw(map, {corners, triangles});
    const auto uniforms = s.uniforms();
    const auto lights = s.setup().lights();
    const auto views = s.depth_views();
    const double sign = clip.direction == depth_direction::forward ? 1 : -1;
    for (int i = 0; i < 30; ++i) {
        const double x = any.between(-0.9, 0.9), y = any.between(-0.9, 0.9);
        const vec3 world = point(x, y);
        const map_place place = Setup::places(uniforms.maps, uniforms.terms, world, vec3(normal))[0];
        const auto number = static_cast<std::size_t>(place.number);
        const glm::ivec2 texel(glm::floor(glm::vec2(place.at))), size = s.map_size();
        if (number >= lights.size() || !(place.at.z > 0 && place.at.z < 1)) continue;
        if (glm::any(glm::lessThan(texel, glm::ivec2(1))) || glm::any(glm::greaterThan(texel, size - 2))) continue;
        const float stored = map[detail::first_texel(place.number, Setup::grid, size) + texel];
        if (stored == cleared_depth(clip)) continue;
        ++out.receivers;
        out.dark += s(map, world, vec3(normal)) < 1;
        if (std::is_same_v<Setup, tetrahedron_map> || std::is_same_v<Setup, adaptive_maps>) continue;
        dmat4 here = texture_matrix(lights[number], size);
        here[3] = here * dvec4(at, 1);
        const dvec2 slope = plane_slope(plane_matrix(here), normal, dvec3(world) - at);
        const double steep = std::abs(slope.x) + std::abs(slope.y);
        if (steep > 1.9) continue;
        const dvec2 units = detail::units_at(here, dvec3(world) - at);
        const double width = detail::is_lens(here) ? units.x * units.y : detail::width_in_depth(here, size);
        const double rounding = place.slack - width - detail::texels_beside_plane(clip, size) * steep;
        dvec3 corner[3];  // of the texel's triangle, as a GPU has them: texels and depth
        for (int k = 0; k < 3; ++k) {
            const depth_view& view = views[number];
            const dvec4 h(
                anchored_vertex(view.to_clip, corners[std::size_t(x > y || k == 0 ? k : k + 1)], view.anchor));
            corner[k] = {(h.x / h.w * 0.5 + 0.5) * size.x, (h.y / h.w * 0.5 + 0.5) * size.y, h.z / h.w};
            if (clip.origin == texture_origin::top) corner[k].y = size.y - corner[k].y;
            if (clip.range == depth_range::minus_one_to_one) corner[k].z = corner[k].z * 0.5 + 0.5;
        }
        const dvec3 q = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
        const dvec2 center = dvec2(texel) + 0.5, to_center = center - dvec2(corner[0]);
        const auto on_gpu = static_cast<float>(corner[0].z - (q.x * to_center.x + q.y * to_center.y) / q.z);
        for (const bool gpu : {false, true}) {
            const double reach = gpu ? 0x1p-21 * map_side : uniforms.terms.reach - 0.5;  // a GPU here does not snap
            const double apart = place.at.z - (gpu ? on_gpu : stored) - glm::dot(slope, dvec2(place.at) - center);
            const double need = sign * apart - reach * steep, scale = sign > 0 ? 1.0 : place.at.z;
            out.beyond_bound += need > rounding;
            if (faces) out.need = glm::max(out.need, need / scale / one_rounding);
            if (faces) out.bound = glm::max(out.bound, rounding / scale / one_rounding);
        }
    }
}

/// Tiles of a scene of 6 units, `away` from the origin; half of them face the light.
/// @param kind   spot, cube, tetrahedron, directional, cascades, warped cascades
seen_tiles try_tiles(const std::string& kind, clip_space clip, double z_near, double away, int tiles) {
    seen_tiles out;
    chance any;
    for (int i = 0; i < tiles; ++i) {
        const bool faces = i % 2 == 0, forward = clip.direction == depth_direction::forward;
        const dvec3 center = any.way() * away, axis = any.way(), lamp = vec3(center + any.way());
        const double far = forward ? 30 : INFINITY, t = any.between(0.5, 6), tilt = any.between(0, 1.3);
        const auto with = [&](const auto& light, dvec3 at, dvec3 normal, double half) {
            const dvec3 turned = normal * std::cos(tilt) + any.beside(normal) * std::sin(tilt);
            try_tile(shadow(light, glm::ivec2(map_side), filters::hard{}), at, faces ? normal : turned, half, faces,
                     any, out);
        };
        dvec3 face(0);
        face[int(any.between(0, 3))] = any.between(-1, 1) < 0 ? -1 : 1;
        const dvec3 before_face = lamp + face * t + glm::cross(face, any.way()) * 0.5 * t;
        cascade_fit<double> fit{
            {center, any.way()}, axis, {0, 1, 0}, {center - 12.0, center + 12.0}, glm::ivec2(map_side)};
        fit.clip = clip;
        if (kind == "spot")
            with(make_spot_light<double>({lamp, axis, {0, 1, 0}, 0.6, 1, z_near, far, clip}),
                 lamp + axis * t + any.beside(axis) * t * any.between(0, 0.4), -axis, 0.25 * t);
        else if (kind == "cube")
            with(point_light<double>{lamp, z_near, far, map_side, 3, clip}, before_face, -face, t / 4);
        else if (kind == "tetrahedron")
            with(tetrahedron_light<double>{lamp, z_near, far, map_side, 3, clip}, before_face, -face, t / 4);
        else if (kind == "directional")
            with(fit_directional_light<double>(
                     {.direction = axis, .receivers = bounding_box<double>{center - 3.0, center + 3.0}, .clip = clip}),
                 center + any.way() * 1.5, -axis, 1.5);
        else if (kind == "cascades")
            with(make_stable_cascades<4>(fit, {0.1, 1.0, 3.0, 6.0, 12.0}), center + any.way() * t, -axis, 2);
        else
            with(
                warped_maps(make_warped_cascades<3>(fit, {0.1, 1.0, 4.0, 12.0},
                                                    [](const auto& part) { return fit_light_space_perspective(part); }),
                            fit.camera),
                center + fit.camera.direction * t + any.way() * 0.3, -axis, 1);
    }
    return out;
}

constexpr const char* kinds[]{"spot", "cube", "tetrahedron", "directional", "cascades", "warped cascades"};

}  // namespace

TEST_CASE("anchored_map: no tile darkens itself, at any distance from the origin") {
    clip_space reversed = direct3d_clip_space;
    reversed.direction = depth_direction::reversed;
    for (const char* kind : kinds)
        for (const clip_space& clip : {cpu_clip_space, opengl_clip_space, reversed})
            for (const double away : {0.0, 20.0, 200.0, 2e3, 6e3}) {
                CAPTURE(kind);
                CAPTURE(away);
                const seen_tiles seen = try_tiles(kind, clip, 0.05, away, rounds(64));
                CHECK(seen.dark == 0);
                CHECK(seen.beyond_bound == 0);
                CHECK(seen.receivers > rounds(64) * 25);
            }
}

TEST_CASE("anchored_map: near the origin rounding is a few units of the last place, and reversed depth's is its own") {
    const int tiles = rounds(160);
    // at 16 near planes and more: the bound grows towards the near plane
    for (const char* kind : {"spot", "cube"}) CHECK(try_tiles(kind, cpu_clip_space, 0.03, 0, tiles).bound < 10);
    for (const char* kind : {"directional", "cascades"})
        CHECK(try_tiles(kind, cpu_clip_space, 0.05, 0, tiles).bound < 14.5);
    clip_space reversed = cpu_clip_space;
    reversed.direction = depth_direction::reversed;
    for (const double z_near : {0.1, 1e-3, 1e-4})
        for (const char* kind : {"spot", "cube"}) CHECK(try_tiles(kind, reversed, z_near, 0, tiles).bound < 30);
}

TEST_CASE("anchored_map: warped maps need few digits near the camera, and their bound does not take the whole box") {
    const seen_tiles seen = try_tiles("warped cascades", cpu_clip_space, 0.05, 0, rounds(160));
    CHECK(seen.need < 6);
    CHECK(seen.bound < 200);
}

TEST_CASE("anchored_map: a warp that hardly bends has nearly the bound of parallel rays") {
    const light_space<double> sun = detail::in_double(shadow_scene::fitted(cpu_clip_space));
    const vec3 world(0.5f, 0.25f, -0.5f), normal(1, 3, 2);
    const auto rounding = [&](double bend) {
        light_space<double> bent = sun;
        bent.projection[0][3] = bend;  // w along the map's x
        const anchored_map map = make_anchored_map(bent, {256, 256});
        const vec3 way = world - vec3(map.anchor);
        const auto place = anchored_place(map.to_texels, map.planes, map.rounding, map.slack, way, normal);
        const glm::dmat4 m = texture_matrix(bent, {256, 256});
        const float steep = glm::abs(place.slope.x) + glm::abs(place.slope.y);
        return place.slack - detail::width_in_depth(m, {256, 256}) -
               detail::texels_beside_plane(bent.clip, {256, 256}) * steep;
    };
    for (const double bend : {1e-18, 1e-12, 1e-6, 1e-3}) {
        CAPTURE(bend);
        CHECK(rounding(bend) >= 0.5f * rounding(0));
        CHECK(rounding(bend) <= 4 * rounding(0));
    }
}

TEST_CASE("anchored_map: where no digits are left, the light is refused by name") {
    const auto spot_at = [](float away) {
        return shadow(
            make_spot_light<float>({.position = {away, 0, 0}, .z_near = 0.1f, .z_far = 10, .clip = cpu_clip_space}),
            {64, 64}, filters::hard{});
    };
    CHECK_NOTHROW(static_cast<void>(spot_at(1e4f)));
    CHECK_THROWS_WITH_AS(
        static_cast<void>(spot_at(1e5f)),
        "umbrage::shadow: light must be within 2048 times its extent of the positions' origin; got 7746.02. "
        "Pass an origin near it.",
        std::invalid_argument);
    CHECK_THROWS_AS(static_cast<void>(shadow(point_light<float>{{1e6f, 0, 0}, 0.1f, 10, 64, 2, cpu_clip_space},
                                             {64, 64}, filters::hard{})),
                    std::invalid_argument);
}

TEST_CASE("anchored_map: with an origin nearby nothing is lost at 650 km") {
    const dvec3 there(4e5, 1e5, 5e5);
    const std::vector<vec3> positions{{-3, 0, -3},        {3, 0, -3},           {3, 0, 3},
                                      {-3, 0, 3},         {-0.5f, 0.1f, -0.5f}, {0.5f, 0.1f, -0.5f},
                                      {0.5f, 0.1f, 0.5f}, {-0.5f, 0.1f, 0.5f}};
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
    const auto check = [&](const auto& light) {
        const shadow lamp(light, glm::ivec2(map_side), filters::hard{}, depth32f{}, there);
        image<float> map(lamp.size(), lamp.cleared());
        lamp.draw(map, {positions, triangles});
        CHECK(lamp(map, {0, 0, 0}, {0, 1, 0}) == 0.0f);
        int dark = 0;
        for (float x = -2.5f; x < 2.5f; x += 0.0313f)
            if (glm::abs(x) > 0.7f) dark += lamp(map, {x, 0, 0.4f}, {0, 1, 0}) < 1;
        CHECK(dark == 0);
        CHECK_THROWS_AS(static_cast<void>(lamp.relative_to(dvec3(0))), std::invalid_argument);
    };
    check(make_spot_light<double>({.position = there + dvec3(0.5, 4, 0.25),
                                   .direction = {0, -1, 0},
                                   .up = {0, 0, 1},
                                   .outer_angle_radians = 0.9,
                                   .z_near = 0.5,
                                   .z_far = 20,
                                   .clip = cpu_clip_space}));
    check(point_light<double>{there + dvec3(0.5, 4, 0.25), 0.5, 20, map_side, 3, cpu_clip_space});
    check(tetrahedron_light<double>{there + dvec3(0.5, 4, 0.25), 0.5, 20, map_side, 3, cpu_clip_space});
    check(fit_directional_light<double>({.direction = {0.1, -1, 0.1},
                                         .receivers = bounding_box<double>{there - 3.0, there + 3.0},
                                         .clip = cpu_clip_space}));
}

TEST_CASE("anchored_map: a card casts under reversed depth, far from a light with a tiny near plane") {
    clip_space clip = cpu_clip_space;
    clip.direction = depth_direction::reversed;
    const std::vector<vec3> positions{{-40, -60, -40},  {40, -60, -40},  {40, -60, 40},  {-40, -60, 40},
                                      {-5, -59.8f, -5}, {5, -59.8f, -5}, {5, -59.8f, 5}, {-5, -59.8f, 5}};
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
    for (const float z_near : {0.1f, 0.1f, 0.001f}) {
        const shadow lamp(make_spot_light<float>({.direction = {0, -1, 0},
                                                  .up = {0, 0, 1},
                                                  .outer_angle_radians = 0.5f,
                                                  .z_near = z_near,
                                                  .z_far = INFINITY,
                                                  .clip = clip}),
                          {1024, 1024}, filters::hard{});
        image<float> map(lamp.size(), cleared_depth(clip));
        lamp.draw(map, {positions, triangles});
        CHECK(lamp(map, {0, -60, 0}, {0, 1, 0}) == 0.0f);
        CHECK(lamp(map, {10, -60, 0}, {0, 1, 0}) == 1.0f);
    }
}

TEST_CASE("anchored_map: a spot's middle and its rays' meeting point are found from its matrix") {
    for (const clip_space clip : {opengl_clip_space, direct3d_clip_space, unity_clip_space, cpu_clip_space}) {
        const single_map spot(shadow_scene::spot(clip)), sun(shadow_scene::fitted(clip));
        const auto lens = make_anchored_map(spot.light, {64, 32}, {100, 200, 300});
        CHECK(glm::length(vec3(lens.anchor) - vec3(-99.5f, -192, -299.75f)) < 1e-4f);
        CHECK(glm::vec3(lens.to_texels[0].z, lens.to_texels[1].z, lens.to_texels[2].z) == vec3(0));
        const auto parallel = make_anchored_map(sun.light, {64, 32});
        CHECK(parallel.to_texels[3].z == 0.0f);
        CHECK(glm::abs(parallel.slack.w - 0.5f) < 1e-5f);
    }
}
