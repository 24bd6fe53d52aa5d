// SPDX-License-Identifier: MIT
#include <umbrage/light/cascades/select.hpp>

#include <cmath>

#include <umbrage/filter/pcf/pcf_2x2.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// A number of a cascade in x0.w.
std::vector<input_class> numbered(std::vector<input_class> classes, std::uint32_t count = 4) {
    for (input_class& c : classes)
        c.fill = [fill = c.fill, count](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            s.x[0].w = static_cast<float>(r.below(count));
        };
    return classes;
}

/// Ordinary ones, and some with x0[what] as `at` has it.
template <class At>
std::vector<input_class> some_at(std::vector<input_class> classes, const char* name, int what, At at) {
    classes.push_back({name, [ordinary = classes.front().fill, what, at](std::uint64_t i, random& r, sample& s) {
                           ordinary(i, r, s);
                           s.x[0][what] = at(r, s);
                       }});
    return classes;
}

/// Four cascades of 64 x 64 texels around a point in x0.xyz: the first one's scale in x1.xy, half of it for each next
/// one; their offsets in x2 to x5.
std::vector<input_class> nested() {
    return spread({{-9.0f, 9.0f},   {-9.0f, 9.0f},  {-0.25f, 1.25f}, {0.0f, 4.0f},   {2.0f, 16.0f},   {2.0f, 16.0f},
                   {1.0f, 1.0f},    {0.0f, 0.0f},   {16.0f, 48.0f},  {16.0f, 48.0f}, {-0.25f, 0.25f}, {0.0f, 0.0f},
                   {24.0f, 40.0f},  {24.0f, 40.0f}, {-0.25f, 0.25f}, {0.0f, 0.0f},   {24.0f, 40.0f},  {24.0f, 40.0f},
                   {-0.25f, 0.25f}, {0.0f, 0.0f},   {24.0f, 40.0f},  {24.0f, 40.0f}, {-0.25f, 0.25f}, {0.0f, 0.0f}},
                  special_values());
}

glm::mat4 scales(const sample& s) {
    const vec2 xy(s.x[1]);
    return {s.x[1], vec4(xy * 0.5f, 1.0f, 0.0f), vec4(xy * 0.25f, 1.0f, 0.0f), vec4(xy * 0.125f, 1.0f, 0.0f)};
}

/// Scales of the next four cascades, which give depths to points eight times as far.
glm::mat4 farther_scales(const sample& s) {
    glm::mat4 m(0.0f);
    for (glm::length_t i = 0; i < 4; ++i)
        m[i] = vec4(vec2(s.x[1]) * std::ldexp(1.0f, -4 - static_cast<int>(i)), 0.125f, 0.0f);
    return m;
}

/// A whole lookup: cascades of x2, x4 and x3, x5 in turn, chosen by a view depth and ends in x1; without its twin.
entry look_up(const std::string& variant, const std::string& size, bound_map map, float most_depth) {
    const std::string number = "umbrage_cascade_by_depth(x1.x, vec3(x1.y, x1.z, x1.w))";
    const std::string coordinate =
        "umbrage_cascade_coordinate(vec3(x0.x, x0.y, x0.z), umbrage_cascade_column(mat4(x2, x3, x3, x2), " + number +
        "), umbrage_cascade_column(mat4(x4, x5, x5, x4), " + number + "))";
    map.which = map.which.empty() ? number : "umbrage_cascade_tile(" + number + ", " + map.which + ")";
    return {.primitive = &glsl::cascade_column,
            .variant = variant,
            .classes = spread(
                {{-9.0f, 9.0f}, {-9.0f, 9.0f}, {-9.0f, 9.0f},  {0.0f, 0.0f},   {0.0f, most_depth}, {1.0f, 1.0f},
                 {2.0f, 2.0f},  {3.0f, 3.0f},  {2.0f, 4.0f},   {2.0f, 4.0f},   {0.04f, 0.06f},     {0.0f, 0.0f},
                 {2.0f, 4.0f},  {2.0f, 4.0f},  {0.04f, 0.06f}, {0.0f, 0.0f},   {10.0f, 40.0f},     {10.0f, 40.0f},
                 {0.5f, 0.5f},  {0.0f, 0.0f},  {10.0f, 40.0f}, {10.0f, 40.0f}, {0.5f, 0.5f},       {0.0f, 0.0f}},
                {}),
            .call = "vec4(umbrage_pcf_2x2(map, " + size + ", vec2(" + coordinate + ".x, " + coordinate + ".y), " +
                    coordinate + ".z))",
            .maps = plain_maps({{64, 64}}),
            .bound = {map},
            .also = {&glsl::cascade_by_depth, &glsl::cascade_coordinate, &glsl::cascade_tile, &glsl::pcf_2x2},
            .share = 16};
}

