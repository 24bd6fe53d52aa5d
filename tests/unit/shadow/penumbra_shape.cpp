// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/plane_optimal.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>
#include <umbrage/shader/glsl.hpp>
#include <umbrage/shadow/in_shader.hpp>
#include <umbrage/shadow/penumbra_shape.hpp>
#include <umbrage/shadow/shadow.hpp>
#include <umbrage/shadow/tetrahedron_map.hpp>
#include <umbrage/shadow/warped_maps.hpp>

#include "roofed.hpp"
#include "texts.hpp"

using namespace umbrage;
using shadow_roof::roofed;
using shadow_roof::width_along;
using shadow_texts::has;

namespace {

const bounding_box<double> valley{{-20, 0, -30}, {20, 4, 20}};

const glm::dvec4 floor_plane(0, 1, 0, 0);

warp_fit<double> seen(glm::dvec3 direction) {
    const frustum<double> camera{.position = {1, 3, 18},
                                 .direction = {0.1, -0.2, -1},
                                 .tan_half_x = 0.8,
                                 .tan_half_y = 0.5,
                                 .z_near = 0.5,
                                 .z_far = 40};
    return {.camera = camera,
            .direction = direction,
            .receivers = intersection(camera, valley),
            .casters = valley,
            .clip = cpu_clip_space};
}

/// The light with y of its map added to x.
light_space<double> sheared(light_space<double> light, double share) {
    for (glm::length_t i = 0; i < 4; ++i) light.projection[i].x += share * light.projection[i].y;
    return light;
}

std::vector<light_space<double>> warped_lights() {
    std::vector<light_space<double>> all;
    for (const glm::dvec3 direction : {glm::dvec3(0, -1, 0), glm::dvec3(0.3, -1, 0.2), glm::dvec3(-0.8, -1, 0.5)}) {
        all.push_back(fit_light_space_perspective(seen(direction)).light);
        all.push_back(fit_trapezoidal(seen(direction), 12.0).light);
        all.push_back(fit_perspective(seen(direction)).light);
        all.push_back(fit_plane_optimal(seen(direction), floor_plane).value().light);
    }
    return all;
}

/// Texels per unit of depth across the light, times themselves: what an ellipse of any basis has in common.
glm::dmat2 squared(const glm::dmat2& j) { return j * glm::transpose(j); }

/// The same of a map at a point, by differences.
glm::dmat2 by_differences(const glm::dmat4& m, glm::dvec3 at) {
    const glm::dvec3 way = detail::unit(detail::direction_of(m));
    const auto placed = [&](glm::dvec3 p) {
        const glm::dvec4 h = m * glm::dvec4(p, 1);
        return glm::dvec3(h) / h.w;
    };
    constexpr double step = 1e-5;
    const double depth = std::abs(placed(at + way * step).z - placed(at - way * step).z);
    glm::dmat2 j;
    for (int i = 0; i < 2; ++i) {
        const glm::dvec3 side = detail::across(way)[std::size_t(i)] * step;
        j[i] = glm::dvec2(placed(at + side) - placed(at - side)) / depth;
    }
    return squared(j);
}

}  // namespace

TEST_CASE("warp_shape: texels per unit of depth everywhere in a warped map, by differences") {
    const glm::ivec2 size(1024, 768);
    for (const light_space<double>& light : warped_lights()) {
        const glm::dmat4 m = texture_matrix(light, size), back = glm::inverse(m);
        glm::mat4 warps(0);
        warps[2] = detail::warp_of(m, size);
        const glm::dvec3 first = detail::measured_at(m, glm::ivec2(0));
        const glm::dvec2 dense = 1.0 / detail::edges_at(m, first) / detail::units_at(m, first).y;
        for (const double x : {0.1, 0.5, 0.85})
            for (const double y : {0.05, 0.4, 0.95}) {
                const glm::dvec2 at(x * size.x, y * size.y);
                const glm::dvec4 h = back * glm::dvec4(at, 0.5, 1);
                const glm::dmat2 exact = by_differences(m, glm::dvec3(h) / h.w);
                const glm::dvec3 shape(warp_shape(warps, 2.0f, glm::vec2(at)));
                const glm::dvec2 own = dense * glm::dvec2(shape);
                const glm::dmat2 ours = squared({own.x, 0, own.x * shape.z, own.y});
                const double scale = std::sqrt(exact[0][0] * exact[1][1]);
                constexpr double off = 1e-3;
                CHECK(ours[0][0] == doctest::Approx(exact[0][0]).epsilon(off));
                CHECK(ours[1][1] == doctest::Approx(exact[1][1]).epsilon(off));
                CHECK(std::abs(ours[0][1] - exact[0][1]) < off * scale);
            }
    }
}

