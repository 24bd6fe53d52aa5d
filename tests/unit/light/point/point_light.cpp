// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/light/point/point_light.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include <umbrage/depth/conversions.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/filter/pcf/windows.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../bodies.hpp"
#include "../clip_spaces.hpp"

using namespace umbrage;

TEST_CASE(
    "make_point_light: cube_coordinate's texels and per-face depths, in every convention, with and without a border") {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (const clip_space clip : all_clip_spaces())
        for (const int border : {0, 3}) {
            CAPTURE(to_string(clip));
            const point_light<double> light{
                .position = {3, -2, 7}, .z_near = 0.25, .z_far = 40, .map_size = 64, .border = border, .clip = clip};
            const auto faces = make_point_light(light);
            double apart = 0;
            for (int i = 0; i < 2000; ++i) {
                const double x = normal(random), y = normal(random), z = normal(random);
                const glm::dvec3 direction = 5.0 * glm::dvec3(x, y, z), at = cube_coordinate(direction);
                const auto& face = faces[static_cast<std::size_t>(at.z)];
                const glm::dvec3 texel = through(texture_matrix(face, {64, 64}), light.position + direction);
                const double m = cube_view_z(direction);
                const double depth = clip.direction == depth_direction::forward
                                         ? depth_from_view_z(m, 0.25, 40.0)
                                         : reversed_depth_from_view_z(m, 0.25, 40.0);
                const glm::dvec3 expected(glm::dvec2(at) * (64.0 - 2 * border) + double(border), depth);
                for (glm::length_t k = 0; k < 3; ++k) apart = worse(apart, std::abs(texel[k] - expected[k]));
            }
            CHECK(apart < 1e-9);
        }
}

namespace {

/// Two faces of a cube, drawn with a border as wide as filters of a reach need.
struct two_faces {
    static constexpr int size = 64;
    int border;
    std::array<light_space<double>, 6> lights;
    std::array<image<float>, 6> maps;

    two_faces(float reach, const std::vector<glm::vec3>& quad, glm::ivec2 faces)
        : border(static_cast<int>(std::ceil(reach))),
          lights(make_point_light<double>(
              {.z_near = 0.5, .z_far = 200, .map_size = size, .border = border, .clip = cpu_clip_space})) {
        const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};
        for (const int face : {faces.x, faces.y}) {
            const auto& light = lights[std::size_t(face)];
            maps[std::size_t(face)] = image<float>(glm::ivec2(size), 1.0f);
            rasterize_depth(maps[std::size_t(face)], {quad, triangles}, glm::mat4(light.projection * light.view),
                            light.clip, cull_mode::none);
        }
    }

    [[nodiscard]] glm::dvec3 texel(int face, glm::dvec3 p) const {
        return through(texture_matrix(lights[std::size_t(face)], glm::ivec2(size)), p);
    }
    template <int N>
    [[nodiscard]] double lit(int face, glm::dvec3 p) const {
        const glm::dvec3 at = texel(face, p);
        return tent<N>(clamped(maps[std::size_t(face)]), glm::dvec2(at), at.z);
    }
};