float number_of(const sample& s) { return cascade_by_depth(s.x[1].x, vec3(s.x[1].y, s.x[1].z, s.x[1].w)); }

template <class Fetch>
vec4 looked_up(const sample& s, const Fetch& fetch) {
    const float number = number_of(s);
    const vec3 at = cascade_coordinate(vec3(s.x[0]), cascade_column(glm::mat4(s.x[2], s.x[3], s.x[3], s.x[2]), number),
                                       cascade_column(glm::mat4(s.x[4], s.x[5], s.x[5], s.x[4]), number));
    return vec4(pcf_2x2(fetch, vec2(at), at.z));
}

/// Layers as bound textures have them: the map is the second, and the first 1 less it.
void add_array(std::vector<entry>& all) {
    entry e = look_up("look-up in an array", "map_size",
                      {.name = "map", .as = {.texture = glsl::texture::array, .outside = outside_map::clamped}}, 2.0f);
    e.twin = [](const sample& s) {
        const bool first = number_of(s) < 0.5f;
        return looked_up(s, [map = s.map, first](ivec2 texel) {
            const float depth = fetch_clamped(map, texel).x;
            return first ? 1.0f - depth : depth;
        });
    };
    all.push_back(std::move(e));
}

/// Four tiles over a texture in which the map is a region, with 1 less it around.
void add_atlas(std::vector<entry>& all) {
    entry e = look_up("look-up in an atlas", "map_size * 0.5",
                      {.name = "map", .as = {.texture = glsl::texture::atlas}, .which = "vec2(32.0, 32.0)"}, 4.0f);
    e.twin = [](const sample& s) {
        const ivec2 first = cascade_tile(static_cast<int>(number_of(s)), ivec2(32)) - bound_map::origin;
        return looked_up(s, [map = s.map, first](ivec2 texel) {
            const ivec2 at = first + glm::clamp(texel, ivec2(0), ivec2(31));
            const float depth = fetch_clamped(map, at).x;
            return inside_map(map.size, at) ? depth : 1.0f - depth;
        });
    };
    all.push_back(std::move(e));
}

}  // namespace

