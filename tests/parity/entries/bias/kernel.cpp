// SPDX-License-Identifier: MIT
#include <umbrage/bias/kernel.hpp>

#include "limits.hpp"

namespace parity {

void add_bias_kernel(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    // normal and width, direction and greatest tangent, way
    std::vector<range> vectors(11, range{-1.0f, 1.0f});
    vectors[3] = {0.0f, 0.1f}, vectors[7] = {0.0f, 30.0f};
    auto classes = spread(vectors, special_values());
    classes.push_back({"limits", [](std::uint64_t i, random&, sample& s) {
                           s.x[0] = vec4(1.0f, 0.0f, 0.0f, limit(i));
                           s.x[1] = vec4(0.0f, 0.0f, -1.0f, 1.0f);
                           s.x[2] = vec4(0.0f, 0.0f, -1.0f, 0.0f);
                       }});
    all.push_back({.primitive = &glsl::kernel_bias,
                   .classes = classes,
                   .twin =
                       [](const sample& s) {
                           return vec4(kernel_bias(vec3(s.x[0]), vec3(s.x[1]), vec3(s.x[2]), s.x[0].w, s.x[1].w));
                       },
                   .call = "vec4(umbrage_kernel_bias(vec3(x0.x, x0.y, x0.z), vec3(x1.x, x1.y, x1.z), "
                           "vec3(x2.x, x2.y, x2.z), x0.w, x1.w))"});
}

}  // namespace parity