/// The shadow of half a plane, whose edge crosses a seam somewhere: where either face has it along the seam.
template <int N>
void cross_seams() {
    std::mt19937 random(N);
    const float reach = tent_row<N>.reach();
    int crossed = 0, apart = 0, lines = 0;
    for (int i = 0; i < 240; ++i) {
        const int a = static_cast<int>(random() % 6), turn = static_cast<int>(random() % 4);
        const int b = (a / 2 * 2 + 2 + turn) % 6;
        const glm::dvec3 along(
            glm::cross(glm::dvec3(cube_faces[std::size_t(a)].forward), glm::dvec3(cube_faces[std::size_t(b)].forward)));
        const auto seam = [&](double u) {
            return glm::dvec3(cube_faces[std::size_t(a)].forward + cube_faces[std::size_t(b)].forward) + u * along;
        };
        const double crossing = bodies::real(-0.5, 0.5)(random);
        const glm::dvec3 on_edge = 3.0 * seam(crossing);
        const glm::dvec3 normal = glm::normalize(glm::normalize(on_edge) + bodies::random_vector(random, -0.2, 0.2));
        const glm::dvec3 edge = glm::normalize(glm::cross(normal, bodies::random_vector(random, -1, 1)));
        const glm::dvec3 inwards = glm::cross(normal, edge);
        const double side = glm::dot(inwards, along);
        std::vector<glm::vec3> quad;
        for (const glm::dvec2 corner : {glm::dvec2(-40, 0), {40, 0}, {40, 40}, {-40, 40}})
            quad.emplace_back(on_edge + corner.x * edge + corner.y * inwards);
        const two_faces cube(reach, quad, {a, b});

        const double step = 2.0 / (cube.size - 2 * cube.border);  // of a texel
        const glm::dvec2 image(cube.texel(a, on_edge + 0.01 * edge) - cube.texel(a, on_edge - 0.01 * edge));
        const glm::dvec2 way(cube.texel(a, seam(0.01)) - cube.texel(a, seam(-0.01)));
        const double sine = std::abs(image.x * way.y - image.y * way.x) / (glm::length(image) * glm::length(way));
        if (sine < 0.2) continue;  // they do not cross but run side by side
        ++crossed;
        const auto crosses_at = [&](auto lit) {
            double at = 1e9, before = lit(crossing - 8 * step);
            for (int k = -8 * 32; k <= 8 * 32; ++k) {
                const double u = crossing + k * step / 32, now = lit(u);
                if ((now < 0.5) != (before < 0.5)) at = u;
                before = now;
            }
            return at;
        };
        const auto in_a = [&](double u) { return cube.template lit<N>(a, 50.0 * seam(u)); };
        const auto in_b = [&](double u) { return cube.template lit<N>(b, 50.0 * seam(u)); };
        apart += !(std::abs(crosses_at(in_a) - crosses_at(in_b)) * sine / step <= 1.0);
        for (const double off : {-12.0, -9.0, -7.0, 7.0, 9.0, 12.0}) {
            const double u = crossing + off * step / sine;
            if (std::abs(off) < double(reach) + 1 || std::abs(u) > 1 || std::abs(u - crossing) > 0.4) continue;
            const double expected = off * side > 0 ? 0 : 1;
            lines += in_a(u) != expected || in_b(u) != expected;
        }
    }
    CHECK(crossed > 150);
    CHECK(apart == 0);
    CHECK(lines == 0);
}

}  // namespace

TEST_CASE(
    "make_point_light: with a border, over a seam a shadow's edge moves by a texel at most, and away from edges "
    "nothing shows") {
    cross_seams<2>();
    cross_seams<3>();
    cross_seams<7>();
}

TEST_CASE("make_point_light: what is wrong is named") {
    const auto of = [](auto change) {
        point_light<float> light{.clip = cpu_clip_space};
        change(light);
        const std::string message = complaint([&] { (void)make_point_light(light); });
        const auto begin = message.find(": ");
        return message.empty() ? message : message.substr(begin + 2, message.find(" must") - begin - 2);
    };
    using light = point_light<float>;
    CHECK(of([](light&) {}).empty());
    CHECK(of([](light& l) { l.z_far = std::numeric_limits<float>::infinity(); }).empty());
    CHECK(of([](light& l) { l.border = -1; }) == "border");
    CHECK(of([](light& l) { l.border = 256; }) == "map_size");
    CHECK(of([](light& l) { l.border = std::numeric_limits<int>::max(); }) == "map_size");
    CHECK(of([](light& l) { l.map_size = 0; }) == "map_size");
    CHECK(of([](light& l) { l.map_size = -5; }) == "map_size");
    CHECK(of([](light& l) { l.z_near = 0; }) == "z_near");
    CHECK(of([](light& l) { l.z_near = 3e-4f; }) == "z_near");  // no digits at 100
    CHECK(of([](light& l) { l.z_near = 3e-4f, l.clip.direction = depth_direction::reversed; }).empty());
    CHECK(of([](light& l) { l.z_far = l.z_near; }) == "z_far");
    CHECK(of([](light& l) { l.position.y = std::nanf(""); }) == "position");
}
