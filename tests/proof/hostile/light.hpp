// SPDX-License-Identifier: MIT
//
// tier_a.cpp's inputs for what looks a light's map up: faces of cubes and tetrahedra, cascades, pages.
#pragma once

#include <array>

#include <umbrage/filter/pcf/pcf_2x2_cube.hpp>
#include <umbrage/light/adaptive/page_table.hpp>
#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/point/cube_atlas.hpp>
#include <umbrage/light/point/cube_map.hpp>
#include <umbrage/light/point/tetrahedron.hpp>
#include <umbrage/shadow/cascade_choice.hpp>
#include <umbrage/shadow/map_tile.hpp>
#include <umbrage/shadow/softness.hpp>
#include <umbrage/shadow/tetrahedron_map.hpp>

#include "hostile.hpp"

namespace hostile {

/// @param run   (name, of, draw, op): one input of so many
template <class Run, class Fetch>
void each_of_light(const Run& run, const Fetch& fetch) {
    using namespace umbrage;
    const auto direction = [](source& s) {
        const glm::vec2 xy = s.coords();
        return glm::vec3(xy, s.level());
    };
    run("cube_face", 1, direction, [](glm::vec3 d) { return float(cube_face(d)); });
    run("cube_view_z", 1, direction, [](glm::vec3 d) { return passed_on(cube_view_z(d)); });
    run("cube_plane", 1, direction, [](glm::vec3 d) { return passed_on(cube_plane(d)); });
    run("cube_point", 1, direction, [](glm::vec3 d) { return passed_on(cube_point(float(cube_face(d)), d)); });
    run("cube_face_point", 1, direction,
        [](glm::vec3 d) { return passed_on(cube_face_point(float(cube_face(d)), d)); });
    const auto cube_texel = [](source& s) {
        const int size = 1 << s.below(12);
        const int u = int(s.below(std::uint32_t(size) + 2)) - 1, v = int(s.below(std::uint32_t(size) + 2)) - 1;
        return glm::vec4(float(u), float(v), float(s.below(6)), float(size));
    };
    run("cube_neighbor", 1, cube_texel, [](glm::vec4 v) { return cube_neighbor(glm::vec3(v), v.w); });
    run("cube_atlas_texel", 1, cube_texel, [](glm::vec4 v) { return cube_atlas_texel(glm::vec2(v) + 1.0f, v.w); });
    run("cube_atlas_direction", 1, cube_texel,  // of even sizes: no middle column, of which zeros keep no sign
        [](glm::vec4 v) { return cube_atlas_direction(glm::vec2(v) + 1.0f, v.w * 2.0f); });
    run("cube_lit", 1, cube_texel, [&](glm::vec4 v) { return cube_lit(fetch, v.w, glm::vec3(v), 0.5f); });
    run("cube_tile", 1, cube_texel, [](glm::vec4 v) { return glm::vec2(cube_tile(int(v.z), int(v.w))); });
    const auto on_face = [](source& s) {
        const glm::vec2 xy = s.coords();
        const float z = s.level();
        return glm::vec4(xy, z, float(s.below(4)));
    };
    run("tetrahedron_face_point", 1, on_face,
        [](glm::vec4 v) { return passed_on(tetrahedron_face_point(int(v.w), glm::vec3(v))); });
    run("tetrahedron_turned", 1, on_face, [](glm::vec4 v) {
        const glm::vec2 turned = tetrahedron_turned(int(v.w), glm::vec2(v));
        return passed_on(glm::vec3(turned, v.z));
    });
    run("tetrahedron_face_of", 1, cube_texel,
        [](glm::vec4 v) { return float(tetrahedron_face_of(glm::vec2(v) + 1.0f, v.w + 2.0f)); });
    run(
        "cascade_by_depth", 1, [](source& s) { return s.level() * 4.0f; },
        [](float depth) { return cascade_by_depth(depth, glm::vec3(1.0f, 1.5f, 3.25f)); });
    run(
        "cascade_column", 1, [](source& s) { return float(s.below(5)); },
        [](float number) { return cascade_column(glm::mat4(1.0f), number); });
    run(
        "cascade_column_8", 1, [](source& s) { return float(s.below(9)); },
        [](float number) { return cascade_column_8(glm::mat4(1.0f), glm::mat4(2.0f), number); });
    run(
        "first_cascade", 1,
        [](source& s) {
            const auto edge = [&] { return float(s.below(9)) - 4.0f; };
            const float a = edge(), b = edge(), c = edge();
            return glm::vec4(a, b, c, edge());
        },
        [](glm::vec4 edges) { return first_cascade(edges); });
    run(
        "cascade_tile", 1,
        [](source& s) {
            const int number = static_cast<int>(s.below(8)), width = static_cast<int>(s.below(4096));
            return glm::ivec3(number, width, s.below(4096));
        },
        [](glm::ivec3 v) {
            return glm::vec2(cascade_tile(v.x, {v.y, v.z}));
        });
    run(
        "cascade_weight", 1, [](source& s) { return s.any(); }, [](float v) { return cascade_weight(v); });
    run(
        "dither_threshold", 1, [](source& s) { return s.coords(); },
        [](glm::vec2 pixel) { return dither_threshold(pixel); });
    run(
        "dithered_cascade", 1,
        [](source& s) {
            const float number = float(s.below(4)), weight = float(s.below(257)) / 256.0f;
            return glm::vec3(number, weight, float(s.below(16)) / 16.0f);
        },
        [](glm::vec3 v) { return dithered_cascade(v.x, v.y, v.z); });
    run(
        "page_coordinate", 1,
        [](source& s) {
            const auto around_root = [&s] {
                const float beside = s.one_in(8) ? float(s.below(3)) - 1.0f : 0.0f;
                return 1.0f + beside + float(s.one_in(4) ? s.below(65) << 17 : s.below(1 << 23)) * 0x1p-23f;
            };
            const float x = around_root(), y = around_root(), column = float(s.below(256)), row = float(s.below(256));
            const float level = float(s.below(17)), page = float(8 << s.below(6));
            return std::array{glm::vec2(x, y), glm::vec2(column, row), glm::vec2(level, page)};
        },
        [](const auto& in) {
            const auto level = static_cast<int>(in[2].x);
            const auto entry = level < 16 ? page_entry(glm::ivec2(in[1]), level) : glm::u8vec4(0);
            const auto table = [&](glm::ivec2 cell) {
                const bool in_root = cell.x > 0 && cell.y > 0 && cell.x < 65 && cell.y < 65;
                return in_root ? entry : glm::u8vec4(0);
            };
            return page_coordinate(table, 66.0f, in[0], in[2].y, 4.0f);
        });
    run(
        "page_tile", 1,
        [](source& s) {
            const int number = static_cast<int>(s.below(64));
            return glm::ivec2(number, s.below(2048));
        },
        [](glm::ivec2 v) { return glm::vec2(page_tile(v.x, v.y)); });
    run(
        "map_tile", 1,
        [](source& s) {
            const int number = static_cast<int>(s.below(64)), columns = static_cast<int>(1 + s.below(8));
            return glm::ivec3(number, columns, s.below(2048));
        },
        [](glm::ivec3 v) {
            return glm::vec2(map_tile(v.x, v.y, {v.z, 64}));
        });
    run(
        "tetrahedron_shape", 1,
        [](source& s) {
            const float x = float(s.below(1 << 16)) / 64.0f, y = float(s.below(1 << 16)) / 64.0f;
            return glm::vec2(x, s.one_in(4) ? x : y);
        },
        [](glm::vec2 at) { return tetrahedron_shape(glm::vec4(512, 0, 0, 0), 0.0f, at); });
    run(
        "map_softness", 1, [](source& s) { return float(s.below(8)); },
        [](float number) {
            glm::mat4 eight;
            for (int i = 0; i < 16; ++i) eight[i / 4][i % 4] = float(i);
            return map_softness(eight, number);
        });
}

}  // namespace hostile