TEST_CASE("warp_shape: one shape where there is no warp, and a shear of 8 at most") {
    const auto sun = make_directional_light<double>({.direction = {1, -2, 0.5},
                                                     .offset = 20,
                                                     .map_size = {512, 256},
                                                     .texels_per_unit = 8,
                                                     .z_near = 0,
                                                     .z_far = 40,
                                                     .clip = vulkan_clip_space});
    const auto spot = make_spot_light<double>(
        {.position = {2, 6, 3}, .direction = {-2, -6, -3}, .z_near = 0.5, .z_far = 40, .clip = cpu_clip_space});
    for (const auto& light : {sun, spot})
        CHECK(detail::warp_of(texture_matrix(light, {512, 256}), {512, 256}) == glm::vec4(0, 0, 0, 1));
    const glm::mat4 columns(0, 0, 9, 1, 0, 2, 0, 1, 0, 0, 0, 1, 0, 0, -1, 1);
    CHECK(warp_shape(columns, 0.0f, glm::vec2(5)) == glm::vec3(1, 1, 8));
    CHECK(warp_shape(columns, 1.0f, glm::vec2(5, 0)) == glm::vec3(1, 1, -8));
    CHECK(warp_shape(columns, 2.0f, glm::vec2(5)) == glm::vec3(1, 1, 0));
    CHECK(warp_shape(columns, 3.0f, glm::vec2(5)) == glm::vec3(1, 1, -1));
    CHECK_FALSE(single_map(sun).is_warped());
    CHECK_FALSE(single_map(spot).is_warped());
    for (const light_space<double>& light : warped_lights()) CHECK(single_map(light).is_warped());
    for (const auto& light : {sun, spot}) {
        CHECK(single_map(sheared(light, 0.01)).is_warped());
        CHECK_FALSE(single_map(sheared(light, 1e-6)).is_warped());
    }
}

TEST_CASE("shaped_softness: factors, and a radius whose ellipse keeps the filter's reach") {
    const glm::vec4 soft(0.5f, 0.25f, 16, 96);
    CHECK(shaped_softness(soft, glm::vec3(1, 1, 0)) == soft);
    CHECK(shaped_softness(soft, glm::vec3(2, 3, 0.75f)) == glm::vec4(1, 0.75f, 16, 76.8f));
    for (const float shear : {-2.0f, -0.3f, 1.7f}) {
        const float most = shaped_softness(soft, glm::vec3(1, 1, shear)).w;
        CHECK(most * std::sqrt(1 + shear * shear) == doctest::Approx(96));
    }
}

TEST_CASE("penumbra_shape: a sun's penumbras have one width everywhere in a warped map") {
    const float tangent = 0.1f, exact = 1.374f * 2 * tangent;
    const auto fit = seen({0, -1, 0});
    const auto plain = fit_directional_light<double>(
        {.direction = fit.direction, .receivers = valley, .casters = valley, .clip = fit.clip});
    // with the number of places whose texels are fine enough
    const std::pair<light_space<double>, int> lights[]{{fit_light_space_perspective(fit).light, 10},
                                                       {fit_trapezoidal(fit, 12.0).light, 18},
                                                       {fit_perspective(fit).light, 6},
                                                       {fit_plane_optimal(fit, floor_plane).value().light, 12},
                                                       {sheared(plain, 0.7), 24}};
    for (const auto& [light, places] : lights) {
        const shadow sun(light, {1024, 1024},
                         filters::pcss{.points = 32, .softness = make_penumbra_params(tangent, 0.0f, 80.0f)});
        int tried = 0;
        for (const float z : {10.0f, 4.0f, -3.0f, -12.0f})
            for (const float x : {0.0f, -3.0f, 5.0f})
                for (const bool along_x : {true, false}) {
                    const glm::vec3 at(x, 0, z), up(0, 1, 0);
                    const glm::vec2 limits = sun.penumbra_widths(at, up);
                    if (!(limits.x < exact && exact < limits.y)) continue;
                    // x and y of the roof are x and -z of the world
                    const glm::dmat4 to_world{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {x, 0, z, 1}};
                    const roofed scene(to_world, 0, 2, along_x);
                    image<float> map(sun.size(), sun.cleared());
                    sun.draw(map, {scene.positions, scene.triangles});
                    CAPTURE(x);
                    CAPTURE(z);
                    CAPTURE(along_x);
                    const glm::vec3 way = along_x ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, -1);
                    CHECK(width_along(sun, map, at, way, up, exact) == doctest::Approx(exact).epsilon(0.1));
                    ++tried;
                }
        CHECK(tried == places);
    }
}

