// SPDX-License-Identifier: MIT
#include <umbrage/shadow/cascade_choice.hpp>
#include <umbrage/shadow/cascade_places.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "places.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Size of a map and reach of a filter: by x1.z, which is 1, so that no compiler knows them.
shadow_terms in_64(const sample& s) { return {.map_size = vec2(64.0f) * s.x[1].z, .reach = 2.0f * s.x[1].z}; }

/// A point in x0.xyz before four cascades of 64 x 64 texels, each with half of the scale before it, x1.xyz; offsets in
/// x2 to x5; a normal in the fourth components, and the number of the last cascade in x0.w.
std::vector<input_class> nested(const std::vector<value_class>& kinds = large_values()) {
    const range offset{24.0f, 40.0f}, depth{-0.25f, 0.25f}, tilt{-1.0f, 1.0f};
    auto classes = spread(
        {{-9.0f, 9.0f}, {-9.0f, 9.0f}, {-0.25f, 1.25f}, {0.0f, 4.0f}, {2.0f, 16.0f}, {2.0f, 16.0f}, {1.0f, 1.0f}, tilt,
         offset,        offset,        depth,           tilt,         offset,        offset,        depth,        tilt,
         offset,        offset,        depth,           tilt,         offset,        offset,        depth,        tilt},
        kinds);
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
constexpr auto all_farther =
    "mat4(vec4(vec2(x1.x, x1.y) * 0.0625, 1.0, x1.x), vec4(vec2(x1.x, x1.y) * 0.03125, 1.0, x1.x), "
    "vec4(vec2(x1.x, x1.y) * 0.015625, 1.0, x1.x), vec4(vec2(x1.x, x1.y) * 0.0078125, 1.0, x1.x))";
constexpr auto all_offsets = "mat4(x2, x3, x4, x5)", other_offsets = "mat4(x5, x4, x3, x2)";
constexpr auto rest =
    "vec4(0.25, -0.5, 0.125, 0.0), vec4(0.125, x0.w, 0.0, 0.0), vec4(64.0, 64.0, 2.0, 0.0) * x1.z, vec3(x0.x, x0.y, "
    "x0.z)";

glm::mat4 farther_scales(const sample& s) {
    glm::mat4 farther = scales(s);
    for (glm::length_t i = 0; i < 4; ++i) farther[i] *= vec4(0.0625f, 0.0625f, 1.0f, 1.0f);
    return farther;
}
glm::mat4 offsets(const sample& s) { return {s.x[2], s.x[3], s.x[4], s.x[5]}; }
glm::mat4 farther_offsets(const sample& s) { return {s.x[5], s.x[4], s.x[3], s.x[2]}; }

/// nested(), with the number of a cascade in x5.w, up to one after the last of `count`.
std::vector<input_class> numbered(std::uint32_t count, const std::vector<value_class>& kinds = large_values()) {
    auto classes = nested(kinds);
    for (input_class& c : classes)
        c.fill = [fill = c.fill, count](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            s.x[0].w = static_cast<float>(r.below(count));
            s.x[5].w = static_cast<float>(r.below(count + 1));
            if (count > 4 && r.below(2) == 0) s.x[0].x *= 8.0f;
        };
    return classes;
}

/// Edges of up to four cascades in x0, some of them 0; a cascade's number and its edges in x1, those of x0 or others;
/// the number of the last one in x1.w.
std::vector<input_class> edges() {
    auto classes = spread(std::vector<range>(24, range{-12.0f, 8.0f}), large_values());
    for (input_class& c : classes)
        c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            for (glm::length_t k = 0; k < 4; ++k)
                if (r.below(4) == 0) s.x[0][k] = 0.0f;
            s.x[1].x = static_cast<float>(r.below(5));
            s.x[1].w = static_cast<float>(r.below(4));
        };
    return classes;
}

}  // namespace