void add_light_cascades_select(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    all.push_back(
        {.primitive = &glsl::cascade_by_depth,
         .classes =
             some_at(spread({{0.0f, 9.0f}, {0.0f, 3.0f}, {3.0f, 6.0f}, {6.0f, 9.0f}}, special_values()), "at an end", 0,
                     [](random& r, const sample& s) { return s.x[0][1 + static_cast<int>(r.below(3))]; }),
         .twin = [](const sample& s) { return vec4(cascade_by_depth(s.x[0].x, vec3(s.x[0].y, s.x[0].z, s.x[0].w))); },
         .call = "vec4(umbrage_cascade_by_depth(x0.x, vec3(x0.y, x0.z, x0.w)))"});
    all.push_back(
        {.primitive = &glsl::cascade_column,
         .classes = numbered(spread(std::vector<range>(20, range{-9.0f, 9.0f}), special_values())),
         .twin = [](const sample& s) { return cascade_column(glm::mat4(s.x[1], s.x[2], s.x[3], s.x[4]), s.x[0].w); },
         .call = "umbrage_cascade_column(mat4(x1, x2, x3, x4), x0.w)"});
    all.push_back({.primitive = &glsl::cascade_column_8,
                   .classes = numbered(spread(std::vector<range>(24, range{-9.0f, 9.0f}), special_values()), 8),
                   .twin =
                       [](const sample& s) {
                           return cascade_column_8(glm::mat4(s.x[1], s.x[2], s.x[3], s.x[4]),
                                                   glm::mat4(s.x[5], s.x[4] * 2.0f, s.x[3] * 2.0f, s.x[2] * 2.0f),
                                                   s.x[0].w);
                       },
                   .call = "umbrage_cascade_column_8(mat4(x1, x2, x3, x4), mat4(x5, x4 * 2.0, x3 * 2.0, x2 * 2.0), "
                           "x0.w)"});
    all.push_back({.primitive = &glsl::cascade_coordinate,
                   .classes = spread(std::vector<range>(12, range{-999.0f, 999.0f}), special_values()),
                   .twin = [](const sample& s) { return vec4(cascade_coordinate(vec3(s.x[0]), s.x[1], s.x[2]), 1.0f); },
                   .call = "vec4(umbrage_cascade_coordinate(vec3(x0.x, x0.y, x0.z), x1, x2), 1.0)"});
    all.push_back(
        {.primitive = &glsl::inside_cascade,
         .classes = some_at(
             spread({{-8.0f, 72.0f}, {-8.0f, 72.0f}, {-0.25f, 1.25f}, {0.0f, 8.0f}, {32.0f, 64.0f}, {32.0f, 64.0f}},
                    special_values()),
             "at a border", 1,
             [](random& r, const sample& s) {
                 const float border = r.below(2) == 0 ? s.x[0].w : s.x[1].y - s.x[0].w;
                 return r.below(2) == 0 ? border : std::nextafter(border, r.below(2) == 0 ? 0.0f : 99.0f);
             }),
         .twin =
             [](const sample& s) { return vec4(inside_cascade(vec3(s.x[0]), vec2(s.x[1]), s.x[0].w) ? 1.0f : 0.0f); },
         .call = "vec4(umbrage_inside_cascade(vec3(x0.x, x0.y, x0.z), vec2(x1.x, x1.y), x0.w) ? 1.0 : 0.0)"});
    const std::string columns =
        "mat4(x1, vec4(vec2(x1.x, x1.y) * 0.5, 1.0, 0.0), vec4(vec2(x1.x, x1.y) * 0.25, 1.0, 0.0), "
        "vec4(vec2(x1.x, x1.y) * 0.125, 1.0, 0.0))";
    const std::string farther =
        "mat4(vec4(vec2(x1.x, x1.y) * 0.0625, 0.125, 0.0), vec4(vec2(x1.x, x1.y) * 0.03125, 0.125, 0.0), "
        "vec4(vec2(x1.x, x1.y) * 0.015625, 0.125, 0.0), vec4(vec2(x1.x, x1.y) * 0.0078125, 0.125, 0.0))";
    all.push_back({.primitive = &glsl::cascade_by_projection,
                   .classes = nested(),
                   .twin =
                       [](const sample& s) {
                           return cascade_by_projection(vec3(s.x[0]), scales(s),
                                                        glm::mat4(s.x[2], s.x[3], s.x[4], s.x[5]), vec2(64.0f),
                                                        s.x[0].w);
                       },
                   .call = "umbrage_cascade_by_projection(vec3(x0.x, x0.y, x0.z), " + columns +
                           ", mat4(x2, x3, x4, x5), vec2(64.0, 64.0), x0.w)"});
    all.push_back({.primitive = &glsl::cascade_by_projection_8,
                   .classes = nested(),
                   .twin =
                       [](const sample& s) {
                           const glm::mat4 offsets(s.x[2], s.x[3], s.x[4], s.x[5]);
                           return cascade_by_projection_8(vec3(s.x[0]) * 8.0f, scales(s), offsets, farther_scales(s),
                                                          glm::mat4(s.x[5], s.x[4], s.x[3], s.x[2]), vec2(64.0f),
                                                          s.x[0].w);
                       },
                   .call = "umbrage_cascade_by_projection_8(vec3(x0.x, x0.y, x0.z) * 8.0, " + columns +
                           ", mat4(x2, x3, x4, x5), " + farther + ", mat4(x5, x4, x3, x2), vec2(64.0, 64.0), x0.w)"});
    all.push_back({.primitive = &glsl::cascade_tile,
                   .classes = numbered(spread({{0.0f, 1.0f}}, special_values()), 8),
                   .twin =
                       [](const sample& s) {
                           return vec4(vec2(cascade_tile(static_cast<int>(s.x[0].w), {512, 256})), 0.0f, 1.0f);
                       },
                   .call = "vec4(umbrage_cascade_tile(x0.w, vec2(512.0, 256.0)), 0.0, 1.0)"});
    add_array(all);
    add_atlas(all);
}

}  // namespace parity