TEST_CASE("penumbra_shape: a lamp's penumbras have the width of a disc across its axis in a warped map") {
    const glm::dvec3 lamp(3, 14, -2), up(0, 1, 0);
    const double radius = 2, roof = 2;
    const auto fit = seen({0.3, -1, -0.2});
    const light_position<double> from{.position = lamp, .z_near = 0.5};
    const auto cone = make_spot_light<double>({.position = lamp,
                                               .direction = fit.direction,
                                               .outer_angle_radians = 1.2,
                                               .z_near = 0.5,
                                               .z_far = 60,
                                               .clip = fit.clip});
    for (const light_space<double>& light :
         {fit_perspective(fit, from).light, fit_plane_optimal(fit, floor_plane, from).value().light,
          sheared(cone, 0.7)}) {
        const shadow bulb(light, {2048, 2048},
                          filters::pcss{.points = 32, .softness = make_penumbra_params(float(radius), 0.0f, 80.0f)});
        const glm::dvec3 axis = detail::unit(detail::direction_of(texture_matrix(light, bulb.size())));
        int tried = 0;
        for (const double z : {7.0, 2.0, -6.0})
            for (const double x : {0.0, 4.0})
                for (const bool along_x : {true, false}) {
                    const glm::dvec3 edge(x, roof, z), way = along_x ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, -1);
                    const double scale = roof / (lamp.y - roof);
                    const glm::dvec3 at = edge + (edge - lamp) * scale;  // where the edge's shadow falls
                    // by how much that moves with the lamp
                    const glm::dvec3 moves = -scale * way - glm::dot(edge - lamp, way) * scale / (lamp.y - roof) * up;
                    const double exact = 1.374 * radius * glm::length(moves - axis * glm::dot(moves, axis));
                    const glm::dvec2 limits(bulb.penumbra_widths(glm::vec3(at), glm::vec3(up)));
                    if (!(limits.x < exact && exact < limits.y)) continue;
                    const roofed scene({{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {x, 0, z, 1}}, 0, roof, along_x);
                    image<float> map(bulb.size(), bulb.cleared());
                    bulb.draw(map, {scene.positions, scene.triangles});
                    CAPTURE(x);
                    CAPTURE(z);
                    CAPTURE(along_x);
                    CHECK(width_along(bulb, map, glm::vec3(at), glm::vec3(way), glm::vec3(up), float(exact)) ==
                          doctest::Approx(exact).epsilon(0.1));
                    ++tried;
                }
        CHECK(tried == 12);
    }
}

