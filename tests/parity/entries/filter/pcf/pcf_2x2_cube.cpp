// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/pcf_2x2_cube.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Receivers before a face: x0.xy in texels, with special values among them, and often at an edge; the face in x0.z,
/// the depth in x0.w.
std::vector<input_class> before_faces() {
    auto classes = spread({{0.0f, 8.0f}, {0.0f, 8.0f}, {0.0f, 1.0f}}, special_values());
    for (input_class& c : classes)
        c.fill = [point = c.fill](std::uint64_t i, random& r, sample& s) {
            point(i, r, s);
            const float side = static_cast<float>(s.map.size.y) * 0.5f;
            s.x[0].w = s.x[0].z;
            s.x[0].z = static_cast<float>(r.below(6));
            for (int axis = 0; axis < 2; ++axis)
                if (const std::uint32_t edge = r.below(6); edge < 3)
                    s.x[0][axis] = edge == 0 ? 0.0f : edge == 1 ? side : side - 0.5f * s.x[0][axis] / 8.0f;
        };
    return classes;
}

/// Texels of a face and around it in x0.xyz, depths in x0.w.
std::vector<input_class> texels_of_faces() {
    auto classes = spread({{0.0f, 1.0f}}, special_values());
    for (input_class& c : classes)
        c.fill = [depth = c.fill](std::uint64_t i, random& r, sample& s) {
            depth(i, r, s);
            const std::uint32_t around = static_cast<std::uint32_t>(s.map.size.y) / 2 + 2;
            s.x[0].w = s.x[0].x;
            for (int axis = 0; axis < 2; ++axis) s.x[0][axis] = static_cast<float>(r.below(around)) - 1.0f;
            s.x[0].z = static_cast<float>(r.below(6));
        };
    return classes;
}

float side(const sample& s) { return static_cast<float>(s.map.size.y / 2); }

}  // namespace

void add_filter_pcf_pcf_2x2_cube(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    all.push_back(
        {.primitive = &glsl::cube_lit,
         .classes = texels_of_faces(),
         .twin = [](const sample& s) { return vec4(cube_lit(s.depth(), side(s), vec3(s.x[0]), s.x[0].w), 0.0f, 1.0f); },
         .call = "vec4(umbrage_cube_lit(map, map_size, vec3(x0.x, x0.y, x0.z), x0.w), 0.0, 1.0)",
         .maps = plain_maps({{24, 16}, {21, 14}, {3, 2}})});
    all.push_back(
        {.primitive = &glsl::pcf_2x2_cube,
         .classes = before_faces(),
         .twin = [](const sample& s) { return vec4(pcf_2x2_cube(s.depth(), side(s), vec3(s.x[0]), s.x[0].w)); },
         .call = "vec4(umbrage_pcf_2x2_cube(map, map_size, vec3(x0.x, x0.y, x0.z), x0.w))",
         .maps = plain_maps({{24, 16}, {48, 32}, {3, 2}})});
    for (const auto direction : {depth_direction::forward, depth_direction::reversed})
        all.push_back({.primitive = &glsl::pcf_2x2_cube,
                       .variant = direction == depth_direction::forward ? "of a cube" : "of a cube, reversed",
                       .classes = before_faces(),
                       .twin =
                           [direction](const sample& s) {
                               return vec4(
                                   pcf_2x2_cube(s.depth(), side(s), vec3(s.x[0]), s.x[0].w, comparison{direction}));
                           },
                       .call = "vec4(umbrage_pcf_2x2_cube(map, map_size, vec3(x0.x, x0.y, x0.z), x0.w))",
                       .maps = plain_maps({{24, 16}, {48, 32}, {3, 2}}),
                       .bound = {{"map", {.texture = glsl::texture::cube_faces, .direction = direction}}}});
}

}  // namespace parity
