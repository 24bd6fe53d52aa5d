// SPDX-License-Identifier: MIT
#include <umbrage/shadow/cascade_choice.hpp>

#include <functional>
#include <string>
#include <utility>

#include "cascade_inputs.hpp"

namespace parity {
namespace {

using namespace umbrage;

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

void add_shadow_cascade_choice(std::vector<entry>& all) {
    using namespace cascades;
    namespace glsl = umbrage::glsl;

    const auto add = [&](const glsl::snippet& s, std::vector<input_class> classes, const std::string& call,
                         const std::function<vec4(const sample&)>& twin) {
        all.push_back({.primitive = &s, .classes = std::move(classes), .twin = twin, .call = call});
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
}

}  // namespace parity
