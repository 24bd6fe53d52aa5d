// SPDX-License-Identifier: MIT
#include <umbrage/bias/acne_free.hpp>

#include "../entries.hpp"

namespace parity {

void add_bias_acne_free(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    const auto slopes = spread({{-0.05f, 0.05f}, {-0.05f, 0.05f}, {0.0f, 9.0f}, {0.0f, 0.01f}}, special_values());
    all.push_back({.primitive = &glsl::acne_free_bias,
                   .classes = slopes,
                   .twin = [](const sample& s) { return vec4(acne_free_bias(vec2(s.x[0]), s.x[0].z, s.x[0].w)); },
                   .call = "vec4(umbrage_acne_free_bias(vec2(x0.x, x0.y), x0.z, x0.w))"});
    all.push_back({.primitive = &glsl::acne_free_disc_bias,
                   .classes = slopes,
                   .twin = [](const sample& s) { return vec4(acne_free_disc_bias(vec2(s.x[0]), s.x[0].z, s.x[0].w)); },
                   .call = "vec4(umbrage_acne_free_disc_bias(vec2(x0.x, x0.y), x0.z, x0.w))"});
    all.push_back(
        {.primitive = &glsl::peter_panning_distance,
         .classes = slopes,
         .twin = [](const sample& s) { return vec4(peter_panning_distance(s.x[0].w, vec2(s.x[0]), s.x[0].z)); },
         .call = "vec4(umbrage_peter_panning_distance(x0.w, vec2(x0.x, x0.y), x0.z))"});
}

}  // namespace parity
