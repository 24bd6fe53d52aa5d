// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>

#include <umbrage/bias/normal_offset.hpp>

#include "limits.hpp"

namespace parity {

void add_bias_normal_offset(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    // normal and width, direction and error, way
    std::vector<range> vectors(11, range{-1.0f, 1.0f});
    vectors[3] = {0.0f, 0.1f}, vectors[7] = {0.0f, 0.01f};
    auto classes = spread(vectors, special_values());
    classes.push_back({"light falls straight, or nearly", [](std::uint64_t i, random& r, sample& s) {
                           const vec3 axis = glm::normalize(vec3{r.between(-1, 1), r.between(-1, 1), 1.5f});
                           const vec3 askew(0.0f, i % 3 == 0 ? 0.0f : r.between(-0.001f, 0.001f), 0.0f);
                           s.x[0] = vec4(-axis + askew, r.unit());
                           s.x[1] = vec4(axis, 0.0f);
                           s.x[2] = vec4(axis, 0.0f);
                       }});
    classes.push_back({"limits", [](std::uint64_t i, random&, sample& s) {
                           s.x[0] = vec4(1.0f, 0.0f, 0.0f, limit(i));
                           s.x[1] = vec4(0.0f, 0.0f, -1.0f, 0.0f);
                           s.x[2] = vec4(0.0f, 0.0f, -1.0f, 0.0f);
                       }});
    all.push_back({.primitive = &glsl::normal_offset,
                   .classes = classes,
                   .twin =
                       [](const sample& s) {
                           return vec4(normal_offset(vec3(s.x[0]), vec3(s.x[1]), vec3(s.x[2]), s.x[0].w, s.x[1].w),
                                       0.0f);
                       },
                   .call = "vec4(umbrage_normal_offset(vec3(x0.x, x0.y, x0.z), vec3(x1.x, x1.y, x1.z), "
                           "vec3(x2.x, x2.y, x2.z), x0.w, x1.w), 0.0)"});
}

}  // namespace parity