void add_shadow_cascade_places(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    const auto add = [&](const glsl::snippet& s, std::vector<input_class> classes, const std::string& call,
                         const std::function<vec4(const sample&)>& twin) {
        all.push_back({.primitive = &s, .classes = std::move(classes), .twin = twin, .call = call});
    };
    const auto add_place = [&](const glsl::snippet& s, std::uint32_t count, const std::string& call, const auto& twin) {
        add_places(all, s, numbered(count), call, [twin](const sample& x) { return std::array{twin(x)}; });
    };

    add(glsl::cascade_edge, with_nan_positions(nested(finite_values())),
        "vec4(umbrage_cascade_edge(vec3(x0.x, x0.y, x0.z), vec4(x1.x, x1.y, 1.0, 0.0), x2, vec2(64.0, 32.0) * x1.z, "
        "2.0 * x1.z))",
        [](const sample& s) {
            return vec4(cascade_edge(vec3(s.x[0]), vec4(s.x[1].x, s.x[1].y, 1, 0), s.x[2], vec2(64, 32) * s.x[1].z,
                                     2.0f * s.x[1].z));
        });
    add(glsl::cascade_edges, with_nan_positions(nested(finite_values())),
        std::string("umbrage_cascade_edges(vec3(x0.x, x0.y, x0.z), ") + all_scales + ", " + all_offsets +
            ", vec2(64.0, 32.0) * x1.z, 2.0 * x1.z)",
        [](const sample& s) {
            return cascade_edges(vec3(s.x[0]), scales(s), offsets(s), vec2(64, 32) * s.x[1].z, 2.0f * s.x[1].z);
        });
    add(glsl::first_cascade, edges(), "vec4(umbrage_first_cascade(x0), 0.0)",
        [](const sample& s) { return vec4(first_cascade(s.x[0]), 0.0f); });
    add(glsl::next_cascade_weight, edges(),
        "vec4(umbrage_next_cascade_weight(vec3(x1.x, x0.x, x0.y), vec4(0.125, x1.w, 0.0, 0.0)), "
        "umbrage_next_cascade_weight(vec3(x1.x, x0.x, x0.y), vec4(0.0, x1.w, 0.0, 0.0)), 0.0, 0.0)",
        [](const sample& s) {
            const vec3 found(s.x[1].x, s.x[0].x, s.x[0].y);
            return vec4(next_cascade_weight(found, vec4(0.125f, s.x[1].w, 0, 0)),
                        next_cascade_weight(found, vec4(0, s.x[1].w, 0, 0)), 0, 0);
        });
    add(glsl::cascaded_maps_choice, with_nan_positions(nested(finite_values())),
        std::string("vec4(umbrage_cascaded_maps_choice(") + turned + ", " + all_scales + ", " + all_offsets + ", " +
            rest + "), 0.0, 0.0)",
        [](const sample& s) {
            return vec4(
                cascaded_maps_choice(axes, scales(s), offsets(s), anchor, blending_of(s), in_64(s), vec3(s.x[0])), 0,
                0);
        });
    add(glsl::cascaded_maps_choice_8, with_nan_positions(numbered(8, finite_values())),
        std::string("vec4(umbrage_cascaded_maps_choice_8(") + turned + ", " + all_scales + ", " + all_offsets + ", " +
            all_farther + ", " + other_offsets + ", " + rest + "), 0.0, 0.0)",
        [](const sample& s) {
            return vec4(cascaded_maps_choice_8(axes, scales(s), offsets(s), farther_scales(s), farther_offsets(s),
                                               anchor, blending_of(s), in_64(s), vec3(s.x[0])),
                        0, 0);
        });

    add_place(glsl::cascade_place, 4,
              "umbrage_cascade_place(vec3(x0.x, x0.y, x0.z), vec3(x2.w, x3.w, x4.w), vec4(x1.x, x1.y, 1.0, x1.x), x3, "
              "x5.w, x0.w)",
              [](const sample& s) {
                  return cascade_place(vec3(s.x[0]), normal_of(s), scales(s)[0], s.x[3], s.x[5].w, s.x[0].w);
              });
    add_place(glsl::cascaded_maps_place, 4,
              std::string("umbrage_cascaded_maps_place(") + turned + ", " + all_scales + ", " + all_offsets + ", " +
                  rest + ", vec3(x2.w, x3.w, x4.w), x5.w)",
              [](const sample& s) {
                  return cascaded_maps_place(axes, scales(s), offsets(s), anchor, blending_of(s), in_64(s),
                                             vec3(s.x[0]), normal_of(s), s.x[5].w);
              });
    add_place(glsl::cascaded_maps_place_8, 8,
              std::string("umbrage_cascaded_maps_place_8(") + turned + ", " + all_scales + ", " + all_offsets + ", " +
                  all_farther + ", " + other_offsets + ", " + rest + ", vec3(x2.w, x3.w, x4.w), x5.w)",
              [](const sample& s) {
                  return cascaded_maps_place_8(axes, scales(s), offsets(s), farther_scales(s), farther_offsets(s),
                                               anchor, blending_of(s), in_64(s), vec3(s.x[0]), normal_of(s), s.x[5].w);
              });
}

}  // namespace parity
