// SPDX-License-Identifier: MIT
#include <umbrage/light/cascades/blend.hpp>

#include "../../entries.hpp"

namespace parity {

void add_light_cascades_blend(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;
    const auto special = special_values();

    all.push_back({.primitive = &glsl::cascade_weight,
                   .classes = spread({{-0.25f, 1.25f}}, special),
                   .twin = [](const sample& s) { return vec4(cascade_weight(s.x[0].x)); },
                   .call = "vec4(umbrage_cascade_weight(x0.x))"});
    all.push_back({.primitive = &glsl::cascade_fade,
                   .classes = spread({{0.0f, 9.0f}, {0.1f, 2.0f}, {-9.0f, 0.0f}}, special),
                   .twin = [](const sample& s) { return vec4(cascade_fade(s.x[0].x, s.x[0].y, s.x[0].z)); },
                   .call = "vec4(umbrage_cascade_fade(x0.x, x0.y, x0.z))"});
    all.push_back(
        {.primitive = &glsl::cascade_border_fade,
         .classes = spread(
             {{-2.0f, 66.0f}, {-2.0f, 66.0f}, {0.0f, 4.0f}, {0.01f, 0.5f}, {16.0f, 64.0f}, {16.0f, 64.0f}}, special),
         .twin =
             [](const sample& s) { return vec4(cascade_border_fade(vec2(s.x[0]), vec2(s.x[1]), s.x[0].z, s.x[0].w)); },
         .call = "vec4(umbrage_cascade_border_fade(vec2(x0.x, x0.y), vec2(x1.x, x1.y), x0.z, x0.w))"});
    all.push_back({.primitive = &glsl::blend_cascades,
                   .classes = spread({{0.0f, 1.0f}, {0.0f, 0.3f}, {0.0f, 1.0f}}, special),
                   .twin = [](const sample& s) { return vec4(blend_cascades(s.x[0].x, s.x[0].y, s.x[0].z)); },
                   .call = "vec4(umbrage_blend_cascades(x0.x, x0.y, x0.z))"});
    all.push_back({.primitive = &glsl::dither_threshold,
                   .classes = spread({{-50.0f, 50.0f}, {-50.0f, 50.0f}}, special),
                   .twin = [](const sample& s) { return vec4(dither_threshold(at(s))); },
                   .call = "vec4(umbrage_dither_threshold(vec2(x0.x, x0.y)))"});
    auto dithered = spread({{0.0f, 4.0f}, {0.0f, 1.0f}, {0.0f, 1.0f}}, special);
    for (input_class& kind : dithered)  // of whole cascades
        kind.fill = [fill = kind.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            s.x[0].x = static_cast<float>(r.below(64));
        };
    all.push_back({.primitive = &glsl::dithered_cascade,
                   .classes = std::move(dithered),
                   .twin = [](const sample& s) { return vec4(dithered_cascade(s.x[0].x, s.x[0].y, s.x[0].z)); },
                   .call = "vec4(umbrage_dithered_cascade(x0.x, x0.y, x0.z))"});
}

}  // namespace parity
