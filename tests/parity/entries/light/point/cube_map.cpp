// SPDX-License-Identifier: MIT
#include <umbrage/light/point/cube_map.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Directions in x0.xyz: ordinary and special ones, and those where two or three faces meet.
std::vector<input_class> directions() {
    auto classes = spread({{-9.0f, 9.0f}, {-9.0f, 9.0f}, {-9.0f, 9.0f}}, special_values());
    classes.push_back({"edges and corners", [](std::uint64_t i, random& r, sample& s) {
                           const float length = r.between(0.1f, 9.0f);
                           for (int axis = 0; axis < 3; ++axis) s.x[0][axis] = r.below(2) == 0 ? length : -length;
                           if (i % 4 < 3) s.x[0][static_cast<int>(i % 4)] = r.between(-length, length);
                       }});
    return classes;
}

/// The same, but not with denormals alone, of which implementations that take them for 0 find no greatest.
std::vector<input_class> longer_directions() {
    auto classes = directions();
    for (input_class& c : classes)
        if (c.name == "denormal")
            c.fill = [direction = c.fill](std::uint64_t i, random& r, sample& s) {
                direction(i, r, s);
                if (cube_view_z(vec3(s.x[0])) < 1e-30f) s.x[0][static_cast<int>(i % 3)] = r.between(-9.0f, -1.0f);
            };
    return classes;
}

/// A face in x0.z, a point on it in x0.xy.
std::vector<input_class> points_on_faces() {
    auto classes = spread({{0.0f, 1.0f}, {0.0f, 1.0f}}, special_values());
    for (input_class& c : classes)
        c.fill = [point = c.fill](std::uint64_t i, random& r, sample& s) {
            point(i, r, s);
            s.x[0].z = static_cast<float>(r.below(6));
        };
    return classes;
}

/// A texel of a face in x0.xyz, or one beyond its edges and corners; the face's size in x0.w.
void cube_texels(std::uint64_t, random& r, sample& s) {
    const std::uint32_t size = r.below(2) == 0 ? 1u + r.below(8) : 1u << r.below(15);
    for (int axis = 0; axis < 2; ++axis) {
        const std::uint32_t edge = r.below(4);
        const std::uint32_t up = edge == 0 ? 0 : edge == 1 ? size + 1 : r.below(size + 2);
        s.x[0][axis] = static_cast<float>(up) - 1.0f;
    }
    s.x[0].z = static_cast<float>(r.below(6));
    s.x[0].w = static_cast<float>(size);
}

int face_of(const sample& s) { return static_cast<int>(s.x[0].z); }

}  // namespace

void add_light_point_cube_map(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    all.push_back({.primitive = &glsl::cube_face,
                   .classes = directions(),
                   .twin = [](const sample& s) { return vec4(static_cast<float>(cube_face(vec3(s.x[0])))); },
                   .call = "vec4(umbrage_cube_face(vec3(x0.x, x0.y, x0.z)))"});
    all.push_back({.primitive = &glsl::cube_view_z,
                   .classes = longer_directions(),
                   .twin = [](const sample& s) { return vec4(cube_view_z(vec3(s.x[0]))); },
                   .call = "vec4(umbrage_cube_view_z(vec3(x0.x, x0.y, x0.z)))"});
    all.push_back({.primitive = &glsl::cube_plane,
                   .classes = longer_directions(),
                   .twin = [](const sample& s) { return vec4(cube_plane(vec3(s.x[0])), 1.0f); },
                   .call = "vec4(umbrage_cube_plane(vec3(x0.x, x0.y, x0.z)), 1.0)"});
    all.push_back({.primitive = &glsl::cube_point,
                   .classes = points_on_faces(),
                   .twin = [](const sample& s) { return vec4(cube_point(s.x[0].z, vec3(vec2(s.x[0]), 2.0f)), 1.0f); },
                   .call = "vec4(umbrage_cube_point(x0.z, vec3(x0.x, x0.y, 2.0)), 1.0)"});
    all.push_back(
        {.primitive = &glsl::cube_face_point,
         .classes = points_on_faces(),
         .twin = [](const sample& s) { return vec4(cube_face_point(s.x[0].z, vec3(vec2(s.x[0]), 2.0f)), 1.0f); },
         .call = "vec4(umbrage_cube_face_point(x0.z, vec3(x0.x, x0.y, 2.0)), 1.0)"});
    all.push_back({.primitive = &glsl::cube_neighbor,
                   .classes = {{"inside and beyond", cube_texels}},
                   .twin = [](const sample& s) { return vec4(cube_neighbor(vec3(s.x[0]), s.x[0].w), 1.0f); },
                   .call = "vec4(umbrage_cube_neighbor(vec3(x0.x, x0.y, x0.z), x0.w), 1.0)"});
    all.push_back({.primitive = &glsl::cube_coordinate,
                   .classes = directions(),
                   .twin = [](const sample& s) { return vec4(cube_coordinate(vec3(s.x[0])), 1.0f); },
                   .call = "vec4(umbrage_cube_coordinate(vec3(x0.x, x0.y, x0.z)), 1.0)"});
    all.push_back({.primitive = &glsl::cube_direction,
                   .classes = points_on_faces(),
                   .twin = [](const sample& s) { return vec4(cube_direction(s.x[0].z, vec2(s.x[0])), 1.0f); },
                   .call = "vec4(umbrage_cube_direction(x0.z, vec2(x0.x, x0.y)), 1.0)"});
    all.push_back({.primitive = &glsl::cube_tile,
                   .classes = points_on_faces(),
                   .twin = [](const sample& s) { return vec4(vec2(cube_tile(face_of(s), 512)), 0.0f, 1.0f); },
                   .call = "vec4(umbrage_cube_tile(x0.z, 512.0), 0.0, 1.0)"});
}

}  // namespace parity