TEST_CASE("penumbra_shape: a lamp's penumbras have one width along both axes of each face of a tetrahedron") {
    const float radius = 0.3f, exact = 1.374f * radius * 1 / 3;  // 1 unit behind a roof 3 units away
    const tetrahedron_light<float> lamp{
        .position = {1, 2, -1}, .z_near = 0.1f, .z_far = 20, .map_size = 1024, .border = 64, .clip = cpu_clip_space};
    const shadow bulb(lamp, {1024, 1024},
                      filters::pcss{.points = 32, .softness = make_penumbra_params(radius, 0.0f, 30.0f)});
    for (const light_space<double>& face : bulb.setup().lights())
        for (const bool along_x : {true, false}) {
            const glm::dmat4 to_world = glm::inverse(face.view);
            const double ahead = cpu_clip_space.hand == handedness::right ? -1 : 1;
            const roofed scene(to_world, float(4 * ahead), float(3 * ahead), along_x);
            image<float> map(bulb.size(), bulb.cleared());
            bulb.draw(map, {scene.positions, scene.triangles});
            const glm::vec3 at(to_world * glm::dvec4(0, 0, 4 * ahead, 1)),
                normal(to_world * glm::dvec4(0, 0, -ahead, 0)),
                way(to_world * (along_x ? glm::dvec4(1, 0, 0, 0) : glm::dvec4(0, 1, 0, 0)));
            CAPTURE(along_x);
            CHECK(width_along(bulb, map, at, way, normal, exact) == doctest::Approx(exact).epsilon(0.1));
        }
}

// of DPCF: proof/every_shadow has PCSS under every setup
TEST_CASE("penumbra_shape: images have the bits of single receivers") {
    const auto check = [](const auto& s, const roofed& scene, glm::vec3 middle, glm::vec3 normal) {
        image<float> map(s.size(), s.cleared());
        s.draw(map, {scene.positions, scene.triangles});
        image<glm::vec3> points({70, 21}), normals({70, 21}, normal);
        for (glm::ivec2 p(0); p.y < 21; ++p.y)
            for (p.x = 0; p.x < 70; ++p.x)
                points[p] = middle + glm::vec3(0.05f * float(p.x - 35), 0, 0.05f * float(p.y - 10));
        image<float> out(points.size());
        s.visibility(map, points, normals, out);
        int wrong = 0, soft = 0;
        for (glm::ivec2 p(0); p.y < 21; ++p.y)
            for (p.x = 0; p.x < 70; ++p.x) {
                wrong += out[p] != s(map, points[p], normal, p);
                soft += out[p] > 0 && out[p] < 1;
            }
        CHECK(wrong == 0);
        CHECK(soft > 50);
    };
    const filters::dpcf filter{.softness = make_penumbra_params(0.2f, 1.0f, 12.0f)};
    const glm::dmat4 to_world{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {3, 0, 2, 1}};
    const roofed scene(to_world, 0, 2, true);
    const auto fit = seen({0.2, -1, 0.3});
    check(shadow(fit_light_space_perspective(fit).light, {256, 256}, filter), scene, {3.2f, 0, 2}, {0, 1, 0});
    const tetrahedron_light<float> lamp{
        .position = {3.4f, 5, 2}, .z_near = 0.1f, .z_far = 20, .map_size = 512, .border = 16, .clip = cpu_clip_space};
    check(shadow(lamp, {512, 512}, filter), scene, {3, 0, 2}, {0, 1, 0});
}

TEST_CASE("penumbra_shape: a text has it where it changes within a map") {
    using namespace umbrage::glsl;
    const filters::pcss filter{.softness = make_penumbra_params(0.2f)};
    const auto text = [&](const auto& light, int size, const auto& f) {
        return glsl::text({bind(shadow(light, glm::ivec2(size), f), "s")}, version::v330);
    };
    const auto warped = text(warped_lights()[0], 256, filter);
    CHECK(has(warped, "vec3 shape = umbrage_warp_shape(warps, number, vec2(at.x, at.y));"));
    CHECK(has(warped, "umbrage_sheared_rotation(umbrage_disc_rotation(pixel), shear)"));
    CHECK(has(warped, "mat4 umbrage_s_warps;"));
    const auto spot = text(make_spot_light<float>({.direction = {0, -1, 0}, .clip = opengl_clip_space}), 256, filter);
    CHECK(has(spot, "mat4 umbrage_s_warps;"));  // the block is that of all lights with one map
    CHECK_FALSE(has(spot, "shape"));
    CHECK_FALSE(has(text(warped_lights()[0], 256, filters::disc{}), "warps"));
    const tetrahedron_light<float> lamp{.map_size = 256, .border = 20, .clip = opengl_clip_space};
    CHECK(has(text(lamp, 256, filter), "umbrage_tetrahedron_shape(center, number, vec2(at.x, at.y))"));
}
