// SPDX-License-Identifier: MIT
#include <umbrage/light/point/tetrahedron.hpp>

#include <cmath>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Directions in x0.xyz: ordinary and special ones, and those between faces and towards corners; but no denormals, nor
/// what makes them, that choose between faces: implementations that take them for 0 choose the other.
std::vector<input_class> towards_faces() {
    auto classes = spread({{-9.0f, 9.0f}, {-9.0f, 9.0f}, {-9.0f, 9.0f}}, special_values());
    classes.push_back({"between faces", [](std::uint64_t i, random& r, sample& s) {
                           const float x = r.between(-9.0f, 9.0f), z = r.between(-9.0f, 9.0f);
                           const float beside = i % 2 == 0 ? std::abs(z) - std::abs(x) : 0.0f;
                           const float away = beside / 1.41421356f;
                           s.x[0] = vec4(i % 3 == 0 ? 0.0f : x, i % 4 == 0 ? 0.0f : away, i % 5 == 0 ? 0.0f : z, 0.0f);
                       }});
    for (input_class& c : classes)
        if (c.name == "denormal" || c.name == "smallest normal")
            c.fill = [direction = c.fill](std::uint64_t i, random& r, sample& s) {
                direction(i, r, s);
                s.x[0].y = -std::abs(s.x[0].y);
                s.x[0].z = i % 2 == 0 ? r.between(-9.0f, -1.0f) : r.between(1.0f, 9.0f);
            };
    return classes;
}

/// Vectors of these ranges and special ones in x0, a face in x1.x.
std::vector<input_class> on_faces(std::vector<range> vector) {
    auto classes = spread(std::move(vector), special_values());
    for (input_class& c : classes)
        c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            s.x[1].x = static_cast<float>(r.below(4));
        };
    return classes;
}

/// A point of a face in x0.xyz, the map's size in x0.w, a border in x1.x.
void on_tetrahedron(std::uint64_t, random& r, sample& s) {
    s.x[0] = vec4{r.between(-1.0f, 1.0f), r.between(0.0f, 1.0f), static_cast<float>(r.below(4)),
                  static_cast<float>(64u << r.below(7))};
    s.x[1].x = static_cast<float>(r.below(8));
}

/// A texel in x0.xy, often on a diagonal, of a map of x0.w.
void texels_of_faces(std::uint64_t, random& r, sample& s) {
    const std::uint32_t size = r.below(2) == 0 ? 1u + r.below(8) : 1u << r.below(15), x = r.below(size);
    const std::uint32_t diagonal = r.below(4);
    s.x[0].x = static_cast<float>(x);
    s.x[0].y = static_cast<float>(diagonal == 0 ? x : diagonal == 1 ? size - 1 - x : r.below(size));
    s.x[0].w = static_cast<float>(size);
}

}  // namespace

void add_light_point_tetrahedron(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    all.push_back({.primitive = &glsl::tetrahedron_face,
                   .classes = towards_faces(),
                   .twin = [](const sample& s) { return vec4(static_cast<float>(tetrahedron_face(vec3(s.x[0])))); },
                   .call = "vec4(umbrage_tetrahedron_face(vec3(x0.x, x0.y, x0.z)))"});
    all.push_back({.primitive = &glsl::tetrahedron_plane,
                   .classes = towards_faces(),
                   .twin = [](const sample& s) { return vec4(tetrahedron_plane(vec3(s.x[0])), 1.0f); },
                   .call = "vec4(umbrage_tetrahedron_plane(vec3(x0.x, x0.y, x0.z)), 1.0)"});
    all.push_back({.primitive = &glsl::tetrahedron_face_point,
                   .classes = on_faces({{-9.0f, 9.0f}, {-9.0f, 9.0f}, {-9.0f, 9.0f}}),
                   .twin =
                       [](const sample& s) {
                           return vec4(tetrahedron_face_point(static_cast<int>(s.x[1].x), vec3(s.x[0])), 1.0f);
                       },
                   .call = "vec4(umbrage_tetrahedron_face_point(x1.x, vec3(x0.x, x0.y, x0.z)), 1.0)"});
    all.push_back({.primitive = &glsl::tetrahedron_turned,
                   .classes = on_faces({{-2.0f, 2.0f}, {-2.0f, 2.0f}}),
                   .twin =
                       [](const sample& s) {
                           return vec4(tetrahedron_turned(static_cast<int>(s.x[1].x), vec2(s.x[0])), 0.0f, 1.0f);
                       },
                   .call = "vec4(umbrage_tetrahedron_turned(x1.x, vec2(x0.x, x0.y)), 0.0, 1.0)"});
    all.push_back({.primitive = &glsl::tetrahedron_view_z,
                   .classes = towards_faces(),
                   .twin = [](const sample& s) { return vec4(tetrahedron_view_z(vec3(s.x[0]))); },
                   .call = "vec4(umbrage_tetrahedron_view_z(vec3(x0.x, x0.y, x0.z)))"});
    all.push_back({.primitive = &glsl::tetrahedron_coordinate,
                   .classes = towards_faces(),
                   .twin = [](const sample& s) { return vec4(tetrahedron_coordinate(vec3(s.x[0])), 1.0f); },
                   .call = "vec4(umbrage_tetrahedron_coordinate(vec3(x0.x, x0.y, x0.z)), 1.0)"});
    all.push_back(
        {.primitive = &glsl::tetrahedron_texel,
         .classes = {{"points of faces", on_tetrahedron}},
         .twin = [](const sample& s) { return vec4(tetrahedron_texel(vec3(s.x[0]), s.x[0].w, s.x[1].x), 0.0f, 1.0f); },
         .call = "vec4(umbrage_tetrahedron_texel(vec3(x0.x, x0.y, x0.z), x0.w, x1.x), 0.0, 1.0)"});
    all.push_back(
        {.primitive = &glsl::tetrahedron_face_of,
         .classes = {{"texels", texels_of_faces}},
         .twin = [](const sample& s) { return vec4(static_cast<float>(tetrahedron_face_of(vec2(s.x[0]), s.x[0].w))); },
         .call = "vec4(umbrage_tetrahedron_face_of(vec2(x0.x, x0.y), x0.w))"});
}

}  // namespace parity
