// SPDX-License-Identifier: MIT
#include <umbrage/shadow/cascade_places.hpp>

#include <cmath>

#include "places.hpp"

namespace parity {
namespace {

using namespace umbrage;

constexpr shadow_terms in_64{.map_size = vec2(64.0f), .reach = 2.0f};

/// A point in x0.xyz before four cascades of 64 x 64 texels, each with half of the scale before it, x1.xyz; offsets in
/// x2 to x5; a normal in the fourth components, and the number of the last cascade in x0.w.
std::vector<input_class> nested() {
    const range offset{24.0f, 40.0f}, depth{-0.25f, 0.25f}, tilt{-1.0f, 1.0f};
    auto classes = spread(
        {{-9.0f, 9.0f}, {-9.0f, 9.0f}, {-0.25f, 1.25f}, {0.0f, 4.0f}, {2.0f, 16.0f}, {2.0f, 16.0f}, {1.0f, 1.0f}, tilt,
         offset,        offset,        depth,           tilt,         offset,        offset,        depth,        tilt,
         offset,        offset,        depth,           tilt,         offset,        offset,        depth,        tilt},
        large_values());
    for (input_class& c : classes)
        c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            s.x[0].w = static_cast<float>(r.below(4));
        };
    return classes;
}

vec3 normal_of(const sample& s) { return {s.x[2].w, s.x[3].w, s.x[4].w}; }
vec4 blending_of(const sample& s) { return {0.125f, s.x[0].w, 0.0f, 0.0f}; }

glm::mat4 scales(const sample& s) {
    glm::mat4 m(0.0f);
    for (glm::length_t i = 0; i < 4; ++i)
        m[i] = vec4(vec2(s.x[1]) * std::ldexp(1.0f, -static_cast<int>(i)), 1.0f, s.x[1].x);
    return m;
}

/// Axes of a light, nearly: no component is 0, of which a compiler makes 0 whatever it is multiplied with.
constexpr auto turned =
    "mat4(vec4(0.25, 1.0, 0.015625, 1.0), vec4(1.0, -0.25, 0.015625, 1.0), vec4(0.0625, 0.125, 1.0, 1.0), "
    "vec4(0.5, -0.5, 0.03125, 1.0))";
const glm::mat4 axes(vec4(0.25f, 1, 0.015625f, 1), vec4(1, -0.25f, 0.015625f, 1), vec4(0.0625f, 0.125f, 1, 1),
                     vec4(0.5f, -0.5f, 0.03125f, 1));
const vec4 anchor(0.25f, -0.5f, 0.125f, 0.0f);
constexpr auto all_scales =
    "mat4(vec4(x1.x, x1.y, 1.0, x1.x), vec4(vec2(x1.x, x1.y) * 0.5, 1.0, x1.x), "
    "vec4(vec2(x1.x, x1.y) * 0.25, 1.0, x1.x), vec4(vec2(x1.x, x1.y) * 0.125, 1.0, x1.x))";
constexpr auto rest =
    "vec4(0.25, -0.5, 0.125, 0.0), vec4(0.125, x0.w, 0.0, 0.0), vec4(64.0, 64.0, 2.0, 0.0), vec3(x0.x, x0.y, x0.z), "
    "vec3(x2.w, x3.w, x4.w))";

}  // namespace

void add_shadow_cascade_places(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    auto pairs = nested();
    for (input_class& c : pairs)
        c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            const float edge = r.below(2) == 0 ? 2.0f : 62.0f;
            s.x[2] = vec4(r.below(2) == 0 ? edge : r.between(2.0f, 62.0f), r.between(2.0f, 62.0f), 0.5f,
                          static_cast<float>(r.below(5)));
        };
    add_places(
        all, glsl::cascade_pair, pairs,
        "umbrage_cascade_pair(vec3(x3.w, x4.w, x5.w), x2, vec3(x3.x, x3.y, x3.z), vec2(x4.x - 40.0, x4.y - 36.0), "
        "vec2(x5.x, x5.y), vec4(x1.x, x1.y, 1.0, x1.x), vec4(vec2(x1.x, x1.y) * 0.5, 1.0, x1.x), "
        "vec4(0.125, x0.w, 0.0, 0.0))",
        [](const sample& s) {
            return cascade_pair(vec3(s.x[3].w, s.x[4].w, s.x[5].w), s.x[2], vec3(s.x[3]),
                                vec2(s.x[4].x - 40.0f, s.x[4].y - 36.0f), vec2(s.x[5]), scales(s)[0], scales(s)[1],
                                blending_of(s));
        });
    all.push_back({.primitive = &glsl::cascade_edge,
                   .classes = nested(),
                   .twin = [](const sample& s) { return vec4(cascade_edge(vec3(s.x[0]), vec2(s.x[2]), s.x[1].x)); },
                   .call = "vec4(umbrage_cascade_edge(vec3(x0.x, x0.y, x0.z), vec2(x2.x, x2.y), x1.x))"});
    add_places(
        all, glsl::cascaded_maps_places, nested(),
        std::string("umbrage_cascaded_maps_places(") + turned + ", " + all_scales + ", mat4(x2, x3, x4, x5), " + rest,
        [](const sample& s) {
            return cascaded_maps_places(axes, scales(s), glm::mat4(s.x[2], s.x[3], s.x[4], s.x[5]), anchor,
                                        blending_of(s), in_64, vec3(s.x[0]), normal_of(s));
        });
    auto eight = nested();
    for (input_class& c : eight)
        c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            s.x[0].w = static_cast<float>(4 + r.below(4));
            if (r.below(2) == 0) s.x[0].x *= 8.0f;
        };
    add_places(all, glsl::cascaded_maps_places_8, eight,
               std::string("umbrage_cascaded_maps_places_8(") + turned + ", " + all_scales +
                   ", mat4(x2, x3, x4, x5), mat4(vec4(vec2(x1.x, x1.y) * 0.0625, 1.0, x1.x), "
                   "vec4(vec2(x1.x, x1.y) * 0.03125, 1.0, x1.x), vec4(vec2(x1.x, x1.y) * 0.015625, 1.0, x1.x), "
                   "vec4(vec2(x1.x, x1.y) * 0.0078125, 1.0, x1.x)), mat4(x5, x4, x3, x2), " +
                   rest,
               [](const sample& s) {
                   glm::mat4 farther = scales(s);
                   for (glm::length_t i = 0; i < 4; ++i) farther[i] *= vec4(0.0625f, 0.0625f, 1.0f, 1.0f);
                   return cascaded_maps_places_8(axes, scales(s), glm::mat4(s.x[2], s.x[3], s.x[4], s.x[5]), farther,
                                                 glm::mat4(s.x[5], s.x[4], s.x[3], s.x[2]), anchor, blending_of(s),
                                                 in_64, vec3(s.x[0]), normal_of(s));
               });
}

}  // namespace parity
