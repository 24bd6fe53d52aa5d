// SPDX-License-Identifier: MIT
#include <umbrage/core/unorm.hpp>

#include "../entries.hpp"

namespace parity {

void add_core_unorm(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    const std::vector<input_class> bytes{{"codes", [](std::uint64_t i, random& r, sample& s) {
                                              for (int c = 0; c < 4; ++c) s.x[0][c] = static_cast<float>(r.below(256));
                                              s.x[0].x = static_cast<float>(i % 256);
                                          }}};
    all.push_back({.primitive = &glsl::to_unorm,
                   .classes = bytes,
                   .twin = [](const sample& s) { return to_unorm(s.x[0]); },
                   .call = "umbrage_to_unorm(x0)"});
    all.push_back({.primitive = &glsl::to_unorm,
                   .variant = "overloads",
                   .classes = bytes,
                   .twin =
                       [](const sample& s) {
                           const vec4 v = s.x[0];
                           return vec4(to_unorm(vec2(v.x, v.y)), to_unorm(vec3(v.y, v.z, v.w)).z, to_unorm(v.x));
                       },
                   .call = "vec4(umbrage_to_unorm(vec2(x0.x, x0.y)), umbrage_to_unorm(vec3(x0.y, x0.z, x0.w)).z, "
                           "umbrage_to_unorm(x0.x))"});
    all.push_back({.primitive = &glsl::to_unorm,
                   .variant = "8-bit target",
                   .classes = bytes,
                   .twin = [](const sample& s) { return s.x[0]; },
                   .call = "umbrage_to_unorm(x0)",
                   .output = target::rgba8,
                   .bits = true});

    all.push_back({.primitive = &glsl::from_unorm,
                   .classes = channels(),
                   .twin = [](const sample& s) { return from_unorm(s.x[0]); },
                   .call = "umbrage_from_unorm(x0)"});
    all.push_back({.primitive = &glsl::from_unorm,
                   .variant = "overloads",
                   .classes = channels(),
                   .twin =
                       [](const sample& s) {
                           const vec4 v = s.x[0];
                           return vec4(from_unorm(vec2(v.x, v.y)), from_unorm(vec3(v.y, v.z, v.w)).z, from_unorm(v.x));
                       },
                   .call = "vec4(umbrage_from_unorm(vec2(x0.x, x0.y)), umbrage_from_unorm(vec3(x0.y, x0.z, x0.w)).z, "
                           "umbrage_from_unorm(x0.x))"});
}

}  // namespace parity
